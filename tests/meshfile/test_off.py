"""OFF, written here by hand."""

import pytest
from mesh_expectations import is_square, mesh, rejected, unreadable

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.where import AtFace
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format

OFF = Format.OFF
BODY = "0 0 0.5\n1 0 0\n0 1 0\n1 1 -2\n3 0 1 2\n3 1 3 2\n"
SQUARE = f"OFF\n4 2 0\n{BODY}"


@pytest.mark.parametrize(
    "text",
    [
        SQUARE,
        f"OFF 4 2 0\n{BODY}",
        f"OFF\n4 2\n{BODY}",
        SQUARE.replace("\n", "\r\n"),
        SQUARE.replace("\n", "\r"),
        SQUARE.rstrip("\n"),
        f"# first\n\nOFF # the header\n# c_o_u_n_t_s\n  4\t2 5 # edges\n\n{BODY}\n# last",
        SQUARE.replace("OFF", "COFF").replace("0 1 0\n", "0 1 0 255 0 0 255\n"),
        SQUARE.replace("OFF", "NOFF").replace("1 0 0\n", "1 0 0 0 0 1\n"),
        SQUARE.replace("OFF", "STCNOFF"),
        SQUARE.replace("3 1 3 2", "3 1 3 2 0.5 0.25 1 1"),
        SQUARE.replace("1 1 -2", "1. +1 -.2E1"),
    ],
)
def test_variants(text: str) -> None:
    """Clauses: TOOL-OFF-1, TOOL-READ-2, TOOL-READ-3, TOOL-READ-8."""
    is_square(OFF, text.encode(), Precision.F32)


def test_decimals_are_binary64_unless_all_are_binary32() -> None:
    """Clauses: TOOL-READ-7, TOOL-READ-8; 0.1 is 3602879701896397 / 2^55 in binary64."""
    read = mesh(OFF, SQUARE.replace("0.5", "0.1").encode())
    assert read.coordinates[2] == 3602879701896397 / 2**55
    assert read.precision == Precision.F64


def test_not_finite_and_not_sound_stay() -> None:
    """Clauses: TOOL-READ-9, TOOL-READ-2."""
    text = SQUARE.replace("1 1 -2", "NaN inf -0").replace("3 1 3 2", "3 9 -1 9")
    read = mesh(OFF, text.encode())
    assert read.faces.faces[1] == (9, -1, 9)
    assert read.coordinates[9] != read.coordinates[9]
    assert read.coordinates[10] == float("inf")
    assert read.coordinates[11].hex() == "-0x0.0p+0"


@pytest.mark.parametrize(
    ("line", "corners"), [("4 0 1 2 3", 4), ("2 0 1", 2), ("0", 0), ("1 3", 1), ("5 0 1 2 3 0", 5)]
)
def test_faces_that_are_no_triangles(line: str, corners: int) -> None:
    """Clause: TOOL-READ-4."""
    data = SQUARE.replace("3 1 3 2", line).encode()
    says = f"{corners} corners"
    rejected(OFF, data, Reason.NOT_TRIANGLES, Clause.TOOL_READ_4, AtFace(1), says)


@pytest.mark.parametrize("text", ["4OFF\n", "nOFF\n", "STCN4nOFF\n", "OFF BINARY\n\x00\x01"])
def test_other_variants_are_unknown(text: str) -> None:
    """Clauses: TOOL-READ-1, TOOL-OFF-1."""
    rejected(OFF, text.encode(), Reason.UNKNOWN_FORMAT, Clause.TOOL_READ_1, says="OFF")


def test_limits_come_before_the_body() -> None:
    """Clause: TOOL-READ-6."""
    text = SQUARE.replace("4 2 0", "4 99999999999999999999 0")
    rejected(OFF, text.encode(), Reason.TOO_MANY_FACES, Clause.TOOL_READ_6, says="99999999999")
    few = Limits(faces=2, vertices=3)
    rejected(OFF, SQUARE.encode(), Reason.TOO_MANY_VERTICES, Clause.TOOL_READ_6, limits=few)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "empty"),
        ("# nothing\n", "empty"),
        ("4 2 0\n", "line 1: no OFF header"),
        ("OFF", "line 1: no numbers"),
        ("OFF\n4\n", "line 2: no numbers"),
        ("OFF\n4 2 0 0\n", "line 2: no numbers"),
        ("OFF\n4 -2 0\n", "line 2: no numbers"),
        ("OFF\n4 2.0 0\n", "line 2: no numbers"),
        ("OFF\n4 2_0 0\n", "line 2: no numbers"),
        (SQUARE.replace("0 1 0", "0 1"), "line 5: no coordinates of vertex 2"),
        (SQUARE.replace("0 1 0", "0 1 z"), "line 5"),
        (SQUARE.replace("0 1 0", "0 1 0 red"), "line 5"),
        (SQUARE.replace("3 1 3 2", "3 1 3"), "line 8: no corners of face 1"),
        (SQUARE.replace("3 1 3 2", "-3 1 3 2"), "line 8"),
        (SQUARE.replace("3 1 3 2", "three 1 3 2"), "line 8"),
        (SQUARE.replace("3 1 3 2", "3 1 3 2.0"), "line 8: no numbers of face 1"),
        (SQUARE.replace("3 1 3 2", "3 1 3 2 red"), "line 8"),
        (SQUARE.replace("3 1 3 2\n", ""), "1 of 2 faces"),
        ("OFF\n4 2 0\n0 0 0\n", "1 of 4 vertices"),
        (SQUARE + "3 1 2 0\n", "line 9: after the last face"),
    ],
)
def test_what_is_no_off(text: str, says: str) -> None:
    """Clauses: TOOL-READ-5, TOOL-OFF-1."""
    unreadable(OFF, text.encode(), says)
