"""Each way in which a file is refused, written by hand."""

import pytest
from by_hand import HEAD, MAGIC, TETRAHEDRON, VERSION, WORD, file, section

from clers.container.file import decode
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Rejected
from clers.conventions.where import WHOLE, AtByte, AtSymbol

MALFORMED = {
    "empty": (b"", Reason.TRUNCATED_FILE, Clause.FILE_LAYOUT_3, AtByte(0)),
    "bad-magic": (b"\x88" + TETRAHEDRON[1:], Reason.BAD_MAGIC, Clause.FILE_MAGIC_1, AtByte(0)),
    "magic-alone": (MAGIC, Reason.TRUNCATED_FILE, Clause.FILE_LAYOUT_3, AtByte(8)),
    "seven-other-bytes": (bytes(7), Reason.TRUNCATED_FILE, Clause.FILE_LAYOUT_3, AtByte(0)),
    "eight-other-bytes": (bytes(8), Reason.BAD_MAGIC, Clause.FILE_MAGIC_1, AtByte(0)),
    "no-section": (MAGIC + VERSION, Reason.BAD_SECTION, Clause.FILE_SECTION_5, AtByte(9)),
    "header-seal": (
        TETRAHEDRON[:17] + b"\0" + TETRAHEDRON[18:],
        Reason.BAD_CHECKSUM,
        Clause.FILE_SECTION_2,
        AtByte(17),
    ),
    "payload-seal": (
        TETRAHEDRON[:-1] + b"\0",
        Reason.BAD_CHECKSUM,
        Clause.FILE_SECTION_2,
        AtByte(46, "WORD"),
    ),
    "half-a-header": (
        TETRAHEDRON + section("POSN", b"")[:10],
        Reason.TRUNCATED_FILE,
        Clause.FILE_LAYOUT_3,
        AtByte(58),
    ),
    "half-a-payload": (
        TETRAHEDRON[:45],
        Reason.TRUNCATED_FILE,
        Clause.FILE_LAYOUT_3,
        AtByte(44, "WORD"),
    ),
    "section-twice": (
        file(("HEAD", HEAD), ("HEAD", HEAD), ("WORD", WORD)),
        Reason.BAD_SECTION,
        Clause.FILE_SECTION_4,
        AtByte(32),
    ),
    "section-late": (
        file(("WORD", WORD), ("HEAD", HEAD)),
        Reason.BAD_SECTION,
        Clause.FILE_SECTION_4,
        AtByte(27),
    ),
    "no-head": (file(("WORD", WORD)), Reason.BAD_SECTION, Clause.FILE_SECTION_5, AtByte(9)),
    "number-without-end": (
        file(("HEAD", "01 01 04 04 00 80 80 80 80 80"), ("WORD", WORD)),
        Reason.BAD_NUMBER,
        Clause.FILE_NUMBER_3,
        AtByte(26, "HEAD"),
    ),
    "no-word": (file(("HEAD", HEAD)), Reason.BAD_SECTION, Clause.FILE_SECTION_5, AtByte(32)),
    "hand-not-asked-for": (
        file(("HEAD", HEAD), ("HAND", ""), ("WORD", WORD)),
        Reason.BAD_SECTION,
        Clause.FILE_SECTION_5,
        AtByte(66),
    ),
    "head-too-long": (
        file(("HEAD", HEAD + "00"), ("WORD", WORD)),
        Reason.TRAILING_BYTES,
        Clause.FILE_LAYOUT_2,
        AtByte(28, "HEAD"),
    ),
    "head-too-short": (
        file(("HEAD", HEAD[:-3]), ("WORD", WORD)),
        Reason.IMPOSSIBLE_COUNT,
        Clause.FILE_COUNT_1,
        AtByte(23, "HEAD"),
    ),
    "number-cut": (
        file(("HEAD", "01 01 04 04 00 03 80"), ("WORD", WORD)),
        Reason.TRUNCATED_FILE,
        Clause.FILE_LAYOUT_3,
        AtByte(28, "HEAD"),
    ),
    "number-not-shortest": (
        file(("HEAD", "01 01 84 00 04 00 03 00"), ("WORD", WORD)),
        Reason.BAD_NUMBER,
        Clause.FILE_NUMBER_3,
        AtByte(23, "HEAD"),
    ),
    "number-too-large": (
        file(("HEAD", "01 01 04 80 80 80 80 10 00 03 00"), ("WORD", WORD)),
        Reason.BAD_NUMBER,
        Clause.FILE_NUMBER_3,
        AtByte(24, "HEAD"),
    ),
    "more-symbols-than-bits": (
        file(("HEAD", "01 01 04 04 00 08 00"), ("WORD", WORD)),
        Reason.IMPOSSIBLE_COUNT,
        Clause.FILE_COUNT_2,
        AtByte(44, "WORD"),
    ),
    "more-records-than-symbols": (
        file(("HEAD", "01 01 04 04 00 03 04"), ("HAND", "00"), ("WORD", WORD)),
        Reason.IMPOSSIBLE_COUNT,
        Clause.FILE_COUNT_1,
        AtByte(44, "HAND"),
    ),
    "records-without-bits": (
        file(("HEAD", "01 01 04 04 00 03 03"), ("HAND", "00"), ("WORD", WORD)),
        Reason.TRUNCATED_BITS,
        Clause.ARITH_STRICT_2,
        AtSymbol(0),
    ),
    "bits-of-more-records": (
        file(("HEAD", "01 01 04 04 00 03 01"), ("HAND", "07 04"), ("WORD", WORD)),
        Reason.TRAILING_BITS,
        Clause.ARITH_STRICT_3,
        WHOLE,
    ),
    "bits-not-filled-with-zeros": (
        file(("HEAD", HEAD), ("WORD", "06 bd")),
        Reason.TRAILING_BITS,
        Clause.ARITH_BITS_3,
        AtByte(44, "WORD"),
    ),
    "bits-missing": (
        file(("HEAD", HEAD), ("WORD", "09 bc")),
        Reason.TRUNCATED_FILE,
        Clause.FILE_LAYOUT_3,
        AtByte(45, "WORD"),
    ),
    "bytes-after-the-bits": (
        file(("HEAD", HEAD), ("WORD", WORD + "00")),
        Reason.TRAILING_BYTES,
        Clause.FILE_LAYOUT_2,
        AtByte(46, "WORD"),
    ),
}


