"""ERRATUM-24, 25 and 31: the dual tree, the remainder, and what Table 1 says of them."""

from collections import Counter
from itertools import combinations

import pytest
from every_small_surface import from_every_gate

from clers.complexes.surface import BORDER, Surface
from clers.complexes.topology import components
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.edgebreaker.given import outlined
from clers.edgebreaker.remainder import Tree, trees


def _walked(surface: Surface) -> tuple[str, Surface, Tree]:
    """The word of a connected surface, the surface in the order of creation, its dual tree."""
    stream = encode(surface).stream
    decoded = decode(stream)
    assert isinstance(decoded, Accepted)
    (tree,) = trees(outlined(stream), decoded.value)
    return stream.word, decoded.value, tree


def _sides(surface: Surface) -> dict[str, set[tuple[str, str]]]:
    """For each symbol, where the remainder is and where the tree goes on: (remainder, tree)."""
    word, decoded, tree = _walked(surface)
    found: dict[str, set[tuple[str, str]]] = {}
    for i, symbol in enumerate(word, start=1):  # face 0 is P
        named = {"right": 3 * i + 1, "left": 3 * i + 2}
        crossed = {c for d in tree.crossed for c in (d, decoded.opposite[d])}
        on = " ".join(name for name, c in named.items() if c in crossed)
        off = " ".join(name for name, c in named.items() if c not in crossed)
        found.setdefault(symbol, set()).add((off, on))
    return found


def test_the_position_in_table_1_is_that_of_the_tree() -> None:
    """ERRATUM-24: at R the remainder is on the right, though table and text together say left.

    EB-TRAVERSE-8. The tetrahedron has C, R and E; the torus has every symbol.
    """
    assert _sides(TETRAHEDRON) == {
        "C": {("left", "right")},
        "R": {("right", "left")},
        "E": {("right left", "")},
    }
    assert _sides(CUBE) == _sides(TETRAHEDRON)
    assert _sides(TORUS)["L"] == {("left", "right")}


def test_an_s_with_a_record_has_two_links() -> None:
    """ERRATUM-25: Table 1 gives every S three; the annulus is smallest (ERRATUM-5).

    EB-TRAVERSE-8, EB-REMAINDER-1. The first S of the annulus is entered from the infinite face.
    """
    word, decoded, tree = _walked(ANNULUS)
    assert word[0] == "S"
    links = sum(c // 3 == 0 or decoded.opposite[c] // 3 == 0 for c in tree.crossed)
    assert 1 + links == 2
    for i in (6, 9):  # the S of Figure 22 that have records; 10 and 13 have none
        assert _links(TORUS, 1 + i) == 2
    assert [_links(TORUS, 1 + i) for i, x in enumerate(_walked(TORUS)[0]) if x == "S"] == [
        2,
        2,
        3,
        3,
    ]


def _links(surface: Surface, face: int) -> int:
    _, decoded, tree = _walked(surface)
    return sum(face in (c // 3, decoded.opposite[c] // 3) for c in tree.crossed)


def test_a_triangle_alone_has_no_neighbour() -> None:
    """ERRATUM-25: `each node of the dual graph has three incident links` only without boundary.

    CPLX-CORNER-2.
    """
    assert TRIANGLE.opposite == (BORDER,) * 3
    assert BORDER not in TORUS.opposite


def dual_remainder(surface: Surface, tree: set[frozenset[int]]) -> tuple[int, int]:
    """χ of the dual graph without the links across a primal tree, and its independent cycles.

    The graph is connected for the trees tried here.
    """
    links = 0
    for c, d in enumerate(surface.opposite):
        edge = frozenset(surface.vertex[3 * (c // 3) + (c + k) % 3] for k in (1, 2))
        links += d > c and edge not in tree
    chi = surface.faces - links
    return chi, 1 - chi


def test_the_dual_remainder_has_no_cycle_for_a_curve() -> None:
    """ERRATUM-31: a triangle has χ = 1 and no cycle, where 1 − 2g − b = 0 and 2g + b = 1 are told.

    EB-REMAINDER-2 speaks of the primal remainder alone. The tree has all border edges but one.
    """
    (part,) = components(TRIANGLE)
    assert (1 - 2 * part.genus - part.curves, 2 * part.genus + part.curves) == (0, 1)
    for two in combinations((frozenset({0, 1}), frozenset({1, 2}), frozenset({0, 2})), 2):
        assert dual_remainder(TRIANGLE, set(two)) == (1, 0)


def test_the_annulus_has_one_morse_edge() -> None:
    """ERRATUM-31: 2g + b = 2 edges are told, and 2g + b − 1 = 1 is coded. EB-REMAINDER-3."""
    (part,) = components(ANNULUS)
    _, _, tree = _walked(ANNULUS)
    assert (2 * part.genus + part.curves, len(tree.morse)) == (2, 1)


@pytest.mark.parametrize("most", [6])
def test_the_primal_remainder_is_right_as_printed(most: int) -> None:
    """χ = 1 − 2g − b, on every surface of at most six faces from every gate. EB-REMAINDER-2."""
    counted: Counter[int] = Counter()
    for surface in from_every_gate(most):
        (part,) = components(surface)
        _, _, tree = _walked(surface)
        chi = part.vertices - len(tree.remainder)
        assert chi == 1 - 2 * part.genus - part.curves
        counted[chi] += 1
    assert counted.keys() == {1, 0, -1}
