"""Surfaces under construction, and operators for them: as a decoder goes, then as chance goes."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.conventions.result import Accepted
from clers.edgebreaker.definition import steps
from clers.edgebreaker.encode import encode
from clers.generate.surfaces import surfaces
from clers.operators.given_handles import HandleStep
from clers.operators.handles import (
    NOTHING,
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
    apply,
)

_SURFACES: Final = st.one_of(
    surfaces(20, (0, 1), (0, 3), (1, 2)),
    surfaces(20, (1, 1), (0, 2), (1, 1)),
    surfaces(20, (0, 0), (2, 3), (1, 1)),
)
_HANDLES: Final = (LowerHandle, UpperHandle, OneHandle)
"""The operators that few steps of a small surface are, and so are asked for."""

_CUT: Final = (Attach(), Attach(), Attach(), LowerHandle(3))
"""Enough vertices for a loop to be cut, whatever its length, and the cut."""

_NUMBERS: Final = st.one_of(st.integers(-1, 9), st.integers())

OPERATORS: Final[st.SearchStrategy[Operator]] = st.one_of(
    st.sampled_from(
        (ZeroHandle(), Attach(), CompleteAfter(), CompleteBefore(), OneHandle(), TwoHandle())
    ),
    st.builds(ZeroHandlePolygon, st.integers(-1, 8)),
    st.builds(LowerHandle, _NUMBERS),
    st.builds(UpperHandle, st.one_of(st.integers(0, 3), st.integers()), _NUMBERS),
)
"""Any operator with any numbers, polygons but few edges; most do not apply to most surfaces."""


def _after(grown: Growing, operator: Operator) -> Growing:
    """The surface after an operator that applies, else the surface as it is."""
    match apply(operator, grown):
        case Accepted(value):
            return value
        case _:
            return grown


@st.composite
def handle_steps(draw: st.DrawFn) -> HandleStep:
    """A step on the way to a small surface: the right operator, or any, after a few of any."""
    found = steps(encode(draw(_SURFACES)).stream)
    assert isinstance(found, Accepted), found
    operators = [operator for step in found.value for operator in step]
    handles = [i for i, operator in enumerate(operators) if isinstance(operator, _HANDLES)]
    cuts = draw(st.sampled_from((range(len(operators)), handles)))
    cut = draw(st.sampled_from(cuts or range(len(operators))))
    grown = NOTHING
    for operator in operators[:cut]:
        grown = _after(grown, operator)
    for operator in _CUT * draw(st.integers(0, 3)):
        grown = _after(grown, operator)
    if draw(st.booleans()):
        return HandleStep(grown, operators[cut])
    for operator in draw(st.lists(OPERATORS, max_size=8)):
        grown = _after(grown, operator)
    return HandleStep(grown, draw(OPERATORS))


def growing() -> st.SearchStrategy[Growing]:
    """Surfaces under construction, none that no operator leads to."""
    return handle_steps().map(lambda step: _after(step.before, step.operator))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "growing-surfaces": growing(),
    "handle-steps": handle_steps(),
}
"""The domains of this module, by name."""
