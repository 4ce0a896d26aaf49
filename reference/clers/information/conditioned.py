"""Models by context, where the context is any function of the past; orders are one example."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from clers.information.model import Model

Q = TypeVar("Q", bound=Hashable)


@dataclass(frozen=True, slots=True)
class Conditioned(Generic[Q]):
    """A model for each context that occurred; a fresh one for the others.

    `after` costs the number of contexts that occurred. Clauses: INFO-CONTEXT-1, INFO-CONTEXT-2.
    """

    fresh: Callable[[Q], Model]
    step: Callable[[Q, int], Q]
    context: Q
    learnt: Mapping[Q, Model] = field(default_factory=dict)

    @property
    def _here(self) -> Model:
        known = self.learnt.get(self.context)
        return self.fresh(self.context) if known is None else known

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model of the present context."""
        return self._here.cumulative

    def after(self, symbol: int) -> "Conditioned[Q]":
        """The model of this context learns the symbol; the step leads to the next context."""
        learnt = {**self.learnt, self.context: self._here.after(symbol)}
        return Conditioned(self.fresh, self.step, self.step(self.context, symbol), learnt)


@dataclass(frozen=True, slots=True)
class Last:
    """The step of order k: the last k symbols, or all of fewer. Clause: INFO-CONTEXT-3."""

    order: int

    def __call__(self, context: tuple[int, ...], symbol: int) -> tuple[int, ...]:
        """The context after one more symbol."""
        longer = (*context, symbol)
        return longer[max(0, len(longer) - self.order) :]


def order_k(order: int, fresh: Callable[[tuple[int, ...]], Model]) -> Conditioned[tuple[int, ...]]:
    """The model of this order; `fresh` makes one for the last symbols. Clause: INFO-CONTEXT-3."""
    return Conditioned(fresh, Last(max(order, 0)), ())


def replayed(
    context_of: Callable[[tuple[int, ...]], Q],
    fresh: Callable[[Q], Model],
    past: tuple[int, ...],
) -> Model:
    """The model of the next symbol, from the whole past: the definition. Clause: INFO-CONTEXT-1."""
    context = context_of(past)
    model = fresh(context)
    for index, symbol in enumerate(past):
        if context_of(past[:index]) == context:
            model = model.after(symbol)
    return model
