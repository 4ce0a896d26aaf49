"""Two suites compared: what was added, retired, removed, changed. Clause: ORCL-SUITE-8."""

from collections.abc import Iterator

import msgspec
from msgspec import Raw, Struct

from clers.conformance.cases.case import Case
from clers.oracle.suite.files import Suite


class Changed(Struct, frozen=True):
    """A case with one id in both, and the keys in which it differs. Clause: ORCL-SUITE-8."""

    id: str
    keys: tuple[str, ...]


class Gone(Struct, frozen=True, omit_defaults=True):
    """A case of the first that the second has not; without a reason if it does not say why."""

    id: str
    reason: str = ""
    successor: str = ""


class Difference(Struct, frozen=True):
    """From one suite to another. Clause: ORCL-SUITE-8."""

    added: tuple[str, ...]
    retired: tuple[Gone, ...]
    removed: tuple[Gone, ...]
    changed: tuple[Changed, ...]

    @property
    def none(self) -> bool:
        """Do both hold the same cases?"""
        return not (self.added or self.retired or self.removed or self.changed)


def difference(first: Suite, second: Suite) -> Difference:
    """What became of the cases, in the order of the suites. Clause: ORCL-SUITE-8."""
    before = {case.id: (part.profile, case) for part in first.parts for case in part.cases}
    after = {case.id: (part.profile, case) for part in second.parts for case in part.cases}
    said = {entry.id: entry for entry in second.retired}
    gone = tuple(
        Gone(said[name].id, said[name].reason, said[name].successor) if name in said else Gone(name)
        for name in before
        if name not in after
    )
    pairs = ((name, before[name], after[name]) for name in before if name in after)
    found = (Changed(name, tuple(_keys(one, other))) for name, one, other in pairs)
    return Difference(
        tuple(name for name in after if name not in before),
        tuple(entry for entry in gone if entry.reason),
        tuple(entry for entry in gone if not entry.reason),
        tuple(change for change in found if change.keys),
    )


def _keys(one: tuple[str, Case], other: tuple[str, Case]) -> Iterator[str]:
    """The keys of two cases that differ, and `profile` if that does."""
    if one[0] != other[0]:
        yield "profile"
    left, right = _read(one[1]), _read(other[1])
    yield from (key for key in Case.__struct_encode_fields__ if left.get(key) != right.get(key))


def _read(case: Case) -> dict[str, Raw]:
    """The keys of a case, their values as texts."""
    return msgspec.json.decode(msgspec.json.encode(case), type=dict[str, Raw])
