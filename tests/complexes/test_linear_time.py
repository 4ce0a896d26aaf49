"""Time is linear: executed lines are counted, not seconds, on the families that tempt to more.

Counted are the lines of this package that the interpreter executes. What Python does inside one
line (a slice of fixed length, a pass of `map` over corners) is linear where it is not constant.
"""

from collections.abc import Callable

import pytest
from golden_complexes import TETRAHEDRON, accepted, beside, grid

from clers.complexes.canonical import code
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.isomorphism import Isomorphic, isomorphism
from clers.complexes.repair import drop_isolated, orient, split_pinched
from clers.complexes.surface import Corner
from clers.complexes.topology import components, curves
from clers.conventions.result import Rejected
from clers.generate.families import bipyramid
from counted import lines

pytestmark = pytest.mark.interpreted


def fan(n: int) -> FaceList:
    """n triangles about vertex 0, open: a hub on the boundary."""
    return FaceList(tuple((0, i, i + 1) for i in range(1, n + 1)), n + 2)


def strip(n: int) -> FaceList:
    """n triangles in a row."""
    return FaceList(tuple((i, i + 1 + i % 2, i + 2 - i % 2) for i in range(n)), n + 2)


def shuffled_strip(n: int) -> FaceList:
    """A strip that disagrees with itself, its faces far from their neighbours in the list."""
    faces = [(i, i + 1, i + 2) for i in range(n)]
    return FaceList((*faces[::3], *faces[2::3], *faces[1::3]), n + 2)


def apart(n: int) -> FaceList:
    """n tetrahedra."""
    return beside(*[TETRAHEDRON] * n)


def daisy(n: int) -> FaceList:
    """n triangles that share one vertex and nothing else."""
    return FaceList(tuple((0, 2 * i + 1, 2 * i + 2) for i in range(n)), 2 * n + 1)


def book(n: int) -> FaceList:
    """n triangles that share one edge."""
    return FaceList(tuple((0, 1, i + 2) for i in range(n)), n + 2)


def twins(n: int) -> FaceList:
    """One triangle n times."""
    return FaceList(((0, 1, 2),) * n, 3)


def lonely(n: int) -> FaceList:
    """One triangle and n vertices that nothing names."""
    return FaceList(((0, 1, 2),), n + 3)


def torus(n: int) -> FaceList:
    """A long torus of 6n triangles."""
    return grid(n, 3)


Family = Callable[[int], FaceList]
GOOD: tuple[Family, ...] = (fan, bipyramid, strip, apart, torus)
BAD: tuple[Family, ...] = (shuffled_strip, daisy, book, twins, lonely)


def assert_linear(work: Callable[[int], Callable[[], object]]) -> None:
    """Twice as much to do takes no more than twice the lines, but for one in a hundred."""
    small, large = lines(work(60), "clers/"), lines(work(120), "clers/")
    assert 60 < small < large <= 2.02 * small


@pytest.mark.parametrize("family", GOOD + BAD)
def test_reading_is_linear(family: Family) -> None:
    """Clause: CPLX-INPUT-2. Whether the face list is good or not."""
    assert isinstance(surface(family(9)), Rejected) == (family in BAD)

    def work(n: int) -> Callable[[], object]:
        given = family(n)
        return lambda: surface(given)

    assert_linear(work)


@pytest.mark.parametrize("family", GOOD)
def test_topology_is_linear(family: Family) -> None:
    """Clauses: CPLX-CURVE-3, CPLX-COMPONENT-1, CPLX-COMPONENT-2."""

    def work(n: int) -> Callable[[], object]:
        of = accepted(family(n))
        return lambda: (components(of), curves(of))

    assert_linear(work)


@pytest.mark.parametrize("family", GOOD)
def test_walks_and_comparing_are_linear(family: Family) -> None:
    """Clause: CPLX-ISO-3. On these, the first corner that is tried is always right."""

    def walking(n: int) -> Callable[[], object]:
        of = accepted(family(n))
        return lambda: code(of, Corner(0))

    def comparing(n: int) -> Callable[[], object]:
        of = accepted(family(n))
        assert isinstance(isomorphism(of, of), Isomorphic)
        return lambda: isomorphism(of, of)

    if family is not apart:  # where a walk sees one tetrahedron
        assert_linear(walking)
    assert_linear(comparing)


@pytest.mark.parametrize("family", [*GOOD, shuffled_strip, daisy, lonely])
def test_repairs_are_linear(family: Family) -> None:
    """Clauses: CPLX-REPAIR-2, CPLX-REPAIR-4, CPLX-REPAIR-5."""

    def work(n: int) -> Callable[[], object]:
        given = family(n)
        return lambda: (orient(given), split_pinched(given), drop_isolated(given))

    assert_linear(work)
