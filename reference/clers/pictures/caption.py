"""What happens at a step, in the words of the tutorial's Figure 14."""

from typing import Final, assert_never

from clers.complexes.border import curve_from
from clers.complexes.surface import Surface, Vertex, next_corner
from clers.pictures.palette import Letter
from clers.pictures.story import Story, Visit

FEW: Final = 8
"""Curves of more vertices are told by their length."""


def caption(told: Story, step: int) -> str:
    """One sentence on the state after `step` faces. Clause: TOOL-PICTURE-2."""
    if step == 0:
        return f"{told.surface.vertices} vertices, {told.surface.faces} triangles"
    visit = told.visits[step - 1]
    before = ""
    if visit.entry.symbol != "P" and _starts(told, step):
        first = tuple(curve_from(told.surface, next_corner(visit.tip)))
        before = f"the curve {curve(first)} is marked; "
    ends = step == len(told.visits) or _starts(told, step + 1)
    closed = "".join(f", meets S number {told.records[r].s}" for r in visit.entry.closes)
    return f"{before}{_sentence(told.surface, visit, ends)}{closed}: {visit.letter}"


def names(vertices: tuple[Vertex, ...]) -> str:
    """Vertices as the tutorial writes them: 143; apart where a number has two digits."""
    return ("" if max(vertices) < 10 else " ").join(map(str, vertices))


def curve(vertices: tuple[Vertex, ...]) -> str:
    """A curve's vertices, or how many there are."""
    return names(vertices) if len(vertices) <= FEW else f"of {len(vertices)} vertices"


def _starts(told: Story, step: int) -> bool:
    """Is it the first face of its component?"""
    entries = told.visits[step - 1].entry, told.visits[max(step - 2, 0)].entry
    return step == 1 or entries[0].component != entries[1].component


def _sentence(surface: Surface, visit: Visit, ends: bool) -> str:
    face = names(visit.names)
    match visit.letter:
        case Letter.P:
            return f"{face} is first, its vertices are marked"
        case Letter.C:
            return f"{face} is created, {visit.triangle[0]} is marked"
        case Letter.R:
            return f"{face} is attached, go left"
        case Letter.L:
            return f"{face} is attached, go right"
        case Letter.E:
            return f"{face} is attached, {'the end' if ends else 'take a gate from the stack'}"
        case Letter.S:
            return f"{face} splits, go right, keep the left gate"
        case Letter.SH:
            return f"{face} splits for a handle, go right"
        case Letter.SB:
            return f"{face} reaches the curve {curve(tuple(curve_from(surface, visit.tip)))}"
        case _:
            assert_never(visit.letter)
