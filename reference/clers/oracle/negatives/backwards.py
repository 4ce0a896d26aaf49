"""Streams from the grammar alone: built from the last symbol to the first, as EB-REVERSI-2 undoes.

No surface is encoded here. The loops are tuples of edges, copied at each step, so that a reader can
hold this beside the table of the clause. What it gives keeps EB-GRAMMAR-1 … EB-GRAMMAR-8; whether
it keeps EB-GRAMMAR-9, that the result is a simplicial complex, a decoder has to say.
"""

from collections.abc import Iterator
from random import Random
from typing import Final

from msgspec import Struct
from msgspec.structs import replace

from clers.edgebreaker.stream import Kind, Record, Side, Stream

Loop = tuple[int, ...]
"""Edges, the gate first: of symbol p from the end, 3p is the gate, 3p+1 and 3p+2 right and left."""

SHORTEST: Final = 3


class Closed(Struct, frozen=True):
    """A record, its symbols counted from the end of the word."""

    kind: Kind
    split: int
    closer: int
    side: Side


class Partial(Struct, frozen=True):
    """The end of a word: loops with gates (the last on top), loops beside them, and records.

    `ends[i]` is the last symbol of the branch behind gate i. `with_boundary` counts the components
    with boundary so far; `curved` says that a curve was cut off in the present one.
    """

    word: str = ""
    gates: tuple[Loop, ...] = ()
    ends: tuple[int, ...] = ()
    beside: tuple[Loop, ...] = ()
    records: tuple[Closed, ...] = ()
    with_boundary: int = 0
    curved: bool = False


def _closable(word: str, edge: int) -> Side | None:
    """The side on which an edge of a loop can close an S. Clause: EB-HANDLE-4."""
    symbol = word[-1 - edge // 3]
    match edge % 3:
        case 1 if symbol in "RE":
            return Side.RIGHT
        case 2 if symbol in "LE":
            return Side.LEFT
        case _:
            return None


def before(end: Partial) -> Iterator[Partial]:
    """All ends of words of one symbol more. Clause: EB-REVERSI-2."""
    p = len(end.word)
    gate, right, left = 3 * p, 3 * p + 1, 3 * p + 2
    new = replace(
        end, word="E" + end.word, gates=(*end.gates, (gate, right, left)), ends=(*end.ends, p)
    )
    yield new
    if not end.gates:
        return
    *others, loop = end.gates
    rest = loop[1:]
    for symbol, made in (("R", (gate, right, *rest)), ("L", (gate, *rest, left))):
        yield replace(end, word=symbol + end.word, gates=(*others, made))
    if len(loop) > SHORTEST and end.word[0] not in "LE":
        yield replace(end, word="C" + end.word, gates=(*others, (gate, *rest[:-1])))
    if others:
        made = (gate, *rest, *others[-1][1:])
        yield replace(end, word="S" + end.word, gates=(*others[:-1], made), ends=end.ends[:-1])
    yield from _recorded(end, gate, others, rest)


def _recorded(end: Partial, gate: int, others: list[Loop], rest: Loop) -> Iterator[Partial]:
    """The S with a record. Clauses: EB-REVERSI-2, EB-GRAMMAR-6, EB-GRAMMAR-7.

    All edges of a gate's loop are of its branch. Those of a loop beside may be of a later one.
    """
    p, word = gate // 3, "S" + end.word
    for i in range(1, len(rest) - 1):  # neither neighbour of the gate
        side = _closable(end.word, rest[i])
        if side is None:
            continue
        gates, cut = (*others, (gate, *rest[:i])), rest[i + 1 :]
        closed = Closed(Kind.HANDLE, p, rest[i] // 3, side)
        yield replace(
            end, word=word, gates=gates, beside=(*end.beside, cut), records=(*end.records, closed)
        )
        if len(cut) >= SHORTEST:
            curve = replace(closed, kind=Kind.BOUNDARY)
            yield replace(end, word=word, gates=gates, records=(*end.records, curve), curved=True)
    for b, loop in enumerate(end.beside):
        for i, edge in enumerate(loop):
            side = _closable(end.word, edge)
            if side is None or edge // 3 < end.ends[-1] or len(loop) == 1:
                continue
            made = (gate, *rest, *loop[i + 1 :], *loop[:i])
            closed = Closed(Kind.HANDLE, p, edge // 3, side)
            yield replace(
                end,
                word=word,
                gates=(*others, made),
                beside=(*end.beside[:b], *end.beside[b + 1 :]),
                records=(*end.records, closed),
            )


def begun(end: Partial) -> Iterator[Partial]:
    """The component that the word begins with, complete: closed, or with boundary. EB-REVERSI-3."""
    if len(end.gates) != 1 or end.beside or len(end.gates[0]) < SHORTEST:
        return
    done = replace(end, gates=(), ends=(), curved=False)
    if len(end.gates[0]) == SHORTEST and not end.curved and end.with_boundary == 0:
        yield done
    yield replace(done, with_boundary=end.with_boundary + 1)


def stream_of(end: Partial) -> Stream:
    """The stream of a word that is complete. Clauses: EB-HANDLE-3, EB-HANDLE-5."""
    word = end.word
    last = len(word) - 1
    records = tuple(
        Record(
            r.kind,
            word[: last - r.split].count("S"),
            sum(symbol in "RLE" for symbol in word[: last - r.closer]),
            r.side,
        )
        for r in reversed(end.records)
    )
    return Stream(word, records, end.with_boundary)


def all_streams(symbols: int, *, records: int = 0) -> Iterator[Stream]:
    """Every stream of so many symbols, and so many records at least, in no order that matters.

    Exponential. Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-8.
    """
    todo = [Partial()]
    while todo:
        end = todo.pop()
        left = symbols - len(end.word)
        if len(end.gates) - 1 + len(end.beside) > left:
            continue
        if end.word:
            for done in begun(end):
                if left == 0 and len(done.records) >= records:
                    yield stream_of(done)
                elif left:
                    todo.extend(before(done))
        if left:
            todo.extend(before(end))


def random_streams(seed: int, symbols: int) -> Iterator[Stream]:
    """Streams without end, of about so many symbols, each from a random walk of `before`.

    The walk then joins what is left and cuts the last loop down. Equal seeds give equal streams.
    """
    random = Random(seed)
    while True:
        end = Partial()
        while len(end.word) < symbols:
            ways = list(before(end))
            new = [way for way in ways if len(way.gates) > len(end.gates)]
            recorded = [way for way in ways if len(way.records) > len(end.records)]
            plain = [
                way
                for way in ways
                if len(way.gates) <= len(end.gates) and len(way.records) <= len(end.records)
            ]
            x = random.random()
            kinds = recorded if x < 0.1 else new if x < 0.25 else plain
            kinds = kinds or plain or new
            end = kinds[int(random.random() * len(kinds))]
        closed = random.random() < 0.5
        while (done := _towards(end, closed=closed)) is not None:
            end = done
        yield from (stream_of(done) for done in begun(end))


def _towards(end: Partial, *, closed: bool) -> Partial | None:
    """One symbol nearer to a single loop, and of three edges if it is to be closed; None if so."""
    ways = list(before(end))
    joined = [
        way for way in ways if len(way.gates) + len(way.beside) < len(end.gates) + len(end.beside)
    ]
    if joined:
        return joined[-1]
    if len(end.gates) == 1 and closed and len(end.gates[0]) > SHORTEST:
        return next((way for way in ways if way.word[0] == "C"), ways[1])
    return None
