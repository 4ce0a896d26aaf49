"""PLY in all its variants, written here by hand."""

from struct import pack

import pytest
from mesh_expectations import PLACES, SQUARE, is_square, mesh, rejected, unreadable

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.where import AtByte, AtFace
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format

PLY = Format.PLY
XYZ = "property float x\nproperty float y\nproperty float z\n"
FACES = "element face 2\nproperty list uchar int vertex_indices\n"
END = "end_header\n"
TEXT_BODY = "0 0 0.5\n1 0 0\n0 1 0\n1 1 -2\n3 0 1 2\n3 1 3 2\n"


def head(form: str, rest: str = f"element vertex 4\n{XYZ}{FACES}") -> bytes:
    return f"ply\nformat {form} 1.0\n{rest}{END}".encode()


def body(order: str, scalar: str = "f", count: str = "B", index: str = "i") -> bytes:
    faces = b"".join(pack(f"{order}{count}3{index}", 3, *corners) for corners in SQUARE)
    places = (int(x) if scalar in "bBhHiI" else x for x in PLACES)
    return pack(f"{order}12{scalar}", *places) + faces


ASCII = head("ascii") + TEXT_BODY.encode()
LITTLE = head("binary_little_endian") + body("<")
BIG = head("binary_big_endian") + body(">")


@pytest.mark.parametrize("data", [ASCII, LITTLE, BIG], ids=["ascii", "little", "big"])
def test_the_three_encodings(data: bytes) -> None:
    """Clauses: TOOL-PLY-1, TOOL-READ-2."""
    is_square(PLY, data, Precision.F32)


@pytest.mark.parametrize("newline", [b"\r\n", b"\r"])
def test_other_ends_of_lines(newline: bytes) -> None:
    """Clause: TOOL-PLY-1. A binary body may begin with a byte that is an end of line."""
    is_square(PLY, ASCII.replace(b"\n", newline), Precision.F32)
    lines = head("binary_little_endian").replace(b"\n", newline)
    is_square(PLY, lines + body("<"), Precision.F32)
    first = pack("<f", 0.0)
    low = pack("<I", 0x3F00000A)  # a binary32 whose first byte is a line feed
    read = mesh(PLY, lines + low + body("<")[len(first) :])
    assert read.coordinates[0] == 0x80000A / 2**24
    assert read.coordinates[1:] == PLACES[1:]


@pytest.mark.parametrize(
    ("name", "code", "precision"),
    [
        ("float32", "f", Precision.F32),
        ("double", "d", Precision.F64),
        ("float64", "d", Precision.F64),
        ("char", "b", Precision.F32),
        ("short", "h", Precision.F32),
        ("int", "i", Precision.F64),
        ("int32", "i", Precision.F64),
    ],
)
def test_types_of_coordinates(name: str, code: str, precision: Precision) -> None:
    """Clauses: TOOL-READ-8, TOOL-PLY-1."""
    lines = head("binary_big_endian").replace(b"property float", f"property {name}".encode())
    read = mesh(PLY, lines + body(">", code))
    whole = tuple(float(int(x)) for x in PLACES)
    assert read.coordinates == (PLACES if code in "fd" else whole)
    assert all(type(x) is float for x in read.coordinates)
    assert read.precision == precision


def test_mixed_types_of_coordinates_are_f64() -> None:
    """Clause: TOOL-READ-8."""
    data = ASCII.replace(b"property float y", b"property double y")
    is_square(PLY, data, Precision.F64)


@pytest.mark.parametrize(
    ("count", "index", "codes"),
    [
        ("uint8", "uint", "BI"),
        ("int", "short", "ih"),
        ("ushort", "uchar", "HB"),
        ("char", "int8", "bb"),
    ],
)
def test_types_of_corners(count: str, index: str, codes: str) -> None:
    """Clause: TOOL-PLY-1."""
    lines = head("binary_little_endian").replace(b"uchar int", f"{count} {index}".encode())
    is_square(PLY, lines + body("<", "f", *codes), Precision.F32)


