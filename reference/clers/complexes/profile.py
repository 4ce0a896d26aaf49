"""What can be told of a component without names: counts, curve lengths, valences.

Isomorphic components have equal profiles. Equal profiles prove nothing, but they save walks.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner
from clers.complexes.topology import component_of_faces, components, curves

Kind = tuple[int, int, int]
"""The valences at a corner, at `next` and at `previous`; negative for vertices on the boundary."""

H = TypeVar("H", int, Kind)


@dataclass(frozen=True, slots=True)
class Profile:
    """The profile of a component; histograms as sorted pairs (what, how often).

    `counts` are faces, vertices, edges, boundary edges, curves and genus. Clause: CPLX-ISO-7.
    """

    counts: tuple[int, int, int, int, int, int]
    curves: tuple[tuple[int, int], ...]
    valences: tuple[tuple[int, int], ...]
    kinds: tuple[tuple[Kind, int], ...]


@dataclass(frozen=True, slots=True)
class Profiled:
    """A component: its profile, and its corners in ascending order."""

    profile: Profile
    corners: tuple[Corner, ...]


def valences(surface: Surface) -> tuple[int, ...]:
    """For each vertex the number of its faces, negative on the boundary. Clause: CPLX-COMPLEX-4."""
    count = [0] * surface.vertices
    on_border = bytearray(surface.vertices)
    for c, d in enumerate(surface.opposite):
        count[surface.vertex[c]] += 1
        if d == BORDER:
            on_border[surface.vertex[next_corner(Corner(c))]] = 1
    return tuple(-n if border else n for n, border in zip(count, on_border, strict=True))


def corner_kinds(surface: Surface) -> tuple[Kind, ...]:
    """The kind of each corner. Clause: CPLX-ISO-7."""
    valence = valences(surface)
    at = [valence[v] for v in surface.vertex]
    corners = (Corner(c) for c in range(len(at)))
    return tuple((at[c], at[next_corner(c)], at[previous_corner(c)]) for c in corners)


def profiled(surface: Surface, kinds: Sequence[Kind]) -> tuple[Profiled, ...]:
    """The components with their profiles. Linear but for sorting. Clause: CPLX-ISO-7."""
    number = component_of_faces(surface)
    parts = components(surface)
    valence = valences(surface)
    corners: list[list[Corner]] = [[] for _ in parts]
    lengths: list[list[int]] = [[] for _ in parts]
    around: list[list[int]] = [[] for _ in parts]
    home = [0] * surface.vertices
    for c, v in enumerate(surface.vertex):
        corners[number[c // 3]].append(Corner(c))
        home[v] = number[c // 3]
    for k, n in zip(home, valence, strict=True):
        around[k].append(n)
    for curve in curves(surface):
        lengths[number[curve.corners[0] // 3]].append(len(curve.corners))
    return tuple(
        Profiled(
            Profile(
                (
                    part.faces,
                    part.vertices,
                    part.edges,
                    part.boundary_edges,
                    part.curves,
                    part.genus,
                ),
                histogram(lengths[k]),
                histogram(around[k]),
                histogram(kinds[c] for c in corners[k]),
            ),
            tuple(corners[k]),
        )
        for k, part in enumerate(parts)
    )


def histogram(of: Iterable[H]) -> tuple[tuple[H, int], ...]:
    """How often each thing occurs, sorted by the things."""
    return tuple(sorted(Counter(of).items()))
