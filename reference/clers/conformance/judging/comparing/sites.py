"""Which vertices are near which: places within an error, and the sites that they make up."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from math import isfinite

from clers.conformance.judging.comparing.soup import Place

Bound = tuple[float, float, float]
"""How far a coordinate may move on each axis. Clause: ORCL-CODEC-1."""

Cell = tuple[int | float | str, ...]


def within(x: float, y: float, bound: float) -> bool:
    """Whether two coordinates differ by no more than the bound, exactly. Clause: ORCL-CODEC-4.

    Rounding is monotone, so only where the rounded difference is the bound can it mislead.
    """
    if x == y or (x != x and y != y):
        return True
    off = abs(x - y)
    return off < bound or (off == bound and abs(Fraction(x) - Fraction(y)) <= Fraction(bound))


def near(p: Place, q: Place, bound: Bound) -> bool:
    """Whether two places are within the bound on each axis. Clause: ORCL-CODEC-4."""
    return all(map(within, p, q, bound))


def sites(
    first: Sequence[Place], second: Sequence[Place], bound: Bound
) -> tuple[list[int], list[int]]:
    """A number for each place of either list, the same for places that near ones link.

    Near places have the same number. Linear, if not very many places are within one bound.
    Clause: ORCL-CODEC-4.
    """
    known = list(dict.fromkeys((*first, *second)))
    cells: dict[Cell, list[int]] = {}
    for i, place in enumerate(known):
        cells.setdefault(tuple(map(_cell, place, bound)), []).append(i)
    root = list(range(len(known)))
    for members in cells.values():
        for i in members[1:]:
            root[i] = members[0]
    steps = list(product(*((0,) if b == 0 else (-1, 0, 1) for b in bound)))
    beyond = [step for step in steps if step > (0, 0, 0)]
    for cell, members in cells.items():
        for step in beyond:
            others = cells.get(tuple(map(_moved, cell, step)), ())
            _link(root, known, members, others, bound)
    number = {place: _root(root, i) for i, place in enumerate(known)}
    return [number[p] for p in first], [number[p] for p in second]


def _cell(x: float, bound: float) -> int | float | str:
    """Coordinates in one cell are within the bound of each other, and near ones in adjacent."""
    if not isfinite(x):
        return repr(x)
    return x if bound == 0 else Fraction(x) // Fraction(bound)


def _moved(cell: int | float | str, step: int) -> int | float | str:
    return cell if isinstance(cell, str) else cell + step


def _link(
    root: list[int],
    known: Sequence[Place],
    members: Sequence[int],
    others: Sequence[int],
    bound: Bound,
) -> None:
    """Unite two cells if a place of one is near a place of the other."""
    if not others or _root(root, members[0]) == _root(root, others[0]):
        return
    if any(near(known[i], known[j], bound) for i in members for j in others):
        root[_root(root, others[0])] = _root(root, members[0])


def _root(root: list[int], i: int) -> int:
    while root[i] != i:
        root[i] = root[root[i]]
        i = root[i]
    return i
