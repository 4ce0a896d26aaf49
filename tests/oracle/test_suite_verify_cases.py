"""Each way in which the cases of a suite may not hold: what is found, and where."""

from pathlib import Path

import pytest
from msgspec import UNSET, Raw, UnsetType
from msgspec.structs import replace
from tampered import base, changed, first, renamed, whole, written
from test_suite_verify import DECODED, bad, good, only, text, with_case

from clers.conformance.cases.case import Edit, FaultForm
from clers.conformance.messages import Rejection
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.records import Flag, Retired
from clers.oracle.suite.rendered import parts_of
from clers.oracle.suite.verify import verify


def test_an_id_that_is_not_the_hash(tmp_path: Path) -> None:
    """ORCL-CASE-2: the expectation was changed, and the id left."""
    case = good()
    ok = text(case.ok).replace(b'"vertices":', b'"vertices":1')
    changed(tmp_path, case.id, lambda one: replace(one, ok=Raw(ok)))
    assert only(tmp_path) == Problem(
        DECODED,
        "its id or its text is not that of what it asks and expects",
        Clause.ORCL_CASE_2,
        case.id,
    )


def test_another_text_for_the_same_value(tmp_path: Path) -> None:
    """ORCL-CASE-8: a space is another text, and makes another id."""
    case = good()
    spaced = Raw(bytes(case.input).replace(b":", b": ", 1))
    changed(tmp_path, case.id, lambda one: replace(one, input=spaced))
    assert only(tmp_path).clause is Clause.ORCL_CASE_2


def test_a_changed_expectation(tmp_path: Path) -> None:
    """ORCL-SUITE-4: with an id of its own it is still not the reference's answer."""
    case = good()
    ok = Raw(text(case.ok).replace(b'"vertices":', b'"vertices":1'))
    wrong = renamed(replace(case, ok=ok))
    parts = [(part.profile, one) for part in base().parts for one in part.cases if one != case]
    written(tmp_path, parts_of([*parts, ("components", wrong)]))
    found = [problem for problem in verify(tmp_path) if problem.case == wrong.id]
    assert [(problem.file, problem.clause) for problem in found] == [(DECODED, Clause.ORCL_SUITE_4)]
    assert found[0].what.startswith("the reference does not answer it right: ")


def test_a_changed_trace(tmp_path: Path) -> None:
    """ORCL-SUITE-4."""
    case = good()
    trace = (replace(case.trace[0], stack=5), *case.trace[1:])
    wrong = renamed(replace(case, trace=trace))
    changed(tmp_path, case.id, lambda _: wrong)
    whats = [problem.what for problem in verify(tmp_path) if problem.case == wrong.id]
    assert whats == ["the reference does not answer it right: step 0: expected 5, got 0"]


def test_a_trace_where_none_is(tmp_path: Path) -> None:
    """ORCL-SUITE-4: nobody traces a classification, and nobody would notice."""
    case = first("surface.classify", "ok")
    wrong = renamed(replace(case, trace=good().trace))
    changed(tmp_path, case.id, lambda _: wrong)
    found = [problem for problem in verify(tmp_path) if problem.case == wrong.id]
    what = "the reference's walk is not its trace"
    file = "components/surface.classify.json"
    assert found == [Problem(file, what, Clause.ORCL_SUITE_4, wrong.id)]


def test_a_changed_reason(tmp_path: Path) -> None:
    """ORCL-SUITE-4: advice has to be right here, too."""
    case = bad()
    assert isinstance(case.reject, Rejection)
    wrong = renamed(replace(case, reject=replace(case.reject, reason="empty-mesh")))
    changed(tmp_path, case.id, lambda _: wrong)
    assert only(tmp_path).what.startswith("the reference does not answer it right: ")


def test_an_id_twice(tmp_path: Path) -> None:
    """ORCL-CASE-2."""
    case = good()
    written(tmp_path, with_case(case))
    assert only(tmp_path) == Problem(
        DECODED, f"its id is in {DECODED} too", Clause.ORCL_CASE_2, case.id
    )


