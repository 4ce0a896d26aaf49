"""Laws of contexts, of what learning costs, of prediction and of mixing."""

from fractions import Fraction
from math import comb, factorial
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information import conditioned, estimator, mixed, predicted
from clers.information.adaptive import Adaptive
from clers.information.given_learning import (
    ANY_MIX,
    CONDITIONING,
    COUNTED,
    MIXING,
    RESIDUALS,
    Conditioning,
    Counted,
    Mixing,
    MixRequest,
    Residuals,
)
from clers.information.laws_measure import along
from clers.information.measure import probability
from clers.information.model import Model, differences, has_ended


def _tables(model: Model, symbols: tuple[int, ...]) -> list[tuple[int, ...]]:
    return [differences(here.cumulative) for here in along(model, symbols)]


def _orders_replay_the_past(given: Conditioning) -> Verdict:
    """Clauses: INFO-CONTEXT-1, INFO-CONTEXT-3."""

    def fresh(last: tuple[int, ...]) -> Model:
        return given.fresh[sum(last) % len(given.fresh)]

    def last(past: tuple[int, ...]) -> tuple[int, ...]:
        return past[::-1][: max(given.order, 0)][::-1]

    pasts = [given.symbols[:n] for n in range(len(given.symbols) + 1)]
    expected = [differences(conditioned.replayed(last, fresh, p).cumulative) for p in pasts]
    return same(expected, _tables(conditioned.order_k(given.order, fresh), given.symbols))


def _contexts_replay_the_past(given: Conditioning) -> Verdict:
    """Clauses: INFO-CONTEXT-1, INFO-CONTEXT-2: the context is a sum, whose period is the order."""
    period = abs(given.order) + 1

    def fresh(context: int) -> Model:
        return given.fresh[context % len(given.fresh)]

    def context_of(past: tuple[int, ...]) -> int:
        return (1 + sum(past)) % period

    pasts = [given.symbols[:n] for n in range(len(given.symbols) + 1)]
    expected = [differences(conditioned.replayed(context_of, fresh, p).cumulative) for p in pasts]
    stepped = conditioned.Conditioned(fresh, lambda q, s: (q + s) % period, 1 % period)
    return same(expected, _tables(stepped, given.symbols))


def _counts(given: Counted) -> tuple[int, ...]:
    return tuple(given.symbols.count(symbol) for symbol in range(given.size))


def _add_half_loses_little(given: Counted) -> Verdict:
    """Clauses: INFO-LEARN-1, INFO-LEARN-2, INFO-LEARN-3."""
    made = estimator.add_half(given.size)
    if isinstance(made, Rejected):
        return Fails("a model", made.line(), WHOLE)
    found = probability(made.value, given.symbols)
    if isinstance(found, Rejected):
        return Fails("a probability", found.line(), WHOLE)
    counts, count = _counts(given), len(given.symbols)
    worst = estimator.worst_ratio(given.size, count)
    best = Fraction(1)
    for symbol in given.symbols:
        best *= Fraction(counts[symbol], count)
    loss = best / found.value
    repeated = len(set(given.symbols)) <= 1
    return every(
        same(best, estimator.best_static(counts)),
        same((True, repeated), (loss <= worst, loss == worst)),
        same(True, count == 0 or worst**2 <= given.size**2 * count ** (given.size - 1)),
    )


def _adding_one_counts_rearrangements(given: Counted) -> Verdict:
    """Clause: INFO-LEARN-4."""
    start = Adaptive(tuple(range(given.size + 1)), 1, 2**30)
    counts, count = _counts(given), len(given.symbols)
    rearrangements = factorial(count)
    for each in counts:
        rearrangements //= factorial(each)
    splits = comb(count + given.size - 1, given.size - 1)
    return every(
        same(
            Accepted(Fraction(1, rearrangements * splits)),
            probability(start, given.symbols),
        ),
        same(True, estimator.best_static(counts) * rearrangements <= 1),
    )


def _predictions_keep_the_cost(given: Residuals) -> Verdict:
    """Clauses: INFO-PREDICT-1, INFO-PREDICT-2, INFO-PREDICT-3."""
    verdicts: list[Verdict] = []
    predictors: tuple[predicted.Predictor, ...] = (predicted.Previous(), predicted.Continued())
    for slope, predictor in enumerate(predictors):
        here: Model = given.model
        symbols: list[int] = []
        past = (0, 0)
        for residual in given.symbols:
            size = len(here.cumulative) - 1
            guess = past[1] + slope * (past[1] - past[0])
            symbols.append((guess + residual) % size)
            past = past[1], symbols[-1]
            here = here.after(residual)
        whole: Model = predicted.Predicted(given.model, predictor)
        ended = [has_ended(m) for m in along(given.model, given.symbols)]
        verdicts += [
            same(probability(given.model, given.symbols), probability(whole, symbols)),
            same(ended, [has_ended(m) for m in along(whole, tuple(symbols))]),
        ]
    return every(*verdicts)