@pytest.mark.parametrize("name", MALFORMED)
def test_malformed(name: str) -> None:
    """The reason, clause and byte of each; all of class `malformed`.

    Clauses: FILE-PARSE-1, FILE-SECTION-4, FILE-SECTION-5, FILE-COUNT-1, FILE-COUNT-2,
    FILE-HAND-1, FILE-HAND-2, FILE-BITS-1, FILE-NUMBER-1.
    """
    data, reason, clause, where = MALFORMED[name]
    found = decode(data)
    assert isinstance(found, Rejected)
    assert (found.reason, found.clause, found.where) == (reason, clause, where)
    assert found.fault is Fault.MALFORMED


UNSUPPORTED = {
    "version": (
        MAGIC + b"\x02" + TETRAHEDRON[9:],
        Reason.UNKNOWN_VERSION,
        Clause.FILE_MAGIC_2,
        AtByte(8),
    ),
    "section": (
        TETRAHEDRON + section("TEXT", b"hello"),
        Reason.UNKNOWN_SECTION,
        Clause.FILE_SECTION_3,
        AtByte(50),
    ),
    "code": (
        file(("HEAD", "ff 01 04 04 00 03 00"), ("WORD", WORD)),
        Reason.UNKNOWN_CODE,
        Clause.FILE_NUMBER_5,
        AtByte(21, "HEAD"),
    ),
    "code-0": (
        file(("HEAD", "00 01 04 04 00 03 00"), ("WORD", WORD)),
        Reason.UNKNOWN_CODE,
        Clause.FILE_NUMBER_5,
        AtByte(21, "HEAD"),
    ),
    "position-coding": (
        file(("HEAD", "01 05 04 04 00 03 00"), ("WORD", WORD)),
        Reason.UNKNOWN_CODE,
        Clause.FILE_NUMBER_5,
        AtByte(22, "HEAD"),
    ),
}


