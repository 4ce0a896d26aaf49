"""A true part of the suite, and the same with one thing changed, whole again but for that."""

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import msgspec
from msgspec import UNSET, Raw, UnsetType

from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import named
from clers.conventions.result import Accepted
from clers.oracle.suite.files import DEFAULT, Suite, read_suite
from clers.oracle.suite.records import Flag, Part, Retired, Score
from clers.oracle.suite.rendered import parts_of, suite_files
from clers.oracle.suite.retiring import slug_in

Change = Callable[[Case], Case]

ENCODE = "word.encode"


CRE = Case(
    id="tetrahedron-cud5sz5x",
    op="word.decode",
    clauses=("EB-DECODE-1",),
    origin="hand",
    size=4,
    input=Raw(b'{"word":"CRE","handles":[],"components_with_boundary":0}'),
    ok=Raw(b'{"faces":[[0,1,2],[3,2,1],[0,3,1],[2,3,0]],"vertices":4}'),
)
"""A case that is written down by hand, with its true id."""


@cache
def whole() -> Suite:
    """The suite of this checkout."""
    found = read_suite(DEFAULT)
    assert isinstance(found, Accepted), found
    return found.value


@cache
def base() -> Suite:
    """A few cases of the suite: of several components, some of them with a fault.

    Nothing is retired: successors would be among the cases that are left out.
    """
    cases = [
        case
        for part in whole().parts
        if part.profile == "components" and part.op in ("word.decode", "surface.classify", ENCODE)
        for case in part.cases
        if case.size < (20 if part.op == ENCODE else 40)
    ]
    there = {case.id for case in cases}
    kept = [
        case for case in cases if isinstance(case.fault, UnsetType) or case.fault.parent in there
    ]
    parts = parts_of(("components", case) for case in kept)
    used = {flag for case in (*kept, *whole().canaries) for flag in case.flags}
    flags = tuple(flag for flag in whole().flags if flag.name in used)
    return Suite(whole().manifest, parts, flags, (), whole().canaries)


def keys(case: Case) -> frozenset[str]:
    """The keys that a case has."""
    read = msgspec.json.decode(msgspec.json.encode(case), type=dict[str, Raw])
    return frozenset(read)


def first(op: str, *having: str) -> Case:
    """The first case of an operation that has these keys."""
    return next(case for case in base().cases if case.op == op and keys(case).issuperset(having))


def write(folder: Path, files: dict[str, bytes]) -> Path:
    """The files in a folder."""
    for path, data in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)
    return folder


def written(
    folder: Path,
    parts: Sequence[Part] | None = None,
    flags: Sequence[Flag] | None = None,
    retired: Sequence[Retired] | None = None,
    canaries: Sequence[Case] | None = None,
    mutation: Score | UnsetType = UNSET,
) -> Path:
    """The suite with other parts, flags, retired or canaries, under a manifest of its own."""
    of = base()
    return write(
        folder,
        suite_files(
            of.parts if parts is None else parts,
            of.flags if flags is None else flags,
            of.retired if retired is None else retired,
            of.canaries if canaries is None else canaries,
            {},
            mutation,
        ),
    )


def changed(folder: Path, name: str, change: Change) -> Path:
    """The suite with one case changed, whatever its id says then."""
    parts = tuple(
        msgspec.structs.replace(
            part, cases=tuple(change(case) if case.id == name else case for case in part.cases)
        )
        for part in base().parts
    )
    return written(folder, parts)


def renamed(case: Case) -> Case:
    """The case under the id that it has by what it asks and expects."""
    return named(slug_in(case.id), case)
