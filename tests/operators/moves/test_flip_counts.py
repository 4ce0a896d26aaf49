"""Triangulations reached by flips, held against numbers from the literature."""

from itertools import permutations
from math import factorial

import pytest
from moved import after

from clers.complexes.known import KLEIN, PROJECTIVE, SPHERES, TORUS
from clers.complexes.simplicial import Complex, closure, of_dimension
from clers.generate.exhaustive import sphere_triangulations
from clers.operators.moves.augmented import in_order
from clers.operators.moves.move import Subdivide
from clers.operators.moves.reach import (
    Form,
    automorphisms,
    canonical,
    labelled,
    neighbours,
    reachable,
)


def with_vertices(k: Complex, count: int) -> Complex:
    """The surface with vertices put into faces, as many as are wanted."""
    for new in range(len(of_dimension(k, 0)), count):
        k = after(k, Subdivide(in_order(of_dimension(k, 2)[-1]), new))
    return k


def counted(forms: frozenset[Form]) -> tuple[int, int, int]:
    """The numbers of surfaces, of roots up to automorphism, and of labellings."""
    roots = labels = 0
    for form in forms:
        k = closure(form)
        symmetries = automorphisms(k)
        roots += 6 * len(form) // symmetries
        labels += factorial(len(of_dimension(k, 0))) // symmetries
    return len(forms), roots, labels


# Up to isomorphism: 1, 1, 2, 5, 14 (Bowen and Fisk 1967).
SPHERE = {4: (1, 1, 1), 5: (1, 3, 10), 6: (2, 13, 195), 7: (5, 68, 5712), 8: (14, 399, 223440)}


@pytest.mark.parametrize("vertices", SPHERE)
def test_spheres(vertices: int) -> None:
    """Clauses: OPER-FLIPS-2, OPER-FLIPS-3."""
    found = reachable(with_vertices(SPHERES[2].complex, vertices))
    classes, roots, labels = SPHERE[vertices]
    assert counted(found) == (classes, roots, labels)
    # Tutte's k counts the vertices beside the root face, and 12 V − 24 roots have each labelling
    assert roots == [1, 3, 13, 68, 399][vertices - 4] == tutte_row(vertices)
    assert labels == factorial(vertices) * roots // (12 * vertices - 24)


def tutte_row(vertices: int) -> int:
    """2 (4k+1)! / ((k+1)! (3k+2)!) with V = k + 3."""
    k = vertices - 3
    return 2 * factorial(4 * k + 1) // (factorial(k + 1) * factorial(3 * k + 2))


@pytest.mark.parametrize("vertices", [4, 5, 6, 7])
def test_the_same_spheres_by_another_walk(vertices: int) -> None:
    """The generator's own flips, on oriented faces, with mirror images made equal."""
    oriented = sphere_triangulations(vertices)
    assert {canonical(closure(faces)) for faces in oriented} == reachable(
        with_vertices(SPHERES[2].complex, vertices)
    )


def test_labelled_spheres_are_reached_one_by_one() -> None:
    """10 and 195 without any symmetry counted. Clause: OPER-FLIPS-3."""
    for vertices, count in ((4, 1), (5, 10), (6, 195)):
        assert len(labelled(with_vertices(SPHERES[2].complex, vertices))) == count


def test_the_torus_on_seven_vertices() -> None:
    """All renamings, one by one. Clause: OPER-FLIPS-4."""
    k = TORUS.complex
    facets = of_dimension(k, 2)
    images = {
        frozenset(frozenset(name[v] for v in facet) for facet in facets)
        for name in permutations(range(7))
    }
    assert len(images) == 120 == factorial(7) // automorphisms(k)
    assert automorphisms(k) == 42
    assert neighbours(k) == []
    assert counted(reachable(k)) == (1, 2, 120)


def test_the_affine_maps_are_the_automorphisms_of_the_torus() -> None:
    mobius = {frozenset({i, (i + 1) % 7, (i + 3) % 7}) for i in range(7)}
    mobius |= {frozenset({i, (i + 2) % 7, (i + 3) % 7}) for i in range(7)}
    assert canonical(closure(mobius)) == canonical(TORUS.complex)
    for a in range(1, 7):
        for b in range(7):
            assert {frozenset((a * v + b) % 7 for v in face) for face in mobius} == mobius


def test_the_projective_plane_on_six_vertices() -> None:
    """Clause: OPER-FLIPS-4."""
    assert automorphisms(PROJECTIVE.complex) == 60
    assert neighbours(PROJECTIVE.complex) == []
    assert counted(reachable(PROJECTIVE.complex)) == (1, 1, 12)


def test_what_flips_reach_on_other_surfaces() -> None:
    """Datta and Nilakantan 2002: 3 projective planes, 7 tori, 6 Klein bottles. OPER-FLIPS-4."""
    assert len(reachable(with_vertices(PROJECTIVE.complex, 7))) == 3
    assert len(reachable(with_vertices(TORUS.complex, 8))) == 7
    assert len(reachable(KLEIN.complex)) == 6


def test_nothing_has_one_form_and_one_automorphism() -> None:
    assert canonical(Complex(frozenset())) == ()
    assert automorphisms(Complex(frozenset())) == 1


def test_forms() -> None:
    """The walk's names, by hand: a strip of two triangles, and an arc. Clause: OPER-FLIPS-1."""
    assert canonical(closure([(3, 5, 9), (5, 9, 11)])) == ((0, 1, 2), (0, 1, 3))
    assert automorphisms(closure([(3, 5, 9), (5, 9, 11)])) == 4
    assert canonical(closure([(4, 2), (2, 7), (7, 1)])) == ((0, 1), (0, 2), (2, 3))
    assert automorphisms(closure([(4, 2), (2, 7), (7, 1)])) == 2


def test_neighbours_keep_the_number_of_vertices() -> None:
    """The bipyramid over a triangle: each of its three edges on the axis' side can be flipped."""
    k = with_vertices(SPHERES[2].complex, 5)
    found = neighbours(k)
    assert len(found) == 3
    assert all(len(of_dimension(other, 0)) == 5 for other in found)
