"""The link condition on all small manifolds: an edge is contracted exactly where it may be."""

from itertools import combinations

import pytest
from moved import after

from clers.complexes.known import (
    ANNULUS,
    KLEIN,
    MOEBIUS_BAND,
    OCTAHEDRON,
    PROJECTIVE,
    SIXTEEN_CELL,
    SPHERES,
    THREE_TORUS,
    TORUS,
)
from clers.complexes.manifolds.kind import Sphere
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds
from clers.generate.exhaustive import connected_surfaces, sphere_triangulations
from clers.operators.moves.apply import apply
from clers.operators.moves.augmented import around, in_order
from clers.operators.moves.candidates import flips
from clers.operators.moves.contract import coned, contract, merged
from clers.operators.moves.laws_common import described
from clers.operators.moves.laws_contract import LAWS, made_regardless
from clers.operators.moves.move import Contract, Split, Subdivide
from clers.operators.moves.reach import Form, canonical, reachable
from clers.operators.moves.recognise import recognise
from clers.operators.moves.split import spanning, split

(EXACT,) = [law for law in LAWS if law.name == "contraction-condition-is-exact"]


def test_all_surfaces_of_few_faces() -> None:
    """Connected oriented surfaces of six faces at most. Clause: OPER-CONTRACT-2."""
    found = [closure(faces) for faces in connected_surfaces(6)]
    assert len(found) > 50
    for k in found:
        assert EXACT.check(k) == Holds(), k


def test_a_fold_may_give_a_disc_again() -> None:
    """So that facets must be counted: four become two. Clause: OPER-CONTRACT-2."""
    k = closure([(0, 1, 2), (0, 2, 3), (3, 2, 4), (0, 3, 4)])
    folded = merged(k, Contract(0, 4))
    assert folded == closure([(0, 1, 2), (0, 2, 3)])
    assert described(folded) == described(k)
    assert not isinstance(contract(k, Contract(0, 4)), Accepted)


def test_all_spheres_of_few_vertices() -> None:
    """Clause: OPER-CONTRACT-2."""
    for vertices in (4, 5, 6, 7):
        for faces in sphere_triangulations(vertices):
            assert EXACT.check(closure(faces)) == Holds(), faces


def one_face_less(forms: frozenset[Form]) -> list[Complex]:
    """Each surface, and each with a face taken away, up to isomorphism."""
    found = [closure(form) for form in forms]
    open_ = {
        canonical(closure([*form[:i], *form[i + 1 :]])) for form in forms for i in range(len(form))
    }
    return found + [closure(form) for form in open_]


def seven(k: Complex) -> Complex:
    return after(k, Subdivide(in_order(of_dimension(k, 2)[0]), len(of_dimension(k, 0))))


@pytest.mark.parametrize(
    ("name", "k"),
    [
        ("projective planes on 6 vertices", PROJECTIVE.complex),
        ("projective planes on 7 vertices", seven(PROJECTIVE.complex)),
        ("tori on 7 vertices", TORUS.complex),
        ("Klein bottles on 8 vertices", KLEIN.complex),
    ],
)
def test_other_surfaces(name: str, k: Complex) -> None:
    """Closed, and with a boundary curve of three edges. Clause: OPER-CONTRACT-2."""
    forms = reachable(k)
    surfaces = one_face_less(forms) if len(forms) < 4 else [closure(form) for form in forms]
    for surface in surfaces:
        assert EXACT.check(surface) == Holds(), name


@pytest.mark.parametrize("k", [ANNULUS.complex, MOEBIUS_BAND.complex])
def test_bands(k: Complex) -> None:
    """Nothing can be contracted: each edge crosses, or is in a curve of three or five edges."""
    assert EXACT.check(k) == Holds()


def test_curves() -> None:
    """Circles of n edges for n > 3 and arcs of n > 1 can be contracted, everywhere."""
    for n in range(1, 7):
        arc = closure([(i, i + 1) for i in range(n)])
        circle = closure([(i, (i + 1) % (n + 2)) for i in range(n + 2)])
        for k, edges, least in ((arc, n, 1), (circle, n + 2, 3)):
            good = [
                edge
                for edge in of_dimension(k, 1)
                if isinstance(contract(k, Contract(*in_order(edge))), Accepted)
            ]
            assert len(good) == (edges if edges > least else 0)
            assert EXACT.check(k) == Holds()


def spheres_of_dimension_three(most: int) -> dict[int, set[Form]]:
    """All that bistellar moves reach from the smallest, never with more vertices than `most`."""
    start = SPHERES[3].complex
    found, todo = {canonical(start)}, [start]
    while todo:
        k = todo.pop()
        moves = list(flips(k))
        if len(of_dimension(k, 0)) < most:
            moves += [Subdivide(in_order(f), most + 90) for f in of_dimension(k, 3)]
        for move in moves:
            result = apply(move, k)
            if isinstance(result, Accepted):
                form = canonical(result.value)
                if form not in found:
                    found.add(form)
                    todo.append(closure(form))
    by_size: dict[int, set[Form]] = {}
    for form in found:
        by_size.setdefault(1 + max(map(max, form)), set()).add(form)
    return by_size


