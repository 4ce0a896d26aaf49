"""ERRATUM-1, 3, 4, 7, 8 and 12: the walk and its counts, as the tutorial tells them."""

from itertools import permutations

import pytest
from every_small_surface import from_every_gate, small_surfaces
from printed_walk import Printed, as_told

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.result import Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.edgebreaker.stream import Kind, Stream


def test_the_text_exchanges_left_and_right() -> None:
    """ERRATUM-1: the rule of 8(a) contradicts Figures 20 and 14, and its words are no surface's.

    EB-TRAVERSE-3, EB-TRAVERSE-4. The tetrahedron is the smallest closed surface.
    """
    assert encode(TETRAHEDRON).stream.word == "CRE"  # Figure 20
    assert encode(CUBE).stream.word == "CCCRCRRCRRE"  # Figure 14
    assert as_told(TETRAHEDRON) == "CLE"
    assert as_told(CUBE) == "CCCLCLLCLLE"
    assert isinstance(decode(Stream("CLE")), Rejected)
    assert all(
        faces >= 4 for faces, begun in small_surfaces(4) if components(begun[0])[0].curves == 0
    )


def _handle_splits(surface: Surface) -> int:
    return len(encode(surface).stream.records)


def test_the_formula_for_handle_splits_fails_on_closed_surfaces() -> None:
    """ERRATUM-3: 2g + b − 1 is −1 for a sphere and 1 for the torus of Figure 22, which has two."""
    (sphere,) = components(TETRAHEDRON)
    assert (2 * sphere.genus + sphere.curves - 1, _handle_splits(TETRAHEDRON)) == (-1, 0)
    (torus,) = components(TORUS)
    assert (2 * torus.genus + torus.curves - 1, _handle_splits(TORUS)) == (1, 2)


def test_the_formula_for_handle_splits_holds_with_boundary() -> None:
    """ERRATUM-3, EB-COUNT-4: on every surface of at most six faces that has a curve."""
    for surface in from_every_gate(6):
        (part,) = components(surface)
        if part.curves:
            assert _handle_splits(surface) == 2 * part.genus + part.curves - 1


def test_the_first_curve_has_no_split() -> None:
    """ERRATUM-4: a triangle has one curve and no S; EB-COUNT-4 holds on all small surfaces."""
    assert encode(TRIANGLE).stream == Stream("E", (), 1)
    assert components(TRIANGLE)[0].curves == 1
    for surface in from_every_gate(6):
        stream = encode(surface).stream
        reached = sum(record.kind is Kind.BOUNDARY for record in stream.records)
        assert reached + stream.components_with_boundary == components(surface)[0].curves


def _differ(surface: Surface, printed: Printed) -> bool:
    written, right = printed.compress(), encode(surface)
    return (written.word, tuple(written.vertices), written.components_with_boundary) != (
        right.stream.word,
        right.vertex_order,
        right.stream.components_with_boundary,
    )


def test_every_vertex_of_a_curve_is_taken_for_a_new_curve() -> None:
    """ERRATUM-7: three triangles in a row, entered in the middle. EB-TRAVERSE-7.

    The curve is written again, the left gate is not pushed, and the rest becomes two components.
    """
    strip = _first_strip()
    right = encode(strip)
    assert right.stream == Stream("SEE", (), 1)
    assert len(right.vertex_order) == 5
    written = Printed(strip, every_boundary=True).compress()
    assert (len(written.vertices), len(written.curves)) == (15, 3)
    assert written.components_with_boundary == 2


def test_the_number_of_an_s_is_no_mark() -> None:
    """ERRATUM-8: S number 0 is marked 0, which is false, so its triangle is visited again as P.

    EB-HANDLE-3, EB-GATE-2.
    """
    strip = _first_strip()
    written = Printed(strip, numbers_as_marks=True).compress()
    assert written.word == "SEE"  # and then a P that was there before
    assert (len(written.vertices), strip.vertices) == (8, 5)


def _first_strip() -> Surface:
    """Three triangles in a row, begun at the middle one."""
    return next(s for s in from_every_gate(3) if encode(s).stream.word == "SEE")


@pytest.mark.parametrize("fault", ["every_boundary", "numbers_as_marks"])
def test_no_smaller_surface_shows_it(fault: str) -> None:
    """ERRATUM-7, ERRATUM-8: found by enumeration; no surface of two faces or one differs."""
    assert not any(_differ(s, _with(s, fault)) for s in from_every_gate(2))
    assert any(_differ(s, _with(s, fault)) for s in from_every_gate(3))


def _with(surface: Surface, fault: str) -> Printed:
    return Printed(
        surface,
        every_boundary=fault == "every_boundary",
        numbers_as_marks=fault == "numbers_as_marks",
    )


def test_with_both_mended_the_printed_algorithms_are_ours() -> None:
    """ERRATUM-7, ERRATUM-8: nothing else is wrong with what Algorithms 3 and 4 visit."""
    assert not any(_differ(surface, Printed(surface)) for surface in from_every_gate(6))


def test_a_curve_can_be_written_in_six_orders() -> None:
    """ERRATUM-12: without Algorithm 6, half of the orders of a triangle's curve turn it over.

    EB-ORDER-2 leaves one, which begins at the left end of the gate and keeps the orientation.
    """
    gate_left, *rest = encode(TRIANGLE).vertex_order
    turned = [order for order in permutations(range(3)) if _is_turned(order)]
    assert len(turned) == 3
    assert not _is_turned((gate_left, rest[0], rest[1]))


def _is_turned(order: tuple[int, ...]) -> bool:
    """Does the face (0, 1, 2) run these vertices backwards?"""
    a, b, _ = order
    return (b - a) % 3 == 2
