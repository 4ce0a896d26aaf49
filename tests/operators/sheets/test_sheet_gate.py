"""OPER-SHEET-7: operators at a gate as operators on sheets, by hand."""

from clers.conventions.result import Accepted
from clers.operators import handles as gate
from clers.operators.handles import NOTHING, Growing
from clers.operators.sheets.gate import at_gate, sheet_of_growing
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Glue,
    Join,
    Lower,
    TwoHandle,
    Upper,
    ZeroHandle,
    ZeroHandlePolygon,
)
from clers.operators.sheets.sheet import sheet_of


def followed(*operators: gate.Operator) -> tuple[list[Constructive], Growing]:
    """The operators on sheets, and the growing surface at the end."""
    grown, found = NOTHING, list[Constructive]()
    for operator in operators:
        found.append(at_gate(operator, grown))
        after = gate.apply(operator, grown)
        assert isinstance(after, Accepted), after
        grown = after.value
    return found, grown


def test_the_tetrahedron() -> None:
    """The loops are [2, 1, 0], [3, 1, 0, 2], [3, 0, 2]."""
    found, grown = followed(
        gate.ZeroHandle(), gate.Attach(), gate.CompleteAfter(), gate.TwoHandle()
    )
    assert found == [ZeroHandle(0, 1, 2), Glue(2, 1, 3), Complete(3, 1, 0), TwoHandle(3, 0, 2)]
    faces = [(0, 1, 2), (2, 1, 3), (3, 1, 0), (3, 0, 2)]
    assert sheet_of_growing(grown) == sheet_of(faces, [])


def test_completing_before_the_gate() -> None:
    """The loop is [3, 1, 0, 2]: the triangle lies on 2 → 3 → 1."""
    found, _ = followed(gate.ZeroHandle(), gate.Attach(), gate.CompleteBefore())
    assert found[-1] == Complete(2, 3, 1)


def test_a_lower_and_an_upper_handle() -> None:
    """Glued three times, the loop [2, 1, 0] becomes [5, 1, 0, 2, 3, 4].

    The gate goes from 5 to 1. Cut at 3: [5, 2, 3, 4] stays below [2, 1, 0]. A polygon is made
    over it, and joined by its first vertex 6.
    """
    attach = gate.Attach()
    found, grown = followed(gate.ZeroHandle(), attach, attach, attach, gate.LowerHandle(3))
    assert found[1:4] == [Glue(2, 1, 3), Glue(3, 1, 4), Glue(4, 1, 5)]
    assert found[4] == Lower(5, 1, 2, 3)
    assert grown.loops == ((5, 2, 3, 4), (2, 1, 0))
    assert at_gate(gate.UpperHandle(1, 3), grown) == Upper(2, 1, 4, 5)
    assert at_gate(gate.UpperHandle(1, 0), grown) == Upper(2, 1, 5, 2)
    polygon = gate.ZeroHandlePolygon(4)
    assert at_gate(polygon, grown) == ZeroHandlePolygon((6, 7, 8, 9))
    waiting = gate.apply(polygon, grown)
    assert isinstance(waiting, Accepted)
    assert at_gate(gate.OneHandle(), waiting.value) == Join(2, 1, 6, 7)
    assert sheet_of_growing(waiting.value).polygons == {(6, 7, 8, 9)}
