"""What the orientation of a rooted triangulation is, so that it can be recognised and searched for.

Whether a directed cycle runs clockwise about some faces is asked of the faces: from the root face
one steps from face to face, across an edge only from its right to its left. What cannot be reached
has all edges about it on its left, and they contain a clockwise cycle; the inside of such a cycle
cannot be reached.
"""

from collections.abc import Iterator

from clers.codes.half_edges import HalfEdges


def inner_edges(edges: HalfEdges) -> tuple[int, ...]:
    """The lower half-edge of each edge that is not of the root face."""
    return tuple(h for h, twin in enumerate(edges.twin) if 2 < h < twin)


def is_orientation(edges: HalfEdges, out: bytes | bytearray) -> bool:
    """Is each inner edge directed one way, three out of each inner vertex, no other at all?

    Clause: CODE-TREE-2.
    """
    roots = edges.source[:3]
    degree = [0] * edges.vertices
    for h, x in enumerate(edges.source):
        degree[x] += out[h]
    return all(degree[x] == (0 if x in roots else 3) for x in range(edges.vertices)) and all(
        out[h] + out[edges.twin[h]] == (min(h, edges.twin[h]) > 2) for h in range(len(out))
    )


def turns_clockwise(edges: HalfEdges, out: bytes | bytearray) -> bool:
    """Does a directed cycle have faces on its right, the root face not among them? CODE-TREE-2."""
    reached = {0}
    todo = [0]
    while todo:
        face = todo.pop()
        for h in range(3 * face, 3 * face + 3):
            beyond = edges.twin[h] // 3
            if not out[h] and beyond not in reached:
                reached.add(beyond)
                todo.append(beyond)
    return 3 * len(reached) < len(out)


def orientations(edges: HalfEdges) -> Iterator[bytes]:
    """Every orientation with three edges out of each inner vertex. Exponential. CODE-TREE-2."""
    inner = inner_edges(edges)
    roots = edges.source[:3]
    todo: list[tuple[int, ...]] = [()]
    while todo:
        chosen = todo.pop()
        left = [0 if x in roots else 3 for x in range(edges.vertices)]
        for h in chosen:
            left[edges.source[h]] -= 1
        if min(left) < 0:
            continue
        if len(chosen) == len(inner):
            yield bytes(h in chosen for h in range(len(edges.twin)))
        else:
            h = inner[len(chosen)]
            todo += [(*chosen, h), (*chosen, edges.twin[h])]
