"""Meshes made from a mesh by taking something away. Clause: ORCL-SHRINK-3."""

from collections.abc import Callable, Iterator
from itertools import pairwise

from clers.oracle.fuzz.behind import Net, Triangle
from clers.oracle.fuzz.shrinking.blocks import without_blocks

Step = Callable[[Net], Iterator[Net]]
"""The meshes that one kind of step leads to, promising ones first."""


def compact(net: Net, kept: frozenset[int]) -> Net:
    """The net with these vertices alone, renumbered; no face uses one that is not kept.

    Numbers of no vertex stay such: negative ones as they are, others as much too large as before.
    """
    number = {v: k for k, v in enumerate(sorted(kept))}
    fewer = net.vertices - len(kept)

    def name(v: int) -> int:
        return number.get(v, v if v < 0 else v - fewer)

    faces = tuple((name(a), name(b), name(c)) for a, b, c in net.faces)
    places = None if net.places is None else tuple(net.places[v] for v in sorted(kept))
    return Net(faces, len(kept), net.precision, places)


def with_faces(net: Net, faces: tuple[Triangle, ...]) -> Net:
    """The net with other faces, without vertices that only the old ones used."""
    gone = _used(net.faces) - _used(faces)
    changed = Net(faces, net.vertices, net.precision, net.places)
    return compact(changed, frozenset(range(net.vertices)) - gone)


def _used(faces: tuple[Triangle, ...]) -> frozenset[int]:
    return frozenset(v for face in faces for v in face)


def without_components(net: Net) -> Iterator[Net]:
    """One component alone, then the net without each."""
    pieces = pieces_of(net.faces)
    if len(pieces) < 2:
        return
    for piece in sorted(pieces, key=len):
        yield with_faces(net, tuple(net.faces[t] for t in sorted(piece)))
    for piece in sorted(pieces, key=len, reverse=True):
        yield with_faces(net, tuple(f for t, f in enumerate(net.faces) if t not in piece))


def pieces_of(faces: tuple[Triangle, ...]) -> list[frozenset[int]]:
    """The faces that hang together by vertices, by number."""
    order, starts = _breadth_first(faces)
    cuts = [*starts, len(order)]
    return [frozenset(order[a:b]) for a, b in pairwise(cuts)]


def _breadth_first(faces: tuple[Triangle, ...]) -> tuple[list[int], list[int]]:
    """All faces, neighbours near each other; and where each component starts."""
    at: dict[int, list[int]] = {}
    for t, face in enumerate(faces):
        for v in face:
            at.setdefault(v, []).append(t)
    order: list[int] = []
    starts: list[int] = []
    seen: set[int] = set()
    for first in range(len(faces)):
        if first in seen:
            continue
        starts.append(len(order))
        order.append(first)
        seen.add(first)
        done = len(order) - 1
        while done < len(order):
            for v in faces[order[done]]:
                for t in at[v]:
                    if t not in seen:
                        seen.add(t)
                        order.append(t)
            done += 1
    return order, starts


def without_faces(net: Net) -> Iterator[Net]:
    """Without a block of neighbouring faces; the last blocks are single faces."""
    order, _ = _breadth_first(net.faces)
    for kept in without_blocks(order):
        yield with_faces(net, tuple(net.faces[t] for t in sorted(kept)))


def without_vertices(net: Net) -> Iterator[Net]:
    """Without a vertex and the faces that use it; without a vertex that no face uses."""
    used = _used(net.faces)
    for v in sorted(used):
        yield with_faces(net, tuple(face for face in net.faces if v not in face))
    known = frozenset(range(net.vertices))
    for v in sorted(known - used):
        yield compact(net, known - {v})
    if net.vertices > 0:
        last = None if net.places is None else net.places[:-1]
        yield Net(net.faces, net.vertices - 1, net.precision, last)


def plainer(net: Net) -> Iterator[Net]:
    """Without positions, with coordinates 0, with vertices numbered as the faces list them."""
    if net.places is not None:
        yield Net(net.faces, net.vertices)
        zero = (0.0, 0.0, 0.0)
        yield Net(net.faces, net.vertices, net.precision, (zero,) * net.vertices)
        for v, place in enumerate(net.places):
            for axis in range(3):
                if place[axis] != 0.0:
                    changed = (*place[:axis], 0.0, *place[axis + 1 :])
                    triple = (changed[0], changed[1], changed[2])
                    places = (*net.places[:v], triple, *net.places[v + 1 :])
                    yield Net(net.faces, net.vertices, net.precision, places)
    yield numbered(net)


def numbered(net: Net) -> Net:
    """The vertices in the order in which the faces list them; unused ones last."""
    known = range(net.vertices)
    order = list(dict.fromkeys(v for face in net.faces for v in face))
    if not set(order) <= set(known):
        return net
    order += [v for v in known if v not in set(order)]
    number = {v: k for k, v in enumerate(order)}
    faces = tuple((number[a], number[b], number[c]) for a, b, c in net.faces)
    places = None if net.places is None else tuple(net.places[v] for v in order)
    return Net(faces, net.vertices, net.precision, places)
