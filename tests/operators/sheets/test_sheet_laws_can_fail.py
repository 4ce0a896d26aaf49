"""Laws of sheets and their operators, with a fault planted: each must say so, on few triangles."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from golden_sheets import (
    ANNULUS,
    DISK,
    PINCHED,
    SPIKE,
    TRIANGLE,
    TWO_TRIANGLES,
    only,
    script,
    sheet,
)
from hypothesis import HealthCheck, Phase, find, settings

from clers.conventions.law import AnyLaw
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.edgebreaker.examples import TORUS
from clers.generate.sheets import sheet_steps
from clers.operators.given_handles import HandleStep
from clers.operators.handles import NOTHING, Attach, ZeroHandle
from clers.operators.sheets import (
    laws_build,
    laws_gate,
    laws_operators,
    laws_surfaces,
)
from clers.operators.sheets.apply import Stage, apply, steps
from clers.operators.sheets.build import build
from clers.operators.sheets.effects import rows
from clers.operators.sheets.euler import euler
from clers.operators.sheets.given import SheetStep
from clers.operators.sheets.laws import LAWS
from clers.operators.sheets.make import changed
from clers.operators.sheets.needs import loop_from
from clers.operators.sheets.numbers import Numbers
from clers.operators.sheets.operator import (
    Constructive,
    Glue,
    Lower,
    MakeTE,
    Operator,
    Script,
    TwoHandle,
    Undo,
    Upper,
)
from clers.operators.sheets.sheet import EMPTY, Sheet, sheet_of, sides_of
from clers.operators.sheets.surgery import cut, past_next

Result = Accepted[Sheet] | Rejected


def law(name: str) -> AnyLaw:
    """The law of a name."""
    (found,) = [one for one in LAWS if one.name == name]
    return found


def doubles_edges(operator: Operator, on: Sheet) -> Result:
    """M TE without a look at the edge that it makes."""
    if isinstance(operator, MakeTE):
        loop = loop_from(on, operator.a, operator.b)
        if loop is not None and loop[2:3] == (operator.c,):
            return changed(on, (operator.a, operator.b, operator.c), (past_next(loop),), (loop,))
    return apply(operator, on)


def loses_a_loop(operator: Operator, on: Sheet) -> Result:
    """The lower 1-handle without the loop that it cuts off."""
    after = apply(operator, on)
    if isinstance(operator, Lower) and isinstance(after, Accepted):
        loop = loop_from(on, operator.a, operator.b) or ()
        at = list(sides_of(loop)).index((operator.c, operator.d))
        lost = cut(loop, at)[1]
        return changed(after.value, (), (), (lost,))
    return after


def forgets_components(operator: Operator, on: Sheet) -> Result:
    """The upper 1-handle between components, too."""
    after = apply(operator, on)
    if isinstance(operator, Upper) and isinstance(after, Rejected):
        a, b, c, d = operator.a, operator.b, operator.c, operator.d
        loop, other = loop_from(on, a, b), loop_from(on, c, d)
        if loop is not None and other is not None and loop[0] != c and not set(loop) & set(other):
            return changed(on, (a, b, c), ((a, *other, c, *loop[1:]),), (loop, other))
    return after


def leaves_the_triangle(operator: Operator, on: Sheet) -> Result:
    """Undo of gluing that leaves the triangle."""
    after = apply(operator, on)
    if isinstance(operator, Undo) and isinstance(operator.of, Glue) and isinstance(after, Accepted):
        return Accepted(replace(after.value, triangles=on.triangles))
    return after


def says_nothing(operator: Operator, on: Sheet) -> Result:
    """Rejections that blame nothing."""
    after = apply(operator, on)
    return Rejected(after.reason, after.clause) if isinstance(after, Rejected) else after


Planted = Callable[[Operator, Sheet], Result]

OPERATORS: tuple[tuple[str, Planted, str, str], ...] = (
    ("as-defined-oper-euler-3", doubles_edges, TRIANGLE, "make-te 2 1 0"),
    ("operator-makes-sheet", doubles_edges, TRIANGLE, "make-te 2 1 0"),
    ("as-defined-oper-surface-5", loses_a_loop, DISK, "lower 1 0 4 5"),
    ("attachment-by-permutation", loses_a_loop, DISK, "lower 1 0 4 5"),
    ("sheet-effect-in-table", loses_a_loop, DISK, "lower 1 0 4 5"),
    ("composed-of-euler-operators", loses_a_loop, DISK, "lower 1 0 4 5"),
    ("as-defined-oper-surface-6", forgets_components, TWO_TRIANGLES, "upper 1 0 3 5"),
    ("sheet-effect-in-table", forgets_components, TWO_TRIANGLES, "upper 1 0 3 5"),
    ("undo-undoes", leaves_the_triangle, TRIANGLE, "glue 2 1 3"),
    ("operator-refusal", says_nothing, TRIANGLE, "glue 1 2 3"),
)


@pytest.mark.parametrize(("name", "planted", "start", "operator"), OPERATORS)
def test_law_of_operators_fails(
    name: str, planted: Planted, start: str, operator: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    step = SheetStep(sheet(start), only(operator))
    assert law(name).check(step) == Holds()
    monkeypatch.setattr(laws_operators, "apply", planted)
    assert isinstance(law(name).check(step), Fails)


def test_a_wrong_row_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """OPER-EFFECT-2: each column, of each operator of the torus's script."""
    found = law("sheet-effect-in-table")
    for column in range(7):
        off = Numbers(*(int(i == column) for i in range(7)))

        def wrong(operator: Operator, off: Numbers = off) -> tuple[Numbers, ...]:
            return tuple(row - off for row in rows(operator))

        monkeypatch.setattr(laws_operators, "rows", wrong)
        assert isinstance(found.check(SheetStep(EMPTY, only(TRIANGLE))), Fails)


