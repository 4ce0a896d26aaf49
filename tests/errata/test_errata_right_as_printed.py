"""What the tutorial prints rightly, where no other test has it: `spec/errata.md`, last table."""

from fractions import Fraction
from typing import Final

import pytest

from clers.operators.effect import Effect
from clers.operators.handle_table import TABLE, Change
from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    LowerHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
)

SEASCAPE: Final = {"black": 3, "red": 4, "darkblue": 1, "lightblue": 2, "white": 4}
"""Figure 2: each probability is 2 to the power of minus this, the depth of its leaf."""


def test_huffmans_seascape() -> None:
    """2(b): the leaves fill a binary tree, and the mean depth is the entropy. INFO-ENTROPY-1."""
    assert sum(Fraction(1, 2**depth) for depth in SEASCAPE.values()) == 1
    assert sum(Fraction(depth, 2**depth) for depth in SEASCAPE.values()) == Fraction(15, 8)


PRINTED: Final[dict[type[Operator], tuple[int, int, int]]] = {
    ZeroHandle: (1, 0, 1),
    CompleteAfter: (0, 0, 0),
    CompleteBefore: (0, 0, 0),
    Attach: (0, 0, 0),
    LowerHandle: (-1, 0, 1),
    UpperHandle: (-1, 1, -1),
    TwoHandle: (1, 0, -1),
}
"""6(b): changes of χ, g and b; of the 0-handle χ alone is printed, and a triangle has one curve."""


@pytest.mark.parametrize("operator", PRINTED, ids=lambda operator: operator.__name__)
def test_effects_of_the_handle_operators(operator: type[Operator]) -> None:
    """6(b), Figures 10 to 13. OPER-EFFECT-1, OPER-SCRIPT-3: and χ = 2c − 2g − b."""
    change: Change = TABLE[operator]
    assert (change.euler, change.genus, change.loops) == PRINTED[operator]
    assert Effect(change.components, change.genus, change.loops).chi == change.euler
