"""Each clause of the grammar rejects its own fault, at its own element.

The streams are the shortest that have the fault, found by going through all short streams and then
read by hand against the clause.
"""

import pytest

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtRecord, AtSymbol, Where
from clers.edgebreaker.codec import FOLD, LINEAR
from clers.edgebreaker.decode import decode
from clers.edgebreaker.stream import Kind, Record, Side, Stream

H, B, R, L = Kind.HANDLE, Kind.BOUNDARY, Side.RIGHT, Side.LEFT

Case = tuple[str, tuple[Record, ...], int, Reason, Clause, Where]

CASES: list[Case] = [
    ("", (), 0, Reason.EMPTY_WORD, Clause.EB_GRAMMAR_1, WHOLE),
    ("CXE", (), 0, Reason.UNKNOWN_SYMBOL, Clause.EB_GRAMMAR_1, AtSymbol(1)),
    (
        "SSEEE", (Record(H, 1, 0, R), Record(H, 0, 0, R)), 0,
        Reason.RECORD_ORDER, Clause.EB_GRAMMAR_2, AtRecord(1),
    ),
    (
        "SSEEE", (Record(H, 0, 0, R), Record(H, 0, 1, R)), 0,
        Reason.RECORD_ORDER, Clause.EB_GRAMMAR_2, AtRecord(1),
    ),
    (
        "SE", (Record(H, 1, 0, R),), 0,
        Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_2, AtRecord(0),
    ),
    ("C", (), 0, Reason.UNFINISHED_WORD, Clause.EB_GRAMMAR_3, AtSymbol(0)),
    ("CRE", (), 2, Reason.TOO_FEW_COMPONENTS, Clause.EB_GRAMMAR_3, WHOLE),
    ("CRE", (), -1, Reason.TOO_FEW_COMPONENTS, Clause.EB_GRAMMAR_3, WHOLE),
    (
        "SE", (Record(H, 0, 1, R),), 0,
        Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_4, AtRecord(0),
    ),
    ("LSE", (Record(H, 0, 0, R),), 0, Reason.RECORD_SIDE, Clause.EB_GRAMMAR_4, AtRecord(0)),
    (
        "LSE", (Record(H, 0, 0, L),), 0,
        Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_4, AtRecord(0),
    ),
    ("SE", (Record(B, 0, 0, R),), 0, Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_4, AtRecord(0)),
    (
        "SSE", (Record(H, 0, 0, R), Record(H, 1, 0, R)), 0,
        Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_4, AtRecord(1),
    ),
    ("CE", (), 0, Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_5, AtSymbol(0)),
    (
        "SCLE", (Record(H, 0, 0, L),), 0,
        Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_5, AtSymbol(1),
    ),
    (
        "SEE", (Record(H, 0, 1, R),), 0,
        Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_6, AtRecord(0),
    ),
    ("SE", (Record(H, 0, 0, R),), 0, Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_6, AtRecord(0)),
    ("SE", (Record(H, 0, 0, L),), 0, Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_6, AtRecord(0)),
    # Undoing the second S leaves the left edge of the L alone in a loop, and the first S takes it.
    (
        "SSLE", (Record(H, 0, 0, L), Record(H, 1, 1, L)), 0,
        Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_6, AtRecord(0),
    ),
    ("SLE", (Record(B, 0, 1, L),), 1, Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_7, AtRecord(0)),
    # The second S cuts off the left edges of both Ls; the first, to one of them, cuts nothing.
    (
        "SSLLE", (Record(B, 0, 1, L), Record(H, 1, 2, L)), 1,
        Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_7, AtRecord(0),
    ),
    (
        "SSLE", (Record(H, 0, 0, L), Record(B, 1, 1, L)), 1,
        Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_7, AtRecord(1),
    ),
    ("LE", (), 0, Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(0)),
    ("SLE", (Record(H, 0, 1, L),), 1, Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_8, AtSymbol(0)),
    # The S cuts off the left edge of the L, and nothing closes it.
    (
        "SRRLE", (Record(H, 0, 3, L),), 1,
        Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(3),
    ),
    ("E", (), 0, Reason.DOUBLE_EDGE, Clause.EB_GRAMMAR_9, AtSymbol(0)),
    (
        "SSLLE", (Record(H, 0, 0, L), Record(H, 1, 2, L)), 0,
        Reason.REPEATED_VERTEX, Clause.EB_GRAMMAR_9, AtSymbol(1),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("word", "records", "boundary", "reason", "clause", "where"), CASES)
def test_each_fault_has_its_clause(
    word: str,
    records: tuple[Record, ...],
    boundary: int,
    reason: Reason,
    clause: Clause,
    where: Where,
) -> None:
    """EB-GRAMMAR-1 … EB-GRAMMAR-9, EB-DECODE-2."""
    stream = Stream(word, records, boundary)
    got = decode(stream)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, clause, where)
    assert got.fault is Fault.INVALID
    assert isinstance(FOLD.decode(stream), Rejected)


