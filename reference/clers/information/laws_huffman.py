"""Laws of Huffman's code, against every choice of lengths; and of coding by a wrong table."""

from functools import cache
from itertools import product
from math import inf, log
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.information import canonical, divergence, huffman, measure, prefix
from clers.information.given import TABLE, Table
from clers.information.given_codes import (
    FEW,
    GROUPED_PAIR,
    PAIR,
    Few,
    GroupedPair,
    Pair,
)
from clers.information.laws_measure import CLOSE, close
from clers.information.model import cumulative
from clers.information.static import Static


@cache
def _kraft_vectors(size: int) -> tuple[tuple[int, ...], ...]:
    """All lengths below `size`, or 0, of so many words, that satisfy Kraft's inequality."""
    most = max(size - 1, 0)
    return tuple(
        lengths
        for lengths in product(range(most + 1), repeat=size)
        if sum(1 << most - length for length in lengths) <= 1 << most
    )


def _huffman_is_optimal(given: Few) -> Verdict:
    """Clause: INFO-HUFFMAN-3. A longer word than k - 1 is never of use to k symbols."""
    got = huffman.huffman_lengths(given.frequencies)
    positive = [f for f in given.frequencies if f > 0]
    if isinstance(got, Rejected):
        return Fails("lengths", got.line(), WHOLE)
    lengths = [n for n, f in zip(got.value, given.frequencies, strict=True) if n is not None and f]

    def cost(choice: tuple[int, ...]) -> tuple[int, int]:
        return sum(f * n for f, n in zip(positive, choice, strict=True)), max(choice)

    return same(min(map(cost, _kraft_vectors(len(positive)))), cost(tuple(lengths)))


def _huffman_is_canonical(given: Table) -> Verdict:
    """Clauses: INFO-HUFFMAN-1, INFO-HUFFMAN-2."""
    expected = huffman.by_merging(given.frequencies)
    return every(
        same(Accepted(expected), huffman.huffman_lengths(given.frequencies)),
        same(canonical.canonical(expected), huffman.huffman(given.frequencies)),
    )


def _huffman_loses_less_than_a_bit(given: Few) -> Verdict:
    """Clause: INFO-HUFFMAN-4, as inequalities of integers: 2^(T·H) = T^T / Π f^f."""
    got = huffman.huffman_lengths(given.frequencies)
    if isinstance(got, Rejected):
        return Fails("lengths", got.line(), WHOLE)
    total, powers, length, dyadic = sum(given.frequencies), 1, 0, True
    for f, n in zip(given.frequencies, got.value, strict=True):
        powers *= f**f
        length += f * (n or 0)
        dyadic = dyadic and (f == 0 or (total % f == 0 and (total // f).bit_count() == 1))
    most = total**total
    return every(
        same(True, most <= powers << length),
        same(True, powers << length < most << total),
        same(dyadic, most == powers << length),
        same(1, prefix.kraft(got.value)),
    )


def _huffman_words_are_short(given: Table) -> Verdict:
    """Clause: INFO-HUFFMAN-5."""
    got = huffman.huffman_lengths(given.frequencies)
    if isinstance(got, Rejected):
        return Fails("lengths", got.line(), WHOLE)
    return at_most(42, max(n for n in got.value if n is not None), "length")


def _entropy_is_continuous(given: Pair) -> Verdict:
    """Clause: INFO-ENTROPY-5."""
    size = max(len(given.one), len(given.other))
    apart = divergence.distance(given.one, given.other)
    change = abs(measure.entropy(given.one) - measure.entropy(given.other))
    even, lone = (1,) * size, (0,) * (size - 1) + (1,)
    far = divergence.modulus(size, divergence.distance(even, lone))
    return every(
        at_most(divergence.modulus(size, apart) + CLOSE, change, "change of entropy"),
        same(divergence.distance(given.other, given.one), apart),
        same(True, 0 <= apart <= 1),
        close(measure.entropy(even), far),
    )


def _cross_entropy_is_mean_content(given: Pair) -> Verdict:
    """Clause: INFO-CROSS-1: a message with counts that are those of the first table, cut down."""
    counts = [min(f, 9) for f in given.one]
    symbols = [s for s, n in enumerate(counts) for _ in range(n)]
    bits = measure.content(Static(cumulative(given.other)), symbols)
    got = divergence.cross_entropy(counts, given.other)
    if isinstance(bits, Rejected):
        return same(inf, got)
    return close(bits.value, sum(counts) * got)


def _redundancy_is_not_negative(given: Pair) -> Verdict:
    """Clause: INFO-CROSS-2."""
    lost = divergence.redundancy(given.one, given.other)
    apart = float(divergence.distance(given.one, given.other))
    return every(
        at_most(lost + CLOSE, 2 / log(2) * apart**2, "2·t²/ln 2"),
        close(0.0, divergence.redundancy(given.one, [3 * f for f in given.one])),
    )


def _redundancy_of_two_steps(given: GroupedPair) -> Verdict:
    """Clause: INFO-CROSS-3."""
    one: dict[int, list[int]] = {}
    other: dict[int, list[int]] = {}
    for f, g, group in zip(given.one, given.other, given.groups, strict=True):
        one.setdefault(group, []).append(f)
        other.setdefault(group, []).append(g)
    whole = divergence.redundancy(given.one, given.other)
    if whole == inf:
        return Holds()
    total = sum(given.one)
    first = divergence.redundancy([sum(f) for f in one.values()], [sum(g) for g in other.values()])
    second = sum(
        sum(f) / total * divergence.redundancy(f, other[group])
        for group, f in one.items()
        if sum(f) > 0
    )
    return close(whole, first + second)


LAWS_OF_HUFFMAN: Final[tuple[AnyLaw, ...]] = (
    Law(
        "entropy-is-continuous",
        Clause.INFO_ENTROPY_5,
        "entropies differ by t·log2(n - 1) + h(t) at most, and even and certain tables by that",
        PAIR,
        _entropy_is_continuous,
    ),
    Law(
        "cross-entropy-is-the-mean-content",
        Clause.INFO_CROSS_1,
        "a message of given counts costs their cross-entropy for each symbol, or cannot be said",
        PAIR,
        _cross_entropy_is_mean_content,
    ),
    Law(
        "redundancy-is-not-negative",
        Clause.INFO_CROSS_2,
        "coding by another table loses 2·t²/ln 2 bits a symbol at least, by the same table none",
        PAIR,
        _redundancy_is_not_negative,
    ),
    Law(
        "redundancy-of-two-steps-adds",
        Clause.INFO_CROSS_3,
        "redundancy is that of the groups plus the mean redundancy within them",
        GROUPED_PAIR,
        _redundancy_of_two_steps,
    ),
    Law(
        "huffman-is-optimal",
        Clause.INFO_HUFFMAN_3,
        "no lengths that have a code have a smaller mean, nor then a smaller greatest length",
        FEW,
        _huffman_is_optimal,
    ),
    Law(
        "huffman-is-canonical",
        Clause.INFO_HUFFMAN_2,
        "heap and sorted list give the same lengths, and the code is the canonical one of them",
        TABLE,
        _huffman_is_canonical,
    ),
    Law(
        "huffman-loses-less-than-a-bit",
        Clause.INFO_HUFFMAN_4,
        "T·H ≤ Σ f·l < T·(H + 1) in integers, equal on the left only for powers of 2",
        FEW,
        _huffman_loses_less_than_a_bit,
    ),
    Law(
        "huffman-words-are-short",
        Clause.INFO_HUFFMAN_5,
        "with totals up to 2^30 no word has more than 42 digits",
        TABLE,
        _huffman_words_are_short,
    ),
)
