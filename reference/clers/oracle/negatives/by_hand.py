"""Files put together byte by byte, from the tables of chapter 8. Clause: ORCL-GRAMMAR-2."""

import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Final
from zlib import crc32

from clers.oracle.negatives import pencil
from clers.oracle.negatives.pencil import Closing

MAGIC: Final = bytes.fromhex("89434c4552530d0a")

CODES: Final[Mapping[str, tuple[int, Callable[[str, str], str]]]] = {
    "plain": (1, pencil.plain),
    "golden": (2, pencil.golden),
    "huffman": (3, pencil.huffman),
    "adaptive-1": (4, partial(pencil.adaptive, 1)),
    "adaptive-3": (5, partial(pencil.adaptive, 3)),
    "adaptive-6": (6, partial(pencil.adaptive, 6)),
    "king-rossignac": (7, pencil.king_rossignac),
}
"""The codes that are written here, with their numbers. Clause: FILE-HEAD-2."""


def varint(value: int) -> bytes:
    """Seven bits a byte, the lowest first. Clause: FILE-NUMBER-3."""
    out = b""
    while value >= 128:
        out += bytes([value % 128 + 128])
        value //= 128
    return out + bytes([value])


def signed(value: int) -> bytes:
    """Folded. Clause: FILE-NUMBER-4."""
    return varint(2 * value if value >= 0 else -2 * value - 1)


def bits(digits: str) -> bytes:
    """Their number, then the bits, filled with zeros. Clause: FILE-BITS-1."""
    filled = digits + "0" * (-len(digits) % 8)
    eights = (filled[i : i + 8] for i in range(0, len(filled), 8))
    return varint(len(digits)) + bytes(int(eight, 2) for eight in eights)


def seal(data: bytes) -> bytes:
    """Clause: FILE-SECTION-2."""
    return struct.pack("<I", crc32(data))


def section(tag: bytes, payload: bytes) -> bytes:
    """Clause: FILE-SECTION-1."""
    header = tag + struct.pack("<I", len(payload))
    return header + seal(header) + payload + seal(payload)


@dataclass(frozen=True, slots=True)
class File:
    """What a file says, in the words of chapter 8. Clauses: FILE-HEAD-1, FILE-POSN-1, FILE-POSN-2.

    `coding` is the number of the position coding, `posn` the payload of POSN.
    """

    word: str
    faces: int
    vertices: int
    with_boundary: int = 0
    closings: tuple[Closing, ...] = ()
    code: str = "plain"
    coding: int = 1
    posn: bytes = b""

    @property
    def parts(self) -> tuple[tuple[bytes, bytes], ...]:
        """The sections: tags and payloads. Clauses: FILE-SECTION-5, FILE-HAND-1, FILE-WORD-1."""
        number, code = CODES[self.code]
        counts = (
            self.faces, self.vertices, self.with_boundary, len(self.word), len(self.closings)
        )  # fmt: skip
        head = bytes([number, self.coding]) + b"".join(map(varint, counts))
        hand = bits(pencil.handles(self.closings, len(self.word)))
        word = bits(code(self.word, "" if self.with_boundary else "C"))
        return (
            (b"HEAD", head),
            *([(b"HAND", hand)] if self.closings else []),
            (b"WORD", word),
            *([(b"POSN", self.posn)] if self.coding > 1 else []),
        )

    @property
    def data(self) -> bytes:
        """The bytes. Clauses: FILE-MAGIC-1, FILE-MAGIC-2."""
        return MAGIC + b"\1" + b"".join(section(tag, payload) for tag, payload in self.parts)


def lattice(exponent: int, low: Sequence[int], extent: Sequence[int], digits: str) -> bytes:
    """The payload of quantised positions. Clause: FILE-POSN-2."""
    lows = b"".join(map(signed, low))
    return signed(exponent) + lows + b"".join(map(varint, extent)) + bits(digits)


Residuals = tuple[tuple[int, int, int], ...]

CORNER_RESIDUALS: Final[Residuals] = ((0, 0, 0), (2, 0, 0), (-2, 2, 0), (-2, -2, 2))
"""Of the indices 0, 2·e1, 2·e2, 2·e3 on a tetrahedron. Clause: GEOM-PREDICT-2.

The first three vertices are predicted by the one before, the fourth by the parallelogram (2, 2, 0).
"""


def on_tetrahedron(residuals: Residuals) -> str:
    """The bits of residuals on axes of extent 2 or 3, which have 4 classes. GEOM-CODE-1 … -3."""
    slots: list[pencil.Slot] = []
    models = {
        (axis, guessed): pencil.Counts((1, 1, 1, 1), 8, 1 << 13)
        for axis in range(3)
        for guessed in (False, True)
    }
    for guessed, vertex in zip((False, False, False, True), residuals, strict=True):
        for axis, residual in enumerate(vertex):
            folded = 2 * residual if residual >= 0 else -2 * residual - 1
            size = folded.bit_length()
            slots.append(models[axis, guessed].slot(size))
            if size > 1:
                rest = folded - (1 << (size - 1))
                slots.append((rest, rest + 1, 1 << (size - 1)))
    return pencil.long_addition(slots)


CORNER: Final = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

BALL: Final = File("CRE", 4, 4)
CUBE: Final = File("CCCRCRRCRRE", 12, 8)
TRIANGLE: Final = File("E", 1, 3, 1)
ANNULUS: Final = File("SLRRLE", 6, 6, 1, ((0, 1, 0, 2),))
TORUS: Final = File("CCCCRCSCRSSRLSEEE", 18, 9, 0, ((2, 0, 0, 2), (0, 0, 0, 4)))
TWO_BALLS: Final = File("CRECRE", 8, 8)
DISK_AND_BALL: Final = File("ECRE", 5, 7, 1)
F32: Final = replace(BALL, coding=2, posn=struct.pack("<12f", *CORNER))
F64: Final = replace(BALL, coding=3, posn=struct.pack("<12d", *CORNER))
LATTICE: Final = replace(
    BALL, coding=4, posn=lattice(-1, (0, 0, 0), (2, 2, 2), on_tetrahedron(CORNER_RESIDUALS))
)
