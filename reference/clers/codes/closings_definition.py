"""Handle data seen from the end of a word, as the page says it: walking back, edges remembered."""

from collections.abc import Mapping, Sequence
from typing import Final

from clers.codes.closings import Closing, no_closing, no_record
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.stream import Record, Side, Stream

SIDES: Final[Mapping[str, tuple[Side, ...]]] = {
    "C": (),
    "L": (Side.LEFT,),
    "E": (Side.RIGHT, Side.LEFT),
    "R": (Side.RIGHT,),
    "S": (),
}
"""The sides on which a triangle can close an S. Clauses: EB-HANDLE-4, CODE-HAND-1."""

CLOSERS: Final = "RLE"
"""The symbols that records count. Clause: EB-HANDLE-3."""


def closings_by_definition(stream: Stream) -> Accepted[tuple[Closing, ...]] | Rejected:
    """The handle data from the last record to the first.

    Clauses: CODE-HAND-1, CODE-HAND-2.
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
                    return no_closing(len(waiting), record)
                between = len(places) - 1 - places[record.at]
                found.append(Closing(passed, record.kind, record.side, between))
                passed = 0
            else:
                passed += 1
        elif symbol in CLOSERS:
            at -= 1
        for side in SIDES.get(symbol, ()):
            edges[side][at] = len(edges[side])
    return no_closing(len(waiting) - 1, waiting[-1]) if waiting else Accepted(tuple(found))


def records_by_definition(
    word: str, given: Sequence[Closing]
) -> Accepted[tuple[Record, ...]] | Rejected:
    """The records of a word from what is seen from its end. Clause: CODE-HAND-3."""
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
                if not 0 <= closing.between < len(places):
                    return no_record(len(given) - 1 - len(found), "its closing edge")
                closer = places[len(places) - 1 - closing.between]
                found.append(Record(closing.kind, s, closer, closing.side))
                passed = 0
            else:
                passed += 1
        elif symbol in CLOSERS:
            at -= 1
        for side in SIDES.get(symbol, ()):
            edges[side].append(at)
    if len(found) < len(given):
        return no_record(len(given) - 1 - len(found), "its S")
    return Accepted(tuple(reversed(found)))


def _closers(word: str) -> int:
    return sum(symbol in CLOSERS for symbol in word)