def test_what_is_stepped_over() -> None:
    """Clauses: TOOL-READ-3, TOOL-PLY-1: properties around, lists in vertices, elements around."""
    lines = (
        "comment made by hand\nobj_info none\n"
        "element extra 2\nproperty list int double many\nproperty uchar one\n"
        "element face 2\nproperty uchar red\nproperty list uchar uint vertex_index\n"
        "property list uchar float texcoord\n"
        "element vertex 4\nproperty list uchar short tags\nproperty float y\nproperty double nx\n"
        "property float x\nproperty float z\n"
        "element last 1\nproperty int n\n"
    )
    faces = b"".join(pack(">BB3IBff", 9, 3, *corners, 2, 0.5, 0.25) for corners in SQUARE)
    points = [PLACES[i : i + 3] for i in range(0, 12, 3)]
    vertices = b"".join(pack(">BhfdffX".strip("X"), 1, 7, y, 8.0, x, z) for x, y, z in points)
    extra = pack(">iddB", 2, 1.0, 2.0, 3) + pack(">iB", 0, 4)
    binary = head("binary_big_endian", lines) + extra + faces + vertices + pack(">i", -1)
    is_square(PLY, binary, Precision.F32)
    text = "2 1 2 3\n0 4\n" + "".join(f"9 3 {a} {b} {c} 2 .5 .25\n" for a, b, c in SQUARE)
    text += "".join(f"1 7 {y} 8 {x} {z}\n" for x, y, z in points) + "-1\n"
    is_square(PLY, head("ascii", lines) + text.encode(), Precision.F32)


def test_numbers_of_no_vertex_and_unused_vertices_stay() -> None:
    """Clause: TOOL-READ-2: chapter 3 judges, not the reader."""
    faces = ((0, 0, 0), (-1, 7, 2147483647), (2, 1, 0), (2, 1, 0))
    text = "".join(f"3 {a} {b} {c}\n" for a, b, c in faces)
    lines = head("ascii").replace(b"face 2", b"face 4")
    read = mesh(PLY, lines + b"0 0 0\n" * 4 + text.encode())
    assert read.faces.faces == faces
    assert read.faces.vertices == 4


def test_decimals_of_a_float_property_are_rounded_to_it() -> None:
    """Clauses: TOOL-READ-7, TOOL-READ-9; 0.1 is 13421773 / 2^27 in binary32."""
    data = ASCII.replace(b"0 0 0.5", b"0.1 1e39 nan").replace(b"1 1 -2", b"-Infinity -0 16777217")
    read = mesh(PLY, data)
    assert read.coordinates[0] == 13421773 / 2**27
    assert read.coordinates[1] == float("inf")
    assert read.coordinates[2] != read.coordinates[2]
    assert read.coordinates[9] == float("-inf")
    assert read.coordinates[10].hex() == "-0x0.0p+0"
    assert read.coordinates[11] == 16777216.0


def test_no_faces() -> None:
    """Clause: TOOL-PLY-1."""
    read = mesh(PLY, head("ascii", f"element vertex 1\n{XYZ}") + b"1 2 3\n")
    assert (read.faces.faces, read.faces.vertices) == ((), 1)


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
def test_faces_that_are_no_triangles(form: str) -> None:
    """Clause: TOOL-READ-4: also where the first face is one."""
    text, binary = (
        b"0 0 0\n" * 4 + b"3 0 1 2\n4 0 1 2 3\n",
        bytes(48) + pack("<B3iB4i", 3, 0, 1, 2, 4, 0, 1, 2, 3),
    )
    data = head(form) + (text if form == "ascii" else binary)
    rejected(PLY, data, Reason.NOT_TRIANGLES, Clause.TOOL_READ_4, AtFace(1), "4 corners")


def test_limits_come_before_the_body() -> None:
    """Clause: TOOL-READ-6."""
    many = head("binary_little_endian").replace(b"vertex 4", b"vertex 99999999999999999999")
    rejected(PLY, many, Reason.TOO_MANY_VERTICES, Clause.TOOL_READ_6, says="99999999999999999999")
    few = Limits(faces=1, vertices=4)
    rejected(PLY, LITTLE, Reason.TOO_MANY_FACES, Clause.TOOL_READ_6, says="2 faces", limits=few)


