"""Where two lists part."""

from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")

NOTHING = "nothing more"


def parting(right: Sequence[T], got: Sequence[T]) -> int | None:
    """The first index at which the lists differ, or one of them has ended; None if equal.

    Clause: ORCL-JUDGE-4.
    """
    for i, (one, other) in enumerate(zip(right, got, strict=False)):
        if one != other:
            return i
    return None if len(right) == len(got) else min(len(right), len(got))


def shown(items: Sequence[T], at: int) -> str:
    """The item at a place as text, or that there is none."""
    return str(items[at]) if at < len(items) else NOTHING


def listed(numbers: Sequence[object]) -> str:
    """Numbers in brackets, as people write triangles and gates."""
    return f"({', '.join(map(str, numbers))})"
