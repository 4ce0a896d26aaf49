"""The laws of chapter 6: lengths that are known before a bit is written."""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes import golden, plain
from clers.codes.closings import closings, records
from clers.codes.code import NOTHING
from clers.codes.implied import implied
from clers.codes.laws_best import LAWS as BEST
from clers.codes.laws_context import LAWS as CONTEXT
from clers.codes.laws_enumerative import LAWS as ENUMERATIVE
from clers.codes.laws_guarantees import LAWS as GUARANTEES
from clers.codes.laws_handles import LAWS as HANDLES
from clers.codes.laws_learning import LAWS as LEARNING
from clers.codes.laws_trees import LAWS as TREES
from clers.codes.registry import CODES, PARTIAL, CodeName, decode, encode, most_symbols
from clers.complexes.given import SPHERES, SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.stream import Stream


def bits_of(code: CodeName, stream: Stream) -> Bits:
    """The bits of a stream that the code takes."""
    match encode(code, stream):
        case Accepted(bits):
            return bits
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def read(code: CodeName, bits: Bits, stream: Stream) -> Accepted[str] | Rejected:
    """The word that these bits decode to, with all that a decoder is told of a stream."""
    symbols, components = len(stream.word), stream.components_with_boundary
    return and_then(closings(stream), lambda seen: decode(code, bits, symbols, components, seen))


def refused(code: CodeName, stream: Stream) -> bool:
    """Whether the code is not for such a stream, and says so."""
    if code not in PARTIAL:
        return False
    found = encode(code, stream)
    return isinstance(found, Rejected) and found.reason is Reason.NOT_REPRESENTABLE


def comes_back(code: CodeName, surface: Surface) -> Verdict:
    """The bits of a word decode to the word, and the count of symbols is believed."""
    stream = encode_surface(surface).stream
    if refused(code, stream):
        return Holds()
    bits = bits_of(code, stream)
    match read(code, bits, stream):
        case Accepted(word):
            return every(
                same(stream.word, word),
                at_most(most_symbols(code, bits.length), len(word), "symbols"),
            )
        case Rejected() as rejected:
            return Fails("a word", rejected.line(), rejected.where)


def no_other_bits(code: CodeName, surface: Surface) -> Verdict:
    """One bit more, or one bit less, is rejected."""
    stream = encode_surface(surface).stream
    if refused(code, stream):
        return Holds()
    bits = bits_of(code, stream)
    longer = (bits.followed_by(pack([0])), bits.followed_by(pack([1])))
    shorter = (pack(bits.values()[:-1]),) if bits.length else ()
    for other in (*longer, *shorter):
        found = read(code, other, stream)
        if isinstance(found, Accepted):
            return Fails("a rejection", found.value, WHOLE)
    return Holds()


def other_beginnings_rejected(surface: Surface) -> Verdict:
    """A closed surface's word begins with C, and no code takes one that does not."""
    stream = encode_surface(surface).stream
    if stream.components_with_boundary:
        return Holds()
    other = Stream("R" + stream.word[1:], stream.records, 0)
    results = [encode(code, other) for code in CodeName]
    reasons = [r.reason if isinstance(r, Rejected) else None for r in results]
    return every(same("C", stream.word[:1]), same([Reason.NOT_IN_ALPHABET] * len(results), reasons))


def within_guarantee(code: CodeName, surface: Surface) -> Verdict:
    """No more bits than are promised for such components."""
    most = CODES[code].guarantee.bits(components(surface))
    if most is None:
        return Holds()
    return at_most(most, bits_of(code, encode_surface(surface).stream).length, "bits")


def plain_length(surface: Surface) -> Verdict:
    """2T − 2 bits."""
    length = bits_of(CodeName.PLAIN, encode_surface(surface).stream).length
    return same(2 * surface.faces - 2, length)


def plain_length_by_counts(surface: Surface) -> Verdict:
    """What the counts of the components say."""
    length = bits_of(CodeName.PLAIN, encode_surface(surface).stream).length
    return same(plain.length(components(surface)), length)


def records_come_back(surface: Surface) -> Verdict:
    """The closings of a stream and its word give the records."""
    stream = encode_surface(surface).stream
    found = and_then(closings(stream), lambda seen: records(stream.word, seen))
    return same(Accepted(stream.records), found)