def test_counts_that_are_only_said_take_no_memory() -> None:
    """Clause: TOOL-READ-6: elements that are stepped over have no limit, lists neither."""
    extra = "element extra 9999999999999\nproperty list uint double many\n"
    lines = head("binary_little_endian", extra + f"element vertex 4\n{XYZ}{FACES}")
    unreadable(PLY, lines, "within extra 0", AtByte(len(lines)))
    data = lines + pack("<I", 2**32 - 1) + bytes(80)
    unreadable(PLY, data, "within extra 0", AtByte(len(data)))
    unreadable(PLY, lines.replace(b"binary_little_endian", b"ascii"), "0 of 9999999999999")


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "no PLY header"),
        (b"plyx\n", "no PLY header"),
        (b"ply\nformat ascii 1.0\n", "the header does not end"),
        (b"ply\nend_header\n", "line 2"),
        (ASCII.replace(b"ascii 1.0", b"ascii 1.1"), "line 2"),
        (ASCII.replace(b"ascii", b"binary_middle_endian"), "line 2"),
        (ASCII.replace(b"format ascii 1.0\n", b"format ascii 1.0\n" * 2), "line 3"),
        (ASCII.replace(b"vertex 4", b"vertex four"), "line 3"),
        (ASCII.replace(b"vertex 4", b"vertex -4"), "line 3"),
        (ASCII.replace(b"element vertex 4\n", b"", 1), "line 3"),
        (ASCII.replace(b"property float y", b"property float x"), "line 5: second property x"),
        (ASCII.replace(b"float y", b"real y"), "line 5"),
        (ASCII.replace(b"list uchar", b"list float"), "line 8"),
        (ASCII.replace(b"face 2", b"vertex 2"), "line 7"),
        (ASCII.replace(b"float z", b"float w"), "x, y, z"),
        (ASCII.replace(b"property float z", b"property list uchar float z"), "x, y, z"),
        (ASCII.replace(b"uchar int", b"uchar float"), "vertex_indices"),
        (ASCII.replace(b"vertex_indices", b"vertices"), "vertex_indices"),
        (ASCII.replace(b"list uchar int", b"int"), "vertex_indices"),
        (ASCII.replace(b"end_header", b"element none 1\nend_header"), "none has no properties"),
        (ASCII.replace(b"element face 2", b"element tristrips 2"), "triangle strips"),
        (ASCII.replace(b"0 1 0", b"0 x 0"), "line 12: no vertex 2"),
        (ASCII.replace(b"0 1 0", b"0 1_0 0"), "line 12"),
        (ASCII.replace(b"0 1 0", b"0 1"), "line 12"),
        (ASCII.replace(b"0 1 0", b"0 1 0 0"), "line 12"),
        (ASCII.replace(b"3 1 3 2", b"3 1 3 2.5"), "line 15: no face 1"),
        (ASCII.replace(b"3 1 3 2", b"3 1 3 9999999999"), "line 15"),
        (ASCII.replace(b"3 1 3 2", b"3 1 3"), "line 15"),
        (ASCII.replace(b"3 1 3 2", b"-3 1 3 2"), "line 15"),
        (ASCII.replace(b"3 1 3 2\n", b""), "1 of 2 elements face"),
        (ASCII + b"\n\n7\n", "line 18: after the last element"),
    ],
)
def test_what_is_no_ply(data: bytes, says: str) -> None:
    """Clauses: TOOL-READ-5, TOOL-PLY-1, TOOL-READ-7."""
    unreadable(PLY, data, says)


def test_binary_of_another_length() -> None:
    """Clause: TOOL-READ-5."""
    start = len(head("binary_little_endian"))
    for cut in range(start, len(LITTLE)):
        where = "vertex" if cut < start + 48 else "face"
        unreadable(PLY, LITTLE[:cut], f"within {where}", AtByte(cut))
    unreadable(PLY, LITTLE + b"\n", "1 bytes after", AtByte(len(LITTLE)))
    lines = head("binary_little_endian").replace(b"uchar int", b"char int")
    unreadable(PLY, lines + bytes(48) + b"\xff", "length -1", AtByte(len(lines) + 49))
