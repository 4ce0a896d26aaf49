"""Which bits belong to which symbol, where that can be said. Clause: ORCL-DIVERGE-3."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from clers.arithmetic.steps import State, narrow, offset, shifted
from clers.codes import adaptive, golden, huffman, plain
from clers.codes.code import Shape
from clers.codes.implied import NUMBER, coded_part, implied
from clers.codes.registry import CodeName
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.numbers import from_wire
from clers.conformance.served.arithmetic import model_of
from clers.conformance.served.codes import named
from clers.conformance.served.forms import stream_of
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.stream import SYMBOLS, Stream
from clers.information.conditioned import Conditioned, Last
from clers.information.model import Model, Slot

END: Final = -1
"""In place of a symbol: bits of none, those of a table or those with which a coder ends."""

ORDERS: Final[Mapping[CodeName, int]] = {
    CodeName.ADAPTIVE_1: 1,
    CodeName.ADAPTIVE_3: 3,
    CodeName.ADAPTIVE_6: 6,
}
"""The orders of the adaptive codes. Clause: CODE-ADAPTIVE-1."""


@dataclass(frozen=True, slots=True)
class Group:
    """Bits start … stop−1 are written at a symbol, which has a name; or (END) at what is named.

    Of an arithmetic coder they are the digits that are shifted out when the symbol has narrowed the
    interval; there may be none. Clause: ORCL-DIVERGE-3.
    """

    symbol: int
    name: str
    start: int
    stop: int

    def told(self) -> str:
        """The symbol, for people."""
        return self.name if self.symbol == END else f"symbol {self.symbol} ({self.name})"


Groups = Callable[[], Sequence[Group]]
"""Groups that are made only where something diverges."""


def groups_of(request: Operation) -> tuple[Group, ...]:
    """The groups of the right bits: of the arithmetic coder and of some codes.

    None for other requests, nor where the reference rejects. Linear. Clause: ORCL-DIVERGE-3.
    """
    match request:
        case message.ArithmeticEncode(input=form.ToCode(coder="arithmetic", model=given) as asked):
            model = model_of(given)
            if isinstance(model, Rejected):
                return ()
            symbols = tuple(map(from_wire, asked.symbols))
            return tuple(_narrowed(model.value, symbols, [str(s) for s in symbols], 0))
        case message.CodeEncode(input=asked):
            return groups_of_word(named(asked.code), stream_of(asked))
        case _:
            return ()


def groups_of_word(code: CodeName | None, stream: Stream) -> tuple[Group, ...]:
    """The groups of a word's bits in a code; none where they are not known. ORCL-DIVERGE-3."""
    part, head = coded_part(stream), implied(stream.components_with_boundary)
    if not isinstance(part, Accepted) or not set(part.value) <= set(NUMBER):
        return ()
    word, first = part.value, len(head)
    symbols = [NUMBER[x] for x in word]
    if code is CodeName.PLAIN:
        lengths = {x: len(codeword) for x, codeword in plain.CODEWORDS.items()}
        return tuple(_written(word, first, 0, lengths))
    if code is CodeName.HUFFMAN:
        return _with_table(word, first)
    if code is CodeName.GOLDEN:
        return tuple(_narrowed(golden.model(head), symbols, word, first))
    order = None if code is None else ORDERS.get(code)
    if order is None:
        return ()
    model = Conditioned(adaptive.fresh, Last(order), tuple(NUMBER[x] for x in head))
    return tuple(_narrowed(model, symbols, word, first))


def _with_table(word: str, first: int) -> tuple[Group, ...]:
    """The table of lengths, then codewords. Clause: CODE-HUFFMAN-1."""
    bits = huffman.encode(word, Shape("C" * first, ()))
    if isinstance(bits, Rejected):
        return ()
    table = bits.value.digits()[: huffman.TABLE]
    widths = range(0, huffman.TABLE, huffman.WIDTH)
    lengths = {
        x: int(table[at : at + huffman.WIDTH], 2) for x, at in zip(SYMBOLS, widths, strict=True)
    }
    return (
        Group(END, "the table", 0, huffman.TABLE),
        *_written(word, first, huffman.TABLE, lengths),
    )


def _written(word: str, first: int, start: int, lengths: Mapping[str, int]) -> Iterator[Group]:
    """Codewords one after another. Clauses: CODE-PLAIN-1, CODE-HUFFMAN-1."""
    for i, x in enumerate(word, first):
        stop = start + lengths[x]
        yield Group(i, x, start, stop)
        start = stop


def _narrowed(
    model: Model, symbols: Sequence[int], names: Sequence[str], first: int
) -> Iterator[Group]:
    """The digits shifted out at each symbol, then the two of the end. Clause: ARITH-CARRY-1.

    Ends at a symbol that the model does not allow.
    """
    state, start = State(), 0
    for i, (symbol, name) in enumerate(zip(symbols, names, strict=True), first):
        table = model.cumulative
        if not 0 <= symbol < len(table) - 1 or table[symbol] == table[symbol + 1]:
            return
        state, stop = narrow(state, Slot(table[symbol], table[symbol + 1], table[-1])), start
        while (away := offset(state)) is not None:
            state, stop = shifted(state, away), stop + 1
        yield Group(i, name, start, stop)
        start, model = stop, model.after(symbol)
    yield Group(END, "the end", start, start + 2)