def test_an_id_among_the_canaries(tmp_path: Path) -> None:
    case = good()
    written(tmp_path, canaries=(case,))
    assert verify(tmp_path)[0] == Problem(
        "canaries.json", f"its id is in {DECODED} too", Clause.ORCL_CASE_2, case.id
    )


def test_an_id_that_is_retired(tmp_path: Path) -> None:
    """ORCL-SUITE-6."""
    written(tmp_path, retired=[Retired(id=good().id, reason="it was wrong")])
    assert only(tmp_path) == Problem(DECODED, "its id is retired", Clause.ORCL_SUITE_6, good().id)


@pytest.mark.parametrize(
    ("entries", "what"),
    [
        ([Retired(id="old-aaaaaaaa", reason="")], "it has no reason"),
        (
            [Retired(id="old-aaaaaaaa", reason="wrong", successor="new-aaaaaaaa")],
            "its successor new-aaaaaaaa is not in the suite",
        ),
        ([Retired(id="old-aaaaaaaa", reason="wrong")] * 2, "it is there twice"),
    ],
)
def test_what_is_retired_wrongly(tmp_path: Path, entries: list[Retired], what: str) -> None:
    """ORCL-SUITE-6."""
    written(tmp_path, retired=entries)
    assert only(tmp_path) == Problem("retired.json", what, Clause.ORCL_SUITE_6, "old-aaaaaaaa")


def test_what_is_retired_well(tmp_path: Path) -> None:
    """ORCL-SUITE-6: a successor may be retired in its turn."""
    entries = [
        Retired(id="old-aaaaaaaa", reason="wrong", successor="new-aaaaaaaa"),
        Retired(id="new-aaaaaaaa", reason="wrong again", successor=good().id),
    ]
    assert verify(written(tmp_path, retired=entries)) == ()


@pytest.mark.parametrize(
    ("change", "clause", "what"),
    [
        ({"clauses": ()}, Clause.ORCL_CASE_1, "it names no clause"),
        (
            {"clauses": ("EB-DECODE-1", "NONE-SUCH-1")},
            Clause.ORCL_CASE_1,
            "no clause is named NONE-SUCH-1",
        ),
        (
            {"requires": ("components", "wings")},
            Clause.ORCL_CASE_4,
            "no capability is named wings",
        ),
        ({"requires": ()}, Clause.ORCL_SUITE_3, "its profile is core, not components"),
        ({"flags": ("unheard-of",)}, Clause.ORCL_CASE_5, "unheard-of is not explained"),
    ],
)
def test_what_a_case_says_beside(
    tmp_path: Path, change: dict[str, tuple[str, ...]], clause: Clause, what: str
) -> None:
    """ORCL-CASE-1, ORCL-CASE-4, ORCL-CASE-5, ORCL-SUITE-3."""
    case = good()
    changed(tmp_path, case.id, lambda one: replace(one, **change))
    found = [problem for problem in verify(tmp_path) if not problem.what.startswith("no case has")]
    assert [(problem.clause, problem.what) for problem in found] == [(clause, what)]
    assert found[0].case == ("" if "flags" in change else case.id)


def test_an_unknown_operation(tmp_path: Path) -> None:
    """ORCL-CASE-1: its file, though, cannot be one of the suite's."""
    case = good()
    changed(tmp_path, case.id, lambda one: replace(one, op="word.guess"))
    found = {problem.what: problem for problem in verify(tmp_path)}
    assert found["no operation is named word.guess"].clause is Clause.ORCL_CASE_1
    assert found["no operation is named word.guess"].case == case.id


