"""The POSN section: exact bytes, or an exponent, a box and coded residuals."""

from typing import Final

from clers.arithmetic.bits import Bits, packed
from clers.container.layout import Layout, dependent, pair, renamed
from clers.container.numbers import raw, signed, varint
from clers.conventions.result import Accepted
from clers.geometry.box import Box, Triple
from clers.geometry.quantised import Coded

BITS: Final[Layout[Bits]] = renamed(
    dependent(varint(40), lambda length: raw((length + 7) // 8)),
    lambda read: packed(read[1], read[0]),
    lambda bits: (bits.length, bits.data),
)
"""A number of bits, and the bytes that hold them. Clause: FILE-BITS-1."""


def _three(axis: Layout[int]) -> Layout[Triple]:
    return renamed(
        pair(axis, pair(axis, axis)),
        lambda read: Accepted((read[0], read[1][0], read[1][1])),
        lambda triple: (triple[0], (triple[1], triple[2])),
    )


LATTICE: Final[Layout[Coded]] = renamed(
    pair(signed(12), pair(_three(signed(54)), pair(_three(varint(30)), BITS))),
    lambda read: Accepted(Coded(read[0], Box(read[1][0], read[1][1][0]), read[1][1][1])),
    lambda coded: (coded.exponent, (coded.box.low, (coded.box.extent, coded.bits))),
)
"""Quantised positions. Clause: FILE-POSN-2."""
