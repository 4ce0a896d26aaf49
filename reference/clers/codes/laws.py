"""The laws of chapter 6: lengths that are known before a bit is written."""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes import golden
from clers.codes.implied import implied
from clers.codes.registry import CodeName, decode, encode, most_symbols
from clers.complexes.given import SPHERES, SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.stream import Stream


def bits_of(code: CodeName, stream: Stream) -> Bits:
    """The bits of a surface's stream; a code that refuses one is broken."""
    match encode(code, stream):
        case Accepted(bits):
            return bits
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def comes_back(code: CodeName, surface: Surface) -> Verdict:
    """The bits of a word decode to the word, and the count of symbols is believed."""
    stream = encode_surface(surface).stream
    bits = bits_of(code, stream)
    match decode(code, bits, len(stream.word), stream.components_with_boundary):
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
    bits = bits_of(code, stream)
    longer = (bits.followed_by(pack([0])), bits.followed_by(pack([1])))
    shorter = (pack(bits.values()[:-1]),) if bits.length else ()
    for other in (*longer, *shorter):
        found = decode(code, other, len(stream.word), stream.components_with_boundary)
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


def plain_length(surface: Surface) -> Verdict:
    """2T − 2 bits."""
    length = bits_of(CodeName.PLAIN, encode_surface(surface).stream).length
    return same(2 * surface.faces - 2, length)


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

    return (
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


LAWS: Final[tuple[AnyLaw, ...]] = (
    *(law for code in CodeName for law in _of_code(code)),
    Law(
        "implied-c",
        Clause.CODE_IMPLIED_1,
        "the word of a closed surface begins with C, and no code takes another",
        SURFACES,
        other_beginnings_rejected,
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
