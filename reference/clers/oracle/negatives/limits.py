"""Files of a few bytes that declare a great deal. Clauses: ORCL-LIMIT-1, FILE-COUNT-4."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from math import floor, log2, sqrt
from typing import Final

from clers.conformance.cases.case import Edit
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.oracle.negatives import by_hand
from clers.oracle.negatives.by_hand import CODES, File, bits, varint
from clers.oracle.negatives.draft import Draft, bad
from clers.oracle.negatives.in_files import exchanged, field, parent, payload
from clers.oracle.suite.profiles import LIMITS

C = Clause
R = Reason

MOST: Final = 1 << 26
"""Of faces and vertices. Clause: FILE-LIMIT-1."""

NUMBERS: Final = (MOST + 1, 1 << 27, 1 << 30, (1 << 31) - 1, 1 << 31, (1 << 32) - 1)
"""Just too many, and those at which signed and unsigned 32-bit integers end."""

BORNE: Final = (900_000, MOST)
"""Sizes that many readers bear, and the greatest that the reference does."""

PHI: Final = log2((1 + sqrt(5)) / 2)

BELIEVED: Final[Mapping[str, Callable[[int], int]]] = {
    "plain": lambda n: n + 1,
    "golden": lambda n: floor(n / PHI) + 2,
    "huffman": lambda n: max(n - 15, 0) + 1,
    "king-rossignac": lambda n: max(n - 2, 0) + 1,
    "adaptive-1": lambda n: 1420 * n + 2,
    "adaptive-3": lambda n: 1420 * n + 2,
    "adaptive-6": lambda n: 1420 * n + 2,
}
"""The most symbols in so many bits, from the table of CODE-NAME-3."""


def drafts() -> Iterator[Draft]:
    """What a reader must refuse before it makes room. Clause: ORCL-LIMIT-1."""
    ball = parent("file-ball-plain", by_hand.BALL)
    for draft in (*declared(ball), *in_sections(ball), *positioned(), *believed()):
        yield draft._replace(profile=LIMITS)


def declared(ball: Draft) -> Iterator[Draft]:
    """HEAD declares more than the limits. Clause: FILE-LIMIT-2."""
    file = by_hand.BALL
    for name, at, reason in (
        ("faces", 2, R.TOO_MANY_FACES),
        ("vertices", 3, R.TOO_MANY_VERTICES),
        ("symbols", 5, R.TOO_MANY_FACES),
    ):
        for number in NUMBERS:
            yield bad(
                ball, f"{number}-{name}", field(file, at, varint(number)), reason, C.FILE_LIMIT_2,
                sealed=True, flags=("size-trusted",),
            )  # fmt: skip
        edits = field(file, at, varint(1 << 32))
        yield bad(
            ball, f"{1 << 32}-{name}", edits, R.BAD_NUMBER, C.FILE_NUMBER_3,
            sealed=True, flags=("integer-wraps",),
        )  # fmt: skip
    rows: tuple[tuple[str, int, int, R, C], ...] = (
        *((f"{n}-faces", 2, n, R.COUNT_MISMATCH, C.FILE_COUNT_3) for n in BORNE),
        *((f"{n}-vertices", 3, n, R.COUNT_MISMATCH, C.FILE_COUNT_3) for n in BORNE),
        *((f"{n}-symbols", 5, n, R.IMPOSSIBLE_COUNT, C.FILE_COUNT_2) for n in BORNE),
        ("boundaries-without-end", 4, (1 << 32) - 1, R.TRUNCATED_BITS, C.CODE_PLAIN_2),
        ("records-without-end", 6, (1 << 32) - 1, R.BAD_SECTION, C.FILE_SECTION_5),
    )
    for kind, at, number, reason, clause in rows:
        yield bad(
            ball, kind, field(file, at, varint(number)), reason, clause, sealed=True,
            flags=("size-trusted",), requires=("boundaries.many", "components") if at == 4 else (),
            size=number if number in BORNE else 0,
        )  # fmt: skip
    torus, annulus = by_hand.TORUS, by_hand.ANNULUS
    for name, file in (("file-torus-plain", torus), ("file-annulus-plain", annulus)):
        draft = parent(name, file)
        yield bad(
            draft, "records-without-end", field(file, 6, varint((1 << 32) - 1)),
            R.IMPOSSIBLE_COUNT, C.FILE_COUNT_1, sealed=True, flags=("size-trusted",),
        )  # fmt: skip


def in_sections(ball: Draft) -> Iterator[Draft]:
    """Lengths of sections and bits that are longer than the file. FILE-LAYOUT-3."""
    file = by_hand.BALL
    past = R.TRUNCATED_FILE, C.FILE_LAYOUT_3
    for number in ((1 << 31) - 1, 1 << 31, (1 << 32) - 1):
        length = exchanged(36, (2).to_bytes(4, "little"), number.to_bytes(4, "little"))
        yield bad(
            ball, f"section-of-{number}-bytes", (length,), *past, sealed=True,
            flags=("size-trusted",),
        )  # fmt: skip
    for number in ((1 << 31) - 1, 1 << 32, (1 << 35) - 1, (1 << 40) - 1):
        edits = payload(file, b"WORD", varint(number) + b"\xbc")
        yield bad(
            ball, f"word-of-{number}-bits", edits, *past, sealed=True, flags=("size-trusted",)
        )


def positioned() -> Iterator[Draft]:
    """Positions for more vertices than there are bytes. FILE-POSN-1, FILE-POSN-2."""
    for name, file in (
        ("file-single-precision-plain", by_hand.F32),
        ("file-double-precision-plain", by_hand.F64),
    ):
        draft = parent(name, file)
        for number in (5, *BORNE):
            edits = field(file, 3, varint(number))
            yield bad(
                draft, f"positions-of-{number}-vertices", edits,
                R.COUNT_MISMATCH, C.GEOM_EXACT_2, sealed=True, flags=("size-trusted",),
                size=number,
            )  # fmt: skip
    lattice = by_hand.LATTICE
    draft = parent("file-lattice-plain", lattice)
    rows: tuple[tuple[str, tuple[Edit, ...], R, C], ...] = (
        ("lattice-of-900000-vertices", field(lattice, 3, varint(BORNE[0])),
         R.COUNT_MISMATCH, C.FILE_COUNT_3),
        ("residuals-of-2-39-bits",
         payload(lattice, b"POSN", lattice.posn[:7] + varint(1 << 39) + lattice.posn[8:]),
         R.TRUNCATED_FILE, C.FILE_LAYOUT_3),
    )  # fmt: skip
    for kind, edits, reason, clause in rows:
        yield bad(
            draft, kind, edits, reason, clause, sealed=True, flags=("size-trusted",), size=BORNE[0]
        )


def believed() -> Iterator[Draft]:
    """One symbol more than the bits of the code can have. FILE-COUNT-2, CODE-NAME-3."""
    for code in CODES:
        file = replace(by_hand.BALL, code=code)
        draft = parent(f"file-ball-{code}", file)
        length = len(CODES[code][1]("CRE", "C"))
        most = BELIEVED[code](length)
        for symbols in (most + 1, *BORNE):
            yield bad(
                draft, f"{symbols}-symbols-in-few-bits", field(file, 5, varint(symbols)),
                R.IMPOSSIBLE_COUNT, C.FILE_COUNT_2,
                sealed=True, flags=("size-trusted",), size=symbols,
            )  # fmt: skip
    empty: File = replace(by_hand.BALL, code="adaptive-6")
    for kind, data in (("no-bits", bits("")), ("one-bit", bits("0"))):
        yield bad(
            parent("file-ball-adaptive-6", empty), f"{BORNE[0]}-symbols-in-{kind}",
            (*payload(empty, b"WORD", data), *field(empty, 5, varint(BORNE[0]))),
            R.IMPOSSIBLE_COUNT, C.FILE_COUNT_2, sealed=True, flags=("size-trusted",),
            size=BORNE[0],
        )  # fmt: skip
