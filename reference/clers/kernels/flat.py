"""Flat arrays of integers that are all the same.

Machine code fills an array where a list of one number is multiplied in its place; to extend an
array by another takes ten times as long.
"""

from librt.vecs import vec
from mypy_extensions import i32, i64, u8


def repeated(number: i64, length: i64) -> vec[i64]:
    """So many times the number. Linear."""
    return vec[i64]([number] * length)


def zeros(length: i64) -> vec[i64]:
    """So many zeros: memory that nobody writes to is not touched."""
    return vec[i64]([0] * length)


def minus_ones(length: i64) -> vec[i64]:
    """So many times −1."""
    return vec[i64]([-1] * length)


def flags(length: i64) -> vec[u8]:
    """So many bytes, all zero."""
    return vec[u8](bytes(length))


def narrow_zeros(length: i64) -> vec[i32]:
    """So many zeros of 32 bits."""
    return vec[i32]([i32(0)] * length)
