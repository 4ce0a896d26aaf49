"""The domains of models that learn from the past."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.information.model import Model


@dataclass(frozen=True, slots=True)
class Conditioning:
    """An order, fresh models that contexts take by turns, all of one alphabet, and symbols."""

    order: int
    fresh: tuple[Model, ...]
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Counted:
    """A number of symbols, and a message of them."""

    size: int
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Residuals:
    """A model, and a message that it allows: to be taken as residuals."""

    model: Model
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Mixing:
    """Models with weights and a unit, and a message that one of them allows."""

    parts: tuple[Model, ...]
    weights: tuple[int, ...]
    unit: int
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class MixRequest:
    """What is asked to be mixed."""

    parts: tuple[Model, ...]
    weights: tuple[int, ...]
    unit: int


CONDITIONING: Final = Given("contexts-and-history", "an order, models, symbols", Conditioning)
COUNTED: Final = Given("message-of-a-size", "1 ≤ size ≤ 6 and symbols below it", Counted)
RESIDUALS: Final = Given(
    "residual-messages", "a small model and a message that it allows", Residuals
)
MIXING: Final = Given("mixing", "models to be mixed and a message of one of them", Mixing)
ANY_MIX: Final = Given("any-mixing", "any models, weights, unit", MixRequest)
