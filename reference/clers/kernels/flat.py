"""Flat arrays of integers, all 0 or all −1."""

from librt.vecs import vec
from mypy_extensions import i64


def zeros(length: int) -> vec[i64]:
    """So many zeros."""
    return vec[i64](memoryview(bytes(8 * length)).cast("q"))


def minus_ones(length: int) -> vec[i64]:
    """So many times −1."""
    return vec[i64](memoryview(b"\xff" * (8 * length)).cast("q"))
