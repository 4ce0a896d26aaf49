"""One layout for all stages of a script of operators: where each triangle and each vertex is."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, assert_never

import numpy as np

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.simplicial import Complex, dimension, of_dimension
from clers.complexes.surface import BORDER, Corner, Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.families import Shape, Stage
from clers.operators.sheets.sheet import Sheet, cells_run, sides, sides_of
from clers.pictures.drawing import Drawing, Point, Ring, fitted
from clers.pictures.flat import flat

Triangle = tuple[int, int, int]
Edge = tuple[int, int]

MOST: Final = 400
"""So many panels, and so many triangles in each, at most. Clause: TOOL-OPERATORS-3."""


@dataclass(frozen=True, slots=True)
class Seen:
    """What is to be drawn of a stage: triangles as given, edges by lower end, loops by sides."""

    vertices: frozenset[int]
    triangles: tuple[Triangle, ...]
    edges: frozenset[Edge]
    loops: tuple[tuple[Edge, ...], ...] = ()


@dataclass(frozen=True, slots=True)
class Layout:
    """Where things are, in a box whose longer side is 1. Clause: TOOL-OPERATORS-5.

    `corners`: the points of a triangle's vertices, in its order begun with the least; `at`: the
    places of a vertex, more than one where a surface was cut open; `whole`: the triangles of all
    stages, if they are one oriented surface.
    """

    corners: Mapping[Triangle, tuple[Point, Point, Point]]
    at: Mapping[int, tuple[Point, ...]]
    rings: Mapping[Triangle, Ring]
    notes: tuple[tuple[Point, str], ...]
    whole: tuple[Triangle, ...]
    width: float
    height: float


def begun(t: Sequence[int]) -> Triangle:
    """An oriented triangle, begun with its least vertex."""
    a, b, c = t
    return min((a, b, c), (b, c, a), (c, a, b))


def seen(shape: Shape) -> Seen:
    """What is drawn of a sheet, a complex of dimension 2 at most, or a surface."""
    match shape:
        case Sheet():
            edges = {(min(side), max(side)) for side in sides(shape)}
            vertices = {v for cell in cells_run(shape) for v in cell}
            loops = tuple(tuple(sides_of(loop)) for loop in sorted(shape.loops))
            triangles = tuple(sorted(begun(t) for t in shape.triangles))
            return Seen(frozenset(vertices), triangles, frozenset(edges), loops)
        case FaceList(faces, count):
            triangles = tuple(map(begun, faces))
            return Seen(frozenset(range(count)), triangles, _edges(triangles))
        case Complex():
            points, lines, flats = (of_dimension(shape, m) for m in range(3))
            return Seen(
                frozenset(v for point in points for v in point),
                tuple(begun(sorted(t)) for t in flats),
                frozenset((min(edge), max(edge)) for edge in lines),
            )
        case _:
            assert_never(shape)


def _edges(triangles: Iterable[Triangle]) -> frozenset[Edge]:
    return frozenset(
        (min(x, y), max(x, y)) for a, b, c in triangles for x, y in ((a, b), (b, c), (c, a))
    )


def drawable(stages: Sequence[Stage]) -> Accepted[tuple[Seen, ...]] | Rejected:
    """What is drawn of each stage, or the first that cannot be. Clause: TOOL-OPERATORS-3."""
    clause, found = Clause.TOOL_OPERATORS_3, list[Seen]()
    if not 0 < len(stages) <= MOST:
        return Rejected(Reason.NOT_DRAWABLE, clause, detail=f"{len(stages)} panels")
    for k, stage in enumerate(stages):
        if isinstance(stage.shape, Complex) and dimension(stage.shape) > 2:
            detail = f"a complex of dimension {dimension(stage.shape)}"
            return Rejected(Reason.NOT_DRAWABLE, clause, AtStep(k), detail)
        shown = seen(stage.shape)
        if len(shown.triangles) > MOST:
            detail = f"{len(shown.triangles)} triangles"
            return Rejected(Reason.NOT_DRAWABLE, clause, AtStep(k), detail)
        found.append(shown)
    return Accepted(tuple(found))


def layout(of: Sequence[Seen]) -> Layout:
    """The layout of all stages. Clause: TOOL-OPERATORS-5."""
    triangles = tuple(dict.fromkeys(t for one in of for t in one.triangles))
    vertices = sorted({v for one in of for v in one.vertices})
    number = {v: i for i, v in enumerate(vertices)}
    faces = tuple((number[a], number[b], number[c]) for a, b, c in triangles)
    built = surface(FaceList(faces, len(vertices)))
    if isinstance(built, Accepted):
        return _flat(built.value, triangles)
    return _spread(of, vertices, triangles)


def _flat(whole: Surface, triangles: tuple[Triangle, ...]) -> Layout:
    """The flat drawing, each component's faces in the order in which they came."""
    drawn, width, height = fitted(flat(whole, _components(whole)))
    corners: dict[Triangle, tuple[Point, Point, Point]] = {}
    at: dict[int, tuple[Point, ...]] = {}
    for t, triangle in enumerate(triangles):
        points = drawn.corners[3 * t], drawn.corners[3 * t + 1], drawn.corners[3 * t + 2]
        corners[triangle] = points
        for v, point in zip(triangle, points, strict=True):
            at[v] = tuple(dict.fromkeys((*at.get(v, ()), _rounded(point))))
    rings = {triangles[ring.face]: ring for ring in drawn.rings}
    return Layout(corners, at, rings, drawn.notes, triangles, width, height)


