"""The enumerative code: a sphere as the tree of Poulalhon and Schaeffer, the tutorial's [55].

It codes the surface and not the word: from the word the surface, from the surface its tree, from
the tree a word of bits of which a quarter are ones. These are coded like balls drawn from an urn,
so that all words with as many ones cost the same, up to what the coder rounds.
"""

from typing import Final

from clers.arithmetic.bits import Bits
from clers.arithmetic.coder import SHORTEST, ended, finished, truncated
from clers.codes.closure import sphere_of
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.tree_word import tree_word
from clers.complexes.surface import Surface
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.decode import decode as surface_of
from clers.edgebreaker.encode import encode as stream_of
from clers.edgebreaker.stream import Stream
from clers.information.enumerative import Urn
from clers.information.model import MAXIMUM_TOTAL, over_maximum
from clers.kernels.interval import Decoder, Encoder
from clers.kernels.urn import decoded, encoded

FRONT: Final = bytes((1, 0))
BACK: Final = bytes((0, 0))
"""What every tree word begins and ends with, and is not coded. Clause: CODE-ENUM-2."""


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The bits of a sphere's word. Linear. Clauses: CODE-ENUM-1, CODE-ENUM-2, CODE-ENUM-4."""
    if shape != Shape("C"):
        return _not_one("it has boundary or handles")
    return and_then(surface_of(Stream(shape.head + symbols)), _bits)


def _bits(surface: Surface) -> Accepted[Bits] | Rejected:
    spheres = surface.vertices - surface.faces // 2
    if spheres != 2:
        return _not_one("it has several components")
    ones = surface.vertices - 4
    to = Encoder()
    encoded(tree_word(surface)[len(FRONT) : -len(BACK)], 3 * ones, ones, to)
    return Accepted(finished(to))


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others. Linear. Clauses: CODE-ENUM-1 … -3."""
    if shape != Shape("C"):
        return _not_one("it has boundary or handles")
    if count < 2 or count % 2:
        return _not_one(f"no sphere has {count + 2} faces")
    sphere = and_then(_read(bits, count // 2 - 1), lambda found: sphere_of(FRONT + found + BACK))
    return and_then(sphere, lambda found: Accepted(stream_of(found).stream.word[len(shape.head) :]))


def _read(bits: Bits, ones: int) -> Accepted[bytes] | Rejected:
    """The bits of a tree word that these bits, and no others, code. CODE-ENUM-2, CODE-ENUM-3."""
    if bits.length < SHORTEST:
        return truncated(0, bits)
    if 4 * ones > MAXIMUM_TOTAL:
        return over_maximum(0, 4 * ones)
    of = Decoder(bits.data)
    found = decoded(3 * ones, ones, bits.length, of)
    if len(found) < 4 * ones:
        return truncated(len(found), bits)
    return ended(found, of, bits)


def urn(vertices: int) -> Urn:
    """What is known of the bits of a tree word that are coded. Clause: CODE-ENUM-2."""
    ones = vertices - 4
    return Urn((3 * ones, ones))


def _not_one(what: str) -> Rejected:
    return Rejected(Reason.NOT_REPRESENTABLE, Clause.CODE_ENUM_1, detail=f"no sphere: {what}")


def most_bits(parts: tuple[Component, ...]) -> int | None:
    """1.622557·T − 4.49 for one sphere, rounded down. Clause: CODE-ENUM-4."""
    match parts:
        case (Component(faces=faces, curves=0, genus=0),):
            return (1622557 * faces - 4490000) // 1000000
        case _:
            return None


def most_symbols(bits: int) -> int:
    """No sphere of more symbols has so few bits. Clause: CODE-ENUM-5."""
    return bits + 3


CODE: Final = Code(
    encode, decode, most_symbols, Guarantee("1.622557·T − 4.49 bits, spheres only", most_bits)
)
"""Clauses: CODE-ENUM-1 … CODE-ENUM-5."""
