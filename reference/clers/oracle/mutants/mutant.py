"""A mutant: the reference with one mistake in one module. Clause: ORCL-MUTANT-1."""

from dataclasses import dataclass

from clers.conventions.clause import Clause


@dataclass(frozen=True, slots=True)
class Mutant:
    """A mistake that people make: where `before` stands in a module, `after` stands instead.

    `clause` is what it breaks, `mistake` says it in a sentence. Clause: ORCL-MUTANT-1.
    """

    name: str
    clause: Clause
    module: str
    before: str
    after: str
    mistake: str


def changed(mutant: Mutant, source: str) -> str | None:
    """The source with the mistake; None where the place is not there, or not once."""
    if source.count(mutant.before) != 1:
        return None
    return source.replace(mutant.before, mutant.after)
