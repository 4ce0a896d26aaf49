"""Pictures of scripts of operators: the layout, and what each panel shows."""

from itertools import pairwise
from math import dist, hypot
from pathlib import Path

import numpy as np
import pytest

from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.families import Stage, read, stages
from clers.pictures.scene import Disc, Line, Polygon, Scene, Words
from clers.pictures.stage_scene import stage_scene
from clers.pictures.stages import MOST, Seen, begun, drawable, layout, majorised, seen

FIGURE_11 = "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4; glue 4 0 5; lower-strip 2 1 4 5"
TETRAHEDRON = "zero-handle 0 1 2; glue 1 0 3; complete 2 1 3; two-handle 2 3 0"


def passed(text: str) -> tuple[Stage, ...]:
    script = read(text)
    assert isinstance(script, Accepted)
    done, fault = stages(script.value)
    assert fault is None, fault.line()
    return done


def shown(text: str) -> tuple[Seen, ...]:
    found = drawable(passed(text))
    assert isinstance(found, Accepted)
    return found.value


def image(text: str) -> Scene:
    return stage_scene(passed(text), shown(text))


def kinds(of: Scene, panel: int) -> list[str]:
    return [item.kind for item in of.groups[panel].items if not isinstance(item, Words)]


def area(points: tuple[tuple[float, float], ...]) -> float:
    (x0, y0), (x1, y1), (x2, y2) = points
    return ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2


def test_what_is_seen() -> None:
    """TOOL-OPERATORS-4: of a sheet, a complex and a surface."""
    sheet = seen(passed("zero-handle 4 2 3; make-ev 2 4 7")[-1].shape)
    assert sheet.triangles == ((2, 3, 4),)
    assert sheet.edges == {(2, 3), (3, 4), (2, 4), (2, 7)}
    assert sheet.vertices == {2, 3, 4, 7}
    assert [len(loop) for loop in sheet.loops] == [5]
    k = seen(passed("attach 0 1 2; attach 2 3 / 2; attach 9")[-1].shape)
    assert k == Seen(
        frozenset({0, 1, 2, 3, 9}),
        ((0, 1, 2),),
        frozenset({(0, 1), (1, 2), (0, 2), (2, 3)}),
    )
    grown = seen(passed("relabel 0")[-1].shape)
    assert grown.triangles == ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2))
    assert grown.edges == {(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)}
    assert grown.vertices == {0, 1, 2, 3}


def test_triangles_begin_with_their_least_vertex() -> None:
    assert [begun(t) for t in ((2, 0, 1), (1, 2, 0), (0, 1, 2))] == [(0, 1, 2)] * 3


def test_one_layout_of_one_surface() -> None:
    """TOOL-OPERATORS-5: the flat drawing of the annulus, its triangles counter-clockwise."""
    places = layout(shown(FIGURE_11))
    assert len(places.whole) == len(places.corners) == 6
    assert all(area(points) > 0 for points in places.corners.values())
    assert all(len(at) == 1 for at in places.at.values())
    assert max(places.width, places.height) == pytest.approx(1)


def test_a_sphere_has_a_face_around_the_others() -> None:
    """TOOL-OPERATORS-5: the last that came."""
    places = layout(shown(TETRAHEDRON))
    assert list(places.rings) == [(0, 2, 3)]
    assert kinds(image(TETRAHEDRON), 3).count("new") == 1
    discs = [item for item in image(TETRAHEDRON).groups[3].items if isinstance(item, Disc)]
    assert [disc.kind for disc in discs].count("new") == 1


def test_vertices_of_a_cut_surface_are_at_several_places() -> None:
    """TOOL-OPERATORS-5: a torus is opened to a polygon, so letters name its sides."""
    places = layout(shown("add-handle 0 3"))
    assert places.whole == ()  # faces of the tetrahedron are gone from it
    done = passed("add-handle 0 3")
    last = drawable(done[-1:])
    assert isinstance(last, Accepted)
    places = layout(last.value)
    assert places.notes
    assert max(map(len, places.at.values())) > 1
    items = stage_scene(done[-1:], last.value).groups[0].items
    words = [item.text for item in items if isinstance(item, Words)]
    assert {text for _, text in places.notes} <= set(words)


def test_spread_out_elsewhere() -> None:
    """TOOL-OPERATORS-5: a path of four edges is drawn with edges of one length, in a line."""
    places = layout(shown("attach 0 1; attach 1 2 / 1; attach 2 3 / 2; attach 3 4 / 3"))
    points = [places.at[v][0] for v in range(5)]
    assert places.whole == ()
    steps = [dist(p, q) for p, q in pairwise(points)]
    assert max(steps) == pytest.approx(min(steps), rel=1e-3)
    assert dist(points[0], points[4]) == pytest.approx(sum(steps), rel=2e-2)


def test_parts_are_apart() -> None:
    """TOOL-OPERATORS-5: no vertex of one on a vertex of another."""
    places = layout(shown("attach 0 1; attach 2 3; attach 4"))
    points = [places.at[v][0] for v in range(5)]
    assert min(dist(p, q) for i, p in enumerate(points) for q in points[:i]) > 0.1


