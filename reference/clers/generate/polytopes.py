"""Polytopes and surfaces of polygons, good and broken, as Hypothesis strategies.

They shrink towards a point, a triangle, a tetrahedron: towards fewer faults, fewer dissolved edges
and smaller factors.
"""

from collections.abc import Mapping
from itertools import product
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import face_list
from clers.complexes.polytopes.cells import CellList, Polytope, boundary, counts, dimension
from clers.complexes.polytopes.construct import LARGEST, polytope
from clers.complexes.polytopes.dual import dual
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.order import from_complex
from clers.complexes.polytopes.oriented import polygon_list
from clers.complexes.polytopes.polygons import (
    Polygon,
    PolygonList,
    cell_list,
    polygon_surface,
    sides,
)
from clers.complexes.polytopes.products import circle, cube, polygon, skeleton, times
from clers.complexes.simplicial import Complex, closure
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.generate.scripts import CHOICES
from clers.generate.surfaces import closed_surfaces, surfaces

PROJECTIVE_PLANE: Final = closure(
    (
        *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1)),
        *((1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)),
    )
)
"""The projective plane on six vertices."""


def accepted(made: Accepted[Polytope] | Rejected) -> Polytope:
    """What is a polytope by construction."""
    if isinstance(made, Accepted):
        return made.value
    raise AssertionError(f"no polytope was made: {made.line()}")


def dissolved(of: PolygonList, choice: int) -> PolygonList:
    """Without one inner edge, its two polygons become one; or as it was, if they cannot."""
    every = list(sides(of))
    side = every[choice % len(every)]
    twins = [s for s in every if (s.tail, s.head) == (side.head, side.tail)]
    if not twins:
        return of
    keep, gone = side.face, twins[0].face
    first, second = _from(of.faces[keep], side.head), _from(of.faces[gone], side.tail)
    joined = (*first, *second[1:-1])
    faces = tuple(joined if t == keep else face for t, face in enumerate(of.faces) if t != gone)
    made = PolygonList(faces, of.vertices)
    return made if isinstance(polygon_surface(made), Accepted) else of


def _from(face: Polygon, vertex: int) -> Polygon:
    at = face.index(vertex)
    return face[at:] + face[:at]


def of_triangles(surface: Surface) -> PolygonList:
    """A triangulated surface as a polygon list."""
    mesh = face_list(surface)
    return PolygonList(mesh.faces, mesh.vertices)


def _dual(of: PolygonList) -> PolygonList:
    made = polygon_list(accepted(dual(accepted(polygon_surface(of)))))
    if isinstance(made, Accepted):
        return made.value
    raise AssertionError(f"no orientation was found: {made.line()}")


@st.composite
def oriented_polygons(draw: st.DrawFn, max_faces: int = 24) -> PolygonList:
    """Oriented polygonal surfaces: triangles with edges dissolved, and duals of closed ones."""
    if draw(st.booleans()):
        mesh = _dual(of_triangles(draw(closed_surfaces(max_faces, (0, 1), (1, 2)))))
    else:
        mesh = of_triangles(draw(surfaces(max_faces, (0, 1), (0, 3), (1, 2))))
    for choice in draw(st.lists(CHOICES, max_size=8)):
        mesh = dissolved(mesh, choice)
    turns = draw(st.lists(st.integers(0, 5), min_size=len(mesh.faces), max_size=len(mesh.faces)))
    faces = (
        face[turn % len(face) :] + face[: turn % len(face)]
        for face, turn in zip(mesh.faces, turns, strict=True)
    )
    return PolygonList(tuple(faces), mesh.vertices)


@st.composite
def polygon_lists(draw: st.DrawFn) -> PolygonList:
    """Oriented polygonal surfaces and what a few faults make of them."""
    mesh = draw(oriented_polygons(12))
    faces = list(mesh.faces)
    vertices = mesh.vertices
    for fault in draw(st.lists(st.sampled_from((0, 1, 2, 3, 4, 5, 6, 6, 7, 7)), max_size=2)):
        t = draw(CHOICES) % len(faces) if faces else 0
        v, w = (draw(CHOICES) % (vertices + 1) for _ in range(2))
        match fault:
            case 0:
                faces = faces[:t] + faces[t + 1 :]
            case 1:
                faces = faces[:t] + [face[::-1] for face in faces[t : t + 1]] + faces[t + 1 :]
            case 2:
                faces = [tuple(w if x == v else x for x in face) for face in faces]
            case 3:
                vertices += 1
            case 4:
                faces += faces[t : t + 1]
            case 5:
                faces = faces[:t] + [face[1:] + face[2:3] for face in faces[t : t + 1]]
            case 6:
                faces += [(face[1], face[0], vertices) for face in faces[t : t + 1]]
                vertices += 1
            case _:
                ends = {*faces[t][:2]} if faces else set[int]()
                faces = [_halved(face, ends, vertices) for face in faces]
                vertices += 1
    return PolygonList(tuple(faces), vertices)


def _halved(face: Polygon, ends: set[int], middle: int) -> Polygon:
    """A polygon with a vertex put into the side between two ends, if it has that side."""
    for i, v in enumerate(face):
        if {v, face[(i + 1) % len(face)]} == ends:
            return (*face[: i + 1], middle, *face[i + 1 :])
    return face


def complexes() -> st.SearchStrategy[Complex]:
    """Simplicial complexes of dimension at most 3 on at most seven vertices, some with gaps."""
    simplex = st.frozensets(st.integers(0, 6), min_size=1, max_size=4)
    return st.lists(simplex, max_size=6).map(closure)


FACTORS: Final = (
    cube(0),
    cube(1),
    circle(3),
    circle(4),
    polygon(3),
    polygon(4),
    skeleton(cube(3), 2),
    from_complex(PROJECTIVE_PLANE),
    cube(3),
    CellList(2, ()),
)
"""Small polytopes of which larger ones are made."""


