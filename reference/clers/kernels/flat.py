"""Flat arrays of integers that are all the same."""

from librt.vecs import extend, vec
from mypy_extensions import i64, u8


def repeated(number: i64, length: i64) -> vec[i64]:
    """So many times the number: as much again as is there is copied at once. Linear."""
    if length == 0:
        return vec[i64]()
    found = vec[i64]([number], capacity=length)
    while 2 * len(found) <= length:
        found = extend(found, found)
    return extend(found, found[: length - len(found)])


def zeros(length: i64) -> vec[i64]:
    """So many zeros."""
    return repeated(0, length)


def minus_ones(length: i64) -> vec[i64]:
    """So many times −1."""
    return repeated(-1, length)


def flags(length: i64) -> vec[u8]:
    """So many bytes, all zero."""
    return vec[u8](bytes(length))
