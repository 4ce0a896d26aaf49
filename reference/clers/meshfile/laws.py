"""The laws of mesh files."""

from dataclasses import dataclass
from math import isnan
from typing import Final

from clers.complexes.face_list import FaceList
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.geometry.positions import Precision, narrowest
from clers.meshfile.formats import Format
from clers.meshfile.mesh import RawMesh
from clers.meshfile.reading import parse
from clers.meshfile.rendering import render
from clers.meshfile.stl import place_of


@dataclass(frozen=True, slots=True)
class FileBytes:
    """Bytes that are said to be of a format."""

    known: Format
    data: bytes


RAW_MESH: Final = Given(
    "raw-mesh",
    "raw meshes whose faces name vertices that are there; coordinates of all kinds, not always "
    "of the precision they state",
    RawMesh,
)
FILE_BYTES: Final = Given(
    "mesh-file-bytes", "mesh files, whole, cut off, with bytes changed, and any bytes", FileBytes
)


def seen(mesh: RawMesh) -> tuple[FaceList, Precision, tuple[str, ...]]:
    """All that makes two raw meshes the same: bits of coordinates, but NaN whatever its payload."""
    bits = tuple("nan" if isnan(x) else x.hex() for x in mesh.coordinates)
    return mesh.faces, mesh.precision, bits


def honest(mesh: RawMesh) -> bool:
    """Is every coordinate of the precision stated? Clause: TOOL-WRITE-2."""
    numbers = [x for x in mesh.coordinates if not isnan(x)]
    return mesh.precision is Precision.F64 or narrowest(numbers) is Precision.F32


def renumbered(mesh: RawMesh) -> RawMesh:
    """The vertices in the order of their first corners, in f32. Clause: TOOL-WRITE-3."""
    order = tuple(dict.fromkeys(v for corners in mesh.faces.faces for v in corners))
    place = {v: i for i, v in enumerate(order)}
    faces = tuple((place[a], place[b], place[c]) for a, b, c in mesh.faces.faces)
    at = tuple(x for v in order for x in mesh.coordinates[3 * v : 3 * v + 3])
    return RawMesh(FaceList(faces, len(order)), at, Precision.F32)


def kept_by_stl(mesh: RawMesh) -> bool:
    """Would STL give it back? Clause: TOOL-WRITE-3."""
    numbers = [x for x in mesh.coordinates if not isnan(x)]
    points = [mesh.coordinates[i : i + 3] for i in range(0, len(mesh.coordinates), 3)]
    apart = len({place_of(point) for point in points}) == len(points)
    used = {v for corners in mesh.faces.faces for v in corners}
    return narrowest(numbers) is Precision.F32 and apart and len(used) == mesh.faces.vertices


def _there_and_back(known: Format, mesh: RawMesh, expected: RawMesh | None) -> Verdict:
    """Rendered and parsed, it is what was expected; refused, if nothing was."""
    data = render(known, mesh)
    match data, expected:
        case Rejected(), None:
            return Holds()
        case Accepted(value), RawMesh():
            again = parse(known, value)
            got = seen(again.value) if isinstance(again, Accepted) else again
            return same(seen(expected), got)
        case _:
            return Fails("refused" if expected is None else "rendered", repr(data)[:200], WHOLE)


def _ply(mesh: RawMesh) -> Verdict:
    return _there_and_back(Format.PLY, mesh, mesh if honest(mesh) else None)


def _untyped(known: Format, mesh: RawMesh) -> Verdict:
    read = RawMesh(mesh.faces, mesh.coordinates, narrowest(mesh.coordinates))
    return _there_and_back(known, mesh, read if honest(mesh) else None)


def _stl(mesh: RawMesh) -> Verdict:
    kept = honest(mesh) and kept_by_stl(mesh)
    return _there_and_back(Format.STL, mesh, renumbered(mesh) if kept else None)


def _answers(file: FileBytes) -> Verdict:
    """Any exception is a failure of its own."""
    result = parse(file.known, file.data)
    if isinstance(result, Rejected):
        return Holds()
    return same(3 * result.value.faces.vertices, len(result.value.coordinates))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "ply-gives-the-mesh-back",
        Clause.TOOL_WRITE_1,
        "a rendered PLY parses to the same faces, precision and bits; a mesh that is not of its "
        "stated precision is refused",
        RAW_MESH,
        _ply,
    ),
    Law(
        "off-gives-the-mesh-back",
        Clause.TOOL_WRITE_1,
        "a rendered OFF parses to the same faces and bits",
        RAW_MESH,
        lambda mesh: _untyped(Format.OFF, mesh),
    ),
    Law(
        "obj-gives-the-mesh-back",
        Clause.TOOL_WRITE_1,
        "a rendered OBJ parses to the same faces and bits",
        RAW_MESH,
        lambda mesh: _untyped(Format.OBJ, mesh),
    ),
    Law(
        "stl-gives-the-mesh-back-or-refuses",
        Clause.TOOL_WRITE_3,
        "a rendered STL parses to the mesh renumbered by first corners; a mesh that it would not "
        "give back is refused",
        RAW_MESH,
        _stl,
    ),
    Law(
        "any-bytes-have-an-answer",
        Clause.TOOL_READ_5,
        "whatever the bytes, parsing gives a mesh with three coordinates a vertex, or a rejection",
        FILE_BYTES,
        _answers,
    ),
)
