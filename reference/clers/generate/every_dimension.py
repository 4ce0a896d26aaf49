"""Complexes of every small dimension, as Hypothesis strategies.

Complexes are drawn as lists of facets, so they shrink to few facets, of few and low vertices.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Final

from hypothesis import strategies as st

from clers.complexes.given_every_dimension import Placed, Rows
from clers.complexes.known import KNOWN
from clers.complexes.simplicial import Complex, closure
from clers.complexes.smith import Matrix

SMALL: Final = tuple(known for known in KNOWN if sum(known.f_vector) < 200)
"""The known complexes that even slow definitions get through."""


def complexes(
    max_dimension: int = 4, max_facets: int = 6, max_vertices: int = 8, min_facets: int = 0
) -> st.SearchStrategy[Complex]:
    """Closures of random simplices on the vertices 0 … max_vertices − 1, mostly not pure.

    So many simplices are drawn; some may be faces of others.
    """
    vertices = st.integers(0, max_vertices - 1)
    facet = st.frozensets(vertices, min_size=1, max_size=max_dimension + 1)
    return st.lists(facet, min_size=min_facets, max_size=max_facets).map(closure)


def pure_complexes(
    max_dimension: int = 4, max_facets: int = 6, max_vertices: int = 7
) -> st.SearchStrategy[Complex]:
    """Closures of random simplices of one dimension each."""

    def of_size(size: int) -> st.SearchStrategy[Complex]:
        facet = st.frozensets(st.integers(0, max_vertices - 1), min_size=size, max_size=size)
        return st.lists(facet, max_size=max_facets).map(closure)

    return st.integers(1, max_dimension + 1).flatmap(of_size)


def known_complexes(*, pure: bool = False) -> st.SearchStrategy[Complex]:
    """The smaller ones of the known complexes, all or the pure ones, under other names.

    Sixteen names are drawn, which is much: so a random complex of a few facets counts as simpler,
    and is what examples shrink to.
    """
    chosen = [known.complex for known in SMALL if known.pure or not pure]
    return st.builds(_renamed, st.sampled_from(chosen), st.permutations(range(16)))


def _renamed(k: Complex, names: Sequence[int]) -> Complex:
    return Complex(frozenset(frozenset(names[v] for v in s) for s in k.simplices))


def joinable() -> st.SearchStrategy[tuple[Complex, Complex]]:
    """Two complexes of dimension at most 2, the second on vertices from 10 on."""
    small = complexes(max_dimension=2, max_facets=5, max_vertices=6)
    return st.tuples(small, small.map(lambda k: _renamed(k, range(10, 16))))


def facet_rows() -> st.SearchStrategy[Rows]:
    """Rows of integers, in which every fault occurs."""
    good = st.lists(st.integers(0, 9), min_size=1, max_size=5, unique=True)
    any_row = st.lists(st.integers(-1, 9), max_size=4)
    too_long = st.integers(17, 30).map(lambda size: list(range(size)))
    row = st.sampled_from([good] * 8 + [any_row] * 3 + [too_long]).flatmap(lambda kind: kind)
    return st.lists(row.map(tuple), max_size=5).map(tuple)


def integer_matrices(max_size: int = 4, most: int = 8) -> st.SearchStrategy[Matrix]:
    """Matrices with many zeros and multiples of 2 and 3, for which factors are not all 1."""
    entry = st.one_of(
        st.just(0), st.integers(-most, most), st.sampled_from((2, 3, 4, 6, 12, -2, -3, -6))
    )

    def of_width(width: int) -> st.SearchStrategy[Matrix]:
        row = st.lists(entry, min_size=width, max_size=width).map(tuple)
        return st.lists(row, max_size=max_size).map(tuple)

    return st.integers(1, max_size).flatmap(of_width)


@st.composite
def placed_complexes(draw: st.DrawFn) -> Placed:
    """A complex of two or three simplices, its six points on a small lattice with halves."""
    space = draw(st.integers(1, 3))
    coordinate = st.integers(0, 6).map(lambda i: Fraction(i, 2))
    points = draw(st.lists(st.tuples(*[coordinate] * space), min_size=6, max_size=6))
    return tuple(points), draw(complexes(space, max_facets=3, max_vertices=6, min_facets=2))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "complexes": st.one_of(complexes(), complexes(), known_complexes()),
    "pure-complexes": st.one_of(pure_complexes(), pure_complexes(), known_complexes(pure=True)),
    "joinable-complexes": joinable(),
    "facet-rows": facet_rows(),
    "integer-matrices": integer_matrices(),
    "placed-complexes": placed_complexes(),
}
"""The domains of this module, by name."""
