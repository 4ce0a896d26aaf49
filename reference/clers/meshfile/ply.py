"""PLY 1.0: ASCII and binary of both byte orders. Clause: TOOL-PLY-1.

No loader library: trimesh 5.2 triangulates quadrilaterals behind the file's own triangles, and
reads binary faces as if all had as many corners as the first.
"""

from dataclasses import dataclass
from typing import Final

from clers.complexes.face_list import FaceList, Limits
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Precision
from clers.meshfile.faults import not_a_triangle, over_limit, unreadable
from clers.meshfile.mesh import RawMesh
from clers.meshfile.ply_header import INTEGERS, WITHIN_BINARY32, Element, Header, header
from clers.meshfile.ply_rows import rows

_FACE_LISTS: Final = ("vertex_indices", "vertex_index")


def parse(data: bytes, limits: Limits) -> Accepted[RawMesh] | Rejected:
    """The mesh that a PLY file says. Clauses: TOOL-PLY-1, TOOL-READ-2 … TOOL-READ-9."""
    head = header(data)
    if isinstance(head, Rejected):
        return head
    shape = _shape(head)
    if isinstance(shape, Rejected):
        return shape
    fault = over_limit(shape.vertices, shape.faces, limits)
    if fault is not None:
        return fault

    coordinates: list[float] = []
    triangles: list[tuple[int, int, int]] = []
    for row in rows(data, head):
        if isinstance(row, Rejected):
            return row
        if row.element.name == "vertex":
            coordinates += (float(row.values[place][0]) for place in shape.xyz)
        elif row.element.name == "face":
            corners = row.values[shape.corners]
            if len(corners) != 3:
                return not_a_triangle(row.index, len(corners))
            a, b, c = map(int, corners)
            triangles.append((a, b, c))
    read = FaceList(tuple(triangles), shape.vertices)
    return Accepted(RawMesh(read, tuple(coordinates), shape.precision))


@dataclass(frozen=True, slots=True)
class _Shape:
    """Where in the rows of vertices and faces that stands which makes a mesh."""

    vertices: int
    faces: int
    xyz: tuple[int, int, int]
    corners: int
    precision: Precision


def _shape(head: Header) -> _Shape | Rejected:
    by_name = {element.name: element for element in head.elements}
    if "tristrips" in by_name:
        return unreadable("triangle strips")
    for element in head.elements:
        if not element.properties and element.rows:
            return unreadable(f"element {element.name} has no properties")
    vertex = by_name.get("vertex", Element("vertex", 0, ()))
    places = [vertex.place(name) for name in "xyz"]
    xyz = [place for place in places if place is not None and not vertex.properties[place].count]
    if len(xyz) != 3:
        return unreadable("no scalar properties x, y, z of the element vertex")
    face = by_name.get("face", Element("face", 0, ()))
    lists = [place for name in _FACE_LISTS if (place := face.place(name)) is not None]
    good = [p for p in lists if face.properties[p].count and face.properties[p].code in INTEGERS]
    if face.rows and (len(lists) != 1 or good != lists):
        return unreadable("no one list property vertex_indices of integers of the element face")
    narrow = all(vertex.properties[place].code in WITHIN_BINARY32 for place in xyz)
    precision = Precision.F32 if narrow else Precision.F64
    x, y, z = xyz
    return _Shape(vertex.rows, face.rows, (x, y, z), lists[0] if lists else 0, precision)
