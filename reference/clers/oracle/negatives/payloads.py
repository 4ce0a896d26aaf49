"""What may be wrong behind the seals of HAND, WORD and POSN. Chapters 5 to 8."""

import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

from clers.conformance.cases.case import Edit
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.oracle.negatives import by_hand, pencil
from clers.oracle.negatives.by_hand import File, bits, varint
from clers.oracle.negatives.draft import Draft, bad
from clers.oracle.negatives.in_files import parent, payload, place

C = Clause
R = Reason

Row = tuple[str, tuple[Edit, ...], R, C, str]


def drafts() -> Iterator[Draft]:
    """Good files, and faults in their payloads, sealed. Clause: ORCL-OP-7."""
    files = {
        "file-ball-plain": (by_hand.BALL, words_of_ball),
        "file-ball-golden": (replace(by_hand.BALL, code="golden"), words_of_golden),
        "file-torus-plain": (by_hand.TORUS, handles_of_torus),
        "file-annulus-plain": (by_hand.ANNULUS, handles_of_annulus),
        "file-single-precision-plain": (by_hand.F32, exact_singles),
        "file-double-precision-plain": (by_hand.F64, exact_doubles),
        "file-lattice-plain": (by_hand.LATTICE, on_lattice),
    }
    for slug, (file, rows) in files.items():
        draft = parent(slug, file, ("reader-knows-one-writer",))
        yield draft
        for kind, edits, reason, clause, flag in rows(file):
            yield bad(
                draft, kind, edits, reason, clause, sealed=True, flags=(flag,),
                requires=NEEDS.get(kind, ()),
            )  # fmt: skip


NEEDS: Final[Mapping[str, tuple[str, ...]]] = {
    "word-cee": ("components",),
    "word-cer": ("components",),
    "handle-for-curve": ("handles",),
    "curve-in-closed-surface": ("boundaries.many",),
}
"""What a fault speaks of that its parent does not, by its kind. Clause: ORCL-CASE-4."""


def words_of_ball(file: File) -> Iterator[Row]:
    """The bits of the word. Clauses: FILE-BITS-1, FILE-WORD-1, CODE-PLAIN-2."""

    def word(data: bytes) -> tuple[Edit, ...]:
        return payload(file, b"WORD", data)

    more, fill = "bits-by-bytes", "filling-bits-ignored"
    yield "fill-first-bit-set", word(b"\x06\xbe"), R.TRAILING_BITS, C.ARITH_BITS_3, fill
    yield "fill-last-bit-set", word(b"\x06\xbd"), R.TRAILING_BITS, C.ARITH_BITS_3, fill
    yield "one-bit-more", word(bits("1011110")), R.TRAILING_BITS, C.CODE_PLAIN_2, more
    yield "two-bits-more", word(bits("10111100")), R.TRAILING_BITS, C.CODE_PLAIN_2, more
    yield "another-symbol-more", word(bits("101111111")), R.TRAILING_BITS, C.CODE_PLAIN_2, more
    yield "one-bit-less", word(bits("10111")), R.TRUNCATED_BITS, C.CODE_PLAIN_2, more
    yield "three-bits-less", word(bits("101")), R.TRUNCATED_BITS, C.CODE_PLAIN_2, more
    yield "no-bits", word(bits("")), R.IMPOSSIBLE_COUNT, C.FILE_COUNT_2, more
    yield "word-empty", word(b""), R.TRUNCATED_FILE, C.FILE_LAYOUT_3, "read-past-the-end"
    yield "bits-without-bytes", word(b"\x06"), R.TRUNCATED_FILE, C.FILE_LAYOUT_3, "size-trusted"
    huge = varint((1 << 40) - 1) + b"\xbc"
    yield "bits-without-end", word(huge), R.TRUNCATED_FILE, C.FILE_LAYOUT_3, "size-trusted"
    wide = varint(1 << 40) + b"\xbc"
    yield "bits-over-40-bits", word(wide), R.BAD_NUMBER, C.FILE_NUMBER_3, "integer-wraps"
    wraps = varint((1 << 32) + 6) + b"\xbc"
    yield "bits-wrap-at-32", word(wraps), R.TRUNCATED_FILE, C.FILE_LAYOUT_3, "integer-wraps"
    long = b"\x86\x00\xbc"
    yield "bits-number-too-long", word(long), R.BAD_NUMBER, C.FILE_NUMBER_3, "number-not-canonical"
    yield "byte-more", word(b"\x06\xbc\0"), R.TRAILING_BYTES, C.FILE_LAYOUT_2, "bytes-left-unread"
    unchecked = "unchecked-word"
    yield "word-crr", word(bits("101101")), R.UNFINISHED_WORD, C.EB_GRAMMAR_3, unchecked
    yield "word-cer", word(bits("111101")), R.UNFINISHED_WORD, C.EB_GRAMMAR_3, unchecked
    yield "word-cle", word(bits("110111")), R.DOUBLE_EDGE, C.EB_GRAMMAR_9, unchecked
    yield "word-cee", word(bits("111111")), R.LOOP_TOO_SHORT, C.EB_GRAMMAR_5, unchecked
    yield "word-cse", word(bits("100111")), R.UNFINISHED_WORD, C.EB_GRAMMAR_3, unchecked


