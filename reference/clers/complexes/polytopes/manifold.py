"""When a polytope of dimension at most 3 is a manifold, decided by its vertex figures."""

from clers.complexes.polytopes.cells import (
    Cell,
    CellList,
    boundary,
    components,
    counts,
    dimension,
    euler,
    figure,
    of_dimension,
)


def is_manifold(of: CellList) -> bool:
    """Is each vertex figure a sphere or a ball of dimension n − 1? Clause: CPLX-POLYMANIFOLD-1.

    The dimension n is at most 3. The list without cells is a manifold of dimension −1.
    By the order complex instead: CPLX-POLYMANIFOLD-2.
    """
    return first_singular(of) is None


def first_singular(of: CellList) -> Cell | None:
    """The lowest vertex whose figure is no sphere and no ball. Clause: CPLX-POLYMANIFOLD-1.

    Each vertex has a pure figure of dimension n − 1 exactly if the polytope is pure.
    """
    good = (_is_empty, _is_pair_or_point, _is_circle_or_arc, _is_sphere_or_disc)[dimension(of)]
    return next((v for v in of_dimension(of, 0) if not good(figure(of, v))), None)


def _is_empty(around: CellList) -> bool:
    return around.vertices == 0


def _is_pair_or_point(around: CellList) -> bool:
    return counts(around) in ((1,), (2,))


def _is_circle_or_arc(around: CellList) -> bool:
    """A connected curve, whose vertices have one edge or two."""
    return dimension(around) == 1 and is_manifold(around) and len(components(around)) == 1


def _is_sphere_or_disc(around: CellList) -> bool:
    """A connected surface with χ = 2, or with χ = 1 and a boundary."""
    surface = dimension(around) == 2 and is_manifold(around) and len(components(around)) == 1
    return surface and euler(around) == (1 if boundary(around) else 2)
