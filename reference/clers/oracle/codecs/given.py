"""The meshes of a survey: files as they stand there, in binary32, and small meshes made here."""

from collections.abc import Iterable, Sequence
from math import isfinite
from pathlib import Path

import msgspec

from clers.conformance import payloads as form
from clers.conventions.result import Rejected
from clers.meshfile.numeral import singles
from clers.meshfile.reading import read
from clers.oracle.codecs.raw import mesh_in


def in_files(
    paths: Iterable[Path],
) -> tuple[tuple[tuple[str, form.MeshForm], ...], tuple[tuple[str, str], ...]]:
    """The meshes of files by name, and the files that are left out with the reason.

    Coordinates are rounded to binary32, which all codecs know. Clause: ORCL-CODEC-14.
    """
    meshes: list[tuple[str, form.MeshForm]] = []
    left: list[tuple[str, str]] = []
    for path in paths:
        found = read(path)
        if isinstance(found, Rejected):
            left.append((path.name, found.line()))
            continue
        rounded = singles(found.value.coordinates)
        if not all(map(isfinite, rounded)):
            left.append((path.name, "a coordinate is no finite binary32 value"))
            continue
        at = form.Places(precision="f32", coordinates=rounded)
        meshes.append((path.name, msgspec.structs.replace(mesh_in(found.value), positions=at)))
    return tuple(meshes), tuple(left)


def files_of(paths: Sequence[Path], suffixes: Sequence[str]) -> list[Path]:
    """Files as they are; of a folder its meshes by name, not those of folders in it."""
    return [
        file
        for path in paths
        for file in (
            sorted(p for p in path.iterdir() if p.suffix.lower() in suffixes)
            if path.is_dir()
            else [path]
        )
    ]
