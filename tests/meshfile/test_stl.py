"""STL, written here by hand."""

from struct import pack

import pytest
from mesh_expectations import mesh, rejected, unreadable

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.where import AtFace
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format

STL = Format.STL
TRIANGLES = (
    ((0.0, 0.0, 0.5), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    ((1.0, 0.0, -0.0), (1.0, 1.0, -2.0), (0.0, 1.0, 0.0)),
)
WELDED = (0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, -2.0)
BINARY = bytes(80) + pack("<I", 2)
for triangle in TRIANGLES:
    BINARY += pack("<12fH", 9.0, 9.0, 9.0, *(x for place in triangle for x in place), 77)


def facet(*places: tuple[float, float, float], normal: str = "0 0 1") -> str:
    vertices = "".join(f"   vertex {x} {y} {z}\n" for x, y, z in places)
    return f" facet normal {normal}\n  outer loop\n{vertices}  endloop\n endfacet\n"


FACETS = "".join(facet(*places) for places in TRIANGLES)
SEAM = "endsolid\nsolid\tb\n"
ASCII = f"solid a name\n{FACETS}endsolid a name\n"


@pytest.mark.parametrize(
    "data",
    [
        BINARY,
        b"solid" + BINARY[5:],
        ASCII.encode(),
        ASCII.upper().replace("\n", "\r\n").encode(),
        f"\n solid\n\n{FACETS}endsolid".encode(),
        f"solid facet\n{facet(*TRIANGLES[0])}{SEAM}{facet(*TRIANGLES[1])}endsolid b".encode(),
        f"solid a\nendsolid\n{ASCII}".encode(),
        ASCII.replace("0 0 1", "-nan(ind) x 1").encode(),
    ],
)
def test_variants(data: bytes) -> None:
    """Clause: TOOL-STL-1: welded by position, −0 as 0, numbered by first corners."""
    read = mesh(STL, data)
    assert read.faces.faces == ((0, 1, 2), (1, 3, 2))
    assert read.faces.vertices == 4
    assert read.coordinates == WELDED
    assert read.precision == Precision.F32


def test_the_first_corner_gives_the_bits() -> None:
    """Clause: TOOL-STL-1."""
    places = ((-0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    again = ((0.0, -0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    text = f"solid\n{facet(*places)}{facet(*again)}endsolid\n"
    read = mesh(STL, text.encode())
    assert read.faces.faces == ((0, 1, 2), (0, 2, 3))
    assert [x.hex() for x in read.coordinates[:3]] == ["-0x0.0p+0", "0x0.0p+0", "0x0.0p+0"]


def test_next_is_not_equal() -> None:
    """Clause: TOOL-STL-1: no tolerance; a triangle on one position is one vertex three times."""
    text = facet((1.0, 0.0, 0.0), (1.0000000000000002, 0.0, 0.0), (1.0, 0.0, 5e-324))
    read = mesh(STL, f"solid\n{text}{facet(*[(1.0, 0.0, 0.0)] * 3)}endsolid".encode())
    assert read.faces.faces == ((0, 1, 2), (0, 0, 0))
    assert read.precision == Precision.F64


def test_nan_is_where_its_bits_are() -> None:
    """Clauses: TOOL-STL-1, TOOL-READ-9."""
    text = f"solid\n{facet(*[(float('nan'), 0.0, float('inf'))] * 3)}endsolid"
    read = mesh(STL, text.encode())
    assert read.faces.faces == ((0, 0, 0),)
    assert read.faces.vertices == 1


def test_no_facets() -> None:
    """Clause: TOOL-STL-1."""
    for data in (bytes(84), b"solid\nendsolid\n"):
        assert mesh(STL, data).faces.faces == ()


@pytest.mark.parametrize("corners", [0, 2, 4])
def test_loops_that_are_no_triangles(corners: int) -> None:
    """Clause: TOOL-READ-4: also where all corners together would make triangles."""
    loop = facet(*[(float(i), 0.0, 0.0) for i in range(corners)])
    data = f"solid\n{facet(*TRIANGLES[0])}{loop * 3}endsolid\n".encode()
    says = f"{corners} corners"
    rejected(STL, data, Reason.NOT_TRIANGLES, Clause.TOOL_READ_4, AtFace(1), says)


def test_limits() -> None:
    """Clause: TOOL-READ-6."""
    few = Limits(faces=1, vertices=4)
    rejected(STL, BINARY, Reason.TOO_MANY_FACES, Clause.TOOL_READ_6, limits=few)
    few = Limits(faces=2, vertices=3)
    rejected(STL, BINARY, Reason.TOO_MANY_VERTICES, Clause.TOOL_READ_6, limits=few)
    mesh(STL, BINARY, Limits(faces=2, vertices=4))


NEITHER = "neither ASCII STL nor binary STL"


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", NEITHER),
        (BINARY[:-1], NEITHER),
        (BINARY + b"\0", NEITHER),
        (bytes(80) + b"\xff\xff\xff\xff", NEITHER),
        (b"solid" + BINARY[5:-1], NEITHER),
        (b"solidity\nendsolid\n", NEITHER),
        (b"solid\n", "the last solid does not end"),
        (ASCII.encode() + b"more\n", "line 17: no solid"),
        (ASCII.replace("endsolid", "solid").encode(), "line 16: no facet"),
        (ASCII.replace("facet normal", "facet", 1).encode(), "line 2"),
        (ASCII.replace("outer loop", "inner loop", 1).encode(), "line 3: no outer loop of facet 0"),
        (ASCII.replace("endloop", "end loop", 1).encode(), "line 7: no endloop"),
        (ASCII.replace(" endfacet\n", "", 1).encode(), "line 8: no endfacet"),
        (ASCII.replace("vertex 1.0 0.0 0.0", "vertex 1.0 0.0").encode(), "line 5: no three"),
        (ASCII.replace("vertex 1.0 0.0 0.0", "vertex 1.0 0.0 x").encode(), "line 5: no three"),
        (ASCII.replace("vertex 1.0 0.0 0.0", "vertex 1 0 0 0").encode(), "line 5: no three"),
    ],
)
def test_what_is_no_stl(data: bytes, says: str) -> None:
    """Clauses: TOOL-READ-5, TOOL-STL-1."""
    unreadable(STL, data, says)


@pytest.mark.parametrize("lines", range(1, 16))
def test_ascii_cut_off(lines: int) -> None:
    """Clause: TOOL-READ-5."""
    cut = "".join(ASCII.splitlines(keepends=True)[:lines])
    unreadable(STL, cut.encode(), "")
