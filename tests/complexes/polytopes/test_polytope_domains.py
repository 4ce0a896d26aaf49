"""The strategies of polytopes and structures reach what their laws are about."""

from collections import Counter

from hypothesis import given, settings

from clers.complexes.polytopes.cells import CellList, Polytope, boundary, dimension
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.kind import kinds
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.polygons import PolygonList, polygon_surface
from clers.complexes.structures.half_edge import HalfEdges, half_edges
from clers.complexes.structures.half_edge_queries import flip
from clers.conventions.result import Accepted, Rejected
from clers.generate.domains import DOMAINS


def tally(domain: str, examples: int = 80) -> list[object]:
    """What a domain's strategy draws, so often that each sort it has is drawn whatever the seed."""
    drawn: list[object] = []

    @settings(max_examples=examples)
    @given(DOMAINS[domain])
    def draw(example: object) -> None:
        drawn.append(example)

    draw()
    return drawn


def said(answer: Accepted[object] | Rejected) -> str:
    return "accepted" if isinstance(answer, Accepted) else f"{answer.clause} {answer.reason}"


def test_cell_lists_are_good_and_bad() -> None:
    """Each rejection of polytopes, but the dimension. Clause: CPLX-POLYTOPE-1."""
    found = Counter(said(polytope(x)) for x in tally("cell-lists") if isinstance(x, CellList))
    clauses = {key.split()[0] for key in found}
    assert clauses >= {"accepted", *(f"CPLX-POLYTOPE-{k}" for k in (2, 4, 5))}
    assert found["accepted"] > 15


def test_polygon_lists_are_good_and_bad() -> None:
    """Clause: CPLX-POLYGON-2."""
    drawn = tally("polygon-lists", 250)
    found = Counter(said(polygon_surface(x)) for x in drawn if isinstance(x, PolygonList))
    assert len(found) >= 5
    assert "CPLX-POLYGON-2 incoherent-cells" in found
    assert found["accepted"] > 15


def test_half_edges_are_good_and_bad() -> None:
    """Clauses: CPLX-HALFEDGE-2 … CPLX-HALFEDGE-8."""
    drawn = tally("foreign-half-edges", 250)
    found = Counter(said(half_edges(x)) for x in drawn if isinstance(x, HalfEdges))
    clauses = {key.split()[0] for key in found}
    assert clauses >= {"accepted", *(f"CPLX-HALFEDGE-{k}" for k in range(2, 5))}


def test_some_edges_can_be_flipped() -> None:
    """Clause: CPLX-HALFEDGE-16."""
    found = Counter(
        said(flip(of, h))
        for drawn in tally("half-edge-flips")
        if isinstance(drawn, tuple)
        for of, h in [drawn]
    )
    assert min(found["accepted"], found["CPLX-HALFEDGE-16 operator-not-applicable"]) > 5


def test_manifolds_of_every_sort() -> None:
    """Clauses: CPLX-POLYMANIFOLD-1, CPLX-POLYMANIFOLD-5."""
    solid = [x for x in tally("manifold-polytopes", 250) if isinstance(x, Polytope)]
    assert {(dimension(x), bool(boundary(x))) for x in solid} == {
        (n, rim) for n in (1, 2, 3) for rim in (False, True)
    }
    sheets = [x for x in tally("polygonal-surfaces") if isinstance(x, Polytope)]
    assert {k.orientable for x in sheets for k in kinds(x)} == {False, True}
    assert {k.genus for x in sheets for k in kinds(x)} >= {0, 1}
    anything = [x for x in tally("polytopes") if isinstance(x, Polytope)]
    assert {is_manifold(x) for x in anything} == {False, True}
    assert {dimension(x) for x in anything} >= {0, 1, 2, 3}
