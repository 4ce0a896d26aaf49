"""Where a closed surface with handles is cut to become a disc: short loops through one vertex.

A spanning tree of the vertices from the first one on, breadth first; then a spanning tree of the
faces that crosses none of its edges and prefers to cross those that would close the longest loops.
The 2g edges that neither has close the shortest loops (Erickson and Whittlesey, 2005).
"""

from clers.complexes.surface import Corner, next_corner, previous_corner
from clers.pictures.table import Table


def cut_edges(table: Table) -> frozenset[Corner]:
    """The corners opposite to the edges of the cut graph, both of each edge; the table is closed.

    The rest of the surface is an open disc. No edge of a fan is cut, and no end is loose.
    """
    distance, tree = _tree(table)
    crossed = _crossed(table, distance, tree)
    kept = {Corner(c) for c in range(len(table.opposite)) if c not in crossed}
    return frozenset(_pruned(table, kept))


def ends(table: Table, c: Corner) -> tuple[int, int]:
    """The vertices of the edge opposite to a corner, as the corner's triangle runs it."""
    return table.vertex[next_corner(c)], table.vertex[previous_corner(c)]


def _tree(table: Table) -> tuple[list[int], set[Corner]]:
    """For each vertex its distance from vertex 0; and the tree, both corners of each edge."""
    edges_at: list[list[Corner]] = [[] for _ in range(max(table.vertex) + 1)]
    for c in range(len(table.vertex)):
        edges_at[ends(table, Corner(c))[0]].append(Corner(c))
    distance = [-1] * len(edges_at)
    distance[0] = 0
    reached, tree = [0], set[Corner]()
    for v in reached:
        for c in edges_at[v]:
            w = ends(table, c)[1]
            if distance[w] < 0 and w < table.real_vertices:
                distance[w] = distance[v] + 1
                reached.append(w)
                tree |= {c, table.opposite[c]}
    return distance, tree


def _crossed(table: Table, distance: list[int], tree: set[Corner]) -> set[Corner]:
    """The edges that the tree of the faces crosses, those of fans before all others."""

    def priority(c: Corner) -> tuple[bool, int, list[int]]:
        a, b = ends(table, c)
        in_fan = max(a, b) >= table.real_vertices
        return in_fan, distance[a] + distance[b], sorted((a, b))

    candidates = [
        Corner(c) for c, d in enumerate(table.opposite) if c < d and Corner(c) not in tree
    ]
    group = list(range(table.faces))
    crossed: set[Corner] = set()
    for c in sorted(candidates, key=priority, reverse=True):
        a, b = find(group, c // 3), find(group, table.opposite[c] // 3)
        if a != b:
            group[a] = b
            crossed |= {c, table.opposite[c]}
    return crossed


def find(group: list[int], i: int) -> int:
    """The representative of a set, with the path to it halved."""
    while group[i] != i:
        group[i] = group[group[i]]
        i = group[i]
    return i


def _pruned(table: Table, kept: set[Corner]) -> set[Corner]:
    """Take away loose ends until there is none."""
    edges_at: dict[int, set[Corner]] = {}
    for c in kept:
        edges_at.setdefault(ends(table, c)[0], set()).add(c)
    loose = [v for v, edges in edges_at.items() if len(edges) == 1]
    while loose:
        v = loose.pop()
        if not edges_at[v]:
            continue
        c = edges_at[v].pop()
        d = table.opposite[c]
        w = ends(table, d)[0]
        edges_at[w].discard(d)
        kept -= {c, d}
        if len(edges_at[w]) == 1:
            loose.append(w)
    return kept
