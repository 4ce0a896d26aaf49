"""Laws of prediction."""

from typing import Final

from clers.complexes.surface import BORDER, Corner
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtVertex
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.given import outlined
from clers.geometry.box import Boxed, boxed
from clers.geometry.given import LATTICE_MESHES, MESHES, LatticeMesh
from clers.geometry.mesh import Mesh
from clers.geometry.order import in_creation_order
from clers.geometry.predict import (
    NONE,
    parallelogram_corner_by_definition,
    parallelogram_corners,
    prediction,
)


def boxed_points(given: LatticeMesh) -> Boxed:
    """The points in their box; the domain's fit in one."""
    match boxed(given.quantised):
        case Accepted(value):
            return value
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def corners_by_definition(given: Mesh) -> Verdict:
    """One pass finds the corners that the definition finds, on a surface in any order."""
    surface = given.surface
    found = parallelogram_corners(surface)
    expected = [parallelogram_corner_by_definition(surface, v) for v in range(surface.vertices)]
    return same(expected, list(found))


def earlier_vertices_only(given: LatticeMesh) -> Verdict:
    """A prediction is the same when the index list ends before its vertex; it stays in the box."""
    surface, found = given.surface, boxed_points(given)
    for v, corner in enumerate(parallelogram_corners(surface)):
        for axis, extent in enumerate(found.box.extent):
            whole = prediction(surface, corner, v, axis, found.indices, extent)
            prefix = prediction(surface, corner, v, axis, found.indices[: 3 * v], extent)
            if whole != prefix or not 0 <= whole <= extent:
                return Fails(str(whole), str(prefix), AtVertex(v))
    return Holds()


def predicted_by_the_rule(given: LatticeMesh) -> Verdict:
    """a + b − o on each axis, moved into the box; or the vertex before."""
    surface, found = given.surface, boxed_points(given)
    points = [found.indices[3 * v : 3 * v + 3] for v in range(surface.vertices)]
    for v, c in enumerate(parallelogram_corners(surface)):
        expected: list[int] = list(points[v - 1]) if v else [0, 0, 0]
        if c != NONE:
            a, b = (surface.vertex[3 * (c // 3) + (c + turn) % 3] for turn in (1, 2))
            o = surface.vertex[surface.opposite[c]]
            sums = zip(points[a], points[b], points[o], found.box.extent, strict=True)
            expected = [sorted((0, p + q - r, extent))[1] for p, q, r, extent in sums]
        got = [
            prediction(surface, c, v, axis, found.indices, extent)
            for axis, extent in enumerate(found.box.extent)
        ]
        if expected != got:
            return Fails(str(expected), str(got), AtVertex(v))
    return Holds()


def created_vertices_have_their_tip(given: Mesh) -> Verdict:
    """The vertex of a C is predicted across its gate, where there is something across."""
    encoding = encode_surface(given.surface)
    surface = in_creation_order(given.surface, encoding)
    corners = parallelogram_corners(surface)
    faces = outlined(encoding.stream).face
    word = encoding.stream.word
    tips = [Corner(3 * face) for x, face in zip(word, faces, strict=True) if x == "C"]
    across = [tip for tip in tips if surface.opposite[tip] != BORDER]
    return every(
        same(across, [corners[surface.vertex[tip]] for tip in across]),
        at_most(encoding.stream.components_with_boundary, len(tips) - len(across), "without"),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "prediction-corners-by-definition",
        Clause.GEOM_PREDICT_1,
        "one pass finds the lowest corner with a parallelogram of lower vertices",
        MESHES,
        corners_by_definition,
    ),
    Law(
        "prediction-by-the-rule",
        Clause.GEOM_PREDICT_2,
        "a vertex is predicted at a + b − o, moved into the box, or at the vertex before",
        LATTICE_MESHES,
        predicted_by_the_rule,
    ),
    Law(
        "prediction-from-earlier-vertices",
        Clause.GEOM_PREDICT_3,
        "the prediction of a vertex needs the indices of lower vertices only",
        LATTICE_MESHES,
        earlier_vertices_only,
    ),
    Law(
        "prediction-across-the-gate",
        Clause.GEOM_PREDICT_4,
        "a vertex created by C is predicted from the tip of its face",
        MESHES,
        created_vertices_have_their_tip,
    ),
)
