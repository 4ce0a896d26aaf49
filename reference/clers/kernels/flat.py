"""Flat arrays of integers that are all the same."""

from typing import Final

from librt.vecs import extend, vec
from mypy_extensions import i64, u8

BLOCK: Final = 4096
"""So many numbers stay in the nearest cache."""


def repeated(number: i64, length: i64) -> vec[i64]:
    """So many times the number, copied block by block, so that nothing is written twice. Linear."""
    if length == 0:
        return vec[i64]()
    most: i64 = min(length, BLOCK)
    block = vec[i64]([number], capacity=most)
    while 2 * len(block) <= most:
        block = extend(block, block)
    found = vec[i64](capacity=length)
    rest: i64 = length - len(block)
    while len(found) <= rest:
        found = extend(found, block)
    return extend(found, block[: length - len(found)])


def zeros(length: i64) -> vec[i64]:
    """So many zeros."""
    return repeated(0, length)


def minus_ones(length: i64) -> vec[i64]:
    """So many times −1."""
    return repeated(-1, length)


def flags(length: i64) -> vec[u8]:
    """So many bytes, all zero."""
    return vec[u8](bytes(length))
