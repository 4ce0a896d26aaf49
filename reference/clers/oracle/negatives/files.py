"""Files that say one thing wrong, section by section in the order of FILE-PARSE-1."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from clers.conformance.cases.case import Edit
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.oracle.negatives import by_hand
from clers.oracle.negatives.by_hand import CODES, File, section
from clers.oracle.negatives.draft import Draft, bad
from clers.oracle.negatives.in_files import (
    cut,
    exchanged,
    field,
    flipped,
    parent,
    payload,
    places,
)

C = Clause
R = Reason

FILES: Final = (
    ("file-ball", by_hand.BALL),
    ("file-cube", by_hand.CUBE),
    ("file-triangle", by_hand.TRIANGLE),
    ("file-annulus", by_hand.ANNULUS),
    ("file-torus", by_hand.TORUS),
    ("file-two-balls", by_hand.TWO_BALLS),
    ("file-disk-and-ball", by_hand.DISK_AND_BALL),
    ("file-single-precision", by_hand.F32),
    ("file-double-precision", by_hand.F64),
    ("file-lattice", by_hand.LATTICE),
)


def good_files() -> Iterator[Draft]:
    """Each file in each code. Clause: ORCL-GRAMMAR-2."""
    for name, file in FILES:
        for code in CODES:
            yield parent(f"{name}-{code}", replace(file, code=code), ("reader-knows-one-writer",))


def drafts() -> Iterator[Draft]:
    """Good files, and all that is wrong with them. Clauses: ORCL-OP-7, ORCL-GRAMMAR-2."""
    yield from good_files()
    ball = parent("file-ball-plain", by_hand.BALL)
    torus = parent("file-torus-plain", by_hand.TORUS)
    corner = parent("file-single-precision-plain", by_hand.F32)
    yield from prologue(ball, by_hand.BALL)
    for draft, file in ((ball, by_hand.BALL), (torus, by_hand.TORUS), (corner, by_hand.F32)):
        yield from broken_off(draft, file)
        yield from damaged(draft, file)
    yield from arranged(ball, by_hand.BALL)
    yield from arranged_more(torus, by_hand.TORUS, corner, by_hand.F32)
    yield from headed(ball, by_hand.BALL)
    yield from miscounted(ball, by_hand.BALL, torus, by_hand.TORUS)


def prologue(ball: Draft, file: File) -> Iterator[Draft]:
    """The first nine bytes. Clauses: FILE-MAGIC-1, FILE-MAGIC-2, FILE-LAYOUT-3."""
    rows: tuple[tuple[str, Edit, str], ...] = (
        ("magic-without-its-high-bit", flipped(file, 0, 0x80), "magic-not-compared"),
        ("magic-in-small-letters", exchanged(1, b"CLERS", b"clers"), "magic-not-compared"),
        ("magic-of-png", exchanged(1, b"CLERS", b"PNG\r\n"), "magic-not-compared"),
        ("magic-last-letter", flipped(file, 5), "magic-not-compared"),
        ("carriage-return-lost", exchanged(6, b"\r\n", b"\n"), "text-mode"),
        ("line-feed-lost", exchanged(6, b"\r\n", b"\r"), "text-mode"),
        ("line-end-doubled", exchanged(6, b"\r\n", b"\r\r\n"), "text-mode"),
        ("byte-order-mark", exchanged(0, b"", b"\xef\xbb\xbf"), "text-mode"),
    )
    for kind, edit, flag in rows:
        yield bad(ball, kind, (edit,), R.BAD_MAGIC, C.FILE_MAGIC_1, flags=(flag,))
    for version in (0, 2, 0x31, 0x81, 0xFF):
        edit = exchanged(8, b"\1", bytes([version]))
        yield bad(
            ball, f"version-{version}", (edit,), R.UNKNOWN_VERSION, C.FILE_MAGIC_2,
            flags=("version-not-compared",),
        )  # fmt: skip


def broken_off(draft: Draft, file: File) -> Iterator[Draft]:
    """The file up to each byte where something begins or is under way. FILE-DAMAGE-2."""
    ends = {0, 1, 8, 9}
    for here in places(file):
        marks = (here.header, here.header + 4, here.start - 4, here.start, here.stop, here.end)
        ends.update(at + step for at in marks for step in (-1, 0, 1))
    boundaries = {9, *(here.end for here in places(file))}
    for end in sorted(end for end in ends if end < len(file.data)):
        whole = end in boundaries
        yield bad(
            draft, f"cut-at-{end}", (cut(file, end),),
            R.BAD_SECTION if whole else R.TRUNCATED_FILE,
            C.FILE_SECTION_5 if whole else C.FILE_LAYOUT_3,
            flags=("read-past-the-end",),
        )  # fmt: skip
    over: tuple[tuple[str, bytes, R, C], ...] = (
        ("zero-byte-after", b"\0", R.TRUNCATED_FILE, C.FILE_LAYOUT_3),
        ("line-feed-after", b"\n", R.TRUNCATED_FILE, C.FILE_LAYOUT_3),
        ("zeros-after", bytes(16), R.BAD_CHECKSUM, C.FILE_SECTION_2),
        ("empty-unknown-section-after", section(b"TEXT", b""), R.UNKNOWN_SECTION, C.FILE_SECTION_3),
    )
    for kind, data, reason, clause in over:
        edit = exchanged(len(file.data), b"", data)
        yield bad(draft, kind, (edit,), reason, clause, flags=("bytes-left-unread",))


def damaged(draft: Draft, file: File) -> Iterator[Draft]:
    """One bit flipped in each part of each section, not sealed again. FILE-DAMAGE-1."""
    for here in places(file):
        tag = here.tag.decode().lower()
        for part, at in (
            ("tag", here.header),
            ("length", here.header + 4),
            ("high-length", here.header + 7),
            ("header-seal", here.header + 8),
            ("payload", here.start),
            ("last-of-payload", here.stop - 1),
            ("payload-seal", here.stop),
            ("last-of-seal", here.end - 1),
        ):
            yield bad(
                draft, f"{tag}-{part}-damaged", (flipped(file, at),),
                R.BAD_CHECKSUM, C.FILE_SECTION_2, flags=("seal-not-checked",),
            )  # fmt: skip


def arranged(ball: Draft, file: File) -> Iterator[Draft]:
    """Sections unknown, missing, twice or in another order; all sealed. FILE-SECTION-3 … -5."""
    head, word = places(file)
    data = file.data
    whole = {here.tag: data[here.header : here.end] for here in (head, word)}
    rows: tuple[tuple[str, Edit, R, C], ...] = (
        ("unknown-tag", exchanged(word.header, b"WORD", b"TEXT"),
         R.UNKNOWN_SECTION, C.FILE_SECTION_3),
        ("tag-in-small-letters", exchanged(head.header, b"HEAD", b"head"),
         R.UNKNOWN_SECTION, C.FILE_SECTION_3),
        ("tag-of-zeros", exchanged(word.header, b"WORD", bytes(4)),
         R.UNKNOWN_SECTION, C.FILE_SECTION_3),
        ("unknown-section-first", exchanged(9, b"", section(b"NOTE", b"hello")),
         R.UNKNOWN_SECTION, C.FILE_SECTION_3),
        ("unknown-section-last", exchanged(len(data), b"", section(b"NOTE", b"hello")),
         R.UNKNOWN_SECTION, C.FILE_SECTION_3),
        ("word-before-head", exchanged(9, data[9:], whole[b"WORD"] + whole[b"HEAD"]),
         R.BAD_SECTION, C.FILE_SECTION_4),
        ("head-twice", exchanged(head.end, b"", whole[b"HEAD"]),
         R.BAD_SECTION, C.FILE_SECTION_4),
        ("word-twice", exchanged(len(data), b"", whole[b"WORD"]),
         R.BAD_SECTION, C.FILE_SECTION_4),
        ("no-head", exchanged(9, whole[b"HEAD"], b""), R.BAD_SECTION, C.FILE_SECTION_5),
        ("no-word", exchanged(word.header, whole[b"WORD"], b""), R.BAD_SECTION, C.FILE_SECTION_5),
        ("handle-data-not-asked-for", exchanged(head.end, b"", section(b"HAND", b"\x02\x40")),
         R.BAD_SECTION, C.FILE_SECTION_5),
        ("positions-not-asked-for", exchanged(len(data), b"", section(b"POSN", bytes(48))),
         R.BAD_SECTION, C.FILE_SECTION_5),
        ("empty-positions-not-asked-for", exchanged(len(data), b"", section(b"POSN", b"")),
         R.BAD_SECTION, C.FILE_SECTION_5),
    )  # fmt: skip
    for kind, edit, reason, clause in rows:
        yield bad(
            ball, kind, (edit,), reason, clause, sealed=True, flags=("sections-as-they-come",)
        )


def arranged_more(torus: Draft, hand: File, corner: Draft, posn: File) -> Iterator[Draft]:
    """The same with handle data and positions. Clauses: FILE-SECTION-4, FILE-SECTION-5."""
    _, handles, word = places(hand)
    data = hand.data
    swapped = data[word.header :] + data[handles.header : handles.end]
    _, letters, last = places(posn)
    rows: tuple[tuple[Draft, str, Edit, C], ...] = (
        (torus, "word-before-handle-data",
         exchanged(handles.header, data[handles.header :], swapped), C.FILE_SECTION_4),
        (torus, "no-handle-data",
         exchanged(handles.header, data[handles.header : handles.end], b""), C.FILE_SECTION_5),
        (corner, "no-positions", cut(posn, last.header), C.FILE_SECTION_5),
        (corner, "positions-before-word",
         exchanged(letters.header, posn.data[letters.header :],
                   posn.data[last.header :] + posn.data[letters.header : letters.end]),
         C.FILE_SECTION_4),
        (corner, "positions-twice",
         exchanged(len(posn.data), b"", posn.data[last.header :]), C.FILE_SECTION_4),
    )  # fmt: skip
    for draft, kind, edit, clause in rows:
        yield bad(
            draft, kind, (edit,), R.BAD_SECTION, clause, sealed=True,
            flags=("sections-as-they-come",),
        )  # fmt: skip
    for kind, edits in (
        ("head-says-no-positions", field(posn, 1, b"\1")),
        ("head-says-one-record", field(posn, 6, b"\1")),
    ):
        yield bad(
            corner, kind, edits, R.BAD_SECTION, C.FILE_SECTION_5, sealed=True,
            flags=("sections-as-they-come",),
        )  # fmt: skip


def headed(ball: Draft, file: File) -> Iterator[Draft]:
    """HEAD as numbers. Clauses: FILE-NUMBER-3, FILE-NUMBER-5, FILE-LAYOUT-2, FILE-LAYOUT-3."""
    head = file.parts[0][1]
    codes = ("unknown-code-taken", R.UNKNOWN_CODE, C.FILE_NUMBER_5)
    numbers = ("number-not-canonical", R.BAD_NUMBER, C.FILE_NUMBER_3)
    left = ("bytes-left-unread", R.TRAILING_BYTES, C.FILE_LAYOUT_2)
    short = ("read-past-the-end", R.TRUNCATED_FILE, C.FILE_LAYOUT_3)
    few = ("read-past-the-end", R.IMPOSSIBLE_COUNT, C.FILE_COUNT_1)
    rows: tuple[tuple[str, tuple[Edit, ...], tuple[str, R, C]], ...] = (
        *((f"code-{n}", field(file, 0, bytes([n])), codes) for n in (0, 13, 14, 128, 255)),
        *((f"coding-{n}", field(file, 1, bytes([n])), codes) for n in (0, 5, 129, 255)),
        ("faces-in-two-bytes", field(file, 2, b"\x84\x00"), numbers),
        ("faces-in-five-bytes", field(file, 2, b"\x84\x80\x80\x80\x00"), numbers),
        ("records-zero-in-two-bytes", field(file, 6, b"\x80\x00"), numbers),
        ("vertices-over-32-bits", field(file, 3, b"\x84\x80\x80\x80\x10"), numbers),
        ("faces-never-end", field(file, 2, b"\x84\x80\x80\x80\x80\x80\x00"), numbers),
        ("head-one-byte-more", payload(file, b"HEAD", head + b"\0"), left),
        ("head-much-more", payload(file, b"HEAD", head + bytes(200)), left),
        ("head-last-number-open", payload(file, b"HEAD", head[:-1] + b"\x80"), short),
        ("head-one-byte-less", payload(file, b"HEAD", head[:-1]), few),
        ("head-two-bytes", payload(file, b"HEAD", head[:2]), few),
        ("head-one-byte", payload(file, b"HEAD", head[:1]), short),
        ("head-empty", payload(file, b"HEAD", b""), short),
    )
    for kind, edits, (flag, reason, clause) in rows:
        yield bad(ball, kind, edits, reason, clause, sealed=True, flags=(flag,))


def miscounted(ball: Draft, file: File, torus: Draft, other: File) -> Iterator[Draft]:
    """HEAD tells other counts than the word has. Clauses: FILE-COUNT-1 … FILE-COUNT-3."""
    wrong = (R.COUNT_MISMATCH, C.FILE_COUNT_3)
    rows: tuple[tuple[Draft, File, str, int, int, R, C], ...] = (
        (ball, file, "one-face-more", 2, 5, *wrong),
        (ball, file, "one-face-less", 2, 3, *wrong),
        (ball, file, "no-faces", 2, 0, *wrong),
        (ball, file, "one-vertex-more", 3, 5, *wrong),
        (ball, file, "one-vertex-less", 3, 3, *wrong),
        (ball, file, "faces-and-symbols-alike", 2, 127, *wrong),
        (ball, file, "one-symbol-less", 5, 2, R.TRAILING_BITS, C.CODE_PLAIN_2),
        (ball, file, "one-symbol-more", 5, 4, R.TRUNCATED_BITS, C.CODE_PLAIN_2),
        (ball, file, "no-symbols", 5, 0, R.EMPTY_WORD, C.CODE_IMPLIED_2),
        (ball, file, "as-many-symbols-as-bits-allow", 5, 7, R.TRUNCATED_BITS, C.CODE_PLAIN_2),
        (ball, file, "one-symbol-more-than-bits-allow", 5, 8, R.IMPOSSIBLE_COUNT, C.FILE_COUNT_2),
        (ball, file, "a-component-with-boundary", 4, 1, R.TRUNCATED_BITS, C.CODE_PLAIN_2),
        (torus, other, "more-records-than-symbols", 6, 18, R.IMPOSSIBLE_COUNT, C.FILE_COUNT_1),
        (torus, other, "one-face-more", 2, 19, *wrong),
        (torus, other, "one-vertex-more", 3, 10, *wrong),
        (torus, other, "one-record-more", 6, 3, R.TRUNCATED_BITS, C.ARITH_STRICT_2),
        (torus, other, "one-record-less", 6, 1, R.TRAILING_BITS, C.ARITH_STRICT_3),
    )
    for draft, here, kind, at, value, reason, clause in rows:
        requires = ("boundaries.one",) if at == 4 else ()
        yield bad(
            draft, f"{kind}-in-head", field(here, at, bytes([value])), reason, clause,
            sealed=True, flags=("count-trusted",), requires=requires,
        )  # fmt: skip
