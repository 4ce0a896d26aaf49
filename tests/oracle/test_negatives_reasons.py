"""The reasons of all cases, beside the texts of the clauses that they name."""

from pathlib import Path
from typing import Final

from msgspec import UnsetType
from negative_cases import rejected

from clers.specification.clause_text import ClauseText
from clers.specification.reasons import said
from clers.specification.repository import find_root, read_specification

SHEETS: Final = ("OPER-SHEET-5", "OPER-SHEET-6", "OPER-SURFACE-10")
MOVES: Final = ("OPER-MOVE-3",)
WORDS: Final = ("CODE-NAME-6",)

SPEAKS_FOR: Final = {
    "OPER-EULER": SHEETS,
    "OPER-SURFACE": SHEETS,
    "OPER-COLLAPSE": MOVES,
    "OPER-STELLAR": MOVES,
    "OPER-BISTELLAR": MOVES,
    "OPER-CONTRACT": MOVES,
    "CODE-PLAIN": WORDS,
    "CODE-GOLDEN": WORDS,
    "CODE-HUFFMAN": WORDS,
    "CODE-ADAPTIVE": WORDS,
    "CODE-CONTEXT": WORDS,
    "CODE-BEST": WORDS,
}
"""Clauses that say what clauses of a topic are named for: the exceptions of CONV-RESULT-6."""


def texts() -> dict[str, str]:
    """The text of each clause."""
    root = find_root(Path(__file__))
    assert root is not None
    stated = read_specification(root)
    return {item.clause: item.text for item in stated if isinstance(item, ClauseText)}


def test_each_reason_is_in_the_clause_that_is_named() -> None:
    """Clause: CONV-RESULT-6."""
    stated = texts()
    pairs = {
        (case.reject.reason, case.reject.clause)
        for case in rejected()
        if not isinstance(case.reject, UnsetType)
    }
    assert len(pairs) > 100
    elsewhere = set()
    for reason, clause in pairs:
        if not said(stated[clause], reason):
            topic = clause.rpartition("-")[0]
            assert any(said(stated[other], reason) for other in SPEAKS_FOR[topic])
            elsewhere.add(topic)
    assert elsewhere == set(SPEAKS_FOR)


def test_the_exceptions_are_those_that_the_clause_names() -> None:
    """Clause: CONV-RESULT-6."""
    clause = texts()["CONV-RESULT-6"]
    for others in SPEAKS_FOR.values():
        assert all(other in clause for other in others)
