"""Each law of contexts, learning, prediction and mixing sees a fault planted in what it judges."""

from collections.abc import Callable, Sequence
from fractions import Fraction

import pytest
from test_laws_of_codes_can_fail import fails

from clers.conventions.result import Accepted, Rejected
from clers.information import conditioned, estimator, mixed, predicted
from clers.information.adaptive import Adaptive
from clers.information.model import Model
from clers.information.static import END


def forgets_the_order(
    order: int, fresh: Callable[[tuple[int, ...]], Model]
) -> conditioned.Conditioned[tuple[int, ...]]:
    return conditioned.Conditioned(fresh, conditioned.Last(max(order - 1, 0)), ())


def adds_one(size: int) -> Accepted[Adaptive]:
    return Accepted(Adaptive(tuple(range(size + 1)), 1, 2**30))


def the_first_alone(
    parts: Sequence[Model], weights: Sequence[int], unit: int
) -> Accepted[Model] | Rejected:
    del weights, unit
    return Accepted(parts[0] if parts else END)


def test_contexts(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(conditioned, "order_k", forgets_the_order)
        assert fails("orders-replay-the-past")
    with monkeypatch.context() as planted:
        planted.setattr(conditioned, "replayed", lambda context_of, fresh, past: fresh(0))
        assert fails("contexts-replay-the-past")


def test_estimators(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(estimator, "add_half", adds_one)
        assert fails("add-half-loses-little")
    with monkeypatch.context() as planted:
        planted.setattr(estimator, "best_static", lambda counts: Fraction(2))
        assert fails("adding-one-counts-rearrangements")


def test_predictions(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(predicted, "Continued", predicted.Previous)
        assert fails("predictions-keep-the-cost")


def test_mixing(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(mixed, "mixed", the_first_alone)
        assert fails("mixing-is-rounded")
        assert fails("mixing-is-near-the-mixture")
        assert fails("bad-mixing-is-rejected")
