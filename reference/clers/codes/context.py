"""The context code: the word from its end, each symbol by what is known of the loop it is put on.

Read backwards, as Spirale Reversi reads it, a word shows its loops as they are: nothing has to be
guessed, and the number of triangles at each vertex of a loop is known. Five contexts foretell each
decision, and are mixed by how well they did.
"""

from typing import Final

from librt.vecs import vec
from mypy_extensions import i64

from clers.arithmetic.bits import Bits
from clers.arithmetic.coder import ended, finished, truncated
from clers.codes.code import NOTHING, Code, Shape
from clers.codes.implied import stranger
from clers.codes.logistic import RATE, SQUASH, STRETCH
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.edgebreaker.stream import Side
from clers.kernels.foretelling import Foretelling, decoded, encoded
from clers.kernels.interval import AHEAD, Decoder, Encoder
from clers.kernels.loops import Loops

ORDER: Final = "CRLES"
"""The symbols in the order in which they are asked for. Clause: CODE-CONTEXT-1."""

DECISIONS: Final = {"C": (1,), "R": (0, 1), "L": (0, 0, 1), "E": (0, 0, 0, 1), "S": (0, 0, 0, 0)}
"""Is it C? R? L? E? Clause: CODE-CONTEXT-1."""

FAR: Final = 1 << 62
"""No word has so many symbols or edges."""

EXPECTED: Final = 1 << 20
"""Memory is kept for no more symbols than these before they come."""

_NUMBERS: Final = bytes.maketrans(ORDER.encode(), bytes(range(len(ORDER))))
_LETTERS: Final = bytes.maketrans(bytes(range(len(ORDER))), ORDER.encode())
_STRETCH: Final = vec[i64](STRETCH)
_SQUASH: Final = vec[i64](SQUASH)
_RATE: Final = vec[i64](RATE)


def foretelling(shape: Shape, count: int = 0) -> Foretelling:
    """What is foretold before the first decision, of a word that is said to have `count` symbols.

    Clauses: CODE-CONTEXT-2 … CODE-CONTEXT-7.
    """
    seen = shape.closings
    loops = Loops(
        vec[i64](min(closing.passed, FAR) for closing in seen),
        vec[i64](int(closing.side is Side.LEFT) for closing in seen),
        vec[i64](min(closing.between, FAR) for closing in seen),
    )
    return Foretelling(loops, _STRETCH, _SQUASH, _RATE, max(0, min(count, EXPECTED)))


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The bits of the symbols, the last one first.

    Linear. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-3.
    """
    fault = stranger(symbols, Clause.CODE_CONTEXT_1)
    if fault is not None:
        return fault
    to = Encoder()
    at = encoded(symbols.encode().translate(_NUMBERS), foretelling(shape, len(symbols)), to)
    if at >= 0:
        detail = "no loop of a surface lets this symbol be undone"
        where = AtSymbol(at)
        return Rejected(Reason.NOT_IN_ALPHABET, Clause.CODE_CONTEXT_3, where, detail)
    return Accepted(finished(to))


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others.

    Linear. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-8.
    """
    of = Decoder(bits.data)
    by = foretelling(shape, count)
    found = decoded(count, bits.length, by, of)
    if len(found) < count or of.at - AHEAD > bits.length:
        return truncated(by.decisions, bits)
    return ended(found.translate(_LETTERS).decode()[::-1], of, bits)


def most_symbols(bits: int) -> int:
    """No decision has more than 65514 of 65536, so it costs 1/2070 bit. Clause: CODE-NAME-3."""
    return 2070 * bits + 2


CODE: Final = Code(encode, decode, most_symbols, NOTHING)
