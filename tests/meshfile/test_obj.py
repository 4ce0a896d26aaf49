"""OBJ, written here by hand."""

import pytest
from mesh_expectations import is_square, mesh, rejected, unreadable

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.where import AtFace
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format

OBJ = Format.OBJ
VERTICES = "v 0 0 0.5\nv 1 0 0\nv 0 1 0\nv 1 1 -2\n"
SQUARE = f"{VERTICES}f 1 2 3\nf 2 4 3\n"


@pytest.mark.parametrize(
    "text",
    [
        SQUARE,
        SQUARE.replace("\n", "\r\n"),
        SQUARE.replace("1 0 0", "1 0 0 1"),
        SQUARE.replace("1 0 0", "1 0 0 0.5 0.5 0.5"),
        f"{VERTICES}f 1/1 2/2 3/3\nf 2/4 4/5 3/6\nvt 0 0\nvt 1 1\n",
        f"{VERTICES}f 1//1 2//1 3//1\nf 2/1/1 4/2/2 3/3/3\n",
        f"{VERTICES}f 1/ 2// 3/1/\nf -3 -1 -2\n",
        "v 0 0 0.5\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 -2\nf -3 -1/-1 -2//-1\n",
        f"f 1 2 3\n{VERTICES}f 2 4 3\n",
        f"mtllib a_b.mtl\no c_1\n{VERTICES}g\nusemtl d\nf 1 2 3\ns off\nusemtl e\nf 2 4 3\n",
        f"# note\n\n{VERTICES}  f\t1 2 3 # one\nf 2 \\\n 4 \\\r\n3\nl 1 2\np 1\nvn 0 0 1\n",
        SQUARE + "vp 1 2\nusemap x\n",
    ],
)
def test_variants(text: str) -> None:
    """Clauses: TOOL-OBJ-1, TOOL-READ-2, TOOL-READ-3: materials and textures split nothing."""
    is_square(OBJ, text.encode(), Precision.F32)


def test_names_in_any_encoding() -> None:
    """Clause: TOOL-READ-3."""
    is_square(OBJ, b"o \xff\xfe\x85 name\n" + SQUARE.encode(), Precision.F32)


def test_numbers_of_no_vertex_stay() -> None:
    """Clauses: TOOL-OBJ-1, TOOL-READ-2."""
    read = mesh(OBJ, f"{VERTICES}f 0 9 1\nf -4 -5 -6\nf 2 2 2\n".encode())
    assert read.faces.faces == ((-1, 8, 0), (0, -1, -2), (1, 1, 1))
    assert read.faces.vertices == 4


def test_decimals() -> None:
    """Clauses: TOOL-READ-7, TOOL-READ-8, TOOL-READ-9."""
    read = mesh(OBJ, b"v 0.1 1e400 -nan\n")
    assert read.coordinates[:2] == (3602879701896397 / 2**55, float("inf"))
    assert read.coordinates[2] != read.coordinates[2]
    assert read.precision == Precision.F64


@pytest.mark.parametrize(("words", "corners"), [("", 0), ("1", 1), ("1 2", 2), ("1 2 4 3", 4)])
def test_faces_that_are_no_triangles(words: str, corners: int) -> None:
    """Clause: TOOL-READ-4."""
    data = f"{VERTICES}f 1 2 3\nf {words}\nf 1 2 3 4 1\n".encode()
    says = f"{corners} corners"
    rejected(OBJ, data, Reason.NOT_TRIANGLES, Clause.TOOL_READ_4, AtFace(1), says)


def test_limits() -> None:
    """Clause: TOOL-READ-6."""
    data = SQUARE.encode()
    few = Limits(faces=1, vertices=4)
    rejected(OBJ, data, Reason.TOO_MANY_FACES, Clause.TOOL_READ_6, says="2 faces", limits=few)
    few = Limits(faces=2, vertices=3)
    rejected(OBJ, data, Reason.TOO_MANY_VERTICES, Clause.TOOL_READ_6, says="4 v", limits=few)
    mesh(OBJ, data, Limits(faces=2, vertices=4))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("v 0 0\n", "line 1: no coordinates of vertex 0"),
        ("v 0 0 0\n\nv 0 0 x\n", "line 3: no coordinates of vertex 1"),
        ("v 0 0 0 x\n", "line 1"),
        ("v 0 0 1_0\n", "line 1"),
        ("v 0 0 0x1p3\n", "line 1"),
        (SQUARE.replace("f 2 4 3", "f 2 4 x"), "line 6: no corners of face 1"),
        (SQUARE.replace("f 2 4 3", "f 2 4 3.0"), "line 6"),
        (SQUARE.replace("f 2 4 3", "f 2 4 /3"), "line 6"),
        (SQUARE.replace("f 2 4 3", "f 2 4 3/1/1/1"), "line 6"),
        (SQUARE.replace("f 2 4 3", "f 2 4 3/a"), "line 6"),
        (SQUARE.replace("f 2 4 3", f"f 2 4 {'9' * 5000}"), "line 6"),
        ("curv 0 1 1 2 3\n", "line 1: no statement"),
        ("surf 0 1 0 1 1 2 3\n", "line 1"),
        ("fo 1 2 3\n", "line 1"),
        ("V 0 0 0\n", "line 1"),
        ("\x00\x01\x02", "line 1"),
    ],
)
def test_what_is_no_obj(text: str, says: str) -> None:
    """Clauses: TOOL-READ-5, TOOL-OBJ-1, TOOL-READ-7."""
    unreadable(OBJ, text.encode(), says)
