"""What half-edges are, by definition: cycles of permutations are faces, edges and vertices."""

from collections.abc import Mapping
from itertools import chain

from clers.complexes.structures.half_edge import NO_FACE, HalfEdges

Cycles = frozenset[frozenset[int]]


def cycles(of: Mapping[int, int]) -> Cycles:
    """The least sets that a map does not lead out of and that hang together by it."""
    sets = {x: frozenset([x]) for x in of}
    for x, y in of.items():
        both = sets[x] | sets[y]
        sets.update(dict.fromkeys(both, both))
    return frozenset(sets.values())


def is_half_edge_structure(of: HalfEdges) -> bool:
    """Is this a map on an oriented surface, with good representatives? Clause: CPLX-HALFEDGE-9."""
    every = range(len(of.next))
    by_half_edge = (of.next, of.previous, of.twin, of.origin, of.face)
    if {len(array) for array in by_half_edge} != {len(every)}:
        return False
    links = chain(of.next, of.previous, of.twin, of.of_vertex, of.of_face)
    if not set(links) <= set(every) or not set(of.origin) <= set(range(of.vertices)):
        return False
    return set(of.face) <= {NO_FACE, *range(of.faces)} and _is_map(of)


def _is_map(of: HalfEdges) -> bool:
    every = range(len(of.next))
    after, before = dict(enumerate(of.next)), dict(enumerate(of.previous))
    if {(y, x) for x, y in after.items()} != set(before.items()) or len(set(of.next)) < len(every):
        return False
    if any(of.twin[of.twin[h]] != h or of.head(h) == of.origin[h] for h in every):
        return False
    rotation = {h: of.rotated(h) for h in every}
    return (
        all(of.head(of.previous[h]) == of.origin[h] for h in every)
        and _are_faces(of, cycles(after))
        and cycles(rotation) == frozenset(_where(of.origin, v) for v in range(of.vertices))
        and all(of.origin[h] == v for v, h in enumerate(of.of_vertex))
        and _has_good_border(of)
    )


def _where(array: tuple[int, ...], value: int) -> frozenset[int]:
    return frozenset(h for h, entry in enumerate(array) if entry == value)


def _are_faces(of: HalfEdges, found: Cycles) -> bool:
    border = _where(of.face, NO_FACE)
    inner = frozenset(cycle for cycle in found if not cycle <= border)
    return inner == frozenset(_where(of.face, f) for f in range(of.faces)) and all(
        of.face[h] == f for f, h in enumerate(of.of_face)
    )


def _has_good_border(of: HalfEdges) -> bool:
    border = _where(of.face, NO_FACE)
    leaving = [_where(of.origin, v) & border for v in range(of.vertices)]
    return not any(of.twin[h] in border for h in border) and all(
        found <= {of.of_vertex[v]} for v, found in enumerate(leaving)
    )
