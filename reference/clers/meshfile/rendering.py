"""From raw meshes to the bytes of files."""

from collections.abc import Iterable, Iterator
from math import isnan
from struct import Struct
from typing import Final, assert_never

import numpy as np

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtFace, AtVertex
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format
from clers.meshfile.mesh import RawMesh
from clers.meshfile.numeral import singles
from clers.meshfile.stl import FACET, HEAD, place_of

_PLY_FACE: Final = Struct("<B3i")


def render(known: Format, mesh: RawMesh) -> Accepted[bytes] | Rejected:
    """The bytes of the one file for a mesh; pure. Clauses: TOOL-WRITE-1 … TOOL-WRITE-3."""
    fault = _misfit(mesh)
    if fault is not None:
        return fault
    match known:
        case Format.PLY:
            return Accepted(_ply(mesh))
        case Format.OFF:
            counts = f"{mesh.faces.vertices} {len(mesh.faces.faces)} 0"
            return Accepted(_text(("OFF", counts, *_off_lines(mesh))))
        case Format.OBJ:
            return Accepted(_text(_obj_lines(mesh)))
        case Format.STL:
            return _lost_in_stl(mesh) or Accepted(_stl(mesh))
        case _:
            assert_never(known)


def _misfit(mesh: RawMesh) -> Rejected | None:
    """What no format can hold. Clause: TOOL-WRITE-2."""
    vertices = mesh.faces.vertices
    if len(mesh.coordinates) != 3 * vertices:
        detail = f"{len(mesh.coordinates)} coordinates for {vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.TOOL_WRITE_2, detail=detail)
    for t, corners in enumerate(mesh.faces.faces):
        if not all(0 <= v < vertices for v in corners):
            detail = f"{corners} with {vertices} vertices"
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.TOOL_WRITE_2, AtFace(t), detail)
    if mesh.precision is Precision.F32:
        for v, wide in enumerate(_wide(mesh)):
            if wide:
                return Rejected(Reason.NOT_REPRESENTABLE, Clause.TOOL_WRITE_2, AtVertex(v), wide)
    return None


def _wide(mesh: RawMesh) -> Iterator[str]:
    """For each vertex, what is no binary32 value of it, in words; empty if nothing is."""
    rounded = singles(mesh.coordinates)
    for v in range(mesh.faces.vertices):
        given = mesh.coordinates[3 * v : 3 * v + 3]
        lost = [x for x, y in zip(given, rounded[3 * v :], strict=False) if x != y and not isnan(x)]
        yield f"{lost[0]!r} is no binary32 value" if lost else ""


def _ply(mesh: RawMesh) -> bytes:
    name, code = ("float", "<f4") if mesh.precision is Precision.F32 else ("double", "<f8")
    lines = (
        "ply",
        "format binary_little_endian 1.0",
        f"element vertex {mesh.faces.vertices}",
        *(f"property {name} {axis}" for axis in "xyz"),
        f"element face {len(mesh.faces.faces)}",
        "property list uchar int vertex_indices",
        "end_header",
    )
    places = np.array(mesh.coordinates, dtype=code).tobytes()
    return _text(lines) + places + b"".join(_PLY_FACE.pack(3, *f) for f in mesh.faces.faces)


def _text(lines: Iterable[str]) -> bytes:
    return "".join(f"{line}\n" for line in lines).encode("ascii")


def _places(mesh: RawMesh) -> Iterator[str]:
    """The coordinates of each vertex; `repr` gives the shortest decimal that means its number."""
    words = [repr(x) for x in mesh.coordinates]
    return map(" ".join, zip(words[0::3], words[1::3], words[2::3], strict=True))


def _off_lines(mesh: RawMesh) -> Iterator[str]:
    yield from _places(mesh)
    yield from (f"3 {a} {b} {c}" for a, b, c in mesh.faces.faces)


def _obj_lines(mesh: RawMesh) -> Iterator[str]:
    yield from (f"v {place}" for place in _places(mesh))
    yield from (f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.faces.faces)


def _lost_in_stl(mesh: RawMesh) -> Rejected | None:
    """The first vertex that STL would not give back. Clause: TOOL-WRITE-3."""
    used = {v for corners in mesh.faces.faces for v in corners}
    owner: dict[bytes, int] = {}
    for v, wide in enumerate(_wide(mesh)):
        other = owner.setdefault(place_of(mesh.coordinates[3 * v : 3 * v + 3]), v)
        if wide:
            detail = wide
        elif v not in used:
            detail = "STL has no vertices without faces"
        elif other != v:
            detail = f"at the position of vertex {other}; STL would make them one"
        else:
            continue
        return Rejected(Reason.NOT_REPRESENTABLE, Clause.TOOL_WRITE_3, AtVertex(v), detail)
    return None


def _stl(mesh: RawMesh) -> bytes:
    """Zero normals: most readers compute them, and chapter 7 knows none."""
    at = mesh.coordinates
    head = HEAD.pack(b"binary STL", len(mesh.faces.faces))
    corners = ([x for v in face for x in at[3 * v : 3 * v + 3]] for face in mesh.faces.faces)
    return head + b"".join(FACET.pack(0, 0, 0, *nine, 0) for nine in corners)