@pytest.mark.parametrize("name", UNSUPPORTED)
def test_unsupported(name: str) -> None:
    """Clauses: FILE-MAGIC-2, FILE-SECTION-3, FILE-NUMBER-5."""
    data, reason, clause, where = UNSUPPORTED[name]
    found = decode(data)
    assert isinstance(found, Rejected)
    assert (found.reason, found.clause, found.where) == (reason, clause, where)
    assert found.fault is Fault.UNSUPPORTED


INVALID = {
    "faces": (file(("HEAD", "01 01 05 04 00 03 00"), ("WORD", WORD)), Clause.FILE_COUNT_3),
    "vertices": (file(("HEAD", "01 01 04 05 00 03 00"), ("WORD", WORD)), Clause.FILE_COUNT_3),
    "positions": (
        file(("HEAD", "01 02 04 04 00 03 00"), ("WORD", WORD), ("POSN", "00" * 36)),
        Clause.GEOM_EXACT_2,
    ),
    "not-finite": (
        file(("HEAD", "01 02 04 04 00 03 00"), ("WORD", WORD), ("POSN", "00" * 44 + "0000807f")),
        Clause.GEOM_POSITION_3,
    ),
    "exponent": (
        file(
            ("HEAD", "01 04 04 04 00 03 00"),
            ("WORD", WORD),
            ("POSN", "98 0f 00 00 00 00 00 00 02 40"),
        ),
        Clause.GEOM_LATTICE_1,
    ),
    "record-without-an-s": (
        # One closing of all zeros for three symbols: 1/2 four times, so 0000 and 01.
        file(("HEAD", "01 01 04 04 00 03 01"), ("HAND", "06 04"), ("WORD", WORD)),
        Clause.CODE_HAND_3,
    ),
    "unfinished-word": (
        file(("HEAD", "01 01 02 04 01 02 00"), ("WORD", "06 b4")),
        Clause.EB_GRAMMAR_3,
    ),
}


@pytest.mark.parametrize("name", INVALID)
def test_invalid(name: str) -> None:
    """Clauses: FILE-COUNT-3, FILE-POSN-1, FILE-POSN-2, GEOM-POSITION-3."""
    data, clause = INVALID[name]
    found = decode(data)
    assert isinstance(found, Rejected)
    assert found.clause is clause
    assert found.fault is Fault.INVALID


