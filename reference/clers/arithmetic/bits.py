"""Strings of bits, and how they are packed into bytes."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte

_DIGITS: Final = bytes.maketrans(b"\0\1", b"01")
_VALUES: Final = bytes.maketrans(b"01", b"\0\1")


@dataclass(frozen=True, slots=True)
class Bits:
    """`length` bits, packed: most significant first, the last byte filled with zeros.

    Clauses: ARITH-BITS-1, ARITH-BITS-2. Built by `pack` or `packed`, never by hand.
    """

    data: bytes
    length: int

    def values(self) -> bytes:
        """The bits, one in each byte, as 0 or 1."""
        return self.digits().encode().translate(_VALUES)

    def digits(self) -> str:
        """The bits as a string of "0" and "1"."""
        digits = f"{int.from_bytes(self.data, 'big'):0{8 * len(self.data)}b}"
        return digits[: self.length]

    def followed_by(self, other: "Bits") -> "Bits":
        """These bits and then the others."""
        first = int.from_bytes(self.data, "big") >> -self.length % 8
        second = int.from_bytes(other.data, "big") >> -other.length % 8
        length = self.length + other.length
        number = (first << other.length | second) << -length % 8
        return Bits(number.to_bytes((length + 7) // 8, "big"), length)

    def upto(self, count: int) -> "Bits":
        """The first bits, at most so many."""
        length = min(count, self.length)
        size = (length + 7) // 8
        number = int.from_bytes(self.data[:size], "big") >> -length % 8 << -length % 8
        return Bits(number.to_bytes(size, "big"), length)

    def after(self, count: int) -> "Bits":
        """The bits after so many; there are as many."""
        length = self.length - count
        rest = int.from_bytes(self.data, "big") >> -self.length % 8 & (1 << length) - 1
        return Bits((rest << -length % 8).to_bytes((length + 7) // 8, "big"), length)


def pack(values: Iterable[int]) -> Bits:
    """Pack bits given one by one, each 0 or 1. Clause: ARITH-BITS-2."""
    digits = bytes(values).translate(_DIGITS)
    size = (len(digits) + 7) // 8
    number = int(digits.ljust(8 * size, b"0") or b"0", 2)
    return Bits(number.to_bytes(size, "big"), len(digits))


def packed(data: bytes, length: int) -> Accepted[Bits] | Rejected:
    """Take bytes from outside as `length` bits. Clause: ARITH-BITS-3."""
    size = (length + 7) // 8
    if length < 0 or len(data) < size:
        detail = f"{length} bits in {len(data)} bytes"
        return Rejected(Reason.TRUNCATED_BITS, Clause.ARITH_BITS_3, detail=detail)
    if len(data) > size:
        detail = f"{length} bits in {len(data)} bytes"
        return Rejected(Reason.TRAILING_BITS, Clause.ARITH_BITS_3, AtByte(size), detail)
    if length % 8 and data[-1] & (0xFF >> length % 8):
        detail = "the last byte is not filled with zeros"
        return Rejected(Reason.TRAILING_BITS, Clause.ARITH_BITS_3, AtByte(size - 1), detail)
    return Accepted(Bits(data, length))