def words_of_golden(file: File) -> Iterator[Row]:
    """The same for an arithmetic code. Clauses: ARITH-STRICT-2, ARITH-STRICT-3, ARITH-STRICT-4."""
    right = pencil.golden("CRE", "C")
    loose = "bits-not-compared"
    for kind, digits, reason, clause in (
        ("one-bit-more", right + "0", R.TRAILING_BITS, C.ARITH_STRICT_3),
        ("one-bit-set-more", right + "1", R.TRAILING_BITS, C.ARITH_STRICT_3),
        ("one-bit-less", right[:-1], R.TRUNCATED_BITS, C.ARITH_STRICT_2),
        ("last-bit-turned", right[:-1] + "1", R.NOT_CANONICAL, C.ARITH_STRICT_4),
    ):
        yield kind, payload(file, b"WORD", bits(digits)), reason, clause, loose


def handles_of_torus(file: File) -> Iterator[Row]:
    """Handle data that is no handle data, or of another word. FILE-HAND-1, CODE-HAND-3."""

    def hand(*closings: pencil.Closing) -> tuple[Edit, ...]:
        return payload(file, b"HAND", bits(pencil.handles(closings, len(file.word))))

    first, second = file.closings
    right = pencil.handles(file.closings, len(file.word))
    here = place(file, b"HAND")
    last = file.data[here.stop - 1]
    loose, record = "bits-not-compared", "unchecked-record"
    filled = file.data[here.start : here.stop - 1] + bytes([last | 1])
    yield "fill-bit-set", payload(file, b"HAND", filled), R.TRAILING_BITS, C.ARITH_BITS_3, loose
    for kind, digits, reason, clause in (
        ("one-bit-more", right + "0", R.TRAILING_BITS, C.ARITH_STRICT_3),
        ("one-bit-less", right[:-1], R.TRUNCATED_BITS, C.ARITH_STRICT_2),
        ("last-bit-turned", right[:-1] + str(1 - int(right[-1])), R.NOT_CANONICAL,
         C.ARITH_STRICT_4),
        ("no-bits", "", R.TRUNCATED_BITS, C.ARITH_STRICT_2),
    ):  # fmt: skip
        yield f"handle-data-{kind}", payload(file, b"HAND", bits(digits)), reason, clause, loose
    range_of = R.RECORD_OUT_OF_RANGE, C.CODE_HAND_3
    yield "passed-all-s", hand((4, 0, 0, 2), second), *range_of, record
    yield "second-passed-too-many", hand(first, (2, 0, 0, 4)), *range_of, record
    yield "between-too-many", hand((2, 0, 0, 4), second), *range_of, record
    yield "second-between-too-many", hand(first, (0, 0, 0, 5)), *range_of, record
    yield "other-side", hand((2, 0, 1, 2), second), R.DOUBLE_EDGE, C.EB_GRAMMAR_9, record
    yield (
        "curve-in-closed-surface",
        hand((2, 1, 0, 2), second),
        R.NOT_A_CURVE,
        C.EB_GRAMMAR_4,
        record,
    )
    yield "same-edge-twice", hand(first, (0, 0, 0, 3)), R.EDGE_CLOSED_TWICE, C.EB_GRAMMAR_4, record
    yield "between-one-less", hand((2, 0, 0, 1), second), R.LOOP_TOO_SHORT, C.EB_GRAMMAR_5, record


def handles_of_annulus(file: File) -> Iterator[Row]:
    """A record of another kind, side or place. Clauses: CODE-HAND-3, EB-GRAMMAR-6, EB-GRAMMAR-8."""

    def hand(closing: pencil.Closing) -> tuple[Edit, ...]:
        return payload(file, b"HAND", bits(pencil.handles((closing,), len(file.word))))

    record = "unchecked-record"
    yield "handle-for-curve", hand((0, 0, 0, 2)), R.LOOP_NOT_CLOSED, C.EB_GRAMMAR_8, record
    yield "left-for-right", hand((0, 1, 1, 2)), R.LOOP_TOO_SHORT, C.EB_GRAMMAR_7, record
    yield "between-too-many", hand((0, 1, 0, 3)), R.RECORD_OUT_OF_RANGE, C.CODE_HAND_3, record
    yield "passed-too-many", hand((1, 1, 0, 2)), R.RECORD_OUT_OF_RANGE, C.CODE_HAND_3, record


def exact_singles(file: File) -> Iterator[Row]:
    """Coordinates of 4 bytes. Clauses: GEOM-EXACT-2, GEOM-POSITION-3."""
    yield from _exact(file, "f", 4)


def exact_doubles(file: File) -> Iterator[Row]:
    """Coordinates of 8 bytes. Clauses: GEOM-EXACT-2, GEOM-POSITION-3."""
    yield from _exact(file, "d", 8)


