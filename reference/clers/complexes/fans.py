"""Fans: the faces at a vertex, taken together as they meet across edges at that vertex."""

from collections.abc import Sequence

from clers.complexes.surface import BORDER


def fans(vertex: Sequence[int], mate: Sequence[int]) -> tuple[int, ...]:
    """For each corner the lowest corner of its fan.

    Two corners at one vertex are in one fan if a walk across edges at that vertex leads from one
    to the other; how the faces are oriented does not matter. Linear. Clause: CPLX-SURFACE-3.
    """
    lowest = [-1] * len(vertex)
    for first, v in enumerate(vertex):
        if lowest[first] >= 0:
            continue
        lowest[first] = first
        stack = [first]
        while stack:
            c = stack.pop()
            after, before = (c - 2 if c % 3 == 2 else c + 1), (c + 2 if c % 3 == 0 else c - 1)
            for d in (mate[after], mate[before]):
                if d == BORDER:
                    continue
                e = d - 2 if d % 3 == 2 else d + 1
                if vertex[e] != v:  # the two faces run their edge the same way
                    e = d + 2 if d % 3 == 0 else d - 1
                if lowest[e] < 0:
                    lowest[e] = first
                    stack.append(e)
    return tuple(lowest)
