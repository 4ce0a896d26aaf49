"""What an operator does to the topology: the change of components, genus and boundary curves."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Effect:
    """Changes of the numbers that classify an oriented surface. Clause: OPER-SCRIPT-3.

    `genus` and `curves` are summed over the components; so `chi`, the change of the Euler
    characteristic, follows from the other three.
    """

    components: int = 0
    genus: int = 0
    curves: int = 0

    @property
    def chi(self) -> int:
        """The change of χ = Σ (2 − 2g − b). Clause: OPER-SCRIPT-3."""
        return 2 * self.components - 2 * self.genus - self.curves

    def __add__(self, then: "Effect") -> "Effect":
        """The effect of one operator and then another."""
        return Effect(
            self.components + then.components,
            self.genus + then.genus,
            self.curves + then.curves,
        )


NO_EFFECT: Final = Effect()
