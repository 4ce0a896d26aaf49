"""Every small manifold, and every simplex glued to it: when is the result a manifold?

All pure complexes of dimension n on n + 3 vertices: their facets are the complements of pairs, so
that they are graphs, and those up to isomorphism are in networkx's atlas.
"""

from itertools import combinations

import networkx as nx
import pytest

from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import Complex, boundary, closure, of_dimension
from clers.conventions.law import AnyLaw
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import attach, attachment
from clers.operators.attachments.classes import pinches
from clers.operators.attachments.expansion import has_order
from clers.operators.attachments.given import AT_MANIFOLDS, Gluable
from clers.operators.attachments.laws import LAWS
from clers.operators.attachments.operator import BoundaryAttach

ON_MANIFOLDS = [law for law in LAWS if law.domain == AT_MANIFOLDS.name]


def small_manifolds(n: int) -> list[Complex]:
    """All manifolds of dimension n on n + 3 vertices at most, up to isomorphism."""
    found: list[Complex] = []
    vertices = frozenset(range(n + 3))
    for graph in nx.graph_atlas_g():
        if graph.number_of_nodes() == n + 3 and graph.number_of_edges() > 0:
            k = closure(vertices - set(edge) for edge in graph.edges())
            if isinstance(manifold(k), Manifold):
                found.append(k)
    return found


def ways_to_glue(k: Complex, n: int) -> list[Gluable]:
    """Every n-simplex on old vertices and new ones that the complex does not have."""
    old = [min(v) for v in of_dimension(k, 0)]
    found: list[Gluable] = []
    for count in range(n + 2):
        new = range(20, 20 + n + 1 - count)
        for chosen in combinations(old, count):
            glued = attachment(k, (*chosen, *new))
            if isinstance(attach(k, glued), Accepted):
                found.append(Gluable(k, glued))
    return found


@pytest.fixture(scope="module", params=[1, 2, 3])
def glued(request: pytest.FixtureRequest) -> tuple[int, list[Gluable]]:
    n = int(request.param)
    return n, [way for k in small_manifolds(n) for way in ways_to_glue(k, n)]


def test_enough_was_tried(glued: tuple[int, list[Gluable]]) -> None:
    """Curves on four vertices are, by hand: edges 1, 2; paths of 2, 3; circles of 3, 4.

    Those are an edge, two edges apart, a path of two, a path of three, a triangle, a square. Each
    dimension has simplices that leave a manifold and simplices that do not.
    """
    n, cases = glued
    if n == 1:
        assert len(small_manifolds(1)) == 6
    good = [isinstance(apply(BoundaryAttach(case.glued), case.before), Accepted) for case in cases]
    assert True in good
    assert False in good
    assert any(pinches(case.glued) for case in cases) == (n > 1)


@pytest.mark.parametrize("law", ON_MANIFOLDS, ids=lambda law: law.name)
def test_law_everywhere(law: AnyLaw, glued: tuple[int, list[Gluable]]) -> None:
    """OPER-SIMPLEX-5, OPER-SIMPLEX-6: both directions, nothing left to chance."""
    for case in glued[1]:
        assert law.check(case) == Holds(), case


def test_bounding_simplices_are_enough_for_curves_and_surfaces(
    glued: tuple[int, list[Gluable]],
) -> None:
    """A simplex attachment of the tutorial's order, along bounding simplices. OPER-SIMPLEX-3.

    For n = 1 and 2 each leaves a manifold. For n = 3 those along a triangle and an edge do not.
    """
    n, cases = glued
    for case in cases:
        rim = boundary(case.before).simplices
        if has_order(case.glued) and all(frozenset(face) in rim for face in case.glued.along):
            after = attach(case.before, case.glued)
            assert isinstance(after, Accepted)
            stays = isinstance(manifold(after.value), Manifold)
            assert stays == (not pinches(case.glued))
            assert stays or n == 3
