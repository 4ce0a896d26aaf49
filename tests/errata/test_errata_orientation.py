"""What section 5(a) says of orientations, and where it fails."""

from itertools import permutations

from clers.complexes.manifolds.orientation import (
    OrientedSimplex,
    induced,
    opposite,
    ordering,
    oriented,
)
from clers.conventions.result import Accepted


def orderings_by_parity(vertices: tuple[int, ...]) -> set[frozenset[tuple[int, ...]]]:
    """Printed: orderings, equivalent if they differ by an even permutation.

    Three exchanged in a cycle are the even permutations; of fewer than three only the identity is.
    """
    classes: set[frozenset[tuple[int, ...]]] = set()
    for start in permutations(vertices):
        reached, waiting = {start}, [start]
        while waiting:
            at = waiting.pop()
            for i, j, k in permutations(range(len(at)), 3):
                turned = list(at)
                turned[i], turned[j], turned[k] = at[k], at[i], at[j]
                if tuple(turned) not in reached:
                    reached.add(tuple(turned))
                    waiting.append(tuple(turned))
        classes.add(frozenset(reached))
    return classes


def test_a_point_has_one_ordering() -> None:
    """ERRATUM-35. As printed a point has one orientation; here it has two. CPLX-COHERENT-1."""
    assert [len(orderings_by_parity(tuple(range(n)))) for n in (1, 2, 3, 4)] == [1, 2, 2, 2]
    point = OrientedSimplex((0,), positive=True)
    assert opposite(point) != point
    assert ordering(opposite(point)) == ordering(point) == (0,)
    edge = oriented((0, 1))
    assert isinstance(edge, Accepted)
    assert induced(edge.value, 0) == OrientedSimplex((1,), positive=True)
    assert induced(edge.value, 1) == OrientedSimplex((0,), positive=False)
