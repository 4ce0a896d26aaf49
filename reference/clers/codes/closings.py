"""Handle data as Spirale Reversi meets it: from the end, counted back from each S with a record."""

from collections.abc import Sequence
from dataclasses import dataclass

from librt.vecs import vec
from mypy_extensions import i64

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtRecord
from clers.edgebreaker.scanning import FAR, records_of
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.kernels import closing as kernel


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
    given = stream.records
    if not given:
        return Accepted(())
    word = stream.word.encode("ascii", "replace")
    followed = [*(record.s for record in given[1:]), word.count(b"S")]
    first = _in_order([record.s for record in given], followed)
    between = kernel.between(word, records_of(given), first, _closers(word))
    wrong = next((r for r in reversed(range(len(given))) if between[r] == kernel.NONE), None)
    if wrong is not None:
        return no_closing(wrong, given[wrong])
    return Accepted(
        tuple(
            Closing(followed[r] - given[r].s - 1, given[r].kind, given[r].side, between[r])
            for r in reversed(range(len(given)))
        )
    )


def _in_order(numbers: Sequence[int], followed: Sequence[int]) -> int:
    """From which record on all S are below the next, and the last below their number."""
    pairs = list(zip(numbers, followed, strict=True))
    wrong = (r for r in reversed(range(len(pairs))) if not 0 <= pairs[r][0] < pairs[r][1])
    return next(wrong, -1) + 1


def records(word: str, given: Sequence[Closing]) -> Accepted[tuple[Record, ...]] | Rejected:
    """The records of a word from what is seen from its end. Linear. Clause: CODE-HAND-3."""
    if not given:
        return Accepted(())
    numbers = _numbers(word.count("S"), given)
    there = given[: len(numbers)]
    closers = kernel.closers(
        word.encode("ascii", "replace"),
        vec[i64](reversed(numbers)),
        vec[i64](int(closing.side is Side.LEFT) for closing in reversed(there)),
        vec[i64](max(-1, min(closing.between, FAR)) for closing in reversed(there)),
    )
    found = [
        Record(closing.kind, s, at, closing.side)
        for closing, s, at in zip(there, numbers, reversed(list(closers)), strict=True)
    ]
    wrong = next((i for i, record in enumerate(found) if record.at == kernel.NONE), None)
    if wrong is not None:
        return no_record(len(given) - 1 - wrong, "its closing edge")
    if len(found) < len(given):
        return no_record(len(given) - 1 - len(found), "its S")
    return Accepted(tuple(reversed(found)))


def _numbers(splits: int, given: Sequence[Closing]) -> list[int]:
    """The S of each closing, the last one first, up to the first that has none."""
    numbers: list[int] = []
    s = splits
    for closing in given:
        s -= closing.passed + 1
        if s < 0 or closing.passed < 0:
            break
        numbers.append(s)
    return numbers


def _closers(word: bytes) -> int:
    """How many R, L and E there are. Clause: EB-HANDLE-3."""
    return word.count(b"R") + word.count(b"L") + word.count(b"E")


def no_closing(index: int, record: Record) -> Rejected:
    """A record that no edge after its S belongs to. Clause: CODE-HAND-2."""
    detail = f"S {record.s} is not closed on the {record.side} by closer {record.at}"
    return Rejected(Reason.NOT_REPRESENTABLE, Clause.CODE_HAND_2, AtRecord(index), detail)


def no_record(index: int, what: str) -> Rejected:
    """A closing that goes back too far. Clause: CODE-HAND-3."""
    detail = f"{what} is further back than the word is long"
    return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.CODE_HAND_3, AtRecord(index), detail)
