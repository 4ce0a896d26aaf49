"""The best code: the shortest of those that learn or promise most, and a selector in front."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import floor, lgamma, log
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes import context, enumerative, golden, king_rossignac, plain
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.implied import stranger
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected

Least = Callable[[str, Shape, int], int]
"""A number of bits, from symbols, their shape, and how many of them are C."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A code, its selector, and numbers of bits that it does not go below.

    `least`: the first costs least to know, the last is the closest. They save runs of codes that
    cannot win, and change no choice.
    """

    selector: str
    code: Code
    least: tuple[Least, ...]


def _least_enumerative(symbols: str, shape: Shape, cs: int) -> int:
    """All spheres of so many faces cost the same but for rounding. Clause: CODE-ENUM-2."""
    del shape, cs
    ones = max(0, (len(symbols) + 2) // 2 - 2)
    information = (lgamma(4 * ones + 1) - lgamma(ones + 1) - lgamma(3 * ones + 1)) / log(2)
    return floor(information * 0.9999) - 1


def _cheaply_golden(symbols: str, shape: Shape, cs: int) -> int:
    """A unit for each C, and three for each other symbol. Clause: CODE-GOLDEN-1."""
    del shape
    units = 3 * len(symbols) - 2 * cs
    return floor(units * golden.UNIT * 0.9999) - 1


def _least_golden(symbols: str, shape: Shape, cs: int) -> int:
    """The units of a word without CL and CE; other words it refuses. Clause: CODE-GOLDEN-4."""
    units = 4 * len(symbols) - 3 * cs + symbols.count("S") - symbols.count("E")
    after_c = 1 if shape.head else 0  # its first symbol costs a unit less
    return floor((units - after_c) * golden.UNIT * 0.9999) - 1


def _cheaply_king_rossignac(symbols: str, shape: Shape, cs: int) -> int:
    """A bit for each C, and two for each other symbol. Clause: CODE-KR-1."""
    del shape
    return 2 * len(symbols) - cs + king_rossignac.SELECTOR


def _least_king_rossignac(symbols: str, shape: Shape, cs: int) -> int:
    """Its very length, by the pairs of symbols; words with CL or CE it refuses. CODE-KR-4."""
    del cs
    return min(king_rossignac.lengths(symbols, shape.head)) + king_rossignac.SELECTOR


def _least_plain(symbols: str, shape: Shape, cs: int) -> int:
    """Its very length. Clause: CODE-PLAIN-1."""
    del shape
    return 3 * len(symbols) - 2 * cs


CANDIDATES: Final = (
    Candidate("0", context.CODE, ()),
    Candidate("100", enumerative.CODE, (_least_enumerative,)),
    Candidate("101", golden.CODE, (_cheaply_golden, _least_golden)),
    Candidate("110", king_rossignac.CODE, (_cheaply_king_rossignac, _least_king_rossignac)),
    Candidate("111", plain.CODE, (_least_plain,)),
)
"""In the order in which ties are decided. Clause: CODE-BEST-1."""

LONGEST: Final = max(len(candidate.selector) for candidate in CANDIDATES)


@dataclass(frozen=True, slots=True)
class Chosen:
    """The selector of the shortest code, and the bits after it. Clause: CODE-BEST-1."""

    selector: str
    rest: Bits

    @property
    def length(self) -> int:
        """How many bits there are in all."""
        return len(self.selector) + self.rest.length

    def bits(self) -> Bits:
        """All bits."""
        return pack(map(int, self.selector)).followed_by(self.rest)


def chosen(symbols: str, shape: Shape, known: Mapping[str, Bits]) -> Chosen:
    """The shortest, where the bits of some selectors are known. Clause: CODE-BEST-1."""
    best: Chosen | None = None
    cs = symbols.count("C")
    for candidate in CANDIDATES:
        selector = candidate.selector
        bounds = (len(selector) + least(symbols, shape, cs) for least in candidate.least)
        if best is not None and any(bound >= best.length for bound in bounds):
            continue
        given = known.get(selector)
        found = candidate.code.encode(symbols, shape) if given is None else Accepted(given)
        if isinstance(found, Rejected):
            continue
        length = len(selector) + found.value.length
        if best is None or length < best.length:
            best = Chosen(selector, found.value)
    assert best is not None, "plain takes every word over the alphabet"
    return best


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The selector and the bits of the shortest code. Linear. CODE-BEST-1, CODE-BEST-3."""
    fault = stranger(symbols, Clause.CODE_BEST_1)
    if fault is not None:
        return fault
    return Accepted(chosen(symbols, shape, {}).bits())


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The symbols, if no other code would have been chosen. Linear. Clause: CODE-BEST-2."""
    digits = bits.upto(LONGEST).digits()
    candidate = next((c for c in CANDIDATES if digits.startswith(c.selector)), None)
    if candidate is None:
        detail = f"{bits.length} bits are no selector"
        return Rejected(Reason.TRUNCATED_BITS, Clause.CODE_BEST_2, detail=detail)
    rest = bits.after(len(candidate.selector))
    found = candidate.code.decode(rest, count, shape)
    if isinstance(found, Rejected):
        return found
    again = chosen(found.value, shape, {candidate.selector: rest})
    if again.selector != candidate.selector:
        detail = f"the selector {candidate.selector} is not that of the shortest code"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_BEST_2, detail=detail)
    return found


def most_symbols(bits: int) -> int:
    """The most that one of the codes can write. Clause: CODE-NAME-3."""
    return max(c.code.most_symbols(max(0, bits - len(c.selector))) for c in CANDIDATES)


def _bound(parts: tuple[Component, ...]) -> int:
    """Every promise of a candidate holds, and three bits. Clause: CODE-BEST-3."""
    promises = (
        None if bound is None else bound + len(c.selector)
        for c in CANDIDATES
        for bound in (c.code.guarantee.bits(parts),)
    )
    return min(bound for bound in promises if bound is not None)


CODE: Final = Code(
    encode,
    decode,
    most_symbols,
    Guarantee("3 bits more than the least of all guarantees", _bound),
)
"""Clauses: CODE-BEST-1, CODE-BEST-2, CODE-BEST-3."""
