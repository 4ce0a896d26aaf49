"""Whole files written by hand: what is written and read."""

from fractions import Fraction
from struct import pack

import pytest
from by_hand import TETRAHEDRON, WORD, crc, file, section

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList, Limits
from clers.container.contents import VERSION as SPEC_VERSION
from clers.container.file import decode, encode, inspect, options_of
from clers.container.head import Head, PositionCoding
from clers.container.layout import Window, read, write
from clers.container.limits import DEFAULT_FILE_LIMITS, FileLimits
from clers.container.numbers import U8, U32
from clers.container.options import Exact, InBits, OnLattice, Options, WithinError
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte, AtVertex
from clers.edgebreaker.encode import encode as encode_walk
from clers.edgebreaker.examples import ANNULUS, TORUS
from clers.edgebreaker.examples import TETRAHEDRON as SURFACE
from clers.geometry.mesh import Mesh
from clers.geometry.positions import Positions, Precision

PLAIN = Options(CodeName.PLAIN)
CORNER = Positions(Precision.F32, (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))


def test_crc_of_the_catalogue() -> None:
    """The check value that catalogues of CRCs give for CRC-32. Clause: FILE-SECTION-2."""
    assert crc(b"123456789") == bytes.fromhex("26 39 f4 cb")


def test_the_tetrahedron_is_fifty_bytes() -> None:
    """FILE-MAGIC-1, FILE-MAGIC-2, FILE-SECTION-1, FILE-HEAD-1, FILE-HEAD-2, FILE-WORD-1."""
    assert len(TETRAHEDRON) == 8 + 1 + (16 + 7) + (16 + 2)
    assert encode(SURFACE, None, PLAIN) == Accepted(TETRAHEDRON)
    found = decode(TETRAHEDRON)
    assert isinstance(found, Accepted)
    assert found.value.positions is None
    assert list(found.value.surface.triangles()) == [(0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0)]


def test_exact_positions() -> None:
    """Clauses: FILE-HEAD-3, FILE-POSN-1, FILE-OPTION-1, FILE-LAYOUT-4."""
    one = "00 00 80 3f"
    zero = "00 00 00 00"
    places = " ".join((zero, zero, zero, one, zero, zero, zero, one, zero, zero, zero, one))
    expected = file(("HEAD", "01 02 04 04 00 03 00"), ("WORD", WORD), ("POSN", places))
    assert encode(SURFACE, CORNER, PLAIN) == Accepted(expected)
    assert decode(expected) == Accepted(Mesh(_decoded().surface, CORNER))
    double = Positions(Precision.F64, CORNER.coordinates)
    doubles = "".join(pack("<d", x).hex() for x in CORNER.coordinates)
    expected = file(("HEAD", "01 03 04 04 00 03 00"), ("WORD", WORD), ("POSN", doubles))
    assert encode(SURFACE, double, PLAIN) == Accepted(expected)


def test_quantised_positions_of_one_place() -> None:
    """All at (−3, 2, 0)·2^−1: exponent −1 is 01, lows 05 04 00, extents 00, bits 01 in two.

    Clauses: FILE-POSN-2, FILE-NUMBER-4, FILE-BITS-1.
    """
    given = Positions(Precision.F32, (-1.5, 1.0, 0.0) * 4)
    expected = file(
        ("HEAD", "01 04 04 04 00 03 00"), ("WORD", WORD), ("POSN", "01 05 04 00 00 00 00 02 40")
    )
    assert encode(SURFACE, given, Options(CodeName.PLAIN, OnLattice(-1))) == Accepted(expected)
    assert decode(expected) == Accepted(Mesh(_decoded().surface, given))
    assert options_of(expected) == Accepted(Options(CodeName.PLAIN, OnLattice(-1)))


@pytest.mark.parametrize("accuracy", [InBits(2), WithinError(0.25), OnLattice(-1)])
def test_three_ways_to_ask_for_one_lattice(accuracy: InBits | WithinError | OnLattice) -> None:
    """Clause: FILE-OPTION-1."""
    expected = encode(SURFACE, CORNER, Options(CodeName.GOLDEN, OnLattice(-1)))
    assert encode(SURFACE, CORNER, Options(accuracy=accuracy)) == expected


def test_defaults() -> None:
    """Clauses: FILE-OPTION-1, FILE-LIMIT-1."""
    assert Options() == Options(CodeName.GOLDEN, Exact())
    assert FileLimits(1 << 31, Limits(1 << 26, 1 << 26)) == DEFAULT_FILE_LIMITS


def test_numbers_of_fixed_width() -> None:
    """Clause: FILE-NUMBER-2."""
    assert write(U32, 0x01020304) == bytes((4, 3, 2, 1))
    assert read(U32, Window(bytes((4, 3, 2, 1)), 4)) == Accepted(0x01020304)
    assert write(U8, 255) == b"\xff"


