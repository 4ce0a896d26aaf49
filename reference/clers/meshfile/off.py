"""OFF, in ASCII. Clause: TOOL-OFF-1.

No loader library: trimesh 5.2 triangulates quadrilaterals behind the file's own triangles, and
reads a file that ends before its last face.
"""

import re
from collections.abc import Iterator
from typing import Final

from clers.complexes.face_list import FaceList, Limits
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import narrowest
from clers.meshfile.faults import bad_line, not_a_triangle, over_limit, unreadable
from clers.meshfile.formats import unknown
from clers.meshfile.mesh import RawMesh
from clers.meshfile.numeral import integer, reals

Row = tuple[int, list[bytes]]
"""A line's number, from 1, and its words."""

_HEADER: Final = re.compile(rb"(?:ST)?C?N?OFF")
_OTHER_SPACE: Final = re.compile(rb"(?:ST)?C?N?4?n?OFF")


def parse(data: bytes, limits: Limits) -> Accepted[RawMesh] | Rejected:
    """The mesh that an OFF file says. Clauses: TOOL-OFF-1, TOOL-READ-2 … TOOL-READ-9."""
    rows = _rows(data)
    sizes = _sizes(rows)
    if isinstance(sizes, Rejected):
        return sizes
    vertices, faces = sizes
    fault = over_limit(vertices, faces, limits)
    if fault is not None:
        return fault

    coordinates: list[float] = []
    for v in range(vertices):
        line, words = next(rows, (0, []))
        if not line:
            return unreadable(f"{v} of {vertices} vertices")
        values = reals(words)
        if values is None or len(values) < 3:
            return bad_line(line, f"no coordinates of vertex {v}")
        coordinates += values[:3]

    triangles: list[tuple[int, int, int]] = []
    for t in range(faces):
        line, words = next(rows, (0, []))
        if not line:
            return unreadable(f"{t} of {faces} faces")
        triangle = _triangle(line, words, t)
        if isinstance(triangle, Rejected):
            return triangle
        triangles.append(triangle)

    line, words = next(rows, (0, []))
    if words:
        return bad_line(line, "after the last face")
    read = FaceList(tuple(triangles), vertices)
    return Accepted(RawMesh(read, tuple(coordinates), narrowest(coordinates)))


def _rows(data: bytes) -> Iterator[Row]:
    """The lines that say something."""
    for line, text in enumerate(data.splitlines(), start=1):
        words = text.split(b"#", 1)[0].split()
        if words:
            yield line, words


def _sizes(rows: Iterator[Row]) -> tuple[int, int] | Rejected:
    """The numbers of vertices and faces, from the header and the counts."""
    line, words = next(rows, (0, []))
    if not line:
        return unreadable("empty")
    header, *rest = words
    if _OTHER_SPACE.fullmatch(header) and not _HEADER.fullmatch(header):
        return unknown(f"OFF of another dimension: {header.decode()}")
    if not _HEADER.fullmatch(header):
        return bad_line(line, "no OFF header")
    if rest == [b"BINARY"]:
        return unknown("OFF BINARY")
    if not rest:
        line, rest = next(rows, (line, []))
    counts = [count for count in map(integer, rest) if count is not None and count >= 0]
    if len(counts) != len(rest) or len(counts) not in (2, 3):
        return bad_line(line, "no numbers of vertices, faces and edges")
    return counts[0], counts[1]


def _triangle(line: int, words: list[bytes], t: int) -> tuple[int, int, int] | Rejected:
    corners = integer(words[0])
    if corners is None or len(words) <= corners:
        return bad_line(line, f"no corners of face {t}")
    numbers = [number for number in map(integer, words[1 : corners + 1]) if number is not None]
    if len(numbers) != corners or reals(words[corners + 1 :]) is None:
        return bad_line(line, f"no numbers of face {t}")
    if corners != 3:
        return not_a_triangle(t, corners)
    a, b, c = numbers
    return a, b, c
