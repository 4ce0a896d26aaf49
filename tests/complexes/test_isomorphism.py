"""Isomorphism against numbers that others have counted, and by trying every permutation."""

from itertools import permutations, product
from math import comb, factorial

import pytest
from golden_complexes import (
    BAND,
    OCTAHEDRON,
    SQUARE,
    TETRAHEDRON,
    TORUS_7,
    TRIANGLE,
    Triangles,
    accepted,
    beside,
)

from clers.complexes.canonical import agreement, canonical_form, canonical_surface, code
from clers.complexes.corner_table import face_list, surface
from clers.complexes.difference import Difference
from clers.complexes.difference_by_definition import first_difference_by_definition
from clers.complexes.face_list import FaceList
from clers.complexes.isomorphism import Different, Isomorphic, is_isomorphism, isomorphism
from clers.complexes.relabel import mirror, relabelled
from clers.complexes.surface import Corner, Surface, Vertex
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Holds
from clers.operators.subdivide import flip_edge, split_face


def polygon(vertices: tuple[int, ...]) -> list[Triangles]:
    """All ways to cut a polygon into triangles along diagonals."""
    if len(vertices) == 2:
        return [()]
    first, last = vertices[0], vertices[-1]
    return [
        ((first, vertices[k], last), *left, *right)
        for k in range(1, len(vertices) - 1)
        for left, right in product(polygon(vertices[: k + 1]), polygon(vertices[k:]))
    ]


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 8, 9])
def test_triangulated_polygons_up_to_rotation(n: int) -> None:
    """Clauses: CPLX-ISO-5. Catalan's numbers divided by rotations, as Burnside's lemma counts them.

    A cut polygon is fixed by the half turn if a diagonal is in its middle, by the third of a turn
    if a triangle is.
    """

    def catalan(k: int) -> int:
        return comb(2 * k, k) // (k + 1)

    drawings = polygon(tuple(range(n)))
    assert len(drawings) == catalan(n - 2)
    half = n // 2 * catalan(n // 2 - 1) if n % 2 == 0 else 0
    third = 2 * (n // 3) * catalan(n // 3 - 1) if n % 3 == 0 else 0
    half = half if n > 2 else 0
    forms = {canonical_form(accepted(FaceList(drawing, n))) for drawing in drawings}
    assert n * len(forms) == catalan(n - 2) + half + third


def spheres(n: int) -> dict[tuple[tuple[int, ...], ...], Surface]:
    """All triangulated spheres of n vertices by canonical form: those a flip leads to.

    Any two are joined by flips (Wagner 1936).
    """
    mesh = TETRAHEDRON
    while mesh.vertices < n:
        mesh = split_face(mesh, 0).mesh
    first = accepted(mesh)
    found = {canonical_form(first): first}
    todo = [mesh]
    while todo:
        mesh = todo.pop()
        for edge in range(3 * n - 6):
            flipped = flip_edge(mesh, edge).mesh
            form = canonical_form(accepted(flipped))
            if form not in found:
                found[form] = accepted(flipped)
                todo.append(flipped)
    return found


@pytest.mark.parametrize(("n", "up_to_mirror"), [(4, 1), (5, 1), (6, 2), (7, 5), (8, 14)])
def test_all_small_spheres(n: int, up_to_mirror: int) -> None:
    """Clauses: CPLX-ISO-3, CPLX-ISO-4, CPLX-ISO-5, CPLX-ISO-8.

    Corners under isomorphism are rooted triangulations, which Tutte counted in 1962; classes up to
    mirror images are the simplicial polyhedra: 1, 1, 2, 5, 14.
    """
    found = spheres(n)
    m = n - 3
    tutte = 2 * factorial(4 * m + 1) // (factorial(m + 1) * factorial(3 * m + 2))
    codes = {code(of, Corner(c)) for of in found.values() for c in range(3 * of.faces)}
    assert len(codes) == tutte
    chiral = [form for form, of in found.items() if canonical_form(mirror(of)) != form]
    assert len(found) - len(chiral) // 2 == up_to_mirror
    assert {canonical_form(mirror(found[form])) for form in chiral} == set(chiral)


def labelled_surfaces(n: int) -> list[Triangles]:
    """All surfaces on exactly the vertices 0 … n−1, each as a sorted set of oriented triangles."""
    triangles = [(a, b, c) for a, b, c in product(range(n), repeat=3) if a < min(b, c) and b != c]
    sets: list[Triangles] = [()]
    for triangle in triangles:
        sets += [(*faces, triangle) for faces in sets if fits(triangle, faces)]
    return [faces for faces in sets if isinstance(surface(FaceList(faces, n)), Accepted)]


def fits(triangle: tuple[int, int, int], faces: Triangles) -> bool:
    """No edge run twice, and no triangle on the same vertices."""
    return not any(runs(triangle) & runs(face) or set(triangle) == set(face) for face in faces)


def runs(triangle: tuple[int, int, int]) -> set[tuple[int, int]]:
    a, b, c = triangle
    return {(a, b), (b, c), (c, a)}


@pytest.mark.parametrize("n", [3, 4, 5])
def test_every_surface_on_few_vertices(n: int) -> None:
    """Clauses: CPLX-ISO-1, CPLX-ISO-5: forms are equal exactly within an orbit of permutations."""
    by_form: dict[tuple[tuple[int, ...], ...], set[Triangles]] = {}
    for faces in labelled_surfaces(n):
        form = canonical_form(accepted(FaceList(faces, n)))
        by_form.setdefault(form, set()).add(faces)
    for members in by_form.values():
        one = min(members)
        orbit = {renamed(one, images) for images in permutations(range(n))}
        assert orbit == members


def renamed(faces: Triangles, images: tuple[int, ...]) -> Triangles:
    """The triangles under other names, each begun at its lowest vertex, sorted."""
    moved = [(images[a], images[b], images[c]) for a, b, c in faces]
    return tuple(sorted(min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in moved))


def bipyramid(n: int) -> FaceList:
    """Two cones over an n-gon."""
    ring = [(i, (i + 1) % n) for i in range(n)]
    return FaceList((*((i, j, n) for i, j in ring), *((j, i, n + 1) for i, j in ring)), n + 2)


def ring(pattern: str) -> FaceList:
    """A ring of triangles: for each o one with an edge on the outer curve, for each i the inner."""
    outer, inner = pattern.count("o"), pattern.count("i")
    faces: list[tuple[int, int, int]] = []
    x, y = 0, 0
    for step in pattern:
        a, b = x % outer, outer + y % inner
        if step == "o":
            faces.append((a, (x + 1) % outer, b))
            x += 1
        else:
            faces.append((a, outer + (y + 1) % inner, b))
            y += 1
    return FaceList(tuple(faces), outer + inner)


def fan_with_ear(edge: int) -> FaceList:
    """Six triangles about vertex 8, and a seventh outside on their edge from `edge` to the next."""
    fan = ((8, i, i + 1) for i in range(6))
    return FaceList((*fan, (edge + 1, edge, 7)), 9)


STACKED = FaceList(
    (
        *((0, 1, 3), (1, 2, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)),
        *((2, 0, 5), (0, 3, 5), (3, 2, 5)),
    ),
    6,
)
"""The bipyramid over a triangle with vertex 5 put into its face 2 0 3."""

HEXAGON_Z = FaceList(((0, 1, 2), (0, 2, 5), (2, 3, 5), (3, 4, 5)), 6)
"""A hexagon cut by a Z. Its mirror image is cut by an N."""

HEXAGON_N = FaceList(((0, 2, 1), (0, 5, 2), (2, 5, 3), (3, 5, 4)), 6)

DIFFERENCES: tuple[tuple[FaceList, FaceList, Difference, str], ...] = (
    (TRIANGLE, SQUARE, Difference.FACES, "1 faces against 2"),
    (beside(TRIANGLE, TRIANGLE), SQUARE, Difference.VERTICES, "6 vertices against 4"),
    (
        beside(TORUS_7, TETRAHEDRON),
        bipyramid(9),
        Difference.COMPONENTS,
        "2 components against 1",
    ),
    (
        beside(OCTAHEDRON, OCTAHEDRON),
        beside(TETRAHEDRON, bipyramid(6)),
        Difference.COUNTS,
        "component with 12 faces, 8 vertices, 18 edges, 0 boundary edges, 0 curves, 0 handles: "
        "0 against 1",
    ),
    (ring("oioioioi"), ring("oioioiii"), Difference.CURVES, "curve of 3 edges: 0 against 1"),
    (OCTAHEDRON, STACKED, Difference.VALENCES, "inner vertex of 3: 0 against 2"),
    (
        HEXAGON_Z,
        HEXAGON_N,
        Difference.KINDS,
        "corner at border vertex of 1, then border vertex of 2, then border vertex of 3: "
        "0 against 2",
    ),
)


@pytest.mark.parametrize(("first", "second", "what", "detail"), DIFFERENCES)
def test_differences_are_named(
    first: FaceList, second: FaceList, what: Difference, detail: str
) -> None:
    """Clause: CPLX-ISO-7."""
    assert isomorphism(accepted(first), accepted(second)) == Different(what, detail)
    assert first_difference_by_definition(first, second) == what


@pytest.mark.parametrize(
    ("known", "other", "agreed"),
    [((), (1,), 0), ((1, 2), (2, 2), 0), ((1, 2, 3), (1, 2, 4), 2), ((1, 2), (1, 2, 3), 2)],
)
def test_codes_agree_up_to_where_they_part(
    known: tuple[int, ...], other: tuple[int, ...], agreed: int
) -> None:
    """Clause: CPLX-ISO-3."""
    assert agreement(known, iter(other)) == agreed


def test_chiral_fans_differ_in_their_walks_alone() -> None:
    """Clauses: CPLX-ISO-7, CPLX-ISO-8. The ear is third from one end and fourth from the other."""
    first, second = accepted(fan_with_ear(2)), accepted(fan_with_ear(3))
    answer = isomorphism(first, second)
    assert isinstance(answer, Different)
    assert answer.what == Difference.WALKS
    assert isinstance(isomorphism(first, mirror(second)), Isomorphic)
    assert isinstance(isomorphism(mirror(first), second), Isomorphic)


def test_chiral_hexagons() -> None:
    """Clause: CPLX-ISO-8."""
    z, n = accepted(HEXAGON_Z), accepted(HEXAGON_N)
    assert mirror(z) == n
    assert isinstance(isomorphism(z, n), Different)
    assert isinstance(isomorphism(accepted(BAND), mirror(accepted(BAND))), Isomorphic)


def test_components_match_whatever_their_order() -> None:
    """Clauses: CPLX-ISO-1, CPLX-ISO-5. Of components with one profile any that fits is right."""
    one = beside(fan_with_ear(2), fan_with_ear(3), fan_with_ear(2), TRIANGLE)
    same = beside(TRIANGLE, fan_with_ear(3), fan_with_ear(2), fan_with_ear(2))
    other = beside(TRIANGLE, fan_with_ear(3), fan_with_ear(3), fan_with_ear(2))
    answer = isomorphism(accepted(one), accepted(same))
    assert isinstance(answer, Isomorphic)
    assert is_isomorphism(accepted(one), accepted(same), answer) == Holds()
    assert isinstance(isomorphism(accepted(one), accepted(other)), Different)
    assert canonical_form(accepted(one)) == canonical_form(accepted(same))
    assert canonical_form(accepted(one)) != canonical_form(accepted(other))


@pytest.mark.parametrize("order", list(permutations(range(3))))
def test_each_component_is_found_wherever_it_stands(order: tuple[int, ...]) -> None:
    """Clause: CPLX-ISO-1. Fans that differ in their walks alone, and one that has no twin."""
    fans = (fan_with_ear(2), fan_with_ear(3), fan_with_ear(2))
    first, second = accepted(beside(*fans)), accepted(beside(*(fans[i] for i in order)))
    answer = isomorphism(first, second)
    assert isinstance(answer, Isomorphic)
    assert is_isomorphism(first, second, answer) == Holds()


def test_one_certificate_by_hand() -> None:
    """Clause: CPLX-ISO-2. The square with its faces exchanged and its vertices counted from 2."""
    first, second = accepted(SQUARE), accepted(FaceList(((3, 0, 2), (1, 2, 0)), 4))
    # faces 0 1 2, 0 2 3 go to 2 3 0 = (3 0 2, turned), 2 0 1 = (1 2 0, turned)
    vertices = tuple(map(Vertex, (2, 3, 0, 1)))
    corners = tuple(map(Corner, (2, 0, 1, 4, 5, 3)))
    assert is_isomorphism(first, second, Isomorphic(vertices, corners)) == Holds()
    swapped = Isomorphic(vertices, (*corners[3:], *corners[:3]))
    assert isinstance(is_isomorphism(first, second, swapped), Fails)
    assert isinstance(is_isomorphism(first, accepted(TRIANGLE), swapped), Fails)
    answer = isomorphism(first, second)
    assert isinstance(answer, Isomorphic)
    assert is_isomorphism(first, second, answer) == Holds()


def test_relabelled_by_hand() -> None:
    """Clause: CPLX-ISO-1. The new vertex k is the old 3 − k; the faces are exchanged."""
    square = accepted(SQUARE)
    order = tuple(map(Vertex, (3, 2, 1, 0)))
    turned = relabelled(square, order, (Corner(5), Corner(1)))
    # face 0 2 3 begun at 3 is 3 0 2, under new names 0 3 1; face 0 1 2 begun at 1 is 2 1 3
    assert face_list(turned) == FaceList(((0, 3, 1), (2, 1, 3)), 4)
    assert turned == accepted(face_list(turned))


def test_canonical_form_of_a_triangle_and_a_square() -> None:
    """Clauses: CPLX-ISO-3, CPLX-ISO-5, CPLX-ISO-6. Worked by hand."""
    assert canonical_form(accepted(TRIANGLE)) == ((-1, -1, -1),)
    # The tip is opposite to the border, and so is `next` of it; the second face is seen last,
    # from its corner 3, which looks back at corner 2.
    assert canonical_form(accepted(SQUARE)) == ((-1, -1, 3, 2, -1, -1),)
    both = canonical_form(accepted(beside(SQUARE, TRIANGLE)))
    assert both == ((-1, -1, -1), (-1, -1, 3, 2, -1, -1))
    named = canonical_surface(accepted(beside(SQUARE, TRIANGLE)))
    assert face_list(named) == FaceList(((0, 1, 2), (3, 4, 5), (6, 4, 3)), 7)
