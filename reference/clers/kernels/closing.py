"""Handle data by the edges between an S and the one that closes it, in one sweep over the word.

A closer is a symbol R, L or E. The edges that can close an S are, on the right side, those of R and
E, on the left side those of L and E: counted from the beginning of the word, what is between two of
them is a difference. Numbers count symbols, but those that are asked for; these are below 2^62.
"""

from typing import Final

from librt.vecs import append, vec
from mypy_extensions import i64

from clers.kernels.flat import minus_ones, zeros
from clers.kernels.scan import E, L, R, Records, S

NONE: Final = -1
"""There is no such edge."""


def between(word: bytes, records: Records, first: i64, closers: i64) -> vec[i64]:
    """For each record, edges of its side between its S and its closing edge; NONE without one.

    Records before the `first` are left out (NONE); the S of the others increase. `closers`: how
    many the word has. Linear. Clauses: CODE-HAND-1, CODE-HAND-2.
    """
    count: i64 = len(records.s)
    right_of = minus_ones(closers)  # the number of its right edge, by closer
    left_of = minus_ones(closers)
    before = zeros(count)  # edges of the record's side before its S
    n: i64 = len(word)
    rights: i64 = 0
    lefts: i64 = 0
    k: i64 = 0
    s: i64 = 0
    r: i64 = first
    i: i64 = 0
    while i < n:
        x: i64 = word[i]
        if x == S:
            if r < count and records.s[r] == s:
                before[r] = lefts if records.left[r] else rights
                r += 1
            s += 1
        elif x in (R, L, E):
            if x != L:
                right_of[k] = rights
                rights += 1
            if x != R:
                left_of[k] = lefts
                lefts += 1
            k += 1
        i += 1
    found = minus_ones(count)
    r = first
    while r < count:
        at: i64 = records.at[r]
        if at >= 0 and at < closers:
            edge: i64 = left_of[at] if records.left[r] else right_of[at]
            if edge >= before[r]:
                found[r] = edge - before[r]
        r += 1
    return found


def closers(word: bytes, s: vec[i64], left: vec[i64], after: vec[i64]) -> vec[i64]:
    """For each S, in order, the closer with so many edges of its side between; NONE without one.

    `left[r]`, `after[r]`: the side of the S number `s[r]`, and how many edges are between.
    Linear. Clause: CODE-HAND-3.
    """
    count: i64 = len(s)
    rights = vec[i64]()  # the closer of each right edge
    lefts = vec[i64]()
    found = minus_ones(count)
    n: i64 = len(word)
    k: i64 = 0
    number: i64 = 0
    r: i64 = 0
    i: i64 = 0
    while i < n:
        x: i64 = word[i]
        if x == S:
            if r < count and s[r] == number:
                if after[r] >= 0:
                    found[r] = (len(lefts) if left[r] else len(rights)) + after[r]
                r += 1
            number += 1
        elif x in (R, L, E):
            if x != L:
                rights = append(rights, k)
            if x != R:
                lefts = append(lefts, k)
            k += 1
        i += 1
    r = 0
    while r < count:
        edges = lefts if left[r] else rights
        edge: i64 = found[r]
        found[r] = edges[edge] if edge >= 0 and edge < len(edges) else NONE
        r += 1
    return found
