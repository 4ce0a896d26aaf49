"""Factors that no word of spheres has: a walk through surroundings of which little is known.

A view holds what a few symbols tell: the loops around the gates met so far, each with a gap where
nothing is known, and the edges known to exist. A symbol leads to every view that agrees with it.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, NewType

from clers.edgebreaker.stream import SYMBOLS

Name = NewType("Name", int)
"""A vertex of a view; two names may be one vertex if they are never in one loop."""

GAP: Final = Name(-1)
"""Any number of unknown vertices, none included. A loop has one gap at most."""

Loop = tuple[Name, ...]
Edge = frozenset[Name]


@dataclass(frozen=True, slots=True)
class View:
    """The gates' loops, the current one first, as [a, b, …] with the gate from a to b.

    `edges`: pairs of vertices of one loop that are known to be joined. Each loop names three
    vertices at least. Clause: CODE-FACTOR-1.
    """

    loops: tuple[Loop, ...]
    edges: frozenset[Edge]


Known = tuple[Loop, frozenset[Edge], int]
"""A loop, the known edges, and the next new name."""

UNKNOWN: Final = View(
    ((Name(0), Name(1), Name(2), GAP),),
    frozenset({frozenset({Name(0), Name(1)}), frozenset({Name(1), Name(2)})}),
)
"""Nothing is known but a gate and that its loop has three edges at least."""


def impossible(factor: str) -> bool:
    """No walk, whatever the surroundings, writes this. Exponential at worst. CODE-FACTOR-2."""
    views = {UNKNOWN}
    for symbol in factor:
        views = {after for view in views for after in following(view, symbol)}
    return not views


def impossible_factors(longest: int) -> tuple[str, ...]:
    """The impossible factors to a length that have none within them. Exponential: CODE-FACTOR-3."""
    found: list[str] = []
    possible: dict[str, frozenset[View]] = {"": frozenset({UNKNOWN})}
    for _ in range(longest):
        longer: dict[str, frozenset[View]] = {}
        for word, views in possible.items():
            for symbol in SYMBOLS:
                factor = word + symbol
                if word and factor[1:] not in possible:
                    continue  # it has a shorter one within it
                after = frozenset(v for view in views for v in following(view, symbol))
                if after:
                    longer[factor] = after
                else:
                    found.append(factor)
        possible = longer
    return tuple(found)


def following(view: View, symbol: str) -> Iterator[View]:
    """Every view that may come after a symbol. Clause: CODE-FACTOR-1."""
    loop, *below = view.loops
    new = 1 + max(name for each in view.loops for name in each)
    match symbol:
        case "C":
            apex = Name(new)
            edges = view.edges | {frozenset({apex, loop[0]}), frozenset({apex, loop[1]})}
            yield _tidy([(apex, *loop[1:], loop[0]), *below], edges)
        case "R":
            for (a, _, apex, *rest), edges, unused in _right_neighbour((loop, view.edges, new)):
                yield from _shortened((a, apex, *rest), frozenset({a, apex}), edges, unused, below)
        case "L":
            for (_, b, *rest, apex), edges, unused in _left_neighbour((loop, view.edges, new)):
                yield from _shortened((apex, b, *rest), frozenset({apex, b}), edges, unused, below)
        case "E":
            for closed in _without_gap((loop, view.edges, new)):
                if len(closed[0]) == 3:
                    yield _tidy(below, closed[1]) if below else UNKNOWN
        case _:
            yield from _split(view, new)


def _shortened(
    loop: Loop, side: Edge, edges: frozenset[Edge], new: int, below: list[Loop]
) -> Iterator[View]:
    """The view after R or L: the side that was open is a new edge of the loop."""
    if side not in edges:
        for longer, known, _ in _with_three((loop, edges | {side}, new)):
            yield _tidy([longer, *below], known)


def _split(view: View, new: int) -> Iterator[View]:
    """The views after S: the apex is any vertex of the loop but the gate's ends' neighbours."""
    (a, b, *others), *below = view.loops
    for at, name in enumerate(others):
        inside = name == GAP
        apex = Name(new) if inside else name
        sides = frozenset({frozenset({a, apex}), frozenset({b, apex})})
        if sides & view.edges:
            continue
        right = (apex, b, *others[: at + inside])
        left = (a, apex, *others[at + (not inside) :])
        for first, edges, unused in _with_three((right, view.edges | sides, new + 1)):
            for second, known, _ in _with_three((left, edges, unused)):
                yield _tidy([first, second, *below], known)


def _right_neighbour(known: Known) -> Iterator[Known]:
    """The ways in which the vertex after the right end can be known."""
    loop, edges, new = known
    if loop[2] != GAP:
        yield known
        return
    edge = frozenset({loop[1], Name(new)})
    yield (*loop[:2], Name(new), *loop[2:]), edges | {edge}, new + 1
    yield from _without_gap(known)


def _left_neighbour(known: Known) -> Iterator[Known]:
    """The ways in which the vertex before the left end can be known."""
    loop, edges, new = known
    if loop[-1] != GAP:
        yield known
        return
    yield (*loop, Name(new)), edges | {frozenset({loop[0], Name(new)})}, new + 1
    yield from _without_gap(known)


def _without_gap(known: Known) -> Iterator[Known]:
    """The loop where nothing is left out; not if two vertices would then be joined twice."""
    loop, edges, new = known
    if GAP not in loop:
        yield known
        return
    at = loop.index(GAP)
    edge = frozenset({loop[at - 1], loop[(at + 1) % len(loop)]})
    if edge not in edges:
        yield (*loop[:at], *loop[at + 1 :]), edges | {edge}, new


def _with_three(known: Known) -> Iterator[Known]:
    """The loop with three vertices named, from its gap; not if it has too few and no gap."""
    loop, edges, new = known
    while len(loop) < 3 + (GAP in loop):
        if GAP not in loop:
            return
        at = loop.index(GAP)
        loop, edges = (
            (*loop[:at], Name(new), *loop[at:]),
            edges | {frozenset({loop[at - 1], Name(new)})},
        )
        new += 1
    yield loop, edges, new


def _tidy(loops: list[Loop], edges: frozenset[Edge]) -> View:
    """The same with names in the order of the loops, without edges that no symbol can ask for."""
    names: dict[Name, Name] = {GAP: GAP}
    for name in (name for loop in loops for name in loop):
        names.setdefault(name, Name(len(names) - 1))
    kept = [edge for edge in edges if any(edge <= set(loop) for loop in loops)]
    return View(
        tuple(tuple(names[name] for name in loop) for loop in loops),
        frozenset(frozenset(names[name] for name in edge) for edge in kept),
    )