def test_all_three_spheres_of_few_vertices() -> None:
    """1, 2 and 5 on 5, 6 and 7 vertices (Grünbaum and Sreedharan 1967). Clause: OPER-CONTRACT-3."""
    spheres = spheres_of_dimension_three(7)
    assert {size: len(forms) for size, forms in spheres.items()} == {5: 1, 6: 2, 7: 5}
    for forms in spheres.values():
        for form in forms:
            k = closure(form)
            for edge in of_dimension(k, 1):
                move = Contract(*in_order(edge))
                accepted = isinstance(contract(k, move), Accepted)
                assert accepted == (recognise(merged(k, move)) == Sphere(3)), (form, edge)


def test_in_higher_dimensions() -> None:
    """The 16-cell, and the smallest 4-sphere with a vertex on an edge."""
    for k in (SIXTEEN_CELL.complex, after(SPHERES[4].complex, Subdivide((0, 1), 6))):
        n = dimension(k)
        for edge in of_dimension(k, 1):
            move = Contract(*in_order(edge))
            accepted = isinstance(contract(k, move), Accepted)
            assert accepted == (recognise(merged(k, move)) == Sphere(n))


def test_no_edge_of_the_neighbourly_torus_can_be_contracted() -> None:
    """Every two of 15 vertices are joined, and 14 would be too few."""
    k = THREE_TORUS.complex
    for edge in of_dimension(k, 1)[:5]:
        assert not isinstance(contract(k, Contract(*in_order(edge))), Accepted)


def test_the_cone() -> None:
    """Clause: OPER-CONTRACT-1."""
    assert coned(OCTAHEDRON.complex) == (OCTAHEDRON.complex, -1)
    assert coned(closure([(0, 1)])) == (closure([(0, 1), (-1, 0), (-1, 1)]), -1)
    assert coned(closure([(-3, 1)])) == (closure([(-3, 1), (-4, -3), (-4, 1)]), -4)
    assert coned(closure([(3, 1)])) == (closure([(3, 1), (-1, 3), (-1, 1)]), -1)


def subcomplexes(of: frozenset[frozenset[int]]) -> list[frozenset[frozenset[int]]]:
    """All complexes made of these simplices, the empty one too."""
    listed = sorted(of, key=lambda s: (len(s), sorted(s)))
    found: list[frozenset[frozenset[int]]] = [frozenset()]
    for s in listed:
        faces = [s - {v} for v in s if len(s) > 1]
        found += [f | {s} for f in found if all(face in f for face in faces)]
    return found


SPLITS = [
    ("inside, degree three", SPHERES[2].complex, 0),
    ("inside, degree four", OCTAHEDRON.complex, 0),
    ("boundary, degree one", closure([(0, 1, 2)]), 0),
    ("boundary, degree two", closure([(0, 1, 2), (0, 2, 3)]), 0),
    ("boundary, degree three", closure([(0, 1, 2), (0, 2, 3), (0, 3, 4)]), 0),
    ("on a circle", closure([(0, 1), (1, 2), (0, 2)]), 0),
    ("on an arc", closure([(0, 1), (1, 2)]), 1),
    ("at an arc's end", closure([(0, 1), (1, 2)]), 0),
]

ACCEPTED = {
    # D between any two of 3 (of 4) vertices of the circle, to either side
    "inside, degree three": 6,
    "inside, degree four": 12,
}


@pytest.mark.parametrize(("name", "k", "v"), SPLITS)
def test_all_splits(name: str, k: Complex, v: int) -> None:
    """Every pair of complexes in the vertex's link. Clauses: OPER-CONTRACT-4, OPER-CONTRACT-6."""
    before, good = described(k), 0
    link = around(k, frozenset([v])) - {frozenset[int]()}
    for moved in subcomplexes(link):
        for shared in subcomplexes(moved):
            move = Split(v, 9, spanning(moved), spanning(shared))
            made, result = made_regardless(k, move), split(k, move)
            expected = made is not None and described(made) == before
            assert isinstance(result, Accepted) == expected, (name, move)
            good += expected
    assert good == ACCEPTED.get(name, good)
    assert good > 0


def test_parts_outside_the_link_are_refused() -> None:
    for moved in combinations(range(5), 2):
        move = Split(0, 9, (moved,), ())
        result = split(closure([(0, 1, 2), (0, 2, 3)]), move)
        assert not isinstance(result, Accepted)
