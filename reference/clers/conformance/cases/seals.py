"""Seals made anew: what a fault behind a checksum needs to be seen at all. Clause: ORCL-FAULT-2."""

from zlib import crc32

from clers.container.contents import MAGIC
from clers.container.numbers import U32
from clers.container.section import HEADER

SEAL = U32.least
FIRST = len(MAGIC) + 1


def resealed(data: bytes) -> bytes:
    """The file with the right seals, as far as its sections can be followed.

    Linear. Clauses: ORCL-FAULT-2, FILE-SECTION-2.
    """
    out = bytearray(data)
    at = FIRST
    while at + HEADER.least <= len(out):
        start = at + HEADER.least
        stop = start + int.from_bytes(out[start - 8 : start - SEAL], "little")
        out[start - SEAL : start] = U32.write(crc32(out[at : start - SEAL]))
        if stop + SEAL > len(out):
            break
        out[stop : stop + SEAL] = U32.write(crc32(out[start:stop]))
        at = stop + SEAL
    return bytes(out)
