"""Solids by hand: touching parts stay apart, empty results are passed over, openings are curves."""

from clers.complexes.topology import components
from clers.conventions.result import Accepted
from clers.generate.solids import Combine, Hole, Part, Program, Shape, build
from clers.geometry.mesh import Mesh

BOX = Part(Combine.UNION, Shape.BOX, 0, (2, 2, 2), (0, 0, 0), (0, 0, 0))  # edges of length 2


def built(*parts: Part, holes: tuple[Hole, ...] = ()) -> Mesh:
    result = build(Program(parts, holes), 200)
    assert isinstance(result, Accepted)
    return result.value


def places(of: Mesh) -> set[tuple[float, float, float]]:
    assert of.positions is not None
    return {of.positions.point(v) for v in range(of.positions.vertices)}


def test_box() -> None:
    """12 faces, 8 vertices at (±1, ±1, ±1)."""
    mesh = built(BOX)
    assert (mesh.surface.faces, mesh.surface.vertices) == (12, 8)
    assert places(mesh) == {
        (x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)
    }


def test_boxes_that_touch_along_an_edge_stay_apart() -> None:
    """Sixteen vertices at fourteen places: never welded by place."""
    touching = Part(Combine.UNION, Shape.BOX, 0, (2, 2, 2), (0, 0, 0), (8, 8, 0))
    mesh = built(BOX, touching)
    assert len(components(mesh.surface)) == 2
    assert mesh.surface.vertices == 16
    assert len(places(mesh)) == 14


def test_empty_result_is_passed_over() -> None:
    """A box less itself would be nothing."""
    nothing = Part(Combine.DIFFERENCE, Shape.BOX, 0, (2, 2, 2), (0, 0, 0), (0, 0, 0))
    assert built(BOX, nothing) == built(BOX)


def test_too_many_faces_are_passed_over() -> None:
    """A ball has 32 faces, over a limit of 20."""
    ball = Part(Combine.APART, Shape.BALL, 1, (2, 2, 2), (0, 0, 0), (0, 0, 0))
    result = build(Program((BOX, ball), ()), 20)
    assert result == Accepted(built(BOX))


def test_plate_has_a_handle_a_hole() -> None:
    plate = Part(Combine.UNION, Shape.PLATE, 2, (2, 2, 2), (0, 0, 0), (0, 0, 0))
    (part,) = components(built(plate).surface)
    assert (part.genus, part.curves) == (3, 0)


def test_apart_is_another_component() -> None:
    beside = Part(Combine.APART, Shape.BOX, 0, (2, 2, 2), (0, 0, 0), (0, 0, 0))
    assert len(components(built(BOX, beside).surface)) == 2


def test_openings() -> None:
    """One face away; the same face asked again touches the curve now, so it stays."""
    once = built(BOX, holes=(Hole(False, 0),))
    assert (once.surface.faces, components(once.surface)[0].curves) == (11, 1)
    star = built(BOX, holes=(Hole(True, 0),))
    assert (star.surface.vertices, components(star.surface)[0].curves) == (7, 1)
    twice = built(BOX, holes=(Hole(False, 0), Hole(False, 10)))
    assert components(twice.surface)[0].curves <= 2