def _exact(file: File, letter: str, width: int) -> Iterator[Row]:
    count = R.COUNT_MISMATCH, C.GEOM_EXACT_2
    size = "positions-not-counted"
    posn = file.posn
    yield "positions-empty", payload(file, b"POSN", b""), *count, size
    yield "position-missing", payload(file, b"POSN", posn[: -3 * width]), *count, size
    yield "coordinate-missing", payload(file, b"POSN", posn[:-width]), *count, size
    yield "byte-missing", payload(file, b"POSN", posn[:-1]), *count, size
    yield "byte-more", payload(file, b"POSN", posn + b"\0"), *count, size
    yield "position-more", payload(file, b"POSN", posn + posn[-3 * width :]), *count, size
    for name, value in (("infinity", "inf"), ("minus-infinity", "-inf"), ("not-a-number", "nan")):
        for at in (0, 7, 11):
            new = posn[: at * width] + struct.pack(f"<{letter}", float(value))
            edits = payload(file, b"POSN", new + posn[(at + 1) * width :])
            yield (
                f"{name}-at-{at}", edits, R.NON_FINITE_COORDINATE, C.GEOM_POSITION_3,
                "numbers-not-checked",
            )  # fmt: skip


def on_lattice(file: File) -> Iterator[Row]:
    """Numbers and bits of quantised positions. Clauses: FILE-POSN-2, GEOM-RESIDUAL-2."""
    digits = by_hand.on_tetrahedron(by_hand.CORNER_RESIDUALS)
    origin, two = (0, 0, 0), (2, 2, 2)

    def posn(
        exponent: int = -1,
        low: Sequence[int] = origin,
        extent: Sequence[int] = two,
        code: str = digits,
    ) -> tuple[Edit, ...]:
        return payload(file, b"POSN", by_hand.lattice(exponent, low, extent, code))

    lattice = R.BAD_LATTICE, C.GEOM_LATTICE_1, "lattice-not-checked"
    number = R.BAD_NUMBER, C.FILE_NUMBER_3, "number-not-canonical"
    strict = "bits-not-compared"
    limit = (1 << 53) - 1
    yield "exponent-too-high", posn(exponent=972), *lattice
    yield "exponent-too-low", posn(exponent=-1075), *lattice
    yield "exponent-greatest-there-is", posn(exponent=2047), *lattice
    yield "exponent-of-13-bits", posn(exponent=2048), *number
    for axis in range(3):
        x = "xyz"[axis]
        low = (*origin[:axis], -limit - 1, *origin[axis + 1 :])
        high = (*origin[:axis], limit - 1, *origin[axis + 1 :])
        wide = (*two[:axis], 1 << 30, *two[axis + 1 :])
        yield f"low-too-low-on-{x}", posn(low=low), *lattice
        yield f"top-too-high-on-{x}", posn(low=high), *lattice
        yield f"extent-of-31-bits-on-{x}", posn(extent=wide), *number
    for kind, code, reason, clause in (
        ("one-bit-more", digits + "0", R.TRAILING_BITS, C.ARITH_STRICT_3),
        ("one-bit-less", digits[:-1], R.TRAILING_BITS, C.ARITH_STRICT_3),
        ("half-of-the-bits", digits[:18], R.TRUNCATED_BITS, C.ARITH_STRICT_2),
        ("last-bit-turned", digits[:-1] + str(1 - int(digits[-1])), R.TRAILING_BITS,
         C.ARITH_STRICT_3),
        ("no-bits", "", R.TRUNCATED_BITS, C.ARITH_STRICT_2),
    ):  # fmt: skip
        yield f"residuals-{kind}", posn(code=code), reason, clause, strict
    beyond = R.BAD_RESIDUAL, C.GEOM_RESIDUAL_2, "residual-not-checked"
    yield "extent-never-met", posn(extent=(3, 2, 2)), *beyond
    v0, v1, v2, v3 = by_hand.CORNER_RESIDUALS
    for kind, rows in (
        ("index-below-zero", ((-1, 0, 0), v1, v2, v3)),
        ("index-over-extent", (v0, (3, 0, 0), v2, v3)),
        ("last-index-below-zero", (v0, v1, v2, (-3, -2, 2))),
        ("last-index-over-extent", (v0, v1, v2, (-2, -2, 3))),
        ("no-index-zero", ((0, 0, 2), v1, v2, (-2, -2, 0))),
        ("no-index-the-extent", (v0, v1, v2, (-2, -2, 1))),
    ):
        yield kind, posn(code=by_hand.on_tetrahedron(rows)), *beyond
    data = by_hand.lattice(-1, origin, two, digits)
    more = R.TRAILING_BYTES, C.FILE_LAYOUT_2, "bytes-left-unread"
    yield "byte-more", payload(file, b"POSN", data + b"\0"), *more
    yield (
        "fill-bit-set",
        payload(file, b"POSN", data[:-1] + bytes([data[-1] | 1])),
        (R.TRAILING_BITS),
        C.ARITH_BITS_3,
        "filling-bits-ignored",
    )
    past = R.TRUNCATED_FILE, C.FILE_LAYOUT_3, "read-past-the-end"
    for end in (0, 1, 4, 6, 7, 8, len(data) - 1):
        yield f"lattice-cut-at-{end}", payload(file, b"POSN", data[:end]), *past