def _mixing_is_rounded(given: Mixing) -> Verdict:
    """Clauses: INFO-MIX-2, INFO-MIX-3, step by step in fractions."""
    made = mixed.mixed(given.parts, given.weights, given.unit)
    if isinstance(made, Rejected):
        return Fails("a model", made.line(), WHOLE)
    here = made.value
    parts = list(zip(given.parts, given.weights, strict=True))
    for index, symbol in enumerate(given.symbols):
        parts = [(part, weight) for part, weight in parts if not has_ended(part)]
        whole = sum(weight for _, weight in parts)
        rows = [(w, differences(part.cumulative)) for part, w in parts]
        size = max(len(row) for _, row in rows)
        means = [
            sum(
                (Fraction(w * row[s], whole * sum(row)) for w, row in rows if s < len(row)),
                Fraction(0),
            )
            for s in range(size)
        ]
        table = tuple(int(given.unit * mean) + 1 if mean > 0 else 0 for mean in means)
        verdict = same(table, differences(here.cumulative), AtSymbol(index))
        if isinstance(verdict, Fails):
            return verdict
        shares = [
            Fraction(w * row[symbol], whole * sum(row)) / means[symbol] if symbol < len(row) else 0
            for w, row in rows
        ]
        parts = [
            (part.after(symbol), int(given.unit * share) + 1)
            for (part, _), share in zip(parts, shares, strict=True)
            if share > 0
        ]
        here = here.after(symbol)
    return same(all(has_ended(part) for part, _ in parts), has_ended(here))


def _mixing_is_near_the_mixture(given: Mixing) -> Verdict:
    """Clauses: INFO-MIX-1, INFO-MIX-4."""
    made = mixed.mixed(given.parts, given.weights, given.unit)
    if isinstance(made, Rejected):
        return Fails("a model", made.line(), WHOLE)
    found = probability(made.value, given.symbols)
    if isinstance(found, Rejected):
        return Fails("a probability", found.line(), WHOLE)
    exact = Fraction(0)
    for part, weight in zip(given.parts, given.weights, strict=True):
        chance = probability(part, given.symbols)
        exact += Fraction(weight, sum(given.weights)) * (
            chance.value if isinstance(chance, Accepted) else 0
        )
    wide = max(len(m.cumulative) - 1 for m in along(made.value, given.symbols))
    once = (1 + Fraction(wide, given.unit)) * (1 + Fraction(len(given.parts), given.unit))
    return every(
        same(exact, mixed.mixture(given.parts, given.weights, given.symbols)),
        same(True, found.value * once ** len(given.symbols) >= exact),
    )


def _bad_mixing_is_rejected(given: MixRequest) -> Verdict:
    """Clause: INFO-MIX-5."""
    got = mixed.mixed(given.parts, given.weights, given.unit)
    low = [index for index, weight in enumerate(given.weights) if weight < 1]
    good = len(given.parts) == len(given.weights) > 0 and sum(given.weights) <= 2**30
    if not low and good and 1 <= given.unit <= 2**29:
        return Holds() if isinstance(got, Accepted) else Fails("a model", got.line(), WHOLE)
    where = AtSymbol(low[0]) if low else WHOLE
    if isinstance(got, Accepted):
        return Fails("rejected", repr(got), where)
    return same((Reason.BAD_TABLE, Clause.INFO_MIX_5, where), (got.reason, got.clause, got.where))


LAWS_OF_LEARNING: Final[tuple[AnyLaw, ...]] = (
    Law(
        "orders-replay-the-past",
        Clause.INFO_CONTEXT_3,
        "order k meets the tables that its contexts of k symbols have learnt from the whole past",
        CONDITIONING,
        _orders_replay_the_past,
    ),
    Law(
        "contexts-replay-the-past",
        Clause.INFO_CONTEXT_1,
        "each context knows the symbols that followed it, and no others",
        CONDITIONING,
        _contexts_replay_the_past,
    ),
    Law(
        "add-half-loses-little",
        Clause.INFO_LEARN_2,
        "P*/P is at most the product of (m + 2j)/(1 + 2j), and that for one repeated symbol alone",
        COUNTED,
        _add_half_loses_little,
    ),
    Law(
        "adding-one-counts-rearrangements",
        Clause.INFO_LEARN_4,
        "adding 1 gives a message one part of its rearrangements times the ways to choose counts",
        COUNTED,
        _adding_one_counts_rearrangements,
    ),
    Law(
        "predictions-keep-the-cost",
        Clause.INFO_PREDICT_2,
        "a message costs what its residuals cost, and ends where they end",
        RESIDUALS,
        _predictions_keep_the_cost,
    ),
    Law(
        "mixing-is-rounded",
        Clause.INFO_MIX_2,
        "tables and weights are the means and shares in fractions, in units, rounded, plus 1",
        MIXING,
        _mixing_is_rounded,
    ),
    Law(
        "mixing-is-near-the-mixture",
        Clause.INFO_MIX_4,
        "P·(1 + k/U)^n·(1 + m/U)^n is at least the probability under the exact mixture",
        MIXING,
        _mixing_is_near_the_mixture,
    ),
    Law(
        "bad-mixing-is-rejected",
        Clause.INFO_MIX_5,
        "models are mixed exactly if parts, weights and unit are good",
        ANY_MIX,
        _bad_mixing_is_rejected,
    ),
)
