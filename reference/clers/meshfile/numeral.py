"""Numerals in text formats, strictly: what Python's own conversions allow beyond them is refused.

`int` and `float` take underscores between digits; nothing else of theirs is foreign to the formats
when they are given bytes without white space.
"""

from array import array
from collections.abc import Iterable, Sequence


def integer(token: bytes) -> int | None:
    """A decimal integer with or without a sign, of any size; None if it is none.

    Clause: TOOL-READ-7.
    """
    if b"_" in token:
        return None
    try:
        return int(token)
    except ValueError:
        return None


def real(token: bytes) -> float | None:
    """The binary64 value nearest to a decimal numeral, or an infinity or NaN; None if neither.

    Clauses: TOOL-READ-7, TOOL-READ-9.
    """
    if b"_" in token:
        return None
    try:
        return float(token)
    except ValueError:
        return None


def reals(tokens: Sequence[bytes]) -> tuple[float, ...] | None:
    """All of them, or None if one is no numeral. Clause: TOOL-READ-7."""
    values = tuple(x for x in map(real, tokens) if x is not None)
    return values if len(values) == len(tokens) else None


def singles(values: Iterable[float]) -> tuple[float, ...]:
    """Each value rounded to the nearest binary32, beyond its range to an infinity.

    Clause: TOOL-READ-7.
    """
    return tuple(array("f", values))
