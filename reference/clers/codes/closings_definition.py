"""Handle data seen from the end of a word, as the page says it: walking back, edges remembered."""

from collections.abc import Iterator, Mapping, Sequence
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


def _splits_from_the_end(word: str) -> Iterator[tuple[int, Mapping[Side, Sequence[int]]]]:
    """Each S by its number, and the closers whose edges of a side come after it, the last first."""
    s, at = word.count("S"), sum(symbol in CLOSERS for symbol in word)
    edges: dict[Side, list[int]] = {Side.RIGHT: [], Side.LEFT: []}
    for symbol in reversed(word):
        if symbol == "S":
            s -= 1
            yield s, edges
        elif symbol in CLOSERS:
            at -= 1
        for side in SIDES.get(symbol, ()):
            edges[side].append(at)


def closings_by_definition(stream: Stream) -> Accepted[tuple[Closing, ...]] | Rejected:
    """The handle data from the last record to the first.

    Quadratic. Clauses: CODE-HAND-1, CODE-HAND-2.
    """
    waiting = list(stream.records)
    found: list[Closing] = []
    passed = 0
    for s, edges in _splits_from_the_end(stream.word):
        if not waiting or waiting[-1].s != s:
            passed += 1
            continue
        record = waiting.pop()
        closers = edges[record.side]
        if record.at not in closers:
            return no_closing(len(waiting), record)
        between = len(closers) - 1 - closers.index(record.at)
        found.append(Closing(passed, record.kind, record.side, between))
        passed = 0
    return no_closing(len(waiting) - 1, waiting[-1]) if waiting else Accepted(tuple(found))


def records_by_definition(
    word: str, given: Sequence[Closing]
) -> Accepted[tuple[Record, ...]] | Rejected:
    """The records of a word from what is seen from its end. Clause: CODE-HAND-3."""
    waiting = list(reversed(given))
    found: list[Record] = []
    passed = 0
    for s, edges in _splits_from_the_end(word):
        if not waiting or waiting[-1].passed != passed:
            passed += 1
            continue
        closing = waiting.pop()
        closers = edges[closing.side]
        if not 0 <= closing.between < len(closers):
            return no_record(len(waiting), "its closing edge")
        closer = closers[len(closers) - 1 - closing.between]
        found.append(Record(closing.kind, s, closer, closing.side))
        passed = 0
    if waiting:
        return no_record(len(waiting) - 1, "its S")
    return Accepted(tuple(reversed(found)))
