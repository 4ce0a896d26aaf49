"""The laws of the code `enumerative`: spheres and nothing else, and how few bits."""

from functools import partial
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits, pack
from clers.codes import enumerative
from clers.codes.closings import closings
from clers.codes.code import Code, Shape
from clers.codes.given_trees import UNIFORM
from clers.codes.tree_word import tree_word
from clers.complexes.given import SPHERES, SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream

CLOSED: Final = Shape("C")


def _after_c(surface: Surface) -> str:
    """What is coded of a sphere's word."""
    return encode(surface).stream.word[1:]


def decodes(code: Code, surface: Surface) -> Verdict:
    """The bits come back as the word, and the number of symbols is believed."""
    word = _after_c(surface)
    match code.encode(word, CLOSED):
        case Accepted(bits):
            return every(
                same(Accepted(word), code.decode(bits, len(word), CLOSED)),
                at_most(code.most_symbols(bits.length), 1 + len(word), "symbols"),
            )
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), rejected.where)


def other_bits(code: Code, surface: Surface) -> Verdict:
    """Bits with a change are never other bits of the same word."""
    word = _after_c(surface)
    match code.encode(word, CLOSED):
        case Accepted(bits):
            return every(*(another(code, word, other) for other in damaged(bits)))
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), rejected.where)


def damaged(bits: Bits) -> tuple[Bits, ...]:
    """Bits with one changed, one more, or one less."""
    values = bits.values()
    changed = (
        pack(1 - bit if i == at else bit for i, bit in enumerate(values))
        for at in range(0, len(values), 1 + len(values) // 16)
    )
    return (*changed, bits.followed_by(pack([0])), bits.followed_by(pack([1])), pack(values[:-1]))


def another(code: Code, word: str, bits: Bits) -> Verdict:
    """Bits that are not the word's are those of another word, or of none."""
    match code.decode(bits, len(word), CLOSED):
        case Accepted(found):
            return every(
                same(Accepted(bits), code.encode(found, CLOSED)), same(True, found != word)
            )
        case Rejected():
            return Holds()


def short(code: Code, surface: Surface) -> Verdict:
    """No sphere takes more than is promised."""
    bound = code.guarantee.bits(components(surface))
    match code.encode(_after_c(surface), CLOSED):
        case Accepted(bits) if bound is not None:
            return at_most(bound, bits.length, "bits")
        case result:
            return Fails("a bound, and bits", repr((bound, result)), WHOLE)


def nothing_else(code: Code, surface: Surface) -> Verdict:
    """What is not one sphere is refused, and nothing is promised for it."""
    parts = components(surface)
    if [(part.genus, part.curves) for part in parts] == [(0, 0)]:
        return Holds()
    stream = encode(surface).stream
    head = "" if stream.components_with_boundary else "C"
    seen = closings(stream)
    if isinstance(seen, Rejected):
        return Fails("closings", seen.line(), seen.where)
    match code.encode(stream.word[len(head) :], Shape(head, seen.value)):
        case Rejected(reason):
            return same((Reason.NOT_REPRESENTABLE, None), (reason, code.guarantee.bits(parts)))
        case Accepted(bits):
            return Fails("a rejection", bits.digits(), WHOLE)


def by_the_urn(code: Code, surface: Surface) -> Verdict:
    """The bits are those of the coder of chapter 2 with the urn as its model."""
    word = _after_c(surface)
    match decode(Stream(f"C{word}")):
        case Accepted(sphere):
            coded = tree_word(sphere)[len(enumerative.FRONT) : -len(enumerative.BACK)]
            expected = coder.encode(enumerative.urn(sphere.vertices), coded)
            return same(expected, code.encode(word, CLOSED))
        case Rejected() as rejected:
            return Fails("a sphere", rejected.line(), rejected.where)


def laws_of(code: Code) -> tuple[AnyLaw, ...]:
    """The laws, of this code."""
    return (
        Law(
            "enumerative-decodes",
            Clause.CODE_ENUM_2,
            "the bits of a sphere's word decode to the word",
            SPHERES,
            partial(decodes, code),
        ),
        Law(
            "enumerative-by-the-urn",
            Clause.CODE_ENUM_2,
            "the bits are the tree word's by the urn, without the bits that are known",
            SPHERES,
            partial(by_the_urn, code),
        ),
        Law(
            "enumerative-other-bits",
            Clause.CODE_ENUM_3,
            "other bits are rejected or decode to a word that they are the bits of",
            UNIFORM,
            partial(other_bits, code),
        ),
        Law(
            "enumerative-length",
            Clause.CODE_ENUM_4,
            "a sphere takes at most 1.622557·T − 4.49 bits",
            UNIFORM,
            partial(short, code),
        ),
        Law(
            "enumerative-spheres-only",
            Clause.CODE_ENUM_1,
            "what is not one sphere is not representable",
            SURFACES,
            partial(nothing_else, code),
        ),
    )


LAWS: Final[tuple[AnyLaw, ...]] = laws_of(enumerative.CODE)
