"""OPER-BUILD-1 … OPER-BUILD-4 on known surfaces, and the laws on every step of building them."""

from collections import Counter

import pytest

from clers.complexes.corner_table import surface as surface_of
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.law import AnyLaw
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.operators.sheets.apply import apply, run, steps
from clers.operators.sheets.build import build, order
from clers.operators.sheets.euler import composed, euler
from clers.operators.sheets.given import SheetStep
from clers.operators.sheets.laws_operators import LAWS
from clers.operators.sheets.operator import Lower, MakeSG, Undo, inverse, taken_apart
from clers.operators.sheets.sheet import EMPTY, fault, vertices
from clers.operators.sheets.surfaces import sheet_of_surface
from clers.operators.sheets.text import read, write


def surface(*faces: tuple[int, int, int]) -> Surface:
    result = surface_of(FaceList(faces, max(v for face in faces for v in face) + 1))
    assert isinstance(result, Accepted), result
    return result.value


TWO = surface((0, 1, 2), (2, 1, 3), (4, 5, 6))
"""A square and a triangle apart."""

STRIP = surface((0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4), (4, 5, 6), (5, 7, 6))
"""Six triangles in a row; the first and the fourth have no vertex in common."""

SURFACES = (TETRAHEDRON, ANNULUS, CUBE, TORUS, TWO, STRIP)


def test_the_tetrahedron() -> None:
    """OPER-BUILD-1: its faces are 0 = (0,1,2), 1 = (0,3,1), 2 = (1,3,2), 3 = (0,2,3)."""
    # Across 0→1 lies (0, 3, 1), across 1→2 (1, 3, 2), across 2→0 (0, 2, 3).
    assert list(order(TETRAHEDRON)) == [0, 1, 2, 3]
    assert (
        write(build(TETRAHEDRON))
        == "zero-handle 0 1 2; glue 1 0 3; complete 2 1 3; two-handle 0 2 3"
    )


def test_two_first_triangles() -> None:
    """OPER-BUILD-1: the first and the fourth of six in a row; the third joins them.

    After (0,1,2) and (3,5,4) comes, across 1→2, (1,3,2): 3 is in the other component, before
    3→4 on its loop [4, 5, 3]. Then across 5→4 (4,5,6), and (2,3,4), which completes.
    """
    assert list(order(STRIP, 2)) == [0, 3, 1, 4, 2, 5]
    assert write(build(STRIP, 2)) == (
        "zero-handle 0 1 2; zero-handle 3 5 4; join 2 1 3 4; glue 4 5 6; complete 2 3 4; glue 6 5 7"
    )


def test_components_are_begun_in_turn() -> None:
    """OPER-BUILD-1."""
    assert write(build(TWO)) == "zero-handle 0 1 2; glue 2 1 3; zero-handle 4 5 6"
    assert write(build(TWO, 2)) == "zero-handle 0 1 2; zero-handle 4 5 6; glue 2 1 3"


def test_the_torus_has_two_lower_and_one_upper() -> None:
    """OPER-BUILD-3: χ = 1 − 3 + 2 = 0, g = 1, b = 1 + 2 − 1 − 2 = 0."""
    kinds = Counter(type(operator).__name__ for operator in build(TORUS))
    assert (kinds["ZeroHandle"], kinds["Lower"], kinds["Upper"], kinds["TwoHandle"]) == (1, 2, 1, 2)


@pytest.mark.parametrize("of", SURFACES)
@pytest.mark.parametrize("first", [0, 1, 2, 3])
def test_built_and_taken_apart(of: Surface, first: int) -> None:
    """OPER-BUILD-2, OPER-BUILD-5: whole, apart, and as text."""
    script, whole = build(of, first), sheet_of_surface(of)
    assert run(script) == Accepted(whole)
    assert run(taken_apart(script), whole) == Accepted(EMPTY)
    assert read(write(script)) == Accepted(script)
    assert len(set(order(of, first))) == of.faces == len(script)


@pytest.mark.parametrize("of", SURFACES)
def test_by_euler_operators(of: Surface) -> None:
    """OPER-BUILD-4: each sheet on the way is one, and the inverse takes it apart."""
    translated = euler(build(of, 2))
    assert isinstance(translated, Accepted)
    found = steps(translated.value)
    assert isinstance(found, Accepted)
    assert all(fault(stage.sheet) is None for stage in found.value)
    whole = sheet_of_surface(of)
    assert found.value[-1].sheet == whole
    assert run(taken_apart(translated.value), whole) == Accepted(EMPTY)


def test_a_chord() -> None:
    """OPER-BUILD-4, by hand: a loop of six edges is cut from 0 to 4 along 0 → 2 → 4, m = 2."""
    start = run(build(surface((0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4))))
    assert isinstance(start, Accepted)
    assert write(composed(Lower(1, 0, 4, 5), start.value)) == (
        "make-ev 0 2 6; make-te 6 0 2; make-ev 6 2 7; make-te 7 6 2; make-te 7 2 4; make-te 6 7 4; "
        "make-te 0 6 4; kill-sg 0 6 4; "
        "kill-te 6 7 4; kill-te 7 2 4; kill-te 7 6 2; kill-ev 6 2 7; kill-te 6 0 2; kill-ev 0 2 6; "
        "make-te 1 0 4"
    )


def test_one_opening_for_each_lower_handle() -> None:
    """OPER-BUILD-4."""
    translated = euler(build(TORUS))
    assert isinstance(translated, Accepted)
    opened = [o for o in translated.value if isinstance(o, Undo) and isinstance(o.of, MakeSG)]
    assert len(opened) == 2


def test_scripts_that_do_not_apply_have_no_translation() -> None:
    """OPER-BUILD-4."""
    script = build(TETRAHEDRON)
    assert isinstance(euler(script[1:]), Rejected)
    half = run(script[:2])
    assert isinstance(half, Accepted)
    rest = euler(script[2:], half.value)
    assert isinstance(rest, Accepted)
    assert write(rest.value) == "make-te 2 1 3; make-sg 0 2 3"


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_laws_while_the_torus_is_built(law: AnyLaw) -> None:
    """Every law of operators, before each handle of the torus and on undoing it."""
    sheet = EMPTY
    checked = 0
    for operator in build(TORUS, 2):
        after = apply(operator, sheet)
        assert isinstance(after, Accepted)
        if type(operator).__name__ in ("Join", "Lower", "Upper", "TwoHandle"):
            for step in (SheetStep(sheet, operator), SheetStep(after.value, inverse(operator))):
                assert law.check(step) == Holds()
                checked += 1
        sheet = after.value
    assert checked == 16
    assert vertices(sheet) == set(range(9))
