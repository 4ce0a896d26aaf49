"""Meshes made by contracting edges: the topology stays, the faces become fewer. ORCL-SHRINK-3."""

from collections import Counter
from collections.abc import Iterator
from typing import Final

from clers.complexes.simplicial import closure
from clers.conventions.result import Accepted
from clers.operators.moves.contract import contract
from clers.operators.moves.move import Contract
from clers.oracle.fuzz.behind import Net, Triangle, surface_of_net
from clers.oracle.fuzz.shrinking.nets import compact

LARGEST: Final = 30
"""The most faces of a mesh whose edges are flipped before others are contracted."""

Edge = tuple[int, int]


def edges_of(faces: tuple[Triangle, ...]) -> list[Edge]:
    """The edges, each once, in order."""
    pairs = {(min(e), max(e)) for a, b, c in faces for e in ((a, b), (b, c), (c, a))}
    return sorted(pair for pair in pairs if pair[0] != pair[1])


def _renamed(faces: tuple[Triangle, ...], keep: int, gone: int) -> tuple[Triangle, ...]:
    """One vertex for two: faces that had both are no more."""

    def name(v: int) -> int:
        return keep if v == gone else v

    renamed = ((name(a), name(b), name(c)) for a, b, c in faces)
    return tuple(face for face in renamed if len(set(face)) == 3)


def _merged(net: Net, keep: int, gone: int) -> Net:
    faces = _renamed(net.faces, keep, gone)
    kept = frozenset(range(net.vertices)) - {gone}
    return compact(Net(faces, net.vertices, net.precision, net.places), kept)


def contracted(net: Net) -> Iterator[Net]:
    """Many edges contracted, then fewer, then each single one either way. OPER-CONTRACT-1.

    Of what is no surface any two ends of an edge are merged.
    """
    known = range(net.vertices)
    if surface_of_net(net) is None:
        for a, b in edges_of(net.faces):
            if a in known and b in known:
                yield _merged(net, a, b)
        return
    for share in (8, 4, 2):
        yield from smaller(net, len(net.faces) // share)
    yield from smaller(net, 3 * len(net.faces) // 4)
    whole = closure(net.faces)
    for a, b in _promising(net.faces):
        for keep, gone in ((a, b), (b, a)):
            if isinstance(contract(whole, Contract(keep, gone)), Accepted):
                yield _merged(net, keep, gone)


def _promising(faces: tuple[Triangle, ...]) -> list[Edge]:
    """The edges whose ends have no neighbours in common but those across their faces.

    Others fail the link condition, and this is quicker to see.
    """
    beside: dict[int, set[int]] = {}
    count: Counter[Edge] = Counter()
    for a, b, c in faces:
        for u, v in ((a, b), (b, c), (c, a)):
            beside.setdefault(u, set()).add(v)
            beside.setdefault(v, set()).add(u)
            count[min(u, v), max(u, v)] += 1
    return [(u, v) for u, v in edges_of(faces) if len(beside[u] & beside[v]) == count[u, v]]


def smaller(net: Net, faces: int) -> Iterator[Net]:
    """Edges of a surface contracted until there are no more faces than this; nothing if stuck.

    The vertex with the fewest neighbours goes first.
    """
    now, whole = net.faces, closure(net.faces)
    kept = set(range(net.vertices))
    while len(now) > faces:
        degree = Counter(v for face in now for v in face)
        pairs = [pair for a, b in _promising(now) for pair in ((a, b), (b, a))]
        for keep, gone in sorted(pairs, key=lambda e: (degree[e[1]], degree[e[0]], e)):
            after = contract(whole, Contract(keep, gone))
            if isinstance(after, Accepted):
                now, whole = _renamed(now, keep, gone), after.value
                kept.discard(gone)
                break
        else:
            return
    yield compact(Net(now, net.vertices, net.precision, net.places), frozenset(kept))


def flipped_and_contracted(net: Net) -> Iterator[Net]:
    """An edge flipped, then another contracted: out of where contractions are stuck."""
    if len(net.faces) > LARGEST or surface_of_net(net) is None:
        return
    for faces in _flipped(net.faces):
        other = Net(faces, net.vertices, net.precision, net.places)
        promising = _promising(faces)
        whole = closure(faces) if promising else None
        for a, b in promising:
            if whole is not None and isinstance(contract(whole, Contract(a, b)), Accepted):
                yield _merged(other, a, b)


def _flipped(faces: tuple[Triangle, ...]) -> Iterator[tuple[Triangle, ...]]:
    """The faces with one edge flipped, for each edge between two faces whose flip is none yet."""
    third = {e: c for x, y, z in faces for e, c in (((x, y), z), ((y, z), x), ((z, x), y))}
    known = set(edges_of(faces))
    for (a, b), c in third.items():
        if a < b and (b, a) in third:
            d = third[b, a]
            if c != d and (min(c, d), max(c, d)) not in known:
                gone = ({a, b, c}, {a, b, d})
                kept = tuple(face for face in faces if set(face) not in gone)
                yield (*kept, (c, a, d), (d, b, c))