def test_another_operation_than_its_file(tmp_path: Path) -> None:
    """ORCL-SUITE-1."""
    case = first("word.encode", "ok")
    part = next(part for part in base().parts if part.op == "word.decode")
    others = tuple(one for one in base().parts if one is not part)
    written(tmp_path, (*others, replace(part, cases=(*part.cases, case))))
    found = [p for p in verify(tmp_path) if p.what == "it is of word.encode"]
    assert [(p.file, p.clause, p.case) for p in found] == [(DECODED, Clause.ORCL_SUITE_1, case.id)]


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"input": Raw(b'{"word":"E"}')}, "its input: Object missing required field `handles`"),
        ({"ok": Raw(b'{"faces":[]}')}, "its result: Object missing required field `vertices`"),
        ({"ok": UNSET}, "it has both a result and a rejection, or none"),
        (
            {"reject": Rejection(Fault.INVALID)},
            "it has both a result and a rejection, or none",
        ),
    ],
)
def test_another_form(
    tmp_path: Path, change: dict[str, Raw | UnsetType | Rejection], what: str
) -> None:
    """ORCL-CASE-1."""
    case = good()
    wrong = renamed(replace(case, **change))
    parts = [(part.profile, one) for part in base().parts for one in part.cases if one != case]
    written(tmp_path, parts_of([*parts, ("components", wrong)]))
    found = [problem for problem in verify(tmp_path) if problem.case == wrong.id]
    assert len(found) == 1
    assert found[0].what.startswith(what)
    assert (found[0].file, found[0].clause) == (DECODED, Clause.ORCL_CASE_1)


def test_a_flag_explained_twice(tmp_path: Path) -> None:
    """ORCL-CASE-5."""
    flag = base().flags[0]
    written(tmp_path, flags=[*base().flags, replace(flag, matters="twice")])
    what = f"{flag.name} is explained twice"
    assert only(tmp_path) == Problem("flags.json", what, Clause.ORCL_CASE_5)


def test_a_flag_that_none_has(tmp_path: Path) -> None:
    """ORCL-CASE-5."""
    written(tmp_path, flags=[*base().flags, Flag(name="idle", mistake="m", matters="w")])
    assert only(tmp_path) == Problem("flags.json", "no case has idle", Clause.ORCL_CASE_5)


def test_a_parent_that_is_not_there(tmp_path: Path) -> None:
    """ORCL-FAULT-1."""
    case = bad()
    assert isinstance(case.fault, FaultForm)
    fault = replace(case.fault, parent="nobody-aaaaaaaa")
    changed(tmp_path, case.id, lambda one: replace(one, fault=fault))
    found = only(tmp_path)
    assert (found.case, found.clause) == (case.id, Clause.ORCL_FAULT_2)
    assert found.what == "its parent nobody-aaaaaaaa is not in the suite"


def test_a_fault_that_does_not_undo(tmp_path: Path) -> None:
    """ORCL-FAULT-2."""
    case = bad()
    assert isinstance(case.fault, FaultForm)
    edit = Edit(path="/word", at=0, remove=Raw(b'"X"'), insert=Raw(b'"C"'))
    fault = replace(case.fault, undo=(edit,))
    changed(tmp_path, case.id, lambda one: replace(one, fault=fault))
    found = only(tmp_path)
    assert (found.case, found.clause) == (case.id, Clause.ORCL_FAULT_2)


def test_a_good_case_with_a_fault(tmp_path: Path) -> None:
    """ORCL-FAULT-1."""
    case = good()
    fault = FaultForm(kind="none", parent=case.id, undo=())
    changed(tmp_path, case.id, lambda one: replace(one, fault=fault))
    assert only(tmp_path).what == "it has a fault and is not rejected"


def test_a_canary_that_passes(tmp_path: Path) -> None:
    """ORCL-SUITE-7."""
    known = {one.id for one in base().cases}
    right = next(case for case in whole().cases if case.id not in known and not case.flags)
    written(tmp_path, canaries=(*base().canaries, right))
    found = only(tmp_path)
    assert (found.file, found.case, found.clause) == (
        "canaries.json",
        right.id,
        Clause.ORCL_SUITE_7,
    )
    assert found.what == "the reference comes to pass, and must fail"


def test_a_line_of_a_problem() -> None:
    """ORCL-SUITE-4."""
    problem = Problem("a.json", "it is bad", Clause.ORCL_CASE_1, "x-aaaaaaaa")
    assert problem.line() == "a.json: x-aaaaaaaa: it is bad [ORCL-CASE-1]"
    assert replace(problem, case="").line() == "a.json: it is bad [ORCL-CASE-1]"
