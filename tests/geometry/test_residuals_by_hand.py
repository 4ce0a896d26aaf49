"""Prediction and residuals on examples worked out by hand."""

from fractions import Fraction
from typing import Final

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TETRAHEDRON, TRIANGLE
from clers.generate.families import sphere_of
from clers.geometry import quantised, residual
from clers.geometry.box import Box
from clers.geometry.lattice import (
    Quantised,
)
from clers.geometry.order import in_creation_order
from clers.geometry.predict import NONE, parallelogram_corners, residuals
from clers.geometry.quantised import Coded
from clers.geometry.residual import fold


def refusal(result: object) -> Rejected:
    """The rejection that a test expects."""
    assert isinstance(result, Rejected), result
    return result


def accepted_surface(*faces: tuple[int, int, int]) -> Surface:
    """A surface that a test writes down."""
    built = surface(FaceList(faces, 1 + max(map(max, faces))))
    assert isinstance(built, Accepted), built
    return built.value


CREATED_TETRAHEDRON: Final = accepted_surface((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
"""The tetrahedron in the order of creation."""


def test_parallelogram_of_two_triangles() -> None:
    """The square 0 = (0,0), 1 = (4,0), 2 = (0,4) predicts 3 at 1 + 2 − 0 = (4,4).

    Clauses: GEOM-PREDICT-1, GEOM-PREDICT-2.
    """
    square = accepted_surface((0, 1, 2), (3, 2, 1))
    assert parallelogram_corners(square) == (NONE, NONE, NONE, 3)
    flat = (0, 0, 0, 4, 0, 0, 0, 4, 0, 5, 3, 0)
    found = residuals(square, Box((0, 0, 0), (5, 4, 0)), flat)
    assert found == (0, 0, 0, 4, 0, 0, -4, 4, 0, 1, -1, 0)


def test_predictions_stay_in_the_box() -> None:
    """1 + 2 − 0 is (9, −1) here, in a box of (5, 4): it is moved to (5, 0).

    Clause: GEOM-PREDICT-2.
    """
    square = accepted_surface((0, 1, 2), (3, 2, 1))
    flat = (0, 4, 0, 5, 1, 0, 4, 2, 0, 3, 0, 0)
    found = residuals(square, Box((0, 0, 0), (5, 4, 0)), flat)
    assert found[9:] == (3 - 5, 0 - 0, 0)


def test_tetrahedron_predicts_its_last_vertex() -> None:
    """Vertex 3 lies across the edge from 2 to 1, opposite to 0. Clause: GEOM-PREDICT-4."""
    assert parallelogram_corners(CREATED_TETRAHEDRON) == (NONE, NONE, NONE, 3)


def test_folded_residuals_count_up() -> None:
    """Clause: GEOM-CODE-1."""
    assert [fold(r) for r in (0, -1, 1, -2, 2, -(1 << 30) + 1)] == [0, 1, 2, 3, 4, (1 << 31) - 3]


def test_one_triangle_of_two_places() -> None:
    """Box (1, 0, 0): on x the classes are 0, 1, 2; y and z have one class and cost nothing.

    The points 0, 1, 1 have the residuals 0, 1, 0 from the vertex before; folded 0, 2, 0; classes
    0, 2, 0 with one raw bit, 0, after the 2. Out of frequencies (1, 1, 1), (9, 1, 1) and (9, 1, 9)
    the slots are 0–1 of 3, 10–11 of 11, 0–1 of 2, 0–9 of 19: the interval begins at
    (1/3)(10/11) = 0.303030… and is (1/3)(1/11)(1/2)(9/19) = 0.007177 wide.
    Clauses: GEOM-CODE-2, GEOM-CODE-3, GEOM-CODE-4.
    """
    given = Quantised(-1, (7, 0, 0, 8, 0, 0, 8, 0, 0))
    coded = quantised.encode(TRIANGLE, given)
    assert isinstance(coded, Accepted)
    assert (coded.value.exponent, coded.value.box) == (-1, Box((7, 0, 0), (1, 0, 0)))
    digits = coded.value.bits.digits()
    low = 10 / 33
    assert low <= int(digits, 2) / 2 ** len(digits) < low + 9 / (3 * 11 * 2 * 19)
    assert len(digits) <= 10  # −log₂ 0.007177 = 7.12, and at most two more
    assert quantised.decode(TRIANGLE, coded.value) == Accepted(given)


def test_frequencies_are_halved() -> None:
    """Classes 0 on x, vertex after vertex: 1 + 8n, 1, 1 with total 3 + 8n, over 8192 at n = 1024.

    Then 8193 becomes 8193 − 4096 = 4097. Vertices 0, 1 and 2 of a sphere have no parallelogram.
    Clause: GEOM-CODE-2.
    """
    built = surface(sphere_of(2060))
    assert isinstance(built, Accepted)
    sphere = in_creation_order(built.value, encode(built.value))
    assert sphere.vertices > 3 + 1024
    state = residual.model(sphere, Box((0, 0, 0), (1, 0, 0)))
    tables = []
    for _ in range(sphere.vertices):
        tables.append(tuple(state.cumulative))
        state = state.after(0).after(0).after(0)
    assert tables[3 + 1023] == (0, 8185, 8186, 8187)
    assert tables[3 + 1024] == (0, 4097, 4098, 4099)


def test_four_corners() -> None:
    """The points (0,0,0), (2,0,0), (0,2,0), (0,0,2): four classes on each axis.

    Vertices 0 to 2 are predicted at the one before, with residuals 000, 200, −220; vertex 3 at
    1 + 2 − 0 = (2,2,0), with residuals −2 −2 2. Folded, 2 is 4: class 3, rest 00; −2 is 3: class 2,
    rest 1. The slots below follow vertex by vertex, x, y, z, each class before its rest.
    Clauses: GEOM-PREDICT-2, GEOM-CODE-1, GEOM-CODE-2, GEOM-CODE-3, GEOM-CODE-4.
    """
    slots = [
        *((0, 1, 4), (0, 1, 4), (0, 1, 4)),
        *((11, 12, 12), (0, 1, 4), (0, 9, 12), (0, 9, 12)),
        *((10, 11, 20), (1, 2, 2), (19, 20, 20), (0, 1, 4), (0, 17, 20)),
        *((2, 3, 4), (1, 2, 2), (2, 3, 4), (1, 2, 2), (3, 4, 4), (0, 1, 4)),
    ]
    low, width = Fraction(0), Fraction(1)
    for below, upto, total in slots:
        low += width * below / total
        width *= Fraction(upto - below, total)
    corner = Quantised(0, (0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2))
    coded = quantised.encode(CREATED_TETRAHEDRON, corner)
    assert isinstance(coded, Accepted)
    bits = coded.value.bits
    number = Fraction(int(bits.digits(), 2), 2**bits.length)
    assert low <= number < number + Fraction(1, 2**bits.length) <= low + width
    assert 2**bits.length * width < 8  # two bits more than the information content, rounded up


@pytest.mark.parametrize(
    ("clause", "coded"),
    [
        (Clause.GEOM_LATTICE_1, Coded(972, Box((0, 0, 0), (0, 0, 0)), Bits(b"\x40", 2))),
        (Clause.GEOM_LATTICE_1, Coded(0, Box((-(1 << 53), 0, 0), (0, 0, 0)), Bits(b"\x40", 2))),
        (Clause.GEOM_LATTICE_1, Coded(0, Box((0, 0, (1 << 53) - 1), (0, 0, 1)), Bits(b"\x40", 2))),
        (Clause.GEOM_BOX_2, Coded(0, Box((0, 0, 0), (1 << 30, 0, 0)), Bits(b"\x40", 2))),
        (Clause.GEOM_BOX_2, Coded(0, Box((0, 0, 0), (-1, 0, 0)), Bits(b"\x40", 2))),
    ],
)
def test_boxes_off_the_lattice_are_refused(clause: Clause, coded: Coded) -> None:
    """Clauses: GEOM-LATTICE-1, GEOM-BOX-2."""
    found = refusal(quantised.decode(TRIANGLE, coded))
    assert (found.reason, found.clause) == (Reason.BAD_LATTICE, clause)


def test_the_largest_lattice_number_is_accepted() -> None:
    """Clause: GEOM-LATTICE-1."""
    for low in ((1 << 53) - 1, 1 - (1 << 53)):
        coded = Coded(0, Box((low, 0, 0), (0, 0, 0)), pack([0, 1]))
        assert quantised.decode(TRIANGLE, coded) == Accepted(Quantised(0, (low, 0, 0) * 3))


def test_a_box_that_is_not_tight_is_refused() -> None:
    """All residuals 0 in a box that claims an extent of 1. Clause: GEOM-RESIDUAL-2."""
    box = Box((0, 0, 0), (1, 0, 0))
    bits = residual.encode(TRIANGLE, box, (0,) * 9)
    assert isinstance(bits, Accepted)
    found = refusal(quantised.decode(TRIANGLE, Coded(0, box, bits.value)))
    assert (found.reason, found.where) == (Reason.BAD_RESIDUAL, WHOLE)


def test_a_box_that_does_not_begin_at_its_low_is_refused() -> None:
    """All indices 1 in a box of extent 1. Clause: GEOM-RESIDUAL-2."""
    box = Box((0, 0, 0), (1, 0, 0))
    bits = residual.encode(TRIANGLE, box, (1, *(0,) * 8))
    assert isinstance(bits, Accepted)
    found = refusal(quantised.decode(TRIANGLE, Coded(0, box, bits.value)))
    assert (found.reason, found.where) == (Reason.BAD_RESIDUAL, WHOLE)


def test_no_residual_takes_no_bits() -> None:
    """All extents 0: nothing is left to say but 01, the empty message. Clause: GEOM-CODE-3."""
    assert quantised.decode(TRIANGLE, Coded(0, Box((0, 0, 0), (0, 0, 0)), pack([0, 1]))) == (
        Accepted(Quantised(0, (0,) * 9))
    )


def test_residuals_of_another_surface_are_refused() -> None:
    """Clause: GEOM-CODE-4."""
    found = refusal(residual.encode(TETRAHEDRON, Box((0, 0, 0), (0, 0, 0)), (0,) * 9))
    assert (found.reason, found.clause) == (Reason.COUNT_MISMATCH, Clause.GEOM_CODE_4)


def test_positions_for_another_surface_are_refused() -> None:
    """Clauses: GEOM-MESH-1, GEOM-CODE-4."""
    found = refusal(quantised.encode(TETRAHEDRON, Quantised(0, (0,) * 9)))
    assert found.reason is Reason.COUNT_MISMATCH