TWICE_WRONG = {
    "version-then-seal": (MAGIC + b"\x02" + TETRAHEDRON[9:-1] + b"\0", Clause.FILE_MAGIC_2),
    "tag-then-seal": (
        TETRAHEDRON + section("TEXT", b"hello")[:-1] + b"\0",
        Clause.FILE_SECTION_3,
    ),
    "order-then-seal": (
        TETRAHEDRON + section("HEAD", b"hello")[:-1] + b"\0",
        Clause.FILE_SECTION_4,
    ),
    "seal-then-head": (
        file(("HEAD", "ff"), ("WORD", WORD))[:-1] + b"\0",
        Clause.FILE_SECTION_2,
    ),
    "head-then-presence": (file(("HEAD", "ff")), Clause.FILE_NUMBER_5),
    "limit-then-presence": (file(("HEAD", "01 01 81 80 80 20 04 00 03 00")), Clause.FILE_LIMIT_2),
    "presence-then-word": (
        file(("HEAD", "01 01 04 04 00 03 01"), ("WORD", "06 bd")),
        Clause.FILE_SECTION_5,
    ),
    "handles-then-word": (
        file(("HEAD", "01 01 04 04 00 03 01"), ("HAND", "01"), ("WORD", "06 bd")),
        Clause.FILE_LAYOUT_3,
    ),
    "word-then-symbols": (
        file(("HEAD", "01 01 04 04 00 08 09"), ("HAND", "00"), ("WORD", "06 bd")),
        Clause.ARITH_BITS_3,
    ),
    "symbols-then-records": (
        file(("HEAD", "01 01 04 04 00 08 09"), ("HAND", "00"), ("WORD", WORD)),
        Clause.FILE_COUNT_2,
    ),
    "records-then-handle-data": (
        file(("HEAD", "01 01 04 04 00 03 04"), ("HAND", "00"), ("WORD", WORD)),
        Clause.FILE_COUNT_1,
    ),
    "handle-data-then-code": (
        file(("HEAD", "01 01 04 04 00 03 01"), ("HAND", "00"), ("WORD", "05 b8")),
        Clause.ARITH_STRICT_2,
    ),
    "code-then-records": (
        file(("HEAD", "01 01 04 04 00 03 01"), ("HAND", "06 04"), ("WORD", "05 b8")),
        Clause.CODE_PLAIN_2,
    ),
    "records-then-positions": (
        file(("HEAD", "01 02 04 04 00 03 01"), ("HAND", "06 04"), ("WORD", WORD), ("POSN", "")),
        Clause.CODE_HAND_3,
    ),
    "word-then-positions": (
        file(("HEAD", "01 02 04 04 00 03 00"), ("WORD", "06 bd"), ("POSN", "")),
        Clause.ARITH_BITS_3,
    ),
    "positions-then-stream": (
        file(("HEAD", "01 02 02 04 01 02 00"), ("WORD", "06 b4"), ("POSN", "")),
        Clause.GEOM_EXACT_2,
    ),
    "stream-then-counts": (
        file(("HEAD", "01 01 09 09 01 02 00"), ("WORD", "06 b4")),
        Clause.EB_GRAMMAR_3,
    ),
    "counts-then-lattice": (
        file(
            ("HEAD", "01 04 04 05 00 03 00"),
            ("WORD", WORD),
            ("POSN", "98 0f 00 00 00 00 00 00 02 40"),
        ),
        Clause.FILE_COUNT_3,
    ),
    "exponent-then-bits": (
        file(
            ("HEAD", "01 04 04 04 00 03 00"),
            ("WORD", WORD),
            ("POSN", "98 0f 00 00 00 00 00 00 09 40 00"),
        ),
        Clause.GEOM_LATTICE_1,
    ),
    "bits-then-indices": (
        file(
            ("HEAD", "01 04 04 04 00 03 00"),
            ("WORD", WORD),
            ("POSN", "00 00 00 00 01 00 00 02 40"),
        ),
        Clause.ARITH_STRICT_2,
    ),
}


@pytest.mark.parametrize("name", TWICE_WRONG)
def test_the_first_fault_is_reported(name: str) -> None:
    """Clauses: FILE-PARSE-1, CONV-RESULT-5."""
    data, clause = TWICE_WRONG[name]
    found = decode(data)
    assert isinstance(found, Rejected)
    assert found.clause is clause


@pytest.mark.parametrize("place", range(len(TETRAHEDRON)))
def test_every_change_of_one_byte_is_seen(place: int) -> None:
    """All 255 of them. Clause: FILE-DAMAGE-1."""
    faults = set()
    for change in range(1, 256):
        data = bytearray(TETRAHEDRON)
        data[place] ^= change
        found = decode(bytes(data))
        assert isinstance(found, Rejected)
        faults.add(found.fault)
    assert faults == {Fault.UNSUPPORTED if place == 8 else Fault.MALFORMED}


def test_every_beginning_of_a_file_is_refused() -> None:
    """Clause: FILE-DAMAGE-2."""
    for size in range(len(TETRAHEDRON)):
        found = decode(TETRAHEDRON[:size])
        assert isinstance(found, Rejected)
        assert found.fault is Fault.MALFORMED
