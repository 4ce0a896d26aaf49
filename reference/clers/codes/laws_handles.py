"""The laws of the bits of handle data."""

from math import log2
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes import handle_data
from clers.codes.closings import Closing, closings, records
from clers.codes.closings_definition import closings_by_definition, records_by_definition
from clers.complexes.given import SURFACES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.given import STREAMS
from clers.edgebreaker.stream import Stream


def _coded(surface: Surface) -> tuple[tuple[Closing, ...], int, Bits]:
    """The closings of a surface, the symbols of its word, and the bits."""
    stream = encode_surface(surface).stream
    symbols = len(stream.word)
    coded = and_then(
        closings(stream),
        lambda seen: and_then(
            handle_data.encode(seen, symbols), lambda bits: Accepted((seen, symbols, bits))
        ),
    )
    match coded:
        case Accepted(found):
            return found
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def handle_data_comes_back(surface: Surface) -> Verdict:
    """The closings, and from a bit more or less nothing."""
    seen, symbols, bits = _coded(surface)
    found = handle_data.decode(bits, len(seen), symbols)
    others = (bits.followed_by(pack([0])), pack(bits.values()[:-1]))
    taken = [isinstance(handle_data.decode(b, len(seen), symbols), Accepted) for b in others]
    return every(same(Accepted(seen), found), same([False, False], taken))


def most_bits(seen: tuple[Closing, ...], symbols: int) -> float:
    """What the page promises. Clause: CODE-HAND-6."""
    size, m = handle_data.sizes(symbols), len(seen)
    digits = sum(
        (c.passed + 1).bit_length() + (c.between + 1).bit_length() - 2 + 2 + 2 * log2(size)
        for c in seen
    )
    return 5 + digits + m / 1000 + size * log2(m) + 2 * log2(size)


def handle_data_is_short(surface: Surface) -> Verdict:
    """The bits are within the bound, which knows the sizes of the numbers alone."""
    seen, symbols, bits = _coded(surface)
    if not seen:
        return Holds() if bits.length == 2 else Fails("2 bits", str(bits.length), WHOLE)
    return at_most(most_bits(seen, symbols), bits.length, "bits")


def seen_as_defined(stream: Stream) -> Verdict:
    """One sweep with differences finds what walking back finds, and blames the same record."""
    return same(closings_by_definition(stream), closings(stream))


def undone_as_defined(stream: Stream) -> Verdict:
    """The same the other way, of numbers that may mean nothing: those of the records."""
    given = [Closing(r.s, r.kind, r.side, r.at) for r in stream.records]
    return same(records_by_definition(stream.word, given), records(stream.word, given))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "handle-data-comes-back",
        Clause.CODE_HAND_5,
        "the bits of handle data decode to it, and no others do",
        SURFACES,
        handle_data_comes_back,
    ),
    Law(
        "handle-data-is-short",
        Clause.CODE_HAND_6,
        "handle data takes its digits, two bits and the sizes, and what learning costs",
        SURFACES,
        handle_data_is_short,
    ),
    Law(
        "closings-definition",
        Clause.CODE_HAND_2,
        "closings counted in one sweep are those that a walk from the end meets",
        STREAMS,
        seen_as_defined,
    ),
    Law(
        "closings-back-definition",
        Clause.CODE_HAND_3,
        "records found in one sweep are those that a walk from the end finds",
        STREAMS,
        undone_as_defined,
    ),
)
