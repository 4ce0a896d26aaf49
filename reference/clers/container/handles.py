"""The HAND section: handle data, each record as a difference to the one before."""

from typing import Final

from clers.container.layout import Layout, pair, renamed, times
from clers.container.numbers import signed, varint
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.stream import Kind, Record, Side

Difference = tuple[int, int]
"""4·(steps of s − 1) + 2·(is boundary) + (is left), and the step of `at`. Clause: FILE-HAND-2."""

DIFFERENCE: Final[Layout[Difference]] = pair(varint(34), signed(33))

COUNTABLE: Final = 1 << 32
"""`s` and `at` are below this. Clause: FILE-HAND-3."""


def handles(count: int) -> Layout[tuple[Record, ...]]:
    """So many records. Clauses: FILE-HAND-1 … FILE-HAND-3."""
    return renamed(times(count, DIFFERENCE), _summed, _differences)


def _differences(records: tuple[Record, ...]) -> tuple[Difference, ...]:
    """Clause: FILE-HAND-2."""
    found: list[Difference] = []
    s, at = -1, 0
    for record in records:
        flags = 2 * (record.kind is Kind.BOUNDARY) + (record.side is Side.LEFT)
        found.append((4 * (record.s - s - 1) + flags, record.at - at))
        s, at = record.s, record.at
    return tuple(found)


def _summed(differences: tuple[Difference, ...]) -> Accepted[tuple[Record, ...]] | Rejected:
    """Clauses: FILE-HAND-2, FILE-HAND-3."""
    found: list[Record] = []
    s, at = -1, 0
    for packed, step in differences:
        s, at = s + 1 + packed // 4, at + step
        if s >= COUNTABLE or not 0 <= at < COUNTABLE:
            detail = f"record {len(found)} has s = {s}, at = {at}"
            return Rejected(Reason.BAD_NUMBER, Clause.FILE_HAND_3, detail=detail)
        kind = Kind.BOUNDARY if packed & 2 else Kind.HANDLE
        found.append(Record(kind, s, at, Side.LEFT if packed & 1 else Side.RIGHT))
    return Accepted(tuple(found))