def test_majorised() -> None:
    """An equilateral triangle, and the diagonal of a square, come out with their lengths."""
    triangle = majorised(3, np.ones((3, 3)) - np.eye(3))
    lengths = [dist(triangle[i], triangle[j]) for i, j in ((0, 1), (1, 2), (0, 2))]
    assert lengths == pytest.approx([1, 1, 1], rel=1e-6)
    far = np.sqrt(2.0)
    square = np.array([[0, 1, far, 1], [1, 0, 1, far], [far, 1, 0, 1], [1, far, 1, 0]])
    points = majorised(4, square)
    assert dist(points[0], points[2]) == pytest.approx(far, rel=1e-6)
    assert dist(points[0], points[1]) == pytest.approx(1, rel=1e-6)
    assert majorised(1, np.zeros((1, 1)))[0] == pytest.approx((0, 0))


def test_new_old_and_later() -> None:
    """TOOL-OPERATORS-4."""
    of = image(FIGURE_11)
    assert [group.name for group in of.groups] == [f"stage-{k}" for k in range(5)]
    assert [kinds(of, k).count("new") for k in range(5)] == [1, 1, 1, 1, 2]
    assert [kinds(of, k).count("old") for k in range(5)] == [0, 1, 2, 3, 4]
    assert [kinds(of, k).count("later") for k in range(5)] == [5, 4, 3, 2, 0]
    assert [kinds(of, k).count("vertex") for k in range(5)] == [3, 4, 5, 6, 6]
    assert [kinds(of, k).count("loop-0") for k in range(5)] == [3, 4, 5, 6, 3]
    assert [kinds(of, k).count("loop-1") for k in range(5)] == [0, 0, 0, 0, 3]


def test_captions() -> None:
    """TOOL-OPERATORS-4: the operator, and what changed."""
    words = [item.text for item in image(FIGURE_11).groups[4].items if isinstance(item, Words)]
    told = " ".join(words)
    assert "(e) lower-strip 2 1 4 5" in told
    assert "χ 1→0, components 1, genus 0, loops 1→2" in told
    assert "vertices" not in told
    idle = image("fill-corner 0")
    told = " ".join(item.text for item in idle.groups[1].items if isinstance(item, Words))
    assert "nothing: no-candidate" in told
    told = " ".join(item.text for item in idle.groups[0].items if isinstance(item, Words))
    assert "to begin with" in told
    alone = image("attach 0 1 2")
    told = " ".join(i.text for i in alone.groups[0].items if isinstance(i, Words))
    assert "attach 0 1 2" in told
    assert "(a)" not in told


def test_loops_run_beside_their_edges() -> None:
    """TOOL-OPERATORS-4: three pixels from the edge, outside of the triangle."""
    of = image("zero-handle 0 1 2")
    triangle = next(item for item in of.groups[0].items if isinstance(item, Polygon))
    lines = [item for item in of.groups[0].items if isinstance(item, Line)]
    assert len(lines) == 3
    cx = sum(x for x, _ in triangle.points) / 3
    cy = sum(y for _, y in triangle.points) / 3
    for line in lines:
        (x, y), (u, v) = line.path
        length = hypot(u - x, v - y)
        away = ((cx - x) * (v - y) - (cy - y) * (u - x)) / length  # positive on the right, y down
        inner = [
            abs((px - x) * (v - y) - (py - y) * (u - x)) / length for px, py in triangle.points
        ]
        assert min(inner) == pytest.approx(3)
        assert away < 0


def test_bare_edges() -> None:
    """TOOL-OPERATORS-4: those of no triangle are drawn, red where they are new."""
    of = image("attach 0 1; attach 1 2 / 1")
    edges = [item for item in of.groups[1].items if isinstance(item, Line)]
    assert [edge.style.name for edge in edges] == ["edge", "new-edge"]


@pytest.mark.parametrize("panels", [1, MOST + 1])
def test_too_many(panels: int) -> None:
    """TOOL-OPERATORS-3."""
    stage = passed("attach 0")[0]
    found = drawable([stage] * panels)
    assert isinstance(found, Accepted) == (panels == 1)
    assert isinstance(drawable([]), Rejected)


def test_too_many_triangles() -> None:
    """TOOL-OPERATORS-3: every split of a face makes two more."""
    done = passed("; ".join(f"split-face {i}" for i in range(199)))
    assert isinstance(drawable(done[-2:]), Rejected)
    fault = drawable(done[-3:])
    assert isinstance(fault, Rejected)
    assert (fault.reason, fault.where) == (Reason.NOT_DRAWABLE, AtStep(2))
    assert isinstance(drawable(done[:-1]), Accepted)


@pytest.mark.parametrize("figure", [9, 10, 11, 12, 13])
def test_the_figures_of_the_page(figure: int) -> None:
    """The committed pictures have a panel for each line of their scripts, with its words."""
    folder = Path(__file__).parents[2] / "spec" / "pictures"
    script = (folder / f"figure-{figure}.script").read_text()
    drawn = (folder / f"figure-{figure}.svg").read_text()
    lines = script.splitlines()
    assert [drawn.count(f'id="stage-{k}"') for k in range(len(lines) + 1)] == [1] * len(lines) + [0]
    assert all(line in drawn for line in lines)
    assert len(image(script).groups) == len(lines)
