"""Laws of probability, information content and entropy."""

from fractions import Fraction
from itertools import accumulate
from math import isclose, log2
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.information.given import GROUPED, MESSAGE, SMALL, TABLE, Grouped, Message, Small, Table
from clers.information.measure import bits, content, entropy, probability
from clers.information.model import Model, cumulative, differences, has_ended
from clers.information.static import Static

CLOSE: Final = 1e-9
"""How far floating-point reports may be off, as part of 1 + their size."""


def close(expected: float, got: float) -> Verdict:
    """The verdict on two reports that should agree."""
    if isclose(expected, got, rel_tol=CLOSE, abs_tol=CLOSE):
        return Holds()
    return Fails(repr(expected), repr(got), WHOLE)


def along(model: Model, symbols: tuple[int, ...]) -> tuple[Model, ...]:
    """The model at the start of a message and after each symbol."""
    return tuple(accumulate(symbols, lambda here, symbol: here.after(symbol), initial=model))


def _chain_rule(given: Message) -> Verdict:
    """Clause: INFO-CONTENT-1."""
    chance, here = Fraction(1), given.model
    for symbol in given.symbols:
        table = here.cumulative
        chance *= Fraction(table[symbol + 1] - table[symbol], table[-1])
        here = here.after(symbol)
    return every(
        same(Accepted(Fraction(1)), probability(given.model, ())),
        same(Accepted(chance), probability(given.model, given.symbols)),
    )


def _content_is_logarithm(given: Message) -> Verdict:
    """Clause: INFO-CONTENT-2."""
    chance, reported = (
        probability(given.model, given.symbols),
        content(given.model, given.symbols),
    )
    if isinstance(chance, Rejected) or isinstance(reported, Rejected):
        return Fails("a probability", f"{chance}, {reported}", WHOLE)
    return close(bits(chance.value), reported.value)


def all_messages(given: Small) -> tuple[tuple[int, ...], ...]:
    """All messages of `count` symbols, or of fewer where the model has ended."""
    open_ends: list[tuple[Model, tuple[int, ...]]] = [(given.model, ())]
    complete: list[tuple[int, ...]] = []
    for _ in range(given.count):
        longer: list[tuple[Model, tuple[int, ...]]] = []
        for model, symbols in open_ends:
            if has_ended(model):
                complete.append(symbols)
            for symbol, frequency in enumerate(differences(model.cumulative)):
                if frequency > 0:
                    longer.append((model.after(symbol), (*symbols, symbol)))
        open_ends = longer
    return (*complete, *(symbols for _, symbols in open_ends))


def _probabilities_sum_to_one(given: Small) -> Verdict:
    """Clause: INFO-CONTENT-3."""
    total = Fraction(0)
    for symbols in all_messages(given):
        chance = probability(given.model, symbols)
        if isinstance(chance, Rejected):
            return Fails("a probability", repr(chance), WHOLE)
        total += chance.value
    return same(Fraction(1), total)


def _entropy_is_mean_content(given: Table) -> Verdict:
    """Clause: INFO-ENTROPY-1."""
    total = sum(given.frequencies)
    mean = sum(float(Fraction(f, total)) * log2(total / f) for f in given.frequencies if f > 0)
    return close(mean, entropy(given.frequencies))


def _entropy_between_bounds(given: Table) -> Verdict:
    """Clause: INFO-ENTROPY-2."""
    positive = [f for f in given.frequencies if f > 0]
    got, most = entropy(given.frequencies), log2(len(positive))
    verdicts = [at_most(got + CLOSE, 0.0, "0"), at_most(most + CLOSE, got, "entropy")]
    if len(set(positive)) == 1:
        verdicts.append(close(most, got))
    return every(*verdicts)


def _own_counts_cost_least(given: Message) -> Verdict:
    """Clause: INFO-ENTROPY-3."""
    size = max(given.symbols, default=0) + 1
    if size > 1 << 10:
        return Holds()  # counting is for small alphabets
    counts = [given.symbols.count(symbol) for symbol in range(size)]
    least = len(given.symbols) * entropy(counts)
    own = content(Static(cumulative(counts)), given.symbols)
    if isinstance(own, Rejected):
        return Fails("a content", own.line(), WHOLE)
    other = content(Static(given.model.cumulative), given.symbols)
    if isinstance(other, Rejected):
        return close(least, own.value)  # that table knows not all of these symbols
    return every(close(least, own.value), at_most(other.value + CLOSE, least, "n·H"))


def _entropy_of_two_steps(given: Grouped) -> Verdict:
    """Clause: INFO-ENTROPY-4."""
    members: dict[int, list[int]] = {}
    for frequency, group in zip(given.frequencies, given.groups, strict=True):
        members.setdefault(group, []).append(frequency)
    total = sum(given.frequencies)
    first = entropy([sum(group) for group in members.values()])
    second = sum(sum(group) / total * entropy(group) for group in members.values())
    return close(entropy(given.frequencies), first + second)


LAWS_OF_MEASURE: Final[tuple[AnyLaw, ...]] = (
    Law(
        "probability-is-the-product",
        Clause.INFO_CONTENT_1,
        "the probability of a message is the product over its symbols; 1 of the empty one",
        MESSAGE,
        _chain_rule,
    ),
    Law(
        "content-is-the-logarithm",
        Clause.INFO_CONTENT_2,
        "the reported information content is -log2 of the exact probability",
        MESSAGE,
        _content_is_logarithm,
    ),
    Law(
        "probabilities-sum-to-one",
        Clause.INFO_CONTENT_3,
        "over all messages of n symbols, or ended sooner, the probabilities sum to 1",
        SMALL,
        _probabilities_sum_to_one,
    ),
    Law(
        "entropy-is-the-mean-content",
        Clause.INFO_ENTROPY_1,
        "the entropy of a table is the mean information content of its symbols",
        TABLE,
        _entropy_is_mean_content,
    ),
    Law(
        "entropy-lies-between-bounds",
        Clause.INFO_ENTROPY_2,
        "entropy is from 0 to log2 n, and log2 n for n equal frequencies",
        TABLE,
        _entropy_between_bounds,
    ),
    Law(
        "own-counts-cost-least",
        Clause.INFO_ENTROPY_3,
        "under its own counts a message costs n·H(counts), under no static table less",
        MESSAGE,
        _own_counts_cost_least,
    ),
    Law(
        "entropy-of-two-steps-adds",
        Clause.INFO_ENTROPY_4,
        "H is the entropy of the groups plus the mean entropy within them",
        GROUPED,
        _entropy_of_two_steps,
    ),
)
