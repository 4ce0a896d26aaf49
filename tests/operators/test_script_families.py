"""Scripts of the three families: which is which, where they begin, and what their stages say."""

import pytest

from clers.complexes.simplicial import closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.edgebreaker.examples import ANNULUS
from clers.operators.families import (
    GROWING,
    ON_COMPLEXES,
    ON_SHEETS,
    AnyScript,
    Growing,
    OnComplexes,
    OnSheets,
    Stage,
    read,
    stages,
)

FIGURE_11 = "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4; glue 4 0 5; lower-strip 2 1 4 5"
"""A fan of four triangles is bent round and its ends are glued by two more."""


def script(text: str) -> AnyScript:
    found = read(text)
    assert isinstance(found, Accepted)
    return found.value


def passed(text: str) -> tuple[Stage, ...]:
    done, fault = stages(script(text))
    assert fault is None
    return done


def test_names_tell_families_apart() -> None:
    """OPER-FAMILY-1: nine moves and more, sixteen operators on sheets and as many inverses."""
    assert len(ON_SHEETS) + len(ON_COMPLEXES) + len(GROWING) == len(
        ON_SHEETS | ON_COMPLEXES | GROWING
    )
    assert {"glue", "kill-ekl", "undo-glue"} <= ON_SHEETS
    assert {"collapse", "attach", "undo"} <= ON_COMPLEXES
    assert {"split-face", "bridge", "add-tetrahedron"} <= GROWING


@pytest.mark.parametrize(
    ("text", "family"),
    [
        ("zero-handle 0 1 2", OnSheets),
        ("kill-stv 0 1 2", OnSheets),
        ("", OnSheets),
        ("; \n attach 0", OnComplexes),
        ("undo attach 0", OnComplexes),
        ("weld 0 1 / 2", OnComplexes),
        ("add-tetrahedron;split-face 1", Growing),
    ],
)
def test_the_first_name_says_the_family(text: str, family: type[AnyScript]) -> None:
    """OPER-FAMILY-1."""
    assert type(script(text)) is family


def test_moves_and_attachments_mix() -> None:
    """OPER-FAMILY-1: a triangle, a vertex in it, and a third of it taken off."""
    done = passed("attach 0 1 2\nsubdivide 0 1 2 / 7; collapse 0 1 / 0 1 7")
    assert [stage.operator for stage in done] == [
        "attach 0 1 2",
        "subdivide 0 1 2 / 7",
        "collapse 0 1 / 0 1 7",
    ]
    assert done[1].shape == closure([(0, 1, 7), (0, 2, 7), (1, 2, 7)])
    assert done[2].shape == closure([(0, 2, 7), (1, 2, 7)])
    assert dict(done[2].numbers) == {
        "#0": 4,
        "#1": 5,
        "#2": 2,
        "χ": 1,
        "components": 1,
        "b0": 1,
        "b1": 0,
        "b2": 0,
    }


@pytest.mark.parametrize(
    ("text", "reason", "clause", "step"),
    [
        ("nonsense 1", Reason.UNKNOWN_OPERATOR, Clause.OPER_BUILD_5, 0),
        ("attach 0; ; nonsense 1", Reason.UNKNOWN_OPERATOR, Clause.OPER_ATTACH_8, 1),
        ("attach 0; collapse 1", Reason.BAD_OPERAND, Clause.OPER_MOVE_8, 1),
        ("split-face 0; glue 1 2 3", Reason.UNKNOWN_OPERATOR, Clause.OPER_SCRIPT_6, 1),
    ],
)
def test_faults_of_texts(text: str, reason: Reason, clause: Clause, step: int) -> None:
    """OPER-FAMILY-1: by the clause of the family, at the step."""
    found = read(text)
    assert isinstance(found, Rejected)
    assert (found.reason, found.clause, found.where) == (reason, clause, AtStep(step))


def test_the_stages_of_figure_11() -> None:
    """OPER-FAMILY-3: by hand. The strip adds three edges and two triangles, so χ falls by one."""
    done = passed(FIGURE_11)
    names = ("vertices", "edges", "faces", "χ", "components", "genus", "loops")
    assert [dict(stage.numbers) for stage in done[-2:]] == [
        dict(zip(names, (6, 9, 4, 1, 1, 0, 1), strict=True)),
        dict(zip(names, (6, 12, 6, 0, 1, 0, 2), strict=True)),
    ]
    assert done[-1].operator == "lower-strip 2 1 4 5"


def test_beginning_on_a_surface() -> None:
    """OPER-FAMILY-2: the annulus' curves are (2, 5, 1) and (4, 3, 0) as the faces run them."""
    done, fault = stages(script("two-handle 5 2 1"), ANNULUS)
    assert fault is None
    assert [stage.operator for stage in done] == ["", "two-handle 5 2 1"]
    assert [dict(stage.numbers)["loops"] for stage in done] == [2, 1]
    on_complex, fault = stages(script("collapse 1 2 / 0 1 2"), ANNULUS)
    assert fault is None
    assert [dict(stage.numbers)["#2"] for stage in on_complex] == [6, 5]
    assert [dict(stage.numbers)["b1"] for stage in on_complex] == [1, 1]
    assert on_complex[0].operator == ""


def test_beginning_on_a_complex() -> None:
    """OPER-FAMILY-2."""
    done, fault = stages(script("attach 1 2 / 1 / 2"), closure([(0, 1), (0, 2)]))
    assert fault is None
    assert [dict(stage.numbers)["b1"] for stage in done] == [0, 1]
    assert [dict(stage.numbers)["components"] for stage in done] == [1, 1]


@pytest.mark.parametrize(
    ("text", "start"), [("glue 0 1 2", closure([(0, 1, 2)])), ("split-face 0", ANNULUS)]
)
def test_beginning_on_what_cannot_be(text: str, start: object) -> None:
    """OPER-FAMILY-2."""
    given = ANNULUS if start is ANNULUS else closure([(0, 1, 2)])
    done, fault = stages(script(text), given)
    assert done == ()
    assert fault is not None
    assert (fault.reason, fault.clause) == (Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_FAMILY_2)
    assert fault.detail


@pytest.mark.parametrize(
    "text",
    ["zero-handle 0 1 2; glue 0 1 3", "attach 0 1; attach 0 1 2 / 0", "attach 5; weld 3 / 4"],
)
def test_stages_before_a_fault_stand(text: str) -> None:
    """OPER-FAMILY-2: the second step is blamed, the detail says which simplex."""
    done, fault = stages(script(text))
    assert len(done) == 1
    assert fault is not None
    assert fault.where == AtStep(1)
    assert fault.detail.startswith("at ")


def test_growing_begins_on_the_tetrahedron() -> None:
    """OPER-FAMILY-3: with its reason where an operator did nothing; a handle makes χ fall by 2."""
    done = passed("split-face 0; fill-corner 0; add-handle 0 3; open-curve 1")
    assert [stage.idle for stage in done] == ["", "", "no-candidate", "", ""]
    assert [stage.operator for stage in done[:2]] == ["", "split-face 0"]
    numbers = [dict(stage.numbers) for stage in done]
    assert [n["χ"] for n in numbers] == [2, 2, 2, 0, -1]
    assert [n["genus"] for n in numbers] == [0, 0, 0, 1, 1]
    assert [n["curves"] for n in numbers] == [0, 0, 0, 0, 1]
    assert [n["components"] for n in numbers] == [1, 1, 1, 1, 1]
    assert [n["faces"] for n in numbers[:3]] == [4, 6, 6]
    assert [n["vertices"] for n in numbers[:3]] == [4, 5, 5]
