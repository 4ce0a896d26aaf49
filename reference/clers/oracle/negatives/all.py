"""All cases of this package: faults with their parents, and what the grammar alone gives."""

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from typing import Final

import msgspec
from msgspec import UnsetType

from clers.conformance.cases.case import Case
from clers.oracle.negatives import (
    codes,
    files,
    from_mutants,
    grammar,
    limits,
    meshes,
    messages,
    payloads,
    scripts,
    surfaces,
    words,
)
from clers.oracle.negatives.draft import Draft

FAMILIES: Final[Mapping[str, Callable[[], Iterable[Draft]]]] = {
    "surfaces": surfaces.drafts,
    "words": words.drafts,
    "grammar": grammar.drafts,
    "messages": messages.drafts,
    "codes": codes.drafts,
    "files": files.drafts,
    "payloads": payloads.drafts,
    "limits": limits.drafts,
    "meshes": meshes.drafts,
    "scripts": scripts.drafts,
    "from mutants": from_mutants.drafts,
}
"""Each family by its name."""


@cache
def drafts() -> tuple[Draft, ...]:
    """Every case, some of them more than once."""
    return tuple(draft for family in FAMILIES.values() for draft in family())


def negatives(parents: Mapping[str, Case]) -> tuple[tuple[str, str, Case], ...]:
    """Each case with its profile and the words of its id; good ones and bad ones.

    `parents` are cases that are there already: what one of them asks is not asked again, and it
    stands as the parent of the bad ones instead. Clauses: ORCL-CASE-2, ORCL-FAULT-1.
    """
    known = {_asked(case): case.id for case in parents.values()}
    instead: dict[str, str] = {}
    found: dict[str, Draft] = {}
    for draft in drafts():
        case = draft.case
        there = known.setdefault(_asked(case), case.id)
        if there != case.id:
            instead[case.id] = there
        else:
            found.setdefault(case.id, draft)
    return tuple(
        (draft.profile, draft.slug, _under(draft.case, instead)) for draft in found.values()
    )


def _asked(case: Case) -> tuple[str, bytes]:
    """The operation, and the input as one text for each value."""
    return case.op, msgspec.json.encode(msgspec.json.decode(case.input), order="sorted")


def _under(case: Case, instead: Mapping[str, str]) -> Case:
    """The case, its fault's parent by the id that the suite has for it."""
    if isinstance(case.fault, UnsetType) or case.fault.parent not in instead:
        return case
    fault = msgspec.structs.replace(case.fault, parent=instead[case.fault.parent])
    return msgspec.structs.replace(case, fault=fault)
