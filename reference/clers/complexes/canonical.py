"""Walks, codes and canonical forms: the name of a surface that does not depend on its names."""

from collections.abc import Iterator, Sequence

from clers.complexes.relabel import relabelled
from clers.complexes.surface import (
    BORDER,
    Corner,
    Surface,
    Vertex,
    next_corner,
    previous_corner,
)
from clers.complexes.topology import component_of_faces

Code = tuple[int, ...]


def walk(surface: Surface, start: Corner, tips: list[Corner]) -> Iterator[int]:
    """The code of a corner, number by number; `tips` receives the tips as faces are numbered.

    `tips` is empty at first. Linear in the faces of the component, and lazy: whoever stops reading
    has paid only for what was read. Clause: CPLX-ISO-3.
    """
    opposite = surface.opposite
    tips.append(start)
    number = {start // 3: 0}
    for tip in tips:  # which grows on the way
        for c in (tip, next_corner(tip), previous_corner(tip)):
            d = opposite[c]
            if d == BORDER:
                yield BORDER
                continue
            k = number.get(d // 3)
            if k is None:
                k = number[d // 3] = len(tips)
                tips.append(d)
            yield 3 * k + (d - tips[k]) % 3


def code(surface: Surface, start: Corner) -> Code:
    """The code of a corner. Clause: CPLX-ISO-3."""
    return tuple(walk(surface, start, []))


def agreement(known: Sequence[int], other: Iterator[int]) -> int:
    """How many numbers of a code another code begins with; all of them if the two are equal."""
    count = 0
    for expected, got in zip(known, other, strict=False):
        if expected != got:
            return count
        count += 1
    return count


def canonical_form(surface: Surface) -> tuple[Code, ...]:
    """The least code of each component, sorted; equal exactly for isomorphic surfaces.

    Quadratic at worst: each corner is walked from, but only until its code is not the least.
    Clause: CPLX-ISO-5.
    """
    return tuple(least for least, _ in _least_codes(surface))


def canonical_surface(surface: Surface) -> Surface:
    """The surface under the names that its canonical form gives. Clause: CPLX-ISO-6."""
    tips = [tip for _, walked in _least_codes(surface) for tip in walked]
    corners = (c for tip in tips for c in (tip, next_corner(tip), previous_corner(tip)))
    order: dict[Vertex, None] = dict.fromkeys(surface.vertex[c] for c in corners)
    return relabelled(surface, tuple(order), tuple(tips))


def _least_codes(surface: Surface) -> list[tuple[Code, tuple[Corner, ...]]]:
    """For each component its least code and the tips of that walk, in canonical order."""
    corners: dict[int, list[Corner]] = {}
    for face, component in enumerate(component_of_faces(surface)):
        corners.setdefault(component, []).extend(Corner(3 * face + i) for i in range(3))
    found = (_least_code(surface, starts) for starts in corners.values())
    return sorted(found, key=lambda least: (len(least[0]), least[0]))


def _least_code(surface: Surface, starts: Sequence[Corner]) -> tuple[Code, tuple[Corner, ...]]:
    """The least code over some corners of one component, and its tips; the first if several."""
    best: list[int] = []
    best_tips: list[Corner] = []
    for start in starts:
        tips: list[Corner] = []
        steps = walk(surface, start, tips)
        for same, step in enumerate(steps):
            if same == len(best) or step < best[same]:
                best = [*best[:same], step, *steps]
                best_tips = tips
            elif step > best[same]:
                break
    return tuple(best), tuple(best_tips)
