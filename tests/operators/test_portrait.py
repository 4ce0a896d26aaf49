"""What is known of a complex, in words: OPER-PORTRAIT-1, against the known complexes."""

import pytest

from clers.complexes.integral import Group
from clers.complexes.known import KNOWN, Known
from clers.complexes.simplicial import Complex, closure
from clers.operators.portrait import Portrait, group_in_words, portrait


def named(part: str) -> Complex:
    return next(known.complex for known in KNOWN if part in known.name)


@pytest.mark.parametrize("known", [k for k in KNOWN if k.dimension <= 2], ids=lambda k: k.name)
def test_known_complexes(known: Known) -> None:
    """OPER-PORTRAIT-1: the numbers of the literature."""
    seen = portrait(known.complex)
    assert seen.f_vector == known.f_vector
    assert seen.euler == known.euler
    assert seen.components == known.q[0]
    assert seen.pure == known.pure
    assert seen.homology == tuple(group_in_words(Group(rank, torsion)) for rank, torsion in known.z)
    assert seen.manifold.startswith("of dimension") == known.manifold
    assert bool(seen.simplex) == (not known.manifold)
    assert bool(seen.types) == (known.manifold and known.dimension == 2)
    if known.manifold:
        assert (seen.orientable == "yes") == known.orientable
        assert bool(seen.one_sided) == (not known.orientable)
    assert seen.collapsible.startswith("yes") == known.collapsible


def test_groups_in_words() -> None:
    groups = [Group(0, ()), Group(1, ()), Group(2, (2, 6)), Group(0, (3,)), Group(1, (2,))]
    words = ["0", "Z", "Z^2 + Z/2 + Z/6", "Z/3", "Z + Z/2"]
    assert list(map(group_in_words, groups)) == words


def test_a_moebius_band() -> None:
    """OPER-PORTRAIT-1: five triangles around; a one-sided cycle goes through them all."""
    seen = portrait(named("Möbius"))
    assert seen == Portrait(
        f_vector=(5, 10, 5),
        euler=0,
        components=1,
        pure=True,
        homology=("Z", "Z", "0"),
        manifold="of dimension 2, with boundary",
        simplex=(),
        orientable="no",
        one_sided=seen.one_sided,
        types=("Möbius band",),
        collapsible="no: the Betti numbers over GF(2) are 1, 1, 0",
    )
    assert len(seen.one_sided) == 5
    assert all(t == tuple(sorted(t)) for t in seen.one_sided)


def test_what_refutes_a_manifold() -> None:
    """OPER-PORTRAIT-1: three pages of a book meet at its spine."""
    seen = portrait(closure([(0, 1, 2), (0, 1, 3), (0, 1, 4)]))
    assert (seen.manifold, seen.simplex) == ("no: a wall in three simplices", (0, 1))
    assert seen.orientable == "no meaning: a wall in three simplices"
    assert seen.collapsible == "yes, by 7 collapses"


def test_a_closed_sphere() -> None:
    assert portrait(named("octahedron")).manifold == "of dimension 2, without boundary"
    assert portrait(named("octahedron")).types == ("sphere",)


def test_how_a_complex_does_not_collapse() -> None:
    """OPER-PORTRAIT-1: the dunce hat has no free edge; a triangle on it is one collapse away."""
    hat = named("dunce hat")
    assert portrait(hat).collapsible == "no: no collapse can begin"
    tailed = closure([*hat.simplices, (0, 90)])
    told = portrait(tailed).collapsible
    assert told == "no: 1 collapses lead to where there is no more, and order is free"
    assert portrait(closure([])).collapsible.startswith("no: the Betti numbers over GF(2) are none")


def test_what_stays_undecided() -> None:
    """OPER-PORTRAIT-1: the suspension of the Poincaré sphere, whose poles no proof reaches."""
    poincare = named("Poincaré")
    tops = [s for s in poincare.simplices if len(s) == 4]
    seen = portrait(closure([*(s | {98} for s in tops), *(s | {99} for s in tops)]))
    assert seen.manifold.startswith("undecided: no 1000 moves")
    assert seen.simplex == (98,)
    assert seen.homology == ("Z", "0", "0", "0", "Z")