def _rounded(point: Point) -> Point:
    return round(point[0], 9), round(point[1], 9)


def _components(whole: Surface) -> list[tuple[Corner, ...]]:
    """The first corners of the faces of each component, in the order of the faces."""
    part = list(range(whole.faces))
    for start in range(whole.faces):
        waiting = [start] if part[start] == start else []
        reached = set(waiting)
        while waiting:
            face = waiting.pop()
            part[face] = start
            for c in range(3 * face, 3 * face + 3):
                across = whole.opposite[c]
                if across != BORDER and across // 3 not in reached:
                    reached.add(across // 3)
                    waiting.append(across // 3)
    return [
        tuple(Corner(3 * face) for face in range(whole.faces) if part[face] == lowest)
        for lowest in sorted(set(part))
    ]


def _spread(of: Sequence[Seen], vertices: Sequence[int], triangles: tuple[Triangle, ...]) -> Layout:
    """Each vertex at one place, by stress majorisation of the distances along edges."""
    edges = {edge for one in of for edge in one.edges}
    points = majorised(len(vertices), _distances(vertices, edges))
    drawing = Drawing(tuple(points), (), (), ())
    moved, width, height = fitted(drawing)
    at = {v: (_rounded(point),) for v, point in zip(vertices, moved.corners, strict=True)}
    corners = {(a, b, c): (at[a][0], at[b][0], at[c][0]) for a, b, c in triangles}
    return Layout(corners, at, {}, (), (), width, height)


def _distances(
    vertices: Sequence[int], edges: Iterable[Edge]
) -> "np.ndarray[tuple[int, int], np.dtype[np.float64]]":
    """The lengths of shortest ways along edges; between parts half of the longest, and 1."""
    number = {v: i for i, v in enumerate(vertices)}
    n = len(vertices)
    lengths = np.full((n, n), np.inf)
    np.fill_diagonal(lengths, 0.0)
    for a, b in edges:
        lengths[number[a], number[b]] = lengths[number[b], number[a]] = 1.0
    for k in range(n):
        lengths = np.minimum(lengths, lengths[:, k : k + 1] + lengths[k : k + 1, :])
    finite = lengths[np.isfinite(lengths)]
    return np.where(np.isfinite(lengths), lengths, (finite.max() if n else 0.0) / 2 + 1.0)


def majorised(
    n: int, wanted: "np.ndarray[tuple[int, int], np.dtype[np.float64]]", rounds: int = 300
) -> list[Point]:
    """Points whose distances are as wanted, as nearly as may be: from a circle, by SMACOF.

    Each round is the Guttman transform with the weights 1/d², which never makes the stress worse
    (Gansner, Koren and North, 2004); the same points for the same distances.
    """
    angles = 2 * np.pi * np.arange(n) / max(n, 1)
    # a circle with one point off it, because a circle of a symmetric graph may be a saddle
    places = np.stack([np.cos(angles), np.sin(angles)], axis=1) * (
        1 + 0.1 * np.arange(n)[:, None] / max(n, 1)
    )
    weights = np.divide(1.0, wanted**2, out=np.zeros_like(wanted), where=wanted > 0)
    laplacian = np.diag(weights.sum(axis=1)) - weights
    inverse = np.linalg.pinv(laplacian)
    for _ in range(rounds):
        apart = places[:, None, :] - places[None, :, :]
        lengths = np.sqrt((apart**2).sum(axis=2))
        ratio = np.divide(
            weights * wanted, lengths, out=np.zeros_like(wanted), where=lengths > 1e-12
        )
        pull = np.diag(ratio.sum(axis=1)) - ratio
        places = inverse @ (pull @ places)
    return [(float(x), float(y)) for x, y in places]
