"""Coding with an automaton: a fixed table in each of a few contexts. Clause: INFO-AUTOMATON-1."""

from librt.strings import BytesWriter
from librt.vecs import vec
from mypy_extensions import i64, u8

from clers.kernels.interval import AHEAD, Decoder, Encoder


class Tables:
    """The tables of all contexts one after another: of context q symbol s at q·(size + 1) + s.

    `cumulative`: the cumulative frequencies, size + 1 of them; `after`: the context after each
    symbol, with one entry too many. All totals are from 1 to 2^30.
    """

    def __init__(self, size: i64, cumulative: vec[i64], after: vec[i64]) -> None:
        self.size = size
        self.cumulative = cumulative
        self.after = after


def encoded(tables: Tables, context: i64, symbols: bytes, to: Encoder) -> i64:
    """Write symbols; the place of the first that has no frequency there, or -1. Linear.

    Clauses: ARITH-ENCODE-1, INFO-AUTOMATON-1; INFO-MODEL-5 for what cannot be written.
    """
    size: i64 = tables.size
    row: i64 = size + 1
    cumulative = tables.cumulative
    after = tables.after
    n: i64 = len(symbols)
    i: i64 = 0
    while i < n:
        symbol: i64 = symbols[i]
        if symbol >= size:
            return i
        at: i64 = context * row + symbol
        below: i64 = cumulative[at]
        upto: i64 = cumulative[at + 1]
        if below == upto:
            return i
        to.narrow(below, upto, cumulative[context * row + size])
        context = after[at]
        i += 1
    return -1


def decoded(tables: Tables, context: i64, count: i64, longest: i64, of: Decoder) -> bytes:
    """The next `count` symbols; fewer if they would take more than `longest` bits. Linear.

    Clauses: ARITH-DECODE-1, ARITH-DECODE-2, ARITH-STRICT-2, INFO-AUTOMATON-1.
    """
    size: i64 = tables.size
    row: i64 = size + 1
    cumulative = tables.cumulative
    after = tables.after
    out = BytesWriter()
    i: i64 = 0
    while i < count:
        base: i64 = context * row
        total: i64 = cumulative[base + size]
        # `target` says the same: it is below a number if and only if these products are in order.
        width: i64 = of.high - of.low + 1
        aim: i64 = (of.offset + 1) * total
        at: i64 = base
        below: i64 = 0
        upto: i64 = cumulative[base + 1]
        while width * upto < aim:
            at += 1
            below = upto
            upto = cumulative[at + 1]
        of.narrow(below, upto, total)
        if of.at - AHEAD > longest:
            break
        out.append(u8(at - base))
        context = after[at]
        i += 1
    return out.getvalue()
