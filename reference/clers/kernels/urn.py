"""Coding bits as drawn from an urn, of which none is put back. Clause: INFO-ENUM-6.

There are at most 2^30 bits in the urn (INFO-MODEL-2).
"""

from librt.strings import BytesWriter
from mypy_extensions import i64, u8

from clers.kernels.interval import AHEAD, Decoder, Encoder


def encoded(bits: bytes, zeros: i64, ones: i64, to: Encoder) -> i64:
    """Write bits, one in each byte; the place of the first that the urn lacks, or -1. Linear."""
    n: i64 = len(bits)
    i: i64 = 0
    while i < n:
        total: i64 = zeros + ones
        bit: i64 = bits[i]
        if (ones if bit else zeros) == 0:
            return i
        to.decide(bit == 1, (to.high - to.low + 1) * zeros // total)
        ones -= bit
        zeros -= 1 - bit
        i += 1
    return -1


def decoded(zeros: i64, ones: i64, longest: i64, of: Decoder) -> bytes:
    """All bits of the urn; fewer if they would take more than `longest` bits. Linear."""
    out = BytesWriter()
    while zeros + ones > 0:
        total: i64 = zeros + ones
        bit: i64 = 1 if of.decide((of.high - of.low + 1) * zeros // total) else 0
        ones -= bit
        zeros -= 1 - bit
        if of.at - AHEAD > longest:
            break
        out.append(u8(bit))
    return out.getvalue()
