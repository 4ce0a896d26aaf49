"""What is around a simplex: closed star and valence; open star and link are in simplicial."""

from clers.complexes.facets import facets
from clers.complexes.simplicial import Complex, Simplex, closure, star


def closed_star(k: Complex, simplex: Simplex) -> Complex:
    """The closure of the open star. Clauses: CPLX-STAR-1, CPLX-STAR-2."""
    return closure(star(k, simplex))


def valence(k: Complex, simplex: Simplex) -> int:
    """The number of facets in the open star. Clause: CPLX-STAR-3."""
    return sum(simplex <= set(facet) for facet in facets(k))