def test_laws_of_surface_operators_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """OPER-SURFACE-10: with operators on sheets in place of those on surfaces."""
    pinching = SheetStep(sheet(DISK), only("undo-complete 0 1 2"))
    names = ("surface-operator-makes-surface", "surface-operator-applies-exactly")
    for name in (*names, "surface-operator-undone"):
        assert law(name).check(pinching) == Holds()
    monkeypatch.setattr(laws_surfaces, "apply_to_surface", apply)
    for name in names:
        assert isinstance(law(name).check(pinching), Fails)
    monkeypatch.setattr(laws_surfaces, "apply_to_surface", leaves_the_triangle)
    glued = SheetStep(sheet(DISK), only("glue 0 2 6"))
    assert isinstance(law("surface-operator-undone").check(glued), Fails)


def short(of: object, first: int = 1) -> Script:
    """The handle decomposition without its end."""
    return build(TORUS, first)[:-1]


def backwards(of: object, first: int = 1) -> Script:
    """Another order of the same surface: its Edgebreaker-like pieces, last triangle first."""
    return tuple(reversed(build(TORUS, first)))


def all_close(of: object, first: int = 1) -> Script:
    """Two-handles for upper handles."""
    return tuple(
        TwoHandle(o.a, o.b, o.c) if isinstance(o, Upper) else o for o in build(TORUS, first)
    )


