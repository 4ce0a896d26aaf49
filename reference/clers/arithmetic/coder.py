"""The arithmetic coder of the tutorial's Algorithms 1 and 2, mended: 32 bits, linear time."""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, TypeVar

from clers.arithmetic.bits import Bits
from clers.arithmetic.by_automaton import Started, as_bytes, tables_of
from clers.arithmetic.steps import PRECISION
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtSymbol
from clers.information.model import MAXIMUM_TOTAL, Model, not_in_alphabet, over_maximum
from clers.kernels.automaton import decoded, encoded
from clers.kernels.interval import AHEAD, Decoder, Encoder

T = TypeVar("T")

SHORTEST: Final = 2
"""The bits of the empty message. Clause: ARITH-END-1."""


def encode(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The bits of a message, linear in symbols and bits.

    Clauses: ARITH-ENCODE-1, ARITH-SHIFT-2, ARITH-END-1, ARITH-END-2; for the length ARITH-LENGTH-1,
    ARITH-LENGTH-2, ARITH-LENGTH-3; rejections by INFO-MODEL-5, INFO-MODEL-6.
    """
    to = Encoder()
    tables = tables_of(model)
    numbers = None if tables is None else as_bytes(symbols)
    fault = (
        _write(model, symbols, to)
        if tables is None or numbers is None
        else _write_by(tables, numbers, to)
    )
    return fault if fault is not None else Accepted(finished(to))


def finished(to: Encoder) -> Bits:
    """The bits that were written, and the last ones. Clause: ARITH-END-1."""
    data = to.finish()
    return Bits(data, to.length)


def _write(model: Model, symbols: Sequence[int], to: Encoder) -> Rejected | None:
    """Write the symbols of any model; what is wrong with the first that cannot be written."""
    narrow = to.narrow
    for index, symbol in enumerate(symbols):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if not 0 <= symbol < len(table) - 1 or table[symbol] == table[symbol + 1]:
            return not_in_alphabet(index, symbol)
        narrow(table[symbol], table[symbol + 1], total)
        model = model.after(symbol)
    return None


def _write_by(automaton: Started, symbols: bytes, to: Encoder) -> Rejected | None:
    """The same for an automaton."""
    fault = encoded(automaton.tables, automaton.context, symbols, to)
    return None if fault < 0 else not_in_alphabet(fault, symbols[fault])


@dataclass(frozen=True, slots=True)
class Reading:
    """What a decoder saw in bits that may go on after the message. Clause: ARITH-DECODE-4.

    `symbols`; `length`, the number of bits that an encoder gives to these symbols; and whether
    the first `length` bits are those that an encoder gives.
    """

    symbols: tuple[int, ...]
    length: int
    canonical: bool


def read(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    """The first `count` symbols that any bits decode to (fewer if the model ends).

    Linear in symbols and bits. Clauses: ARITH-DECODE-1 … ARITH-DECODE-4; rejection by INFO-MODEL-6.
    """
    # A symbol shifts 32 times at most, so that this bound is never met.
    return _read(model, bits, count, PRECISION * max(count, 0) + 2)


def decode(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The message that these bits, and no others, encode: `count` symbols, or to the model's end.

    Linear in symbols and bits. Clauses: ARITH-STRICT-1 … ARITH-STRICT-4.
    """
    return and_then(_read(model, bits, count, bits.length), lambda found: strictly(found, bits))


def decode_bytes(model: Model, bits: Bits, count: int) -> Accepted[bytes] | Rejected:
    """The same of a model whose symbols are all below 256, each in a byte."""
    tables = tables_of(model)
    if tables is None or bits.length < SHORTEST:
        return and_then(decode(model, bits, count), lambda found: Accepted(bytes(found)))
    of = Decoder(bits.data)
    found = _read_by(tables, of, bits, count, bits.length)
    return and_then(found, lambda numbers: ended(numbers, of, bits))


def strictly(found: Reading, bits: Bits) -> Accepted[tuple[int, ...]] | Rejected:
    """The symbols, if the bits are those of an encoder. Clauses: ARITH-STRICT-3, ARITH-STRICT-4."""
    fault = _bad_end(found.length, found.canonical, bits)
    return Accepted(found.symbols) if fault is None else fault


def ended(found: T, of: Decoder, bits: Bits) -> Accepted[T] | Rejected:
    """What was found, if the bits that a kernel has read are those of an encoder.

    Clauses: ARITH-STRICT-3, ARITH-STRICT-4.
    """
    fault = _bad_end(of.at - AHEAD, of.canonical(), bits)
    return Accepted(found) if fault is None else fault


def _bad_end(length: int, canonical: bool, bits: Bits) -> Rejected | None:
    """What is wrong with bits of which an encoder would give so many, if they are its own."""
    if length < bits.length:
        detail = f"the message has {length} bits, {bits.length} are given"
        return Rejected(Reason.TRAILING_BITS, Clause.ARITH_STRICT_3, detail=detail)
    if not canonical:
        detail = "an encoder ends these symbols with other bits"
        return Rejected(Reason.NOT_CANONICAL, Clause.ARITH_STRICT_4, detail=detail)
    return None


def _read_by(
    automaton: Started, of: Decoder, bits: Bits, count: int, longest: int
) -> Accepted[bytes] | Rejected:
    """The symbols of an automaton, each in a byte. Clauses: ARITH-DECODE-1, ARITH-STRICT-2."""
    numbers = decoded(automaton.tables, automaton.context, max(count, 0), longest, of)
    return truncated(len(numbers), bits) if len(numbers) < count else Accepted(numbers)


def _read(model: Model, bits: Bits, count: int, longest: int) -> Accepted[Reading] | Rejected:
    """Decode; give up as soon as the message must be longer than `longest` bits.

    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4, ARITH-STRICT-2.
    """
    if longest < SHORTEST:
        return truncated(0, bits)
    of = Decoder(bits.data)
    tables = tables_of(model)
    if tables is not None:
        numbers = _read_by(tables, of, bits, count, longest)
        return and_then(numbers, lambda found: Accepted(_reading(tuple(found), of)))
    symbols: list[int] = []
    for index in range(count):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if total == 0:
            break
        symbol = bisect_right(table, of.target(total)) - 1
        of.narrow(table[symbol], table[symbol + 1], total)
        if of.at - AHEAD > longest:
            return truncated(index, bits)
        symbols.append(symbol)
        model = model.after(symbol)
    return Accepted(_reading(tuple(symbols), of))


def _reading(symbols: tuple[int, ...], of: Decoder) -> Reading:
    return Reading(symbols, of.at - AHEAD, of.canonical())


def truncated(index: int, bits: Bits) -> Rejected:
    """The message up to symbol `index` needs more bits than there are. Clause: ARITH-STRICT-2."""
    detail = f"{bits.length} bits are given"
    return Rejected(Reason.TRUNCATED_BITS, Clause.ARITH_STRICT_2, AtSymbol(index), detail)


@dataclass(frozen=True, slots=True)
class Coder:
    """An arithmetic coder as a value: what the laws of this chapter judge."""

    encode: Callable[[Model, Sequence[int]], Accepted[Bits] | Rejected]
    decode: Callable[[Model, Bits, int], Accepted[tuple[int, ...]] | Rejected]
    read: Callable[[Model, Bits, int], Accepted[Reading] | Rejected]


REFERENCE: Final = Coder(encode, decode, read)
