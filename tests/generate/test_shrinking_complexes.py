"""What complexes shrink to when a claim is wrong, or a law's subject: the least example."""

from collections.abc import Callable
from random import Random

import pytest
from hypothesis import HealthCheck, find, settings
from hypothesis import strategies as st

from clers.complexes import laws_integral, laws_parts, laws_vocabulary
from clers.complexes.facets import Row, facets
from clers.complexes.homology import Field, betti
from clers.complexes.integral import Group, homology_over_z
from clers.complexes.laws_every_dimension import LAWS
from clers.complexes.simplicial import (
    Complex,
    Simplex,
    dimension,
    is_pure,
    link,
    of_dimension,
    pieces,
    star,
)
from clers.conventions.verdict import Fails
from clers.generate.every_dimension import DOMAINS

FINDING = settings(
    max_examples=1000, database=None, deadline=None, suppress_health_check=list(HealthCheck)
)


def shrunk(of: st.SearchStrategy[object], wanted: Callable[[Complex], bool]) -> tuple[Row, ...]:
    """The facets of the example that Hypothesis shrinks to."""
    found = find(
        of, lambda k: isinstance(k, Complex) and wanted(k), settings=FINDING, random=Random(0)
    )
    assert isinstance(found, Complex)
    return facets(found)


# The claim that is wrong, and the least complex against it.
WRONG: list[tuple[str, Callable[[Complex], bool], tuple[Row, ...]]] = [
    ("there is no complex", lambda k: True, ()),
    ("every complex is pure", lambda k: not is_pure(k), ((0, 1), (2,))),
    ("every complex is connected", lambda k: len(pieces(k)) > 1, ((0,), (1,))),
    (
        "at most two triangles meet at an edge",
        lambda k: any(sum(e < t for t in of_dimension(k, 2)) > 2 for e in of_dimension(k, 1)),
        ((0, 1, 2), (0, 1, 3), (0, 1, 4)),
    ),
    ("dimension is below 4", lambda k: dimension(k) == 4, ((0, 1, 2, 3, 4),)),
    (
        "every circle bounds",
        lambda k: betti(k, Field.GF2)[1:2] > (0,),
        ((0, 1), (0, 2), (1, 2)),
    ),
    (
        "no link has an edge",
        lambda k: any(dimension(link(k, v)) == 1 for v in k.simplices),
        ((0, 1, 2),),
    ),
]


@pytest.mark.parametrize(("claim", "against", "least"), WRONG, ids=[row[0] for row in WRONG])
def test_wrong_claims(
    claim: str, against: Callable[[Complex], bool], least: tuple[Row, ...]
) -> None:
    assert shrunk(DOMAINS["complexes"], against) == least, claim


def test_torsion_shrinks_to_six_vertices() -> None:
    """Torsion is not met by chance, so a known complex is found; no other has fewer vertices."""
    found = shrunk(DOMAINS["complexes"], lambda k: any(g.torsion for g in homology_over_z(k)))
    assert len(found) == 10
    assert {v for row in found for v in row} == set(range(6))


def link_with_faces(k: Complex, simplex: Simplex) -> Complex:
    """Forgets that the link is off the simplex."""
    around = star(k, simplex)
    return Complex(frozenset(s for s in k.simplices if s | simplex in around and s != simplex))


def facets_of_largest_dimension(k: Complex) -> tuple[Row, ...]:
    """Takes the tutorial's maximal faces for the facets."""
    return tuple(row for row in facets(k) if len(row) == dimension(k) + 1)


def ranks_shifted(k: Complex) -> tuple[Group, ...]:
    """Counts dimensions from the top."""
    return homology_over_z(k)[::-1]


# The law, what is exchanged in its module and for what, and the facets of the shrunk example.
PLANTED: list[tuple[str, object, str, object, tuple[Row, ...]]] = [
    ("closed-star-is-a-join", laws_vocabulary, "link", link_with_faces, ((0, 1),)),
    (
        "facets-are-the-least-list",
        laws_vocabulary,
        "facets",
        facets_of_largest_dimension,
        ((0, 1), (2,)),
    ),
    (
        "purity-has-a-witness",
        laws_parts,
        "facets",
        facets_of_largest_dimension,
        ((0, 1), (2,)),
    ),
    (
        "rank-over-z-is-the-betti-number-over-q",
        laws_integral,
        "homology_over_z",
        ranks_shifted,
        ((0, 1),),
    ),
]


@pytest.mark.parametrize(("name", "module", "attribute", "fault", "least"), PLANTED)
def test_planted_faults(
    name: str,
    module: object,
    attribute: str,
    fault: object,
    least: tuple[Row, ...],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """CONV-LAW-5. The law fails, and this is what it is shown to fail on."""
    (law,) = [law for law in LAWS if law.name == name]
    monkeypatch.setattr(module, attribute, fault)
    assert shrunk(DOMAINS[law.domain], lambda k: isinstance(law.check(k), Fails)) == least
