"""Manifolds made to order: spheres, handles and holes, put together by connected sums."""

from itertools import combinations, product

from clers.complexes.manifolds.connected_sum import Summand, connected_sum
from clers.complexes.manifolds.given import Piece
from clers.complexes.simplicial import Complex, boundary, closure, dimension, of_dimension
from clers.conventions.result import Accepted

PROJECTIVE_PLANE = (
    *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 1, 5)),
    *((1, 2, 4), (2, 3, 5), (1, 3, 4), (2, 4, 5), (1, 3, 5)),
)


def made(n: int, piece: Piece, place: int) -> Complex:
    """A connected n-manifold as small as it comes; `place` chooses where parts are summed to it."""
    if n < 2:
        return _of_low_dimension(n, piece.curves)
    if piece.genus == 0 and piece.curves > 0:
        k, holes = closure([range(n + 1)]), piece.curves - 1
    elif piece.genus == 0:
        k, holes = _sphere(n), 0
    else:
        k, holes = handle(n, orientable=piece.orientable), piece.curves
        for _ in range(piece.genus - 1):
            k = _with(k, place, handle(n, orientable=piece.orientable))
        if holes > 0:
            k, holes = Complex(k.simplices - {_facet(k, place)}), holes - 1
    for _ in range(holes):
        k = _with(k, place, _holed_sphere(n))
    return k


def _of_low_dimension(n: int, ends: int) -> Complex:
    if n == 0:
        return closure([[0]])
    return closure([[0, 1]]) if ends else _sphere(1)


def _sphere(n: int) -> Complex:
    return closure(combinations(range(n + 2), n + 1))


def handle(n: int, *, orientable: bool) -> Complex:
    """A bundle of spheres over the circle; in dimension 2 a torus, or a projective plane.

    The boundary of a chain of (n+1)-simplices on i … i+n+1 modulo N. From each to the next the
    orientation changes by (−1)^n, so it is orientable exactly if nN is even (W. Kühnel).
    """
    if n == 2 and not orientable:
        return closure(PROJECTIVE_PLANE)
    count = 2 * n + 3
    if orientable:
        count += n % 2
    return boundary(closure([(i + j) % count for j in range(n + 2)] for i in range(count)))


def _holed_sphere(n: int) -> Complex:
    """The boundary of a cross-polytope without its last facet; the first is far from the hole."""
    facets = product(*((2 * i, 2 * i + 1) for i in range(n + 1)))
    return closure(list(facets)[:-1])


def _with(k: Complex, place: int, other: Complex) -> Complex:
    at, first = _facet(k, place), min(of_dimension(other, dimension(other)), key=sorted)
    answer = connected_sum(Summand(k, tuple(sorted(at))), Summand(other, tuple(sorted(first))))
    if isinstance(answer, Accepted):
        return answer.value
    raise AssertionError(f"no sum was made: {answer.line()}")


def _facet(k: Complex, place: int) -> frozenset[int]:
    facets = of_dimension(k, dimension(k))
    return facets[place % len(facets)]
