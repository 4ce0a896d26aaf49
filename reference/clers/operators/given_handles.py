"""The domains that laws of handle operators range over; `clers.generate` draws from them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    Growing,
    LowerHandle,
    OneHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
    ZeroHandlePolygon,
)


@dataclass(frozen=True, slots=True)
class HandleStep:
    """A growing surface and an operator that may apply to it or not. Clause: OPER-HANDLE-9."""

    before: Growing
    operator: Operator


GROWING: Final = Given(
    "growing-surfaces", "surfaces under construction, as the decoder and chance leave them", Growing
)
HANDLE_STEPS: Final = Given(
    "handle-steps", "a growing surface and an operator, applicable or not", HandleStep
)


def in_reach(step: HandleStep) -> Iterator[Operator]:
    """The operator of a step, and every other whose numbers the loops admit or nearly admit."""
    loops = step.before.loops
    yield step.operator
    yield from (ZeroHandle(), Attach(), CompleteAfter(), CompleteBefore(), OneHandle(), TwoHandle())
    yield from (ZeroHandlePolygon(edges) for edges in range(-1, 6))
    for below, loop in enumerate((*reversed(loops), ())):
        for at in range(-1, len(loop) + 2):
            yield UpperHandle(below, at)
            if below == 0:
                yield LowerHandle(at)
