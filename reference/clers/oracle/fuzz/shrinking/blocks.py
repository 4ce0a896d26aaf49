"""Lists with a block removed: large blocks first, single entries last. Clause: ORCL-SHRINK-3."""

from collections.abc import Iterator, Sequence
from typing import TypeVar

T = TypeVar("T")


def without_blocks(items: Sequence[T]) -> Iterator[tuple[T, ...]]:
    """The list without each block of half its length, of a quarter, … and of one entry."""
    size = len(items) // 2
    while size > 0:
        for start in range(0, len(items), size):
            yield (*items[:start], *items[start + size :])
        size //= 2
    if len(items) == 1:
        yield ()


def nearer(number: int) -> Iterator[int]:
    """Smaller numbers: 0, the half, and one less. Of a negative one its opposite and these."""
    if number < 0:
        yield -number
    size = abs(number)
    yield from sorted({0, size // 2, max(size - 1, 0)} - {size})
