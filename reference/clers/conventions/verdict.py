"""What a law says of one example: it holds, or it fails with evidence. Clause: CONV-LAW-4."""

from dataclasses import dataclass

from clers.conventions.where import Where


@dataclass(frozen=True, slots=True)
class Holds:
    """The law holds on this example."""


@dataclass(frozen=True, slots=True)
class Fails:
    """The law fails: what was expected, what was got, and where they first differ."""

    expected: str
    got: str
    where: Where


Verdict = Holds | Fails
