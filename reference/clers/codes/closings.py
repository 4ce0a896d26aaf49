"""Handle data as Spirale Reversi meets it: from the end, counted back from each S with a record."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtRecord
from clers.edgebreaker.stream import Kind, Record, Side, Stream

SIDES: Final[Mapping[str, tuple[Side, ...]]] = {
    "C": (),
    "L": (Side.LEFT,),
    "E": (Side.RIGHT, Side.LEFT),
    "R": (Side.RIGHT,),
    "S": (),
}
"""The sides on which a triangle can close an S. Clauses: EB-HANDLE-4, CODE-HAND-1."""


@dataclass(frozen=True, slots=True)
class Closing:
    """A record seen from the end of the word. Clause: CODE-HAND-1.

    `passed`: S without record between this S and the next with one, or the end of the word;
    `between`: edges of this side between this S and the closing edge.
    """

    passed: int
    kind: Kind
    side: Side
    between: int


def closings(stream: Stream) -> Accepted[tuple[Closing, ...]] | Rejected:
    """The handle data from the last record to the first.

    Linear. Clauses: CODE-HAND-1, CODE-HAND-2.
    """
    if not stream.records:
        return Accepted(())
    word, waiting = stream.word, list(stream.records)
    s, at = word.count("S"), _closers(word)
    edges: dict[Side, dict[int, int]] = {Side.RIGHT: {}, Side.LEFT: {}}  # `at` to its place
    found: list[Closing] = []
    passed = 0
    for symbol in reversed(word):
        if symbol == "S":
            s -= 1
            if waiting and waiting[-1].s == s:
                record = waiting.pop()
                places = edges[record.side]
                if record.at not in places:
                    return _no_closing(len(waiting), record)
                between = len(places) - 1 - places[record.at]
                found.append(Closing(passed, record.kind, record.side, between))
                passed = 0
            else:
                passed += 1
        elif symbol != "C":
            at -= 1
        for side in SIDES.get(symbol, ()):
            edges[side][at] = len(edges[side])
    return _no_closing(len(waiting) - 1, waiting[-1]) if waiting else Accepted(tuple(found))


def records(word: str, given: Sequence[Closing]) -> Accepted[tuple[Record, ...]] | Rejected:
    """The records of a word from what is seen from its end. Linear. Clause: CODE-HAND-3."""
    if not given:
        return Accepted(())
    s, at = word.count("S"), _closers(word)
    edges: dict[Side, list[int]] = {Side.RIGHT: [], Side.LEFT: []}
    found: list[Record] = []
    passed = 0
    for symbol in reversed(word):
        if symbol == "S":
            s -= 1
            if len(found) < len(given) and given[len(found)].passed == passed:
                closing = given[len(found)]
                places = edges[closing.side]
                if closing.between >= len(places):
                    return _no_record(len(given) - 1 - len(found), "its closing edge")
                closer = places[len(places) - 1 - closing.between]
                found.append(Record(closing.kind, s, closer, closing.side))
                passed = 0
            else:
                passed += 1
        elif symbol != "C":
            at -= 1
        for side in SIDES[symbol]:
            edges[side].append(at)
    if len(found) < len(given):
        return _no_record(len(given) - 1 - len(found), "its S")
    return Accepted(tuple(reversed(found)))


def _closers(word: str) -> int:
    return word.count("R") + word.count("L") + word.count("E")


def _no_closing(index: int, record: Record) -> Rejected:
    """A record that no edge after its S belongs to. Clause: CODE-HAND-2."""
    detail = f"S {record.s} is not closed on the {record.side} by closer {record.at}"
    return Rejected(Reason.NOT_REPRESENTABLE, Clause.CODE_HAND_2, AtRecord(index), detail)


def _no_record(index: int, what: str) -> Rejected:
    """A closing that goes back too far. Clause: CODE-HAND-3."""
    detail = f"{what} is further back than the word is long"
    return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.CODE_HAND_3, AtRecord(index), detail)
