"""Random scripts within bounds, as a Hypothesis strategy: first grow, then open, then act.

A script is drawn as short lists of small integers, so that drawing is fast, and so that shrinking
drops operators and turns the others into the first and simplest of their table.
"""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.generate.bounds import FIRST, Bounds, Grown, go_on, go_on_within
from clers.generate.kinds import ACT, EVERY, GROW, Kind
from clers.operators.script import AddHandle, AddTetrahedron, OpenCurve, Operator, Relabel, Script

Choice = tuple[int, int]

CHOICES: Final = st.integers(0, 999)
TWO_CHOICES: Final = st.integers(0, 999_999)  # drawn at once, for speed


def any_scripts(max_size: int = 40) -> st.SearchStrategy[Script]:
    """Scripts with any operators and any integers; half of them are long."""
    anything = st.one_of(st.integers(0, 15), CHOICES, st.integers())
    raw = st.tuples(st.integers(0, len(EVERY) - 1), anything, anything)
    lists = [st.lists(raw, min_size=low, max_size=max_size) for low in (0, max_size // 2)]
    return (
        st.sampled_from(lists)
        .flatmap(lambda chosen: chosen)
        .map(lambda drawn: tuple(EVERY[kind](first, second) for kind, first, second in drawn))
    )


@st.composite
def grown(draw: st.DrawFn, bounds: Bounds) -> Grown:
    """A script within bounds, with its mesh. The topology asked for comes before `bounds.faces`."""
    components = draw(_count(*bounds.components))
    handles = draw(_pairs(draw(_count(*bounds.genus))))
    holes = draw(_pairs(draw(_count(*bounds.curves))))
    grow = draw(_operators(GROW, bounds.faces))
    act = draw(_operators(ACT if bounds.curves[1] else GROW, bounds.faces))
    seed = draw(st.integers(0, 1 << 16))

    wanted: list[Operator] = [AddTetrahedron() for _ in range(components - 1)]
    topology: list[Operator] = [
        *(AddHandle(first, second) for first, second in handles),
        *(OpenCurve(face) for face, _ in holes),
    ]
    roomy = Bounds(bounds.faces, (1, components), (0, 0), (0, 0))
    start = go_on(FIRST, wanted)
    full = go_on(go_on_within(start, grow, roomy), topology)
    if len(full.mesh.faces) > bounds.faces:
        full = go_on(start, topology)
    acted = go_on_within(full, act, bounds)
    return go_on(acted, [Relabel(seed)]) if seed else acted


def _count(low: int, high: int) -> st.SearchStrategy[int]:
    """A number in a range; the lowest most often, then the next one."""
    span = range(low, high + 1)
    return st.sampled_from([low] * len(span) + [*span[1:2], *span])


def _pairs(count: int) -> st.SearchStrategy[list[Choice]]:
    return st.lists(TWO_CHOICES.map(_split), min_size=count, max_size=count)


def _split(choices: int) -> Choice:
    return choices % 1000, choices // 1000


def _operators(table: tuple[Kind, ...], faces: int) -> st.SearchStrategy[list[Operator]]:
    """A list of operators of a table; one in three is long, where there is room for it."""
    raw = st.tuples(st.integers(0, len(table) - 1), TWO_CHOICES)
    lists = [st.lists(raw, min_size=low, max_size=max(faces // 2, 8)) for low in (0, 0, faces // 8)]
    return (
        st.sampled_from(lists)
        .flatmap(lambda chosen: chosen)
        .map(lambda drawn: [table[kind](*_split(choices)) for kind, choices in drawn])
    )


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "scripts": any_scripts(),
}
"""The domains of this module, by name."""
