"""Contexts, estimators, predictions and mixtures of a few symbols, worked out by hand."""

from fractions import Fraction

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol, Where, Whole
from clers.information.adaptive import Adaptive
from clers.information.combined import times
from clers.information.conditioned import order_k, replayed
from clers.information.estimator import add_half, best_static, worst_ratio
from clers.information.measure import probability
from clers.information.mixed import UNIT, Mixed, mixed, mixture
from clers.information.model import Model, cumulative, differences, has_ended
from clers.information.predicted import Continued, Predicted, Previous
from clers.information.static import END, Static


def counting(_: tuple[int, ...]) -> Model:
    """Two symbols, each once, and one more for each that is seen."""
    return Adaptive((0, 1, 2), 1, 1 << 16)


def test_order_one_learns_an_alternation() -> None:
    """INFO-CONTEXT-3. 010101: 1/2 in each of three contexts, then 2/3, 2/3, 3/4."""
    word = (0, 1, 0, 1, 0, 1)
    assert probability(order_k(1, counting), word) == Accepted(Fraction(1, 24))
    # Order 0 counts both alike: 1/2 · 1/3 · 2/4 · 2/5 · 3/6 · 3/7.
    assert probability(order_k(0, counting), word) == Accepted(Fraction(1, 140))
    assert probability(order_k(-5, counting), word) == Accepted(Fraction(1, 140))


def test_contexts_of_order_two() -> None:
    """INFO-CONTEXT-3: the fresh model is asked for the last two symbols, or fewer."""
    asked: list[tuple[int, ...]] = []

    def fresh(last: tuple[int, ...]) -> Model:
        asked.append(last)
        return Static((0, 1, 2))

    here: Model = order_k(2, fresh)
    for symbol in (1, 0, 0):
        here = here.after(symbol)
    assert asked == [(), (1,), (1, 0)]
    assert here.cumulative == (0, 1, 2)
    assert asked[3:] == [(0, 0)]


def test_replay_by_parity() -> None:
    """INFO-CONTEXT-1, INFO-CONTEXT-2: of 0, 1, 1, 0 the even places have 0, 1."""
    model = replayed(lambda past: len(past) % 2, lambda _: counting(()), (0, 1, 1, 0))
    assert differences(model.cumulative) == (2, 2)
    model = replayed(lambda past: len(past) % 2, lambda _: counting(()), (0, 1, 1))
    assert differences(model.cumulative) == (1, 2)


def test_add_half() -> None:
    """INFO-LEARN-1, INFO-LEARN-2: 00 costs 1/2 · 3/4; 01 costs 1/2 · 1/4."""
    made = add_half(2)
    assert made == Accepted(Adaptive((0, 1, 2), 2, 2**30))
    assert isinstance(made, Accepted)
    assert probability(made.value, (0, 0)) == Accepted(Fraction(3, 8))
    assert probability(made.value, (0, 1)) == Accepted(Fraction(1, 8))
    assert worst_ratio(2, 2) == Fraction(8, 3)
    assert worst_ratio(7, 0) == worst_ratio(1, 9) == 1
    assert best_static((2, 0)) == best_static(()) == best_static((0,)) == 1
    assert best_static((1, 2)) == Fraction(4, 27)


@pytest.mark.parametrize("size", [0, -1])
def test_sizes_that_cannot_be_learnt(size: int) -> None:
    """INFO-LEARN-1."""
    got = add_half(size)
    assert isinstance(got, Rejected)
    assert got.reason == Reason.BAD_TABLE


def test_the_worst_of_all_short_messages() -> None:
    """INFO-LEARN-2, INFO-LEARN-3: over all counts of up to twelve of up to four symbols."""
    for size in range(1, 5):
        made = add_half(size)
        assert isinstance(made, Accepted)
        for count in range(1, 13):
            seen = []
            for counts in splits(count, size):
                word = tuple(s for s, n in enumerate(counts) for _ in range(n))
                found = probability(made.value, word)
                assert isinstance(found, Accepted)
                seen.append(best_static(counts) / found.value)
            assert max(seen) == worst_ratio(size, count)
            assert seen.count(max(seen)) == size
            assert max(seen) ** 2 <= size**2 * count ** (size - 1)


def splits(total: int, parts: int) -> list[tuple[int, ...]]:
    """All ways to write a number as a sum of so many, in order."""
    if parts == 1:
        return [(total,)]
    return [(n, *rest) for n in range(total + 1) for rest in splits(total - n, parts - 1)]