def golden_units_of_word(surface: Surface) -> Verdict:
    """Units by cost are 4n − 3#C + #S − #E."""
    word = encode_surface(surface).stream.word
    expected = 4 * len(word) - 3 * word.count("C") + word.count("S") - word.count("E")
    return same(expected, golden.units(word))


def golden_units_of_surface(surface: Surface) -> Verdict:
    """Units by cost are those that T, B, g and b give, summed over the components."""
    expected = sum(golden.units_of(component) for component in components(surface))
    return same(expected, golden.units(encode_surface(surface).stream.word))


def golden_real_length(surface: Surface) -> Verdict:
    """The bits written are within a small constant of the ideal length."""
    stream = encode_surface(surface).stream
    head = implied(stream.components_with_boundary)
    ideal = (golden.units(stream.word) - golden.units(head)) * golden.UNIT
    symbols = len(stream.word) - len(head)
    length = bits_of(CodeName.GOLDEN, stream).length
    return at_most(ideal + 2 + symbols / 15000, length, "bits")


def golden_on_spheres(surface: Surface) -> Verdict:
    """At most 11T/6 bits, the first C implied."""
    length = bits_of(CodeName.GOLDEN, encode_surface(surface).stream).length
    return at_most(11 * surface.faces // 6, length, "bits")


def _of_code(code: CodeName) -> tuple[AnyLaw, ...]:
    """The laws that every code has for itself."""

    def round_trip(surface: Surface) -> Verdict:
        return comes_back(code, surface)

    def unique(surface: Surface) -> Verdict:
        return no_other_bits(code, surface)

    def promised(surface: Surface) -> Verdict:
        return within_guarantee(code, surface)

    always: tuple[AnyLaw, ...] = (
        Law(
            f"code-round-trip-{code}",
            Clause.CODE_NAME_1,
            f"the bits of a word in `{code}` decode to the word",
            SURFACES,
            round_trip,
        ),
        Law(
            f"code-unique-{code}",
            Clause.CODE_NAME_2,
            f"a bit more or less than the bits of a word in `{code}` is rejected",
            SURFACES,
            unique,
        ),
    )
    if CODES[code].guarantee is NOTHING:
        return always
    guarantee = Law(
        f"code-guarantee-{code}",
        Clause.CODE_NAME_4,
        f"`{code}` takes at most the bits that it promises for such components",
        SURFACES,
        promised,
    )
    return (*always, guarantee)


LAWS: Final[tuple[AnyLaw, ...]] = (
    *(law for code in CodeName for law in _of_code(code)),
    *LEARNING,
    *BEST,
    *HANDLES,
    *CONTEXT,
    *TREES,
    *ENUMERATIVE,
    *GUARANTEES,
    Law(
        "implied-c",
        Clause.CODE_IMPLIED_1,
        "the word of a closed surface begins with C, and no code takes another",
        SURFACES,
        other_beginnings_rejected,
    ),
    Law(
        "records-come-back",
        Clause.CODE_HAND_3,
        "the closings of a stream and its word give the records",
        SURFACES,
        records_come_back,
    ),
    Law(
        "plain-length-by-counts",
        Clause.CODE_PLAIN_3,
        "three bits a symbol, less two for each created vertex, less one for an implied C",
        SURFACES,
        plain_length_by_counts,
    ),
    Law("plain-length", Clause.CODE_PLAIN_3, "2T − 2 bits on a sphere", SPHERES, plain_length),
    Law(
        "golden-units-of-word",
        Clause.CODE_GOLDEN_4,
        "the ideal length is 4n − 3#C + #S − #E units",
        SURFACES,
        golden_units_of_word,
    ),
    Law(
        "golden-units-of-surface",
        Clause.CODE_GOLDEN_5,
        "the ideal length is 5T/2−2+8g units, or 5T/2+3B/2−8+8g+4b with boundary",
        SURFACES,
        golden_units_of_surface,
    ),
    Law(
        "golden-real-length",
        Clause.CODE_GOLDEN_6,
        "the bits written are at most U·log2 φ + 2 + n/15000",
        SURFACES,
        golden_real_length,
    ),
    Law(
        "golden-on-spheres",
        Clause.CODE_GOLDEN_7,
        "a sphere takes at most 11T/6 bits",
        SPHERES,
        golden_on_spheres,
    ),
)
