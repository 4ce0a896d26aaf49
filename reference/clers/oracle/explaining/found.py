"""A case by its id, the beginning of one, or the file of a finding. Clause: ORCL-EXPLAIN-1."""

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Final

from clers.conformance.cases.case import Case

NEAREST: Final = 8
"""Ids that are named where none is meant. Clause: ORCL-EXPLAIN-1."""


@dataclass(frozen=True, slots=True)
class NoCase:
    """Nothing, or more than one case, has this name; the nearest ids."""

    why: str


def case_named(name: str, cases: Sequence[Case]) -> Case | NoCase:
    """The case with this id, or the only one whose id begins so. Clause: ORCL-EXPLAIN-1."""
    exact = next((case for case in cases if case.id == name), None)
    if exact is not None:
        return exact
    begun = [case for case in cases if case.id.startswith(name)]
    if len(begun) == 1:
        return begun[0]
    if begun:
        return NoCase(f"{len(begun)} cases begin with {name!r}: {_listed([c.id for c in begun])}")
    ids = [case.id for case in cases]
    near = get_close_matches(name, ids, NEAREST, 0.5) or [i for i in ids if name in i]
    return NoCase(f"no case {name!r}" + (f"; near it: {_listed(near)}" if near else ""))


def _listed(ids: Sequence[str]) -> str:
    more = f" and {len(ids) - NEAREST} more" if len(ids) > NEAREST else ""
    return ", ".join(ids[:NEAREST]) + more