@pytest.mark.parametrize(
    ("name", "planted"),
    [
        ("build-and-take-apart", short),
        ("build-breadth-first", backwards),
        ("build-morse", all_close),
        ("build-by-euler-operators", short),
    ],
)
def test_law_of_building_fails(
    name: str, planted: Callable[[object, int], Script], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert law(name).check(TORUS) == Holds()
    monkeypatch.setattr(laws_build, "build", planted)
    assert isinstance(law(name).check(TORUS), Fails)


def test_laws_of_scripts_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """OPER-BUILD-4 … OPER-BUILD-6, OPER-EULER-6."""
    of = script(f"{DISK}; lower 1 0 4 5")
    names = ("scripts-by-euler-operators", "sheet-script-text", "sheet-script-steps")
    for name in (*names, "making-cuts-no-loop"):
        assert law(name).check(of) == Holds()

    def untranslated(given: Script) -> Accepted[Script]:
        return Accepted(given)

    def misread(text: str) -> Accepted[Script]:
        return Accepted(of[1:])

    def uncounted(given: Script) -> Accepted[tuple[Stage, ...]] | Rejected:
        found = steps(given)
        assert isinstance(found, Accepted)
        return Accepted(tuple(replace(stage, numbers=Numbers()) for stage in found.value))

    def cutting(operator: Operator, on: Sheet) -> Result:
        """M SG that opens a loop beside."""
        after = apply(operator, on)
        if isinstance(after, Accepted) and len(after.value.triangles) > 2:
            return apply(Undo(TwoHandle(0, 1, 2)), after.value)
        return after

    monkeypatch.setattr(laws_build, "euler", untranslated)
    monkeypatch.setattr(laws_build, "read", misread)
    monkeypatch.setattr(laws_build, "steps", uncounted)
    for name in names:
        assert isinstance(law(name).check(of), Fails)
    monkeypatch.setattr(laws_build, "euler", euler)
    monkeypatch.setattr(laws_build, "apply", cutting)
    assert isinstance(law("making-cuts-no-loop").check(of), Fails)


def test_law_of_gates_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    """OPER-SHEET-7."""
    step = HandleStep(NOTHING, ZeroHandle())
    found = law("gate-is-sheet")
    assert found.check(step) == Holds()

    def elsewhere(operator: object, grown: object) -> Constructive:
        return Glue(0, 1, 2)

    monkeypatch.setattr(laws_gate, "at_gate", elsewhere)
    assert isinstance(found.check(step), Fails)
    assert isinstance(found.check(HandleStep(NOTHING, Attach())), Fails)


WRONG: tuple[tuple[str, Sheet], ...] = (
    ("sheet-sides-once", sheet_of([(0, 1, 2)], [])),
    ("sheet-sides-once", sheet_of([(0, 1, 2), (2, 1, 0)], [])),
    ("sheet-has-no-fault", sheet_of([(0, 1, 2), (0, 3, 4)], [(2, 1, 0), (4, 3, 0)])),
    ("sheet-closed-homology", sheet_of([(0, 1, 2), (0, 3, 4)], [(2, 1, 0), (4, 3, 0)])),
    ("sheet-is-surface", sheet_of([(0, 1, 2)], [(0, 1, 2)])),
)


@pytest.mark.parametrize(("name", "wrong"), WRONG)
def test_law_of_sheets_fails(name: str, wrong: Sheet) -> None:
    assert isinstance(law(name).check(wrong), Fails)
    for right in (TRIANGLE, ANNULUS, PINCHED, SPIKE):
        assert law(name).check(sheet(right)) == Holds()


@pytest.mark.parametrize(
    ("name", "planted", "most"),
    [
        ("operator-makes-sheet", doubles_edges, 1),
        ("as-defined-oper-surface-5", loses_a_loop, 4),
        ("as-defined-oper-surface-6", forgets_components, 6),
    ],
)
def test_failures_shrink(
    name: str, planted: Planted, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A planted fault is shown on a sheet of few triangles."""
    monkeypatch.setattr(laws_operators, "apply", planted)
    found = find(
        sheet_steps(),
        lambda step: isinstance(law(name).check(step), Fails),
        settings=settings(
            max_examples=100,
            database=None,
            derandomize=True,
            suppress_health_check=list(HealthCheck),
            phases=(Phase.generate, Phase.shrink),
        ),
    )
    assert len(found.before.triangles) <= most
