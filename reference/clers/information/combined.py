"""Models made of models: by context, in turn, up to a stop, a number of times, one after another.

All speak of one stream of symbols, so that several sources share one message and one bit stream.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from clers.information.model import Model, has_ended
from clers.information.static import END, Static


@dataclass(frozen=True, slots=True)
class Contexts:
    """A model for each context; only the one in use learns. Clause: INFO-COMBINE-1.

    `successors[q][s]` is the context after symbol s in context q.
    """

    models: tuple[Model, ...]
    successors: tuple[tuple[int, ...], ...]
    number: int = 0

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the context in use."""
        return self.models[self.number].cumulative

    def after(self, symbol: int) -> "Contexts":
        """The model in use learns the symbol; the symbol chooses the next context."""
        q = self.number
        models = _with(self.models, q, self.models[q].after(symbol))
        return Contexts(models, self.successors, self.successors[q][symbol])


@dataclass(frozen=True, slots=True)
class Turns:
    """Symbol j belongs to model j mod k, whatever the symbols. Clause: INFO-COMBINE-2."""

    models: tuple[Model, ...]
    number: int = 0

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model whose turn it is."""
        return self.models[self.number].cumulative

    def after(self, symbol: int) -> "Turns":
        """That model learns the symbol; the next has its turn."""
        q = self.number
        models = _with(self.models, q, self.models[q].after(symbol))
        return Turns(models, (q + 1) % len(models))


@dataclass(frozen=True, slots=True)
class Until:
    """Ends after the stop symbol. Clause: INFO-COMBINE-3."""

    model: Model
    stop: int

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model within."""
        return self.model.cumulative

    def after(self, symbol: int) -> Model:
        """The end, after the stop symbol."""
        return END if symbol == self.stop else Until(self.model.after(symbol), self.stop)


@dataclass(frozen=True, slots=True)
class Times:
    """Ends after `count` ≥ 1 symbols; see `times`. Clause: INFO-COMBINE-4."""

    model: Model
    count: int

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model within."""
        return self.model.cumulative

    def after(self, symbol: int) -> Model:
        """One symbol less to come."""
        return END if self.count == 1 else Times(self.model.after(symbol), self.count - 1)


def times(model: Model, count: int) -> Model:
    """The first `count` symbols of a model; none if it is not positive. Clause: INFO-COMBINE-4."""
    return Times(model, count) if count >= 1 else END


@dataclass(frozen=True, slots=True)
class Followed:
    """`now` until it ends, then `then`; see `followed`. Clause: INFO-COMBINE-5."""

    now: Model
    then: Model

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model that has not ended."""
        return self.now.cumulative

    def after(self, symbol: int) -> Model:
        """The next of `now`, or `then`."""
        return followed(self.now.after(symbol), self.then)


def followed(now: Model, then: Model) -> Model:
    """One model until it ends, then the other. Clause: INFO-COMBINE-5."""
    return then if has_ended(now) else Followed(now, then)


@dataclass(frozen=True, slots=True)
class Refined:
    """Each symbol c of `coarse`, then `fine[c]` until that ends. Clause: INFO-COMBINE-6.

    It ends where `coarse` ends. Every `fine[c]` must end; each use of it starts anew.
    """

    coarse: Model
    fine: tuple[Model, ...]

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the next coarse symbol."""
        return self.coarse.cumulative

    def after(self, symbol: int) -> Model:
        """The fine symbols of the coarse one, and then the next coarse one."""
        return followed(self.fine[symbol], Refined(self.coarse.after(symbol), self.fine))


def _with(models: tuple[Model, ...], place: int, model: Model) -> tuple[Model, ...]:
    """The models with one replaced."""
    return (*models[:place], model, *models[place + 1 :])


CHUNK: Final = 16
"""Raw bits go in pieces of so many: a larger table would waste the coder's precision."""


def raw(bits: int) -> Model:
    """So many uniform bits, the most significant first, in pieces. Clause: INFO-COMBINE-7."""
    whole = times(Static(range((1 << CHUNK) + 1)), bits // CHUNK)
    rest = bits % CHUNK
    return Followed(Times(Static(range((1 << rest) + 1)), 1), whole) if rest else whole


def pieces(value: int, bits: int) -> tuple[int, ...]:
    """The symbols that `raw(bits)` takes for 0 ≤ value < 2^bits. Clause: INFO-COMBINE-7."""
    rest = bits % CHUNK
    places = range(bits - rest - CHUNK, -1, -CHUNK)
    whole = tuple(value >> place & ((1 << CHUNK) - 1) for place in places)
    return (value >> bits - rest, *whole) if rest else whole


def joined(symbols: Sequence[int]) -> int:
    """The value of the symbols of `raw`. Clause: INFO-COMBINE-7."""
    value = 0
    for symbol in symbols:
        value = value << CHUNK | symbol
    return value