PAIRS: Final = tuple(
    both for both in product(FACTORS, FACTORS) if sum(map(dimension, both)) <= LARGEST
)
SOLID: Final = tuple(both for both in PAIRS if sum(map(dimension, both)) > 0)


def pairs() -> st.SearchStrategy[tuple[CellList, CellList]]:
    """Two factors whose product has dimension at most 3."""
    return st.sampled_from(PAIRS)


def polytopes() -> st.SearchStrategy[Polytope]:
    """Simplicial complexes, polygonal surfaces, products."""
    made = st.one_of(
        complexes().map(from_complex).map(polytope),
        oriented_polygons(12).map(polygon_surface),
        pairs().map(lambda both: polytope(times(*both))),
    )
    return made.map(accepted)


@st.composite
def cell_lists(draw: st.DrawFn) -> CellList:
    """Polytopes, and what a few faults make of them: facets and cells lost, added, doubled."""
    of: CellList = draw(polytopes().filter(lambda p: sum(counts(p)) < 60))
    for fault in draw(st.lists(st.integers(0, 6), max_size=2)):
        of = _broken(of, fault, draw(CHOICES), draw(CHOICES))
    return of


def _broken(of: CellList, fault: int, i: int, j: int) -> CellList:
    if fault == 0:
        return CellList(of.vertices + j % 5 - 2, of.cells)
    if fault == 1 or not of.cells:
        return CellList(of.vertices, (*of.cells, *((frozenset(range(j % 5)),),) * (1 + j % 2)))
    m = i % len(of.cells)
    layer = of.cells[m]
    k = j % (len(layer) + 1)
    below = len(of.cells[m - 1]) if m else of.vertices
    cell = layer[k] if k < len(layer) else frozenset[int]()
    match fault:
        case 2:
            layer = layer[:k] + layer[k + 1 :]
        case 3:
            layer = (*layer, cell)
        case 4:
            layer = (*layer[:k], cell ^ {i % (below + 1)}, *layer[k + 1 :])
        case 5:
            layer = (*layer[:k], cell - {max(cell, default=0)}, *layer[k + 1 :])
        case _:
            other = layer[i % len(layer)] if layer else cell
            layer = (*layer, cell ^ other)
    return CellList(of.vertices, (*of.cells[:m], layer, *of.cells[m + 1 :]))


def _moebius(columns: int) -> CellList:
    """A strip of squares with its ends glued upside down."""
    n = columns
    faces = tuple((k, k + 1, n + k + 1, n + k) for k in range(n - 1))
    return _unoriented((*faces, (n - 1, n, 0, 2 * n - 1)), 2 * n)


def klein(columns: int, rows: int) -> CellList:
    """A grid of squares, closed to a Klein bottle; both at least 3."""

    def at(i: int, j: int) -> int:
        j = -j if i == columns else j
        return i % columns * rows + j % rows

    faces = tuple(
        (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
        for i in range(columns)
        for j in range(rows)
    )
    return _unoriented(faces, columns * rows)


def _unoriented(faces: tuple[Polygon, ...], vertices: int) -> CellList:
    return cell_list(PolygonList(faces, vertices))


def polygonal_surfaces() -> st.SearchStrategy[Polytope]:
    """Polygonal surfaces of every kind, one-sided ones among them."""
    plane = accepted(polytope(from_complex(PROJECTIVE_PLANE)))
    fixed = (
        plane,
        accepted(dual(plane)),
        accepted(polytope(klein(3, 3))),
        accepted(polytope(klein(4, 3))),
        accepted(polytope(_moebius(4))),
        accepted(polytope(_moebius(5))),
        accepted(polytope(times(circle(3), circle(4)))),
    )
    return st.one_of(oriented_polygons().map(polygon_surface).map(accepted), st.sampled_from(fixed))


def _boundary_of_simplex(n: int) -> CellList:
    return skeleton(from_complex(closure([range(n + 1)])), n - 1)


SPHERES_AND_SPACES: Final = tuple(
    accepted(polytope(made))
    for made in (
        cube(0),
        CellList(2, ()),
        circle(3),
        circle(5),
        _boundary_of_simplex(4),
        skeleton(cube(4), 3),
        times(circle(3), skeleton(cube(3), 2)),
        times(circle(3), from_complex(PROJECTIVE_PLANE)),
    )
)
"""Closed manifolds of dimension 0, 1 and 3: the last two are S¹ × S² and S¹ × P²."""


def closed_polytopes() -> st.SearchStrategy[Polytope]:
    """Closed manifolds of dimension 0 to 3, and duals of them."""
    closed = polygonal_surfaces().filter(lambda p: not boundary(p))
    known = st.sampled_from(SPHERES_AND_SPACES)
    return st.one_of(closed, known, known.map(lambda p: accepted(dual(p))))


def manifold_polytopes() -> st.SearchStrategy[Polytope]:
    """Manifolds of dimension 1 to 3, with boundary or not."""
    made = st.sampled_from(SOLID).map(lambda both: accepted(polytope(times(*both))))
    closed = closed_polytopes().filter(lambda p: dimension(p) > 0)
    return st.one_of(made.filter(is_manifold), polygonal_surfaces(), closed)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "cell-lists": cell_lists(),
    "polytopes": polytopes(),
    "polygonal-surfaces": polygonal_surfaces(),
    "closed-polytopes": closed_polytopes(),
    "manifold-polytopes": manifold_polytopes(),
    "small-complexes": complexes(),
    "polytope-pairs": pairs(),
    "polygon-lists": polygon_lists(),
    "oriented-polygons": oriented_polygons(),
}
"""The domains of this module, by name."""
