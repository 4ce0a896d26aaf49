"""Rows of numbers in two forms: tuples for whoever reads them, flat arrays for kernels."""

from typing import Generic, TypeGuard, TypeVar, final

from librt.vecs import vec
from mypy_extensions import i64
from typing_extensions import override

N = TypeVar("N", bound=int)


@final
class Row(Generic[N]):
    """Numbers in a row that never change: a value, whose other form is made when first asked for.

    A mesh of a million faces goes from file to file without a Python integer for each corner, and
    whoever wants to look at a corner sees a tuple. Made by `listed` and `flat_row`.
    """

    __slots__ = ("_flat", "_numbers")

    def __init__(self, numbers: tuple[N, ...] | None, flat: vec[i64] | None) -> None:
        self._numbers = numbers
        self._flat = flat

    @property
    def numbers(self) -> tuple[N, ...]:
        """All of them, for Python."""
        if self._numbers is None:
            found = tuple(self.flat)
            assert _all_are(found, self)
            self._numbers = found
        return self._numbers

    @property
    def flat(self) -> vec[i64]:
        """All of them, for kernels, which do not write into it."""
        if self._flat is None:
            self._flat = vec[i64](self.numbers)
        return self._flat

    def __len__(self) -> int:
        """How many."""
        return len(self.flat if self._numbers is None else self._numbers)

    @override
    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Row):
            return NotImplemented
        if self._flat is not None and other._flat is not None:
            return self._flat == other._flat
        return self.numbers == other.numbers

    @override
    def __hash__(self) -> int:
        return hash(self.numbers)

    @override
    def __repr__(self) -> str:
        return repr(self.numbers)


def listed(numbers: tuple[N, ...]) -> Row[N]:
    """The row of these numbers."""
    return Row(numbers, None)


def flat_row(flat: vec[i64]) -> Row[N]:
    """The row that a kernel has found; nobody writes into it afterwards."""
    return Row(None, flat)


def _all_are(_: tuple[int, ...], like: Row[N]) -> TypeGuard[tuple[N, ...]]:
    """What a kernel gives as vertices are vertices: to ask each would take longer than it took."""
    return isinstance(like, Row)
