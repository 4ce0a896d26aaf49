"""The pictures of the tutorial's examples say and show what its figures do."""

from math import isclose
from typing import Final

from pictured import picture

from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.pictures.options import Options
from clers.pictures.palette import Letter
from clers.pictures.picture import Role
from clers.pictures.shown import edges_of, shapes_of

FIGURE_14: Final = {
    1: ("012 is first", "P"),
    2: ("132 is created, 3 is marked", "C"),
    3: ("143 is created, 4 is marked", "C"),
    4: ("5 is marked", "C"),
    5: ("105 is attached, go left", "R"),
    6: ("6 is marked", "C"),
    7: ("go left", "R"),
    8: ("go left", "R"),
    9: ("7 is marked", "C"),
    10: ("go left", "R"),
    11: ("go left", "R"),
    12: ("567 is attached, the end", "E"),
}
"""What the figure's captions say of the cube, panel by panel; RR in (k) are two panels here."""


def test_cube_has_the_captions_of_figure_14() -> None:
    """Clauses: TOOL-PICTURE-2, TOOL-PICTURE-10."""
    panels = picture(CUBE).panels
    assert [panel.step for panel in panels] == list(range(13))
    assert panels[0].caption == "8 vertices, 12 triangles"
    for step, (part, letter) in FIGURE_14.items():
        assert part in panels[step].caption
        assert panels[step].caption.endswith(f": {letter}")


def test_cube_is_counted() -> None:
    """Figure 14's word is CCCRCRRCRRE after P. Clause: TOOL-PICTURE-3."""
    assert picture(CUBE).counts == ((Letter.P, 1), (Letter.C, 5), (Letter.E, 1), (Letter.R, 5))


def test_cube_starts_from_edge_12() -> None:
    """Figure 14 (b): "The traversal starts from edge 12." Clause: TOOL-PICTURE-1."""
    before, after, *_ = picture(CUBE).panels
    assert before.gates == ()
    assert [(gate.waiting, {gate.tail, gate.head}) for gate in after.gates] == [(0, {1, 2})]
    assert {mark.vertex for mark in after.marks if mark.known} == {0, 1, 2}


def test_torus_is_the_square_of_figure_22() -> None:
    """Three by three equal squares; sides are 0, 3, 6, 0 and 0, 1, 2, 0. Clause: TOOL-PICTURE-6."""
    panel = picture(TORUS).panels[0]
    grid: dict[tuple[int, int], int] = {}
    left, low = min(mark.at[0] for mark in panel.marks), min(mark.at[1] for mark in panel.marks)
    side = max(mark.at[0] for mark in panel.marks) - left
    for mark in panel.marks:
        column, row = 3 * (mark.at[0] - left) / side, 3 * (mark.at[1] - low) / side
        assert isclose(column, round(column), abs_tol=1e-9)
        assert isclose(row, round(row), abs_tol=1e-9)
        grid[round(column), round(row)] = mark.vertex
    assert sorted(grid) == [(i, j) for i in range(4) for j in range(4)]
    assert all(grid[i, j] == 3 * (i % 3) + j % 3 for i, j in grid)
    assert [note.text for note in panel.notes] == ["a", "b", "a", "b"]
    assert len(edges_of(panel, Role.CUT)) == 12


def test_torus_handles_are_closed_by_the_last_two_e() -> None:
    """Figure 22 (c), (d): two handle S, each closed by an E. Clauses: TOOL-PICTURE-1, -2."""
    panels = picture(TORUS).panels
    morse = [len(edges_of(panel, Role.MORSE)) for panel in panels]
    assert morse == [0] * 17 + [2, 4]  # an edge is drawn on both of its sides
    assert panels[17].caption.endswith("meets S number 1: E")
    assert panels[18].caption.endswith("meets S number 0: E")
    letters = [shape.visit.letter for shape in shapes_of(panels[18])]
    assert letters.count(Letter.SH) == 2
    assert letters.count(Letter.S) == 2


def test_annulus_says_which_curves() -> None:
    """Figure 23: the first triangle here touches both curves. Clause: TOOL-PICTURE-2."""
    panels = picture(ANNULUS).panels
    expected = "the curve 251 is marked; 254 reaches the curve 430: Sb"
    assert panels[1].caption == expected
    assert [len(edges_of(panel, Role.CURVE)) for panel in panels[:2]] == [6, 0]
    assert [len(edges_of(panel, Role.REACHED)) for panel in panels[:2]] == [0, 6]
    assert panels[6].caption.endswith("meets S number 0: E")


def test_sphere_is_opened_at_its_last_face() -> None:
    """P and C and R are inside, E is the ring, entered from above. Clause: TOOL-PICTURE-6."""
    panel = picture(TETRAHEDRON, Options(steps=(3,))).panels[0]
    rings = [shape for shape in shapes_of(panel) if shape.ring]
    assert [(ring.visit.letter, ring.visit.step) for ring in rings] == [(Letter.E, 4)]
    (gate,) = panel.gates
    assert gate.into[1] < gate.path[0][1]
    assert isclose(gate.path[0][1], gate.path[1][1])
    assert rings[0].node[1] < gate.path[0][1]


def test_smallest_surface() -> None:
    """Clause: TOOL-PICTURE-2."""
    panels = picture(TRIANGLE).panels
    assert panels[1].caption == "the curve 120 is marked; 012 is attached, the end: E"
    assert [gate.waiting for gate in panels[0].gates] == [0]
