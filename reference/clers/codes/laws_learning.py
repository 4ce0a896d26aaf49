"""The laws of the codes that learn: what they are by definition, and what learning costs."""

from fractions import Fraction
from math import log2
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes import adaptive, huffman, plain
from clers.codes.code import Shape
from clers.codes.implied import NUMBER, implied
from clers.complexes.given import SURFACES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface
from clers.information.conditioned import Conditioned, Last
from clers.information.estimator import best_static, worst_ratio

ORDERS: Final = (1, 3, 6)
"""Clause: CODE-ADAPTIVE-1."""


def _parts(surface: Surface) -> tuple[str, str]:
    """The implied head of a surface's word, and the rest."""
    stream = encode_surface(surface).stream
    head = implied(stream.components_with_boundary)
    return head, stream.word[len(head) :]


def _bits(order: int, surface: Surface) -> Bits:
    head, rest = _parts(surface)
    match adaptive.encode(order, rest, head):
        case Accepted(bits):
            return bits
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def adaptive_by_definition(surface: Surface) -> Verdict:
    """The bits are those of the model of order k of chapter 1."""
    head, rest = _parts(surface)
    start, numbers = tuple(NUMBER[x] for x in head), [NUMBER[x] for x in rest]
    return every(
        *(
            same(
                coder.encode(Conditioned(adaptive.fresh, Last(k), start), numbers),
                Accepted(_bits(k, surface)),
            )
            for k in ORDERS
        )
    )


def _learnt(order: int, head: str, rest: str) -> float:
    """The bits of the best fixed tables and of what learning may cost. CODE-ADAPTIVE-2."""
    counts: dict[str, dict[str, int]] = {}
    word = head + rest
    for i in range(len(head), len(word)):
        here = counts.setdefault(word[max(0, i - order) : i], {})
        here[word[i]] = here.get(word[i], 0) + 1
    total = 0.0
    for context, found in counts.items():
        times = tuple(found.values())
        size = 3 if context.endswith("C") else 5
        total += _log2(worst_ratio(size, sum(times))) - _log2(best_static(times))
    return total


def _log2(ratio: Fraction) -> float:
    """Of fractions whose parts are beyond the range of a double too."""
    return log2(ratio.numerator) - log2(ratio.denominator)


def adaptive_learns(surface: Surface) -> Verdict:
    """Not much more bits than the best fixed tables would need, whatever the word."""
    head, rest = _parts(surface)
    return every(
        *(
            at_most(
                _learnt(k, head, rest) + 2 + len(rest) / 15000, _bits(k, surface).length, "bits"
            )
            for k in ORDERS
        )
    )


def huffman_within_plain(surface: Surface) -> Verdict:
    """At most fifteen bits more than the plain code."""
    head, rest = _parts(surface)
    found, other = huffman.encode(rest, Shape(head)), plain.encode(rest)
    if isinstance(found, Rejected) or isinstance(other, Rejected):
        return Fails("bits in both", "a rejection", WHOLE)
    return at_most(other.value.length + 15, found.value.length, "bits")


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "huffman-within-plain",
        Clause.CODE_HUFFMAN_4,
        "Huffman's code of a word is at most 15 bits longer than plain",
        SURFACES,
        huffman_within_plain,
    ),
    Law(
        "adaptive-definition",
        Clause.CODE_ADAPTIVE_1,
        "the bits are those of chapter 1's model of order k",
        SURFACES,
        adaptive_by_definition,
    ),
    Law(
        "adaptive-learns",
        Clause.CODE_ADAPTIVE_2,
        "learning costs no more than the add-half redundancy of each context",
        SURFACES,
        adaptive_learns,
    ),
)
