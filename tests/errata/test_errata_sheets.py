"""Errata of the tutorial's section 6 about Euler operators on surfaces."""

from clers.complexes.simplicial import closure, euler, of_dimension
from clers.conventions.result import Accepted
from clers.operators.sheets.apply import apply
from clers.operators.sheets.numbers import numbers
from clers.operators.sheets.operator import MakeSTV
from clers.operators.sheets.sheet import EMPTY


def test_the_initial_triangle_brings_its_edges() -> None:
    """ERRATUM-38. OPER-EULER-1, OPER-EFFECT-2."""
    vertices_as_printed, edges_as_printed, faces = 1, 0, 1
    assert vertices_as_printed - edges_as_printed + faces == 2
    triangle = closure([(0, 1, 2)])
    assert [len(of_dimension(triangle, m)) for m in range(3)] == [3, 3, 1]
    made = apply(MakeSTV(0, 1, 2), EMPTY)
    assert isinstance(made, Accepted)
    assert numbers(made.value).euler == euler(triangle) == 1
