"""Corner tables: which corners lie opposite to one edge, and whether each vertex has one fan.

Entries are corners and vertices, of both at most 2^31: a corner doubled is below 2^32, and with a
vertex above it below 2^63, so that nothing wraps.
"""

from typing import Final

from librt.strings import read_i32_le, read_i64_le
from librt.vecs import vec
from mypy_extensions import i64

from clers.kernels.flat import flags, minus_ones, zeros

WORD: Final = 0xFFFF_FFFF
MOST: Final = 0x8000_0000
"""No table has more corners."""


def indices(buffer: bytes) -> vec[i64]:
    """The numbers of 32 bits, lowest byte first, that a buffer holds. Linear. CPLX-INPUT-5."""
    count: i64 = len(buffer) // 4
    found = zeros(count)
    last: i64 = count - 1
    k: i64 = 0
    while k < last:
        two: i64 = read_i64_le(buffer, 4 * k)
        found[k] = two & WORD
        found[k + 1] = two >> 32 & WORD
        k += 2
    if k == last:
        found[k] = i64(read_i32_le(buffer, 4 * k)) & WORD
    return found


def fit(vertex: vec[i64], vertices: i64) -> bool:
    """Whether each face has three vertices, from 0 to `vertices` - 1. Linear.

    Clauses: CPLX-REJECT-3, CPLX-REJECT-4.
    """
    corners: i64 = len(vertex)
    c: i64 = 0
    while c < corners:
        x: i64 = vertex[c]
        y: i64 = vertex[c + 1]
        z: i64 = vertex[c + 2]
        if x < 0 or y < 0 or z < 0 or x >= vertices or y >= vertices or z >= vertices:
            return False
        if x == y or y == z or z == x:
            return False
        c += 3
    return True


def opposites(vertex: vec[i64], vertices: i64) -> vec[i64]:
    """The corner opposite to each corner, or -1; nothing at all if some edge is not as it must be.

    `vertex[c]` is the vertex at corner c, from 0 to `vertices` - 1, three that differ in each face.
    An edge has one face, or two that run it in opposite directions. Linear: corners are sorted by
    the lower end of their edge, and of one lower end the last corner of each upper end is kept.
    Clauses: CPLX-CORNER-3, CPLX-REJECT-6, CPLX-REJECT-7.
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
    # Of each edge the upper end, twice the corner opposite to it, and 1 if its face runs it up.
    edge = zeros(corners)
    c = 0
    while c < corners:
        x = vertex[c]
        y = vertex[c + 1]
        z = vertex[c + 2]
        two: i64 = 2 * c
        low: i64 = x if x < y else y
        j: i64 = start[low]
        edge[j] = y << 32 | two + 5 if x < y else x << 32 | two + 4
        start[low] = j + 1
        low = y if y < z else z
        j = start[low]
        edge[j] = z << 32 | two + 1 if y < z else y << 32 | two
        start[low] = j + 1
        low = z if z < x else x
        j = start[low]
        edge[j] = x << 32 | two + 3 if z < x else z << 32 | two + 2
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
            one: i64 = edge[j]
            w: i64 = one >> 32
            p: i64 = last[w]
            if p < first:
                last[w] = j
            else:
                other: i64 = edge[p]
                if (one ^ other) & 1 == 0:
                    return vec[i64]()
                d: i64 = (other & WORD) >> 1
                if opposite[d] >= 0:
                    return vec[i64]()
                c = (one & WORD) >> 1
                opposite[d] = c
                opposite[c] = d
            j += 1
        u += 1
    return opposite


def one_fan_each(vertex: vec[i64], opposite: vec[i64], vertices: i64) -> bool:
    """Whether the faces at each vertex are one fan, and there is a face at each. Linear.

    From one corner of each vertex all others of its fan are reached by turning one way, and at a
    border the other way; all corners are reached if and only if there is no second fan. Where no
    edge has three faces, two faces on the same vertices share all edges, and are a whole fan.
    Clauses: CPLX-REJECT-5, CPLX-REJECT-8, CPLX-REJECT-9.
    """
    corners: i64 = len(vertex)
    met = flags(vertices)
    used: i64 = 0
    reached: i64 = 0
    c: i64 = 0
    while c < corners:
        v: i64 = vertex[c]
        if met[v] == 0:
            met[v] = 1
            used += 1
            before: i64 = reached
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
            elif reached - before < 3:
                return False
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
    done = flags(vertices)
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