def test_handle_data_of_the_torus() -> None:
    """The page's slots: 1/5, 1/2, kind and side 1/2, 1/5, 1/2; then 1/7, 3/4, 3/4, 1/7, 1/4.

    Clauses: FILE-HAND-1, FILE-HAND-2, CODE-HAND-4.
    """
    slots = [(1, 1, 5), (1, 1, 2), (0, 1, 2), (0, 1, 2), (1, 1, 5), (1, 1, 2)]
    slots += [(0, 1, 7), (0, 3, 4), (0, 3, 4), (4, 1, 7), (1, 1, 4)]
    low, width = Fraction(0), Fraction(1)
    for below, frequency, total in slots:
        low, width = low + width * below / total, width * frequency / total
    bits = 18
    number = Fraction(0x4EC080 >> 24 - bits, 1 << bits)
    assert low <= number < number + Fraction(1, 1 << bits) <= low + width
    assert section("HAND", bytes.fromhex("12 4e c0 80")) in _encoded(TORUS)


def test_handle_data_of_the_annulus() -> None:
    """(0, boundary, right, 2) for six symbols, three sizes: 1/3, 1/2, 1/2, 1/3 and a digit.

    That is from 15/72 to 16/72. Both begin with 0011; then the ends are 24/72 and 40/72: a central
    half is taken, and 0 and twice 1 end the bits. Clauses: FILE-HAND-1, CODE-HAND-4.
    """
    assert section("HAND", bytes.fromhex("07 36")) in _encoded(ANNULUS)


def _encoded(surface: object) -> bytes:
    assert surface is TORUS or surface is ANNULUS
    found = encode(TORUS if surface is TORUS else ANNULUS, None, PLAIN)
    assert isinstance(found, Accepted)
    return found.value


def _decoded() -> Mesh:
    found = decode(TETRAHEDRON)
    assert isinstance(found, Accepted)
    return found.value


def test_inspection() -> None:
    """Clause: FILE-INSPECT-1."""
    found = inspect(TETRAHEDRON)
    assert isinstance(found, Accepted)
    assert found.value.version == SPEC_VERSION == 1
    assert found.value.head == Head(CodeName.PLAIN, PositionCoding.NONE, 4, 4, 0, 3, 0)
    places = [(s.tag, s.start, s.stop) for s in found.value.sections]
    assert places == [("HEAD", 21, 28), ("WORD", 44, 46)]


def test_limits() -> None:
    """Exactly the size is accepted, one less is not. Clauses: FILE-LIMIT-1, FILE-LIMIT-2."""

    def reason(size: int, faces: int, vertices: int) -> Reason | None:
        found = decode(TETRAHEDRON, FileLimits(size, Limits(faces, vertices)))
        return found.reason if isinstance(found, Rejected) else None

    assert reason(50, 4, 4) is None
    assert reason(49, 4, 4) is Reason.TOO_MANY_BYTES
    assert reason(50, 3, 4) is Reason.TOO_MANY_FACES
    assert reason(50, 4, 3) is Reason.TOO_MANY_VERTICES
    assert {r.fault for r in (Reason.TOO_MANY_BYTES, Reason.TOO_MANY_FACES)} == {Fault.LIMIT}


def test_more_symbols_than_the_limit() -> None:
    """Clause: FILE-LIMIT-2."""
    data = file(("HEAD", "01 01 04 04 00 05 00"), ("WORD", WORD))
    found = decode(data, FileLimits(1000, Limits(4, 4)))
    assert isinstance(found, Rejected)
    told = (found.reason, found.clause, found.where)
    assert told == (Reason.TOO_MANY_FACES, Clause.FILE_LIMIT_2, AtByte(21, "HEAD"))


def test_a_vertex_is_blamed_by_the_number_it_was_given() -> None:
    """In the order of creation the vertices are 1, 2, 0. Clause: GEOM-LATTICE-3."""
    alone = surface(FaceList(((0, 1, 2),), 3))
    assert isinstance(alone, Accepted)
    assert encode_walk(alone.value).vertex_order == (1, 2, 0)
    far = Positions(Precision.F64, (1e300, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
    found = encode(alone.value, far, Options(CodeName.PLAIN, OnLattice(0)))
    assert isinstance(found, Rejected)
    assert (found.clause, found.where) == (Clause.GEOM_LATTICE_3, AtVertex(0))


def test_positions_for_another_surface_are_not_written() -> None:
    """Clauses: GEOM-MESH-1, CONV-RESULT-1."""
    found = encode(SURFACE, Positions(Precision.F64, (0.0, 0.0, 0.0)))
    assert isinstance(found, Rejected)
    assert found.reason is Reason.COUNT_MISMATCH
