"""Each class of surfaces is drawn, from scripts and from solids, and bounds are kept."""

from functools import cache
from itertools import product

import pytest

from clers.generate.distribution import STRATEGIES, Seen, draw, row

EXAMPLES = 200
SEEDS = 4
"""So many that each class of a percent or two is drawn, and from several seeds, for one alone
dwells on what it found.

Hypothesis mixes in numbers that it finds in the program, so that a change anywhere gives other
examples: a class must not hang on luck.
"""
TRIGRAMS = {
    first + second + third
    for first, second, third in product("CLERS", repeat=3)
    if not {"CL", "CE"} & {first + second, second + third}
}
BOTH_SOURCES = ("surfaces", "solid-surfaces")


@cache
def seen(name: str) -> tuple[Seen, ...]:
    """The examples of a strategy, drawn once."""
    if name in BOTH_SOURCES:
        return tuple(one for k in range(SEEDS) for one in draw(STRATEGIES[name], EXAMPLES, k))
    return draw(STRATEGIES[name], 80, 0)


@pytest.mark.parametrize("name", BOTH_SOURCES)
@pytest.mark.parametrize("genus", range(6))
def test_every_genus(name: str, genus: int) -> None:
    assert any(one.genus == genus for one in seen(name))


@pytest.mark.parametrize("name", BOTH_SOURCES)
@pytest.mark.parametrize("curves", range(7))
def test_every_number_of_curves(name: str, curves: int) -> None:
    assert any(one.curves == curves for one in seen(name))


@pytest.mark.parametrize("name", BOTH_SOURCES)
@pytest.mark.parametrize("components", range(1, 5))
def test_every_number_of_components(name: str, components: int) -> None:
    assert any(one.components == components for one in seen(name))


@pytest.mark.parametrize("name", BOTH_SOURCES)
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("handles", [True, False])
@pytest.mark.parametrize("connected", [True, False])
def test_combinations(name: str, closed: bool, handles: bool, connected: bool) -> None:
    wanted = (closed, handles, connected)
    assert wanted in {(one.curves == 0, one.genus > 0, one.components == 1) for one in seen(name)}


@pytest.mark.parametrize("name", BOTH_SOURCES)
def test_small_and_large(name: str) -> None:
    """A tetrahedron, and a tenth of the examples of more than 60 faces."""
    faces = sorted(one.faces for one in seen(name))
    assert faces[0] <= 4
    assert faces[len(faces) * 9 // 10] > 60


@pytest.mark.parametrize("name", BOTH_SOURCES)
def test_every_trigram_of_symbols(name: str) -> None:
    """No word has CL or CE; every other three symbols follow each other somewhere."""
    assert frozenset[str]().union(*(one.trigrams for one in seen(name))) == TRIGRAMS


def test_bounds_of_surfaces() -> None:
    """The ranges that `surfaces` promises."""
    for one in seen("surfaces"):
        assert one.faces <= 120
        assert one.genus <= 5
        assert one.curves <= 6
        assert 1 <= one.components <= 4


def test_bounds_of_spheres() -> None:
    for one in seen("spheres"):
        assert (one.genus, one.curves, one.components) == (0, 0, 1)
        assert one.faces <= 120


def test_bounds_of_closed_surfaces() -> None:
    assert all(one.curves == 0 for one in seen("closed-surfaces"))


def test_bounds_of_small_surfaces() -> None:
    for one in seen("small-surfaces"):
        assert one.faces <= 40
        assert one.genus <= 1
        assert one.curves <= 3
        assert one.components <= 2


def test_row_counts_from_the_lowest() -> None:
    """A class that is not drawn shows as 0; the median is the upper one."""
    three = [
        Seen(components, genus, curves, faces, frozenset({f"CR{faces}"}))
        for components, genus, curves, faces in ((1, 0, 2, 4), (3, 0, 0, 6), (1, 2, 0, 5))
    ]
    assert row("x", three) == ("`x`", "2 0 1", "2 0 1", "2 0 1", "5, 6, 6", "3")
