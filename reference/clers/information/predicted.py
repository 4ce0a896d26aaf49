"""Prediction as a model: the residuals of guesses have a model, and so the symbols have one."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from clers.information.model import Model, cumulative, differences


class Predictor(Protocol):
    """A guess from the past. Clause: INFO-PREDICT-1."""

    @property
    def guess(self) -> int:
        """The symbol that is expected, up to multiples of the size of the alphabet."""
        ...

    def after(self, symbol: int) -> "Predictor":
        """The predictor of what follows `symbol`. Pure."""
        ...


@dataclass(frozen=True, slots=True)
class Predicted:
    """Symbols by their residuals. Clauses: INFO-PREDICT-1, INFO-PREDICT-2."""

    residuals: Model
    predictor: Predictor

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the residuals, turned so that residual 0 is at the guess."""
        frequencies = differences(self.residuals.cumulative)
        if not frequencies:
            return self.residuals.cumulative
        turn = -self.predictor.guess % len(frequencies)
        return cumulative(frequencies[turn:] + frequencies[:turn])

    def after(self, symbol: int) -> "Predicted":
        """The residual is learnt; the predictor sees the symbol."""
        size = len(self.residuals.cumulative) - 1
        residual = (symbol - self.predictor.guess) % size
        return Predicted(self.residuals.after(residual), self.predictor.after(symbol))


@dataclass(frozen=True, slots=True)
class Previous:
    """The last symbol again. Clause: INFO-PREDICT-3."""

    guess: int = 0

    def after(self, symbol: int) -> "Previous":
        """The symbol is the next guess."""
        return Previous(symbol)


@dataclass(frozen=True, slots=True)
class Continued:
    """As far from the last symbol as that was from the one before. Clause: INFO-PREDICT-3."""

    last: int = 0
    before: int = 0

    @property
    def guess(self) -> int:
        """Twice the last less the one before."""
        return 2 * self.last - self.before

    def after(self, symbol: int) -> "Continued":
        """The symbol is the last one now."""
        return Continued(symbol, self.last)
