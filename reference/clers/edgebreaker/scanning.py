"""The forward scan of a stream, and what is wrong with one, in words."""

from collections.abc import Sequence
from typing import Final

from librt.vecs import vec
from mypy_extensions import i64

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtRecord, AtSymbol
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.kernels import scan as kernel
from clers.kernels.scan import Records, Scan

FAR: Final = 1 << 61
"""No symbol, record or component has so great a number. Clause: CPLX-INPUT-3."""


def scanned(stream: Stream) -> Accepted[Scan] | Rejected:
    """The scan of a stream that is sound as far as it tells. Linear.

    Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-4, and before all others by EB-GRAMMAR-11.
    """
    word = stream.word.encode("ascii", "replace")
    scan = Scan(word, records_of(stream.records), _within(stream.components_with_boundary))
    return Accepted(scan) if scan.run() else _fault(stream, scan)


def records_of(records: Sequence[Record]) -> Records:
    """The handle data as flat arrays; numbers beyond all that there are stay so, and in order."""
    s = [record.s for record in records]
    if s and not -FAR < min(s) <= max(s) < FAR:
        far = {number: number for number in s if abs(number) >= FAR}
        for rank, number in enumerate(sorted(far)):
            far[number] = FAR + rank if number > 0 else rank - 2 * FAR
        s = [far.get(number, number) for number in s]
    return Records(
        vec[i64](s),
        vec[i64]([_within(record.at) for record in records]),
        vec[i64]([record.side is Side.LEFT for record in records]),
        vec[i64]([record.kind is Kind.BOUNDARY for record in records]),
    )


def _within(number: int) -> int:
    """The number, or one that is as much out of range."""
    return number if 0 <= number < FAR else -1 if number < 0 else FAR


def _fault(stream: Stream, scan: Scan) -> Rejected:
    """What is wrong, where, and in words. Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-4."""
    at, detail = scan.where, scan.detail
    match scan.fault:
        case kernel.EMPTY:
            return Rejected(Reason.EMPTY_WORD, Clause.EB_GRAMMAR_1, WHOLE)
        case kernel.UNKNOWN:
            found = repr(stream.word[at])
            return Rejected(Reason.UNKNOWN_SYMBOL, Clause.EB_GRAMMAR_1, AtSymbol(at), found)
        case kernel.DISORDERED:
            return Rejected(Reason.RECORD_ORDER, Clause.EB_GRAMMAR_2, AtRecord(at))
        case kernel.NO_SUCH_SPLIT:
            why = f"S number {stream.records[at].s} of {detail}"
            return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_2, AtRecord(at), why)
        case kernel.UNFINISHED:
            why = f"{detail} more E needed at least"
            return Rejected(Reason.UNFINISHED_WORD, Clause.EB_GRAMMAR_3, AtSymbol(at), why)
        case kernel.FEW_COMPONENTS:
            why = f"{detail} components, {stream.components_with_boundary} with boundary"
            return Rejected(Reason.TOO_FEW_COMPONENTS, Clause.EB_GRAMMAR_3, WHOLE, why)
        case kernel.NO_SUCH_CLOSER:
            why = f"closing symbol {stream.records[at].at} of {detail}"
            return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_4, AtRecord(at), why)
        case kernel.OTHER_SIDE:
            symbol, side = stream.word[detail], stream.records[at].side
            why = f"symbol {detail} is {symbol}, its {side} edge leads on"
            return Rejected(Reason.RECORD_SIDE, Clause.EB_GRAMMAR_4, AtRecord(at), why)
        case kernel.BEFORE_SPLIT:
            split = scan.splits[stream.records[at].s]
            why = f"symbol {detail} comes before its S, symbol {split}"
            return Rejected(Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_4, AtRecord(at), why)
        case kernel.IN_CLOSED_COMPONENT:
            why = "its component is closed"
            return Rejected(Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_4, AtRecord(at), why)
        case _:
            return Rejected(Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_4, AtRecord(at))
