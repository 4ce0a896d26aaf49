"""Corner tables: which corners lie opposite to one edge, and whether each vertex has one fan.

Entries are corners (below 3T) and vertices; with at most 2^26 of each (CPLX-INPUT-3) nothing here
comes near 2^63.
"""

from librt.vecs import vec
from mypy_extensions import i64

from clers.kernels.flat import minus_ones, zeros


def opposites(vertex: vec[i64], vertices: i64) -> vec[i64]:
    """The corner opposite to each corner, or -1; nothing at all if some edge is not as it must be.

    `vertex[c]` is the vertex at corner c, from 0 to `vertices` - 1, three that differ in each face.
    An edge has one face, or two that run it in opposite directions and have other tips. Linear:
    corners are sorted by the lower end of their edge, and of one lower end the last corner of each
    upper end is kept.
    Clauses: CPLX-CORNER-3, CPLX-REJECT-5, CPLX-REJECT-6, CPLX-REJECT-7.
    """
    corners: i64 = len(vertex)
    start = zeros(vertices + 1)
    c: i64 = 0
    while c < corners:
        x: i64 = vertex[c]
        y: i64 = vertex[c + 1]
        z: i64 = vertex[c + 2]
        start[x if x < y else y] += 1
        start[y if y < z else z] += 1
        start[z if z < x else x] += 1
        c += 3
    before: i64 = 0
    v: i64 = 0
    while v <= vertices:
        here: i64 = start[v]
        start[v] = before
        before += here
        v += 1
    corner_at = zeros(corners)
    upper = zeros(corners)
    c = 0
    while c < corners:
        x = vertex[c]
        y = vertex[c + 1]
        z = vertex[c + 2]
        low: i64 = x if x < y else y
        j: i64 = start[low]
        corner_at[j] = c + 2
        upper[j] = y if x < y else x
        start[low] = j + 1
        low = y if y < z else z
        j = start[low]
        corner_at[j] = c
        upper[j] = z if y < z else y
        start[low] = j + 1
        low = z if z < x else x
        j = start[low]
        corner_at[j] = c + 1
        upper[j] = x if z < x else z
        start[low] = j + 1
        c += 3
    opposite = minus_ones(corners)
    last = minus_ones(vertices)  # the place of the last edge to this upper end
    j = 0
    u: i64 = 0
    while u < vertices:
        first: i64 = j
        end: i64 = start[u]
        while j < end:
            w: i64 = upper[j]
            p: i64 = last[w]
            if p < first:
                last[w] = j
            else:
                d: i64 = corner_at[p]
                c = corner_at[j]
                if opposite[d] >= 0 or vertex[c] == vertex[d]:
                    return vec[i64]()
                if vertex[c - 2 if c % 3 == 2 else c + 1] == vertex[d - 2 if d % 3 == 2 else d + 1]:
                    return vec[i64]()
                opposite[d] = c
                opposite[c] = d
            j += 1
        u += 1
    return opposite


def one_fan_each(vertex: vec[i64], opposite: vec[i64], vertices: i64) -> bool:
    """Whether the faces at each vertex are one fan, and there is a face at each. Linear.

    From one corner of each vertex all others of its fan are reached by turning one way, and at a
    border the other way; all corners are reached if and only if there is no second fan.
    Clauses: CPLX-REJECT-8, CPLX-REJECT-9.
    """
    corners: i64 = len(vertex)
    met = zeros(vertices)
    used: i64 = 0
    reached: i64 = 0
    c: i64 = 0
    while c < corners:
        v: i64 = vertex[c]
        if met[v] == 0:
            met[v] = 1
            used += 1
            d: i64 = c
            o: i64 = 0
            while True:
                reached += 1
                o = opposite[d - 2 if d % 3 == 2 else d + 1]
                if o < 0:
                    break
                d = o - 2 if o % 3 == 2 else o + 1
                if d == c:
                    break
            if o < 0:
                d = c
                while True:
                    o = opposite[d - 1 if d % 3 else d + 2]
                    if o < 0:
                        break
                    d = o - 1 if o % 3 else o + 2
                    reached += 1
        c += 1
    return reached == corners and used == vertices


def simple(vertex: vec[i64], opposite: vec[i64], vertices: i64) -> bool:
    """Whether no two edges have the same ends, and no two faces the same vertices. Linear.

    The faces at each vertex are one fan, and no face has a vertex twice. So two faces on the same
    vertices have the same edges, and are all that is at each vertex.
    Clauses: CPLX-REJECT-5, CPLX-REJECT-6, CPLX-REJECT-7.
    """
    corners: i64 = len(vertex)
    seen_from = minus_ones(vertices)  # the last vertex that an edge to this one was seen from
    done = zeros(vertices)
    c: i64 = 0
    while c < corners:
        v: i64 = vertex[c]
        if done[v] == 0:
            done[v] = 1
            faces: i64 = 0
            d: i64 = c
            o: i64 = 0
            while True:
                faces += 1
                a: i64 = d - 2 if d % 3 == 2 else d + 1
                b: i64 = d - 1 if d % 3 else d + 2
                w: i64 = vertex[b]
                if seen_from[w] == v:
                    return False
                seen_from[w] = v
                o = opposite[a]
                if o < 0:
                    break
                d = o - 2 if o % 3 == 2 else o + 1
                if d == c:
                    break
            if o >= 0:
                if faces < 3:
                    return False
            else:
                d = c
                while True:
                    a = d - 2 if d % 3 == 2 else d + 1
                    b = d - 1 if d % 3 else d + 2
                    w = vertex[a]
                    if seen_from[w] == v:
                        return False
                    seen_from[w] = v
                    o = opposite[b]
                    if o < 0:
                        break
                    d = o - 1 if o % 3 else o + 2
        c += 1
    return True


def distinct(vertex: vec[i64]) -> bool:
    """Whether no face has a vertex twice. Clause: CPLX-REJECT-4."""
    corners: i64 = len(vertex)
    c: i64 = 0
    while c < corners:
        x: i64 = vertex[c]
        y: i64 = vertex[c + 1]
        z: i64 = vertex[c + 2]
        if x == y or y == z or z == x:
            return False
        c += 3
    return True
