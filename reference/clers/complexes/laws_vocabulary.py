"""Laws of simplices, facets, stars and links in every dimension."""

from itertools import product
from math import comb
from typing import Final

from clers.complexes.complex_text import read_complex, write_complex
from clers.complexes.facets import facets, from_facets, top_simplices
from clers.complexes.given_every_dimension import COMPLEXES, FACET_ROWS, Rows
from clers.complexes.neighbourhood import closed_star, valence
from clers.complexes.parts import join
from clers.complexes.simplex import are_adjacent, faces, frontier, is_incident, join_simplices
from clers.complexes.simplicial import Complex, Simplex, closure, dimension, link, star
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtFace, AtSimplex, AtVertex


def _at(simplex: Simplex) -> AtSimplex:
    return AtSimplex(tuple(sorted(simplex)))


def _faces(k: Complex) -> Verdict:
    return every(
        *(
            every(
                same(closure([s]).simplices, faces(s), _at(s)),
                same(faces(s) - {s}, frontier(s), _at(s)),
                *(same(comb(len(s), m + 1), len(faces(s, m)), _at(s)) for m in range(len(s) + 1)),
                same(faces(s), frozenset().union(*(faces(s, m) for m in range(len(s)))), _at(s)),
            )
            for s in k.simplices
        )
    )


def _incidence(k: Complex) -> Verdict:
    small = sorted(k.simplices, key=sorted)[:30]
    return every(
        *(
            every(
                same(t in frontier(s), is_incident(s, t), _at(s)),
                same(s != t and bool(frontier(s) & frontier(t)), are_adjacent(s, t), _at(s)),
            )
            for s, t in product(small, small)
        )
    )


def _join_of_simplices(k: Complex) -> Verdict:
    small = sorted(k.simplices, key=sorted)[:30]

    def holds(s: Simplex, t: Simplex) -> Verdict:
        joined = join_simplices(s, t)
        if isinstance(joined, Rejected):
            return same(AtVertex(min(s & t, default=-1)), joined.where)
        whole = joined.value
        return every(same(len(s) + len(t), len(whole), _at(s)), same(True, whole >= s | t, _at(t)))

    return every(*(holds(s, t) for s, t in product(small, small)))


def _facets(k: Complex) -> Verdict:
    rows = facets(k)
    maximal = [tuple(sorted(s)) for s in k.simplices if not any(s < t for t in k.simplices)]
    without = [closure(rows[:i] + rows[i + 1 :]) for i in range(len(rows))]
    n = dimension(k)
    return every(
        same(tuple(sorted(maximal)), rows),
        same(k, closure(rows)),
        same(False, k in without),
        same([r for r in rows if len(r) == n + 1], [tuple(sorted(s)) for s in top_simplices(k)]),
    )


def _reading_rows(rows: Rows) -> Verdict:
    alone = [from_facets([row]) for row in rows]
    bad = [(i, one) for i, one in enumerate(alone) if isinstance(one, Rejected)]
    answer = from_facets(rows)
    if not bad:
        return every(
            same(Accepted(closure(rows)), answer),
            same(answer, from_facets([row[::-1] for row in (*rows, *rows)][::-1])),
        )
    first, fault = bad[0]
    return same(Rejected(fault.reason, fault.clause, AtFace(first)), answer)


def _text(k: Complex) -> Verdict:
    text = write_complex(k)
    everything = sorted((sorted(s, reverse=True) for s in k.simplices), reverse=True)
    return every(
        same(Accepted(k), read_complex(text)), same(Accepted(k), read_complex(f" {everything}"))
    )


def _closed_star(k: Complex) -> Verdict:
    def holds(s: Simplex) -> Verdict:
        around = closed_star(k, s)
        off = Complex(frozenset(t for t in around.simplices if not t & s))
        return every(
            same(join(closure([s]), link(k, s)), Accepted(around), _at(s)),
            same(link(k, s), off, _at(s)),
        )

    return every(*map(holds, k.simplices))


def _absent(k: Complex) -> Verdict:
    absent = frozenset({1 + max((v for s in k.simplices for v in s), default=-1)})
    return every(
        same(frozenset(), star(k, absent)),
        same(Complex(frozenset()), closed_star(k, absent)),
        same(0, valence(k, absent)),
    )


def _valence(k: Complex) -> Verdict:
    return every(
        *(
            same(
                sum(comb(len(row), m + 1) for row in facets(k)),
                sum(valence(k, s) for s in k.simplices if len(s) == m + 1),
            )
            for m in range(dimension(k) + 1)
        )
    )


def _link_of_link(k: Complex) -> Verdict:
    def holds(s: Simplex) -> Verdict:
        around = link(k, s)
        return every(*(same(link(k, s | t), link(around, t), _at(s)) for t in around.simplices))

    return every(*map(holds, k.simplices))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "faces-are-counted-by-binomials",
        Clause.CPLX_SIMPLEX_1,
        "A simplex of n vertices has as many faces of m vertices as n has subsets of m.",
        COMPLEXES,
        _faces,
    ),
    Law(
        "incidence-is-being-in-the-frontier",
        Clause.CPLX_SIMPLEX_2,
        "A simplex is incident to its frontier; adjacent are two whose frontiers meet.",
        COMPLEXES,
        _incidence,
    ),
    Law(
        "join-of-simplices-adds-vertices",
        Clause.CPLX_SIMPLEX_3,
        "Two simplices are rejected at their lowest common vertex, or joined with all vertices.",
        COMPLEXES,
        _join_of_simplices,
    ),
    Law(
        "facets-are-the-least-list",
        Clause.CPLX_FACET_2,
        "The facets are the simplices in no larger one; all are needed, and they are enough.",
        COMPLEXES,
        _facets,
    ),
    Law(
        "rows-are-read-one-by-one",
        Clause.CPLX_FACET_3,
        "Rows are read as their closure in any order, or rejected at the first that is bad alone.",
        FACET_ROWS,
        _reading_rows,
    ),
    Law(
        "text-is-read-back",
        Clause.CPLX_FACET_4,
        "The text of a complex is read as the complex, and so is a list of all its simplices.",
        COMPLEXES,
        _text,
    ),
    Law(
        "closed-star-is-a-join",
        Clause.CPLX_STAR_2,
        "The closed star is the join of the simplex and its link, and the link is what is off it.",
        COMPLEXES,
        _closed_star,
    ),
    Law(
        "nothing-is-around-an-absent-simplex",
        Clause.CPLX_STAR_1,
        "Star, closed star and valence of a simplex that is not there are empty and 0.",
        COMPLEXES,
        _absent,
    ),
    Law(
        "valences-count-faces-of-facets",
        Clause.CPLX_STAR_3,
        "The valences of all m-simplices add up to the numbers of m-faces of the facets.",
        COMPLEXES,
        _valence,
    ),
    Law(
        "link-in-a-link-is-the-link-of-the-union",
        Clause.CPLX_STAR_4,
        "The link of τ in the link of σ is the link of their union.",
        COMPLEXES,
        _link_of_link,
    ),
)
