"""What becomes of cases that a new suite no longer has. Clause: ORCL-SUITE-6."""

from collections.abc import Sequence
from dataclasses import dataclass

from clers.conformance.cases.case import Case
from clers.oracle.suite.records import Retired

HASH = 9
"""The characters of an id after its slug. Clause: ORCL-CASE-2."""


@dataclass(frozen=True, slots=True)
class Unretired:
    """Cases that would be gone without a word. Clause: ORCL-SUITE-6."""

    ids: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Reused:
    """Cases whose id was retired. Clause: ORCL-SUITE-6."""

    ids: tuple[str, ...]


def slug_in(name: str) -> str:
    """The slug of an id. Clause: ORCL-CASE-2."""
    return name[:-HASH]


def retire(
    old: Sequence[Case], new: Sequence[Case], before: Sequence[Retired], reason: str
) -> tuple[Retired, ...] | Unretired | Reused:
    """The retired of the new suite: those of before, and the cases of the old that it has not.

    `reason` empty: none may be gone. Clause: ORCL-SUITE-6.
    """
    known = {case.id for case in old}
    present = {case.id for case in new}
    reused = tuple(sorted(entry.id for entry in before if entry.id in present))
    if reused:
        return Reused(reused)
    gone = [case for case in old if case.id not in present]
    if gone and not reason:
        return Unretired(tuple(case.id for case in gone))
    came = {(case.op, slug_in(case.id)): case.id for case in new if case.id not in known}
    return (
        *before,
        *(
            Retired(id=case.id, reason=reason, successor=came.get((case.op, slug_in(case.id)), ""))
            for case in gone
        ),
    )