TWICE: list[tuple[str, tuple[Record, ...], int, Clause, Where]] = [
    ("SXE", (Record(H, 5, 0, R),), 0, Clause.EB_GRAMMAR_1, AtSymbol(1)),
    ("SSE", (Record(H, 5, 0, R), Record(H, 1, 0, R)), 0, Clause.EB_GRAMMAR_2, AtRecord(1)),
    ("SER", (Record(H, 5, 9, R),), 0, Clause.EB_GRAMMAR_2, AtRecord(0)),
    ("SER", (Record(H, 0, 9, R),), 0, Clause.EB_GRAMMAR_3, AtSymbol(2)),
    ("SLE", (Record(H, 0, 9, R),), 0, Clause.EB_GRAMMAR_4, AtRecord(0)),
    ("CE", (), 0, Clause.EB_GRAMMAR_5, AtSymbol(0)),
    ("LECE", (), 0, Clause.EB_GRAMMAR_5, AtSymbol(2)),
    ("CELE", (), 0, Clause.EB_GRAMMAR_8, AtSymbol(2)),
    ("LEE", (), 0, Clause.EB_GRAMMAR_8, AtSymbol(0)),
]
"""Streams with two faults, and the one that is to be reported."""


@pytest.mark.parametrize(("word", "records", "boundary", "clause", "where"), TWICE)
def test_the_first_of_two_faults_is_reported(
    word: str, records: tuple[Record, ...], boundary: int, clause: Clause, where: Where
) -> None:
    """EB-GRAMMAR-11, CONV-RESULT-5. The last E of LEE has a double edge, found later."""
    got = decode(Stream(word, records, boundary))
    assert isinstance(got, Rejected)
    assert (got.clause, got.where) == (clause, where)


def test_every_clause_of_the_grammar_has_a_case() -> None:
    """EB-GRAMMAR-1 … EB-GRAMMAR-9."""
    assert {case[4] for case in CASES} == {
        clause
        for clause in Clause
        if clause.startswith("EB-GRAMMAR") and clause[-2:] not in ("10", "11")
    }


def test_a_word_longer_than_the_limit_is_refused_before_it_is_read() -> None:
    """EB-DECODE-2."""
    got = decode(Stream("CCRCRRCRRE" * 10), Limits(faces=99, vertices=99))
    assert isinstance(got, Rejected)
    assert (got.reason, got.fault) == (Reason.TOO_MANY_FACES, Fault.LIMIT)


@pytest.mark.parametrize("word", ["RRRRE", "CCCCE", "LLLLE", "CRCRRE"])
def test_a_word_that_an_unchecked_zip_turns_in_for_ever_is_refused(word: str) -> None:
    """EB-DECODE-2: without the grammar a zip goes round a loop that never closes."""
    for codec in LINEAR:
        assert isinstance(codec.decode(Stream(word)), Rejected)


def test_no_other_handle_data_fit_the_word_of_the_torus() -> None:
    """EB-HANDLE-1: of all pairs of handle records for its two S only the encoder's own."""
    word = "CCCCRCSCRSSRLSEEE"
    own = Stream(word, (Record(H, 0, 6, R), Record(H, 1, 5, R)))
    closers = sum(x in "RLE" for x in word)
    accepted = [
        stream
        for i in range(closers)
        for j in range(closers)
        for side_i in Side
        for side_j in Side
        if isinstance(
            decode(stream := Stream(word, (Record(H, 0, i, side_i), Record(H, 1, j, side_j)))),
            Accepted,
        )
    ]
    assert accepted == [own]
