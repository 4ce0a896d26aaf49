"""A suite as the bytes of its files: one way to write it, to the byte. Clause: ORCL-SUITE-1."""

from base64 import b32encode
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from typing import Final

import msgspec
from msgspec import UNSET, UnsetType

from clers import SPEC_VERSION
from clers.conformance.cases.case import PROFILES, Case
from clers.conformance.results import RESULTS
from clers.oracle.suite.files import CANARIES, FLAGS, MANIFEST, RETIRED
from clers.oracle.suite.records import (
    FORMAT,
    FileEntry,
    Flag,
    Manifest,
    OtherEntry,
    Part,
    ProfileEntry,
    Retired,
    Score,
)

ABOUT: Final[Mapping[str, str]] = {
    "core": "spheres of one component: faces, words and back, and echo",
    "handles": "surfaces of higher genus, closed and of one component",
    "boundaries": "surfaces with boundary curves, of genus 0 and one component",
    "components": "closed surfaces of several components, of genus 0",
    "mixed": "handles, boundary curves and several components together",
    "codes": "symbols and words to bits and back: arithmetic coders, models, the codes of words",
    "operators": "scripts of operators, with the numbers of each stage",
    "geometry": "meshes with positions, files, and any codec there and back",
    "limits": "sizes that are declared and cannot be, and sizes at the edge of what can",
}
"""What the cases of each profile ask. Clause: ORCL-SUITE-3."""


def part_path(profile: str, op: str) -> str:
    """Where the cases of a profile and an operation stand. Clause: ORCL-SUITE-1."""
    return f"{profile}/{op}.json"


def name_of(cases: Iterable[Case]) -> str:
    """The name of the suite with these cases: 60 bits of a hash of their ids. ORCL-SUITE-2."""
    ids = "".join(f"{case.id}\n" for case in cases)
    return b32encode(sha256(ids.encode()).digest()).decode().lower()[:12]


def order(case: Case) -> tuple[int, str]:
    """The smaller case first; among cases of one size by id. Clause: ORCL-SUITE-1."""
    return case.size, case.id


def parts_of(cases: Iterable[tuple[str, Case]]) -> tuple[Part, ...]:
    """Cases, each with its profile, as the files they stand in, in order. Clause: ORCL-SUITE-1."""
    held: dict[tuple[str, str], list[Case]] = {}
    for profile, case in cases:
        held.setdefault((profile, case.op), []).append(case)
    return tuple(
        Part(profile=profile, op=op, cases=tuple(sorted(held[profile, op], key=order)))
        for profile in PROFILES
        for op in RESULTS
        if (profile, op) in held
    )


def rows(head: str, elements: Sequence[object]) -> bytes:
    """A JSON object whose last key is an array with one element a line."""
    lines = b",\n".join(map(msgspec.json.encode, elements))
    return b"%b[%b]}\n" % (head.encode(), b"\n%b\n" % lines if elements else b"")


def part_bytes(part: Part) -> bytes:
    """A file of cases. Clause: ORCL-SUITE-1."""
    return rows(f'{{"profile":"{part.profile}","op":"{part.op}","cases":', part.cases)


def suite_files(
    parts: Sequence[Part],
    flags: Sequence[Flag],
    retired: Sequence[Retired],
    canaries: Sequence[Case],
    others: Mapping[str, bytes],
    mutation: Score | UnsetType = UNSET,
) -> dict[str, bytes]:
    """Every file of the suite by its path, the manifest last. Clauses: ORCL-SUITE-1, ORCL-SUITE-2.

    `others`: what else stands in the folder, as it is.
    """
    files = {part_path(part.profile, part.op): part_bytes(part) for part in parts}
    explained = sorted(flags, key=lambda flag: flag.name)
    gone = sorted(retired, key=lambda entry: entry.id)
    wrong = sorted(canaries, key=order)
    beside = {
        FLAGS: rows('{"flags":', explained),
        RETIRED: rows('{"retired":', gone),
        CANARIES: rows('{"cases":', wrong),
        **dict(sorted(others.items())),
    }
    entries = tuple(
        FileEntry(
            path=part_path(part.profile, part.op),
            profile=part.profile,
            op=part.op,
            cases=len(part.cases),
            sha256=sha256(files[part_path(part.profile, part.op)]).hexdigest(),
        )
        for part in parts
    )
    manifest = Manifest(
        format=FORMAT,
        spec=SPEC_VERSION,
        suite=name_of(case for part in parts for case in part.cases),
        count=sum(entry.cases for entry in entries),
        profiles=tuple(
            ProfileEntry(
                name=name,
                about=ABOUT[name],
                cases=sum(entry.cases for entry in entries if entry.profile == name),
            )
            for name in PROFILES
        ),
        files=entries,
        others=tuple(
            OtherEntry(path=path, sha256=sha256(data).hexdigest()) for path, data in beside.items()
        ),
        mutation=mutation,
    )
    return {**files, **beside, MANIFEST: manifest_bytes(manifest)}


def manifest_bytes(manifest: Manifest) -> bytes:
    """The file `manifest.json`: for people too, so indented by 2. Clause: ORCL-SUITE-1."""
    return msgspec.json.format(msgspec.json.encode(manifest), indent=2) + b"\n"
