"""Spirale Reversi: decode from the last symbol to the first, checking the grammar on the way."""

from librt.vecs import vec
from mypy_extensions import i64

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtRecord, AtSymbol
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.scanning import scanned
from clers.kernels import gluing as kernel
from clers.kernels.gluing import Gluing
from clers.kernels.scan import Scan


def reversi(outlined: Outline) -> Accepted[list[int]] | Rejected:
    """The opposite corner of each corner, or the symbol at which no surface has this stream.

    Linear in the word: each edge enters a loop once and leaves it once.
    Clauses: EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3, EB-GRAMMAR-5 … EB-GRAMMAR-8.
    """
    glued = and_then(scanned(outlined.stream), gluing)
    return and_then(glued, lambda opposite: Accepted(list(opposite)))


def gluing(scan: Scan) -> Accepted[vec[i64]] | Rejected:
    """The same of a stream that was scanned."""
    machine = Gluing(scan)
    return Accepted(machine.opposite) if machine.run() else _fault(machine)


def _fault(found: Gluing) -> Rejected:
    """What is wrong, where, and in words. Clauses: EB-GRAMMAR-5 … EB-GRAMMAR-8."""
    at, detail = found.where, found.detail
    match found.fault:
        case kernel.SHORT_UNDER_C:
            why = "a loop of 4 edges at least must follow a C"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_5, AtSymbol(at), why)
        case kernel.GLUED_UNDER_C:
            why = "the left edge of this C is glued by a handle record"
            return Rejected(Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_5, AtSymbol(at), why)
        case kernel.OUTSIDE_BRANCH:
            why = "the closing triangle is not in the right branch of its S"
            return Rejected(Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_6, AtRecord(at), why)
        case kernel.SHORT_AT_SPLIT:
            why = "no surface has so short a loop at this S"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_6, AtRecord(at), why)
        case kernel.NOT_FREE:
            why = "the loop that this S cuts off is not free"
            return Rejected(Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_7, AtRecord(at), why)
        case kernel.SHORT_CURVE:
            why = f"a boundary curve of {detail} edges"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_7, AtRecord(at), why)
        case kernel.LEFT_OPEN:
            why = f"{detail} edges are left open, P has 3"
            return Rejected(Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(at), why)
        case kernel.SHORT_FIRST_CURVE:
            why = f"a boundary curve of {detail} edges"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_8, AtSymbol(at), why)
        case _:
            why = "an edge of its triangle is closed by no other triangle"
            return Rejected(Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(at), why)
