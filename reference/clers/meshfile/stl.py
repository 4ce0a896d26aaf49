"""STL, binary and ASCII: triangles of positions, welded to vertices. Clause: TOOL-STL-1.

No loader library: trimesh 5.2 reads three loops of four ASCII vertices as four triangles, and needs
another package to answer to a truncated binary file. Binary STL is one line of `struct`.
"""

import re
from array import array
from collections.abc import Sequence
from struct import Struct
from typing import Final

from clers.complexes.face_list import FaceList, Limits
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Precision, narrowest
from clers.meshfile.faults import bad_line, not_a_triangle, over_limit, unreadable
from clers.meshfile.mesh import RawMesh
from clers.meshfile.numeral import reals

HEAD: Final = Struct("<80sI")
FACET: Final = Struct("<3f9fH")
_LINES_OF_A_FACET: Final = 7
_OPENING: Final = re.compile(rb"\s*solid(\s|\Z)", re.IGNORECASE)

Row = tuple[int, list[bytes]]


def parse(data: bytes, limits: Limits) -> Accepted[RawMesh] | Rejected:
    """The mesh that an STL file says. Clauses: TOOL-STL-1, TOOL-READ-2 … TOOL-READ-9."""
    if len(data) >= HEAD.size:
        _, faces = HEAD.unpack_from(data)
        if len(data) == HEAD.size + FACET.size * faces:
            corners = array("d")
            for facet in FACET.iter_unpack(memoryview(data)[HEAD.size :]):
                corners.extend(facet[3:12])
            return welded(corners, Precision.F32, limits)
    if not _OPENING.match(data):
        return unreadable("neither ASCII STL nor binary STL of the length it says")
    solids = _solids(data)
    if isinstance(solids, Rejected):
        return solids
    return welded(solids, narrowest(solids), limits)


def welded(
    corners: Sequence[float], precision: Precision, limits: Limits
) -> Accepted[RawMesh] | Rejected:
    """Corners at one position are one vertex, numbered by their first corners. Clause: TOOL-STL-1.

    `corners` is flat, nine numbers for a face.
    """
    number: dict[bytes, int] = {}
    coordinates: list[float] = []
    vertex: list[int] = []
    for i in range(0, len(corners), 3):
        place = corners[i : i + 3]
        key = place_of(place)
        if key not in number:
            number[key] = len(number)
            coordinates += place
        vertex.append(number[key])
    fault = over_limit(len(number), len(vertex) // 3, limits)
    if fault is not None:
        return fault
    faces = tuple(zip(vertex[0::3], vertex[1::3], vertex[2::3], strict=True))
    return Accepted(RawMesh(FaceList(faces, len(number)), tuple(coordinates), precision))


def place_of(coordinates: Sequence[float]) -> bytes:
    """A key that two positions share if they are one to STL. Clause: TOOL-STL-1.

    Adding 0 makes 0 of −0 and changes nothing else. The key is bytes, whose hash is keyed: with
    numbers the writer of a file could choose collisions.
    """
    return array("d", [x + 0.0 for x in coordinates]).tobytes()


def _solids(data: bytes) -> Sequence[float] | Rejected:
    """The corners of all facets of an ASCII file, flat."""
    lines = enumerate(data.splitlines(), start=1)
    rows = [(line, words) for line, text in lines if (words := text.lower().split())]
    corners = array("d")
    inside = False
    i = 0
    while i < len(rows):
        line, words = rows[i]
        i += 1
        if words[0] == (b"endsolid" if inside else b"solid"):
            inside = not inside
        elif inside and words[:2] == [b"facet", b"normal"] and len(words) == 5:
            facet = _facet(rows, i, len(corners) // 9)
            if isinstance(facet, Rejected):
                return facet
            i += _LINES_OF_A_FACET - 1
            corners.extend(facet)
        else:
            return bad_line(line, "no facet and no end of the solid" if inside else "no solid")
    return unreadable("the last solid does not end") if inside else corners


def _facet(rows: list[Row], start: int, face: int) -> list[float] | Rejected:
    """The nine coordinates of the facet whose loop begins at a row."""
    places: list[float] = []
    i = start + 1
    while i < len(rows) and rows[i][1][0] == b"vertex":
        line, words = rows[i]
        place = reals(words[1:])
        if place is None or len(place) != 3:
            return bad_line(line, "no three coordinates")
        places += place
        i += 1
    for at, said in ((start, b"outer loop"), (i, b"endloop"), (i + 1, b"endfacet")):
        if at >= len(rows):
            return unreadable(f"facet {face} does not end")
        line, words = rows[at]
        if words != said.split():
            return bad_line(line, f"no {said.decode()} of facet {face}")
    if len(places) != 9:
        return not_a_triangle(face, len(places) // 3)
    return places
