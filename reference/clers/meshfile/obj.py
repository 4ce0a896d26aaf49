"""OBJ: its polygons. Clause: TOOL-OBJ-1.

No loader library: trimesh 5.2 splits the faces by material, the last material first, drops vertices
that no face names where faces have texture corners, and takes corner −1 for the last vertex of the
whole file, whatever stands before the face.
"""

import re
from typing import Final

from clers.complexes.face_list import FaceList, Limits
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import narrowest
from clers.meshfile.faults import bad_line, not_a_triangle, over_limit
from clers.meshfile.mesh import RawMesh
from clers.meshfile.numeral import integer, reals

_STEPPED_OVER: Final = frozenset(
    b"vt vn vp g o s l p mg usemtl mtllib usemap maplib bevel c_interp d_interp lod shadow_obj"
    b" trace_obj".split()
)
_CORNER: Final = re.compile(rb"([+-]?[0-9]+)(?:/(?:[+-]?[0-9]+)?(?:/(?:[+-]?[0-9]+)?)?)?")
_CONTINUED: Final = re.compile(rb"\\\r?\n")


def parse(data: bytes, limits: Limits) -> Accepted[RawMesh] | Rejected:
    """The mesh that an OBJ file says. Clauses: TOOL-OBJ-1, TOOL-READ-2 … TOOL-READ-9."""
    coordinates: list[float] = []
    triangles: list[tuple[int, int, int]] = []
    vertices = 0
    for line, text in enumerate(_CONTINUED.sub(b" ", data).splitlines(), start=1):
        words = text.split(b"#", 1)[0].split()
        if not words or words[0] in _STEPPED_OVER:
            continue
        if words[0] == b"v":
            values = reals(words[1:])
            if values is None or len(values) < 3:
                return bad_line(line, f"no coordinates of vertex {vertices}")
            coordinates += values[:3]
            vertices += 1
        elif words[0] == b"f":
            triangle = _triangle(line, words[1:], vertices, len(triangles))
            if isinstance(triangle, Rejected):
                return triangle
            triangles.append(triangle)
        else:
            return bad_line(line, "no statement of an OBJ polygon mesh")
        fault = over_limit(vertices, len(triangles), limits)
        if fault is not None:
            return fault
    read = FaceList(tuple(triangles), vertices)
    return Accepted(RawMesh(read, tuple(coordinates), narrowest(coordinates)))


def _triangle(
    line: int, words: list[bytes], vertices: int, t: int
) -> tuple[int, int, int] | Rejected:
    numbers: list[int] = []
    for word in words:
        corner = _CORNER.fullmatch(word)
        number = integer(corner[1]) if corner else None
        if number is None:
            return bad_line(line, f"no corners of face {t}")
        numbers.append(number - 1 if number >= 0 else vertices + number)
    if len(numbers) != 3:
        return not_a_triangle(t, len(numbers))
    a, b, c = numbers
    return a, b, c