def test_a_prediction_turns_the_table() -> None:
    """INFO-PREDICT-1: residuals 0, 1, 2, 3 of the guess 2 are the symbols 2, 3, 0, 1."""
    residuals = Static(cumulative((5, 1, 2, 3)))
    assert differences(Predicted(residuals, Previous(2)).cumulative) == (2, 3, 5, 1)
    assert differences(Predicted(residuals, Previous(-2)).cumulative) == (2, 3, 5, 1)
    assert differences(Predicted(residuals, Previous()).cumulative) == (5, 1, 2, 3)
    assert has_ended(Predicted(END, Previous(3)))


def test_a_ramp_is_continued() -> None:
    """INFO-PREDICT-3. 0 1 2 3 0 1 of four symbols has the residuals 0 1 0 0 0 0."""
    model = Predicted(Static(cumulative((5, 1, 1, 1))), Continued())
    assert probability(model, (0, 1, 2, 3, 0, 1)) == Accepted(Fraction(5**5, 8**6))
    model = Predicted(Static(cumulative((1, 5, 1, 1))), Previous())
    assert probability(model, (1, 2, 3, 0, 1, 1)) == Accepted(Fraction(5**5, 8**6))


def test_residuals_are_learnt() -> None:
    """INFO-PREDICT-1. After 2, guessed 0, residual 2 is known better; guessed from 2 it is 1."""
    model = Predicted(Adaptive((0, 1, 2, 3), 4, 1 << 16), Previous()).after(2)
    assert differences(model.residuals.cumulative) == (1, 1, 5)
    assert differences(model.cumulative) == (1, 5, 1)
    assert differences(model.after(1).cumulative) == (9, 1, 1)


def test_right_predictions_cost_a_logarithm() -> None:
    """INFO-PREDICT-2, INFO-LEARN-4; 3(c), Prediction: n right guesses cost log2(n+1)."""
    model = Predicted(counting(()), Previous())
    for count in (1, 10, 500):
        assert probability(model, (0,) * count) == Accepted(Fraction(1, count + 1))


def test_mixing_by_hand() -> None:
    """INFO-MIX-1, INFO-MIX-2, INFO-MIX-3. Eighths of 1/2, 1/2; of 1/4, 3/4; of 3/5, 2/5."""
    low, high = Static((0, 1, 4)), Static((0, 3, 4))
    made = mixed((low, high), (1, 1), 8)
    assert made == Accepted(Mixed((low, high), (1, 1), 8))
    assert isinstance(made, Accepted)
    assert differences(made.value.cumulative) == (5, 5)
    after = made.value.after(0)
    assert after == Mixed((low, high), (3, 7), 8)
    assert differences(after.cumulative) == (5, 4)
    assert mixture((low, high), (1, 3), (0, 0)) == Fraction(1, 4) * Fraction(1, 16) + Fraction(
        3, 4
    ) * Fraction(9, 16)


def test_parts_are_left_out() -> None:
    """INFO-MIX-3: one that has not the symbol, and one that has ended."""
    lone, coin = Static((0, 1)), Static((0, 1, 2))
    made = mixed((lone, coin, times(coin, 1), END), (2, 1, 1, 5), 8)
    assert isinstance(made, Accepted)
    assert made.value == Mixed((lone, coin, times(coin, 1)), (2, 1, 1), 8)
    assert differences(made.value.cumulative) == (7, 3)
    assert made.value.after(1) == Mixed((coin,), (5,), 8)
    assert made.value.after(0) == Mixed((lone, coin), (6, 2), 8)
    assert mixed((END,), (1,)) == Accepted(END)
    ending = mixed((times(coin, 1),), (1,))
    assert ending == Accepted(Mixed((times(coin, 1),), (1,), UNIT))
    assert isinstance(ending, Accepted)
    assert ending.value.after(1) == END
    assert mixture((lone, coin), (1, 1), (1,)) == Fraction(1, 4)


@pytest.mark.parametrize(
    ("parts", "weights", "unit", "where"),
    [
        (0, (), 8, Whole()),
        (1, (1, 1), 8, Whole()),
        (2, (1, 0), 8, AtSymbol(1)),
        (2, (0, -1), 0, AtSymbol(0)),
        (2, (2**30, 1), 8, Whole()),
        (1, (1,), 0, Whole()),
        (1, (1,), 2**29 + 1, Whole()),
    ],
)
def test_bad_mixings(parts: int, weights: tuple[int, ...], unit: int, where: Where) -> None:
    """INFO-MIX-5."""
    got = mixed((END,) * parts, weights, unit)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (Reason.BAD_TABLE, Clause.INFO_MIX_5, where)
    assert isinstance(mixed((END, END), (2**30 - 1, 1), 2**29), Accepted)
    assert isinstance(mixed((END,), (1,), 1), Accepted)


def test_the_unit_that_costs_little() -> None:
    """INFO-MIX-4: 17/65536 of log2 e."""
    assert UNIT == 65536
