"""The undo check: what it finds in cases that are not as they say."""

from collections.abc import Callable

import msgspec
import pytest
from msgspec import UNSET, Raw

from clers.conformance.cases.case import Case, FaultForm
from clers.conformance.cases.edits import replaced
from clers.conformance.cases.faults import fault_in, reference_answer
from clers.conformance.lines import NoMessage
from clers.conformance.messages import OkReply, Rejection, RejectReply, UnsupportedReply
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.edgebreaker.stream import Stream
from clers.oracle.negatives.draft import Slip, bad, good, request_of, spoilt
from clers.oracle.negatives.words import accepted, stream_form

replace = msgspec.structs.replace

PARENT = good("ball", "word.decode", stream_form(Stream("CRE")), (Clause.EB_DECODE_1,), size=4)
EDIT = replaced("/word", 0, "C", "R")
CHILD = bad(PARENT, "r-for-c", (EDIT,), Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8)
SUITE = {draft.case.id: draft.case for draft in (PARENT, CHILD)}


def test_a_good_case_and_a_bad_one_pass() -> None:
    """Clauses: ORCL-FAULT-1, ORCL-FAULT-2, ORCL-FAULT-4."""
    assert fault_in(PARENT.case, SUITE) == ""
    assert fault_in(CHILD.case, SUITE) == ""
    assert CHILD.profile == PARENT.profile == "core"
    assert CHILD.slug == "ball-r-for-c"
    assert CHILD.case.size == 4
    assert CHILD.case.clauses == ("EB-GRAMMAR-8",)
    assert CHILD.case.reject == Rejection(
        Fault.INVALID, "loop-not-closed", {"symbol": 0}, "EB-GRAMMAR-8"
    )
    undo = (replaced("/word", 0, "R", "C"),)
    assert CHILD.case.fault == FaultForm(kind="r-for-c", parent=PARENT.case.id, undo=undo)


def _fault(case: Case, **changes: object) -> Case:
    assert isinstance(case.fault, FaultForm)
    return replace(case, fault=replace(case.fault, **changes))


def _reject(case: Case, **changes: object) -> Case:
    assert isinstance(case.reject, Rejection)
    return replace(case, reject=replace(case.reject, **changes))


ELSE = Raw(b'{"word":"RRE","handles":[],"components_with_boundary":1}')
LIMIT = Raw(b'{"faces":[[0,1,2]],"vertices":67108865}')


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (lambda c: replace(c, reject=UNSET), "it has a fault and is not rejected"),
        (lambda c: replace(c, input=PARENT.case.input), "the reference accepts it"),
        (lambda c: replace(c, op="word.spell"), "the reference does not reject it"),
        (lambda c: _reject(c, fault=Fault.MALFORMED), "the reference rejects it otherwise"),
        (lambda c: _reject(c, reason="double-edge"), "the reference rejects it otherwise"),
        (lambda c: _reject(c, at={"symbol": 1}), "the reference rejects it otherwise"),
        (lambda c: _reject(c, clause="EB-GRAMMAR-5"), "the reference rejects it otherwise"),
        (lambda c: replace(c, fault=UNSET), "it names no fault"),
        (lambda c: _fault(c, parent="none-aaaaaaaa"), "its parent none-aaaaaaaa is not in"),
        (lambda c: _fault(c, parent=CHILD.case.id), "is of another operation, or rejected"),
        (lambda c: _fault(c, undo=()), "undoing its fault does not give the input of ball-"),
        (
            lambda c: _fault(c, undo=(replaced("/word", 0, "L", "C"),)),
            'its fault cannot be undone: "L" is not at /word, place 0',
        ),
        (lambda c: _fault(c, sealed=True), "its fault cannot be undone: only a file has seals"),
        (
            lambda c: _fault(c, undo=(replaced("/word", 0, "R", "L"),)),
            "undoing its fault does not give the input of ball-",
        ),
    ],
)
def test_what_is_wrong_is_named(change: Callable[[Case], Case], why: str) -> None:
    """Clauses: ORCL-FAULT-1, ORCL-FAULT-2, ORCL-FAULT-4."""
    assert why in fault_in(change(CHILD.case), SUITE)


def test_a_parent_of_another_operation() -> None:
    """Clause: ORCL-FAULT-1."""
    other = replace(PARENT.case, op="word.encode")
    assert "another operation" in fault_in(CHILD.case, {PARENT.case.id: other})


def test_a_parent_that_is_not_accepted() -> None:
    """Clause: ORCL-FAULT-4."""
    undo = (replaced("/word", 0, "R", "L"),)
    word = Raw(bytes(PARENT.case.input).replace(b"CRE", b"LRE"))
    wrong = replace(PARENT.case, input=word)
    found = fault_in(_fault(CHILD.case, undo=undo), {PARENT.case.id: wrong})
    assert found.startswith("the reference does not accept its parent")


def test_a_parent_that_is_no_request() -> None:
    """Clause: ORCL-FAULT-4."""
    text = replaced("/word", 0, "R", "")
    none = replaced("/word", 0, "RE", 7)
    wrong = replace(PARENT.case, input=Raw(bytes(PARENT.case.input).replace(b'"CRE"', b"7")))
    found = fault_in(_fault(CHILD.case, undo=(text, none)), {PARENT.case.id: wrong})
    assert found.startswith("its parent is no request")


def test_a_fault_that_is_none() -> None:
    """Undoing must change something. Clause: ORCL-FAULT-4."""
    same = replace(PARENT.case, input=CHILD.case.input)
    none = _fault(CHILD.case, undo=())
    assert fault_in(none, {PARENT.case.id: same}) == "it has no fault: its input is its parent's"


def test_only_limits_need_no_fault() -> None:
    """Clauses: ORCL-FAULT-1, ORCL-FAULT-4, ORCL-LIMIT-1."""
    reject = Rejection(Fault.LIMIT, "too-many-vertices", {}, "CPLX-REJECT-2")
    case = replace(CHILD.case, op="surface.classify", input=LIMIT, reject=reject, fault=UNSET)
    assert fault_in(case, {}) == ""
    assert fault_in(_reject(case, detail="words do not count"), {}) == ""


def test_the_answer_of_the_reference() -> None:
    """Clause: ORCL-CASE-1."""
    assert isinstance(reference_answer(PARENT.case), OkReply)
    assert isinstance(reference_answer(CHILD.case), RejectReply)
    assert isinstance(reference_answer(replace(PARENT.case, op="none")), NoMessage)
    code = Raw(b'{"code":"morse","word":"CRE","handles":[],"components_with_boundary":0}')
    morse = replace(PARENT.case, op="code.encode", input=code)
    assert isinstance(reference_answer(morse), UnsupportedReply)


def test_a_slip_of_the_writer_stops_the_making() -> None:
    """Who states a wrong reason or clause, or edits what is not there, hears of it.

    Clause: ORCL-FAULT-4.
    """
    for reason, clause in (
        (Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_5),
        (Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_8),
    ):
        with pytest.raises(Slip, match="ball-r-for-c"):
            bad(PARENT, "r-for-c", (EDIT,), reason, clause)
    same = (replaced("/word", 0, "C", "C"),)
    with pytest.raises(Slip, match="ball-c-for-c"):
        bad(PARENT, "c-for-c", same, Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8)
    with pytest.raises(Slip, match="is not at /word"):
        spoilt(PARENT, "x", (replaced("/word", 0, "E", "C"),))
    with pytest.raises(Slip, match="CRE"):
        request_of("word.encode", PARENT.case.input)
    with pytest.raises(Slip):
        spoilt(PARENT, "x", (replaced("/word", 0, "CRE", 7),))
    with pytest.raises(AssertionError):
        good("none", "word.decode", stream_form(Stream("RRE")), ())


def test_a_spoilt_case_may_be_good_after_all() -> None:
    """Clause: EB-DECODE-2."""
    draft = spoilt(PARENT, "open", (replaced("/components_with_boundary", 0, 0, 1),))
    assert draft.case.fault is UNSET
    assert draft.case.reject is UNSET
    assert draft.case.ok is not UNSET
    assert accepted("none", Stream("RRE")) is None


def test_what_a_fault_needs_is_added_to_its_parents_needs() -> None:
    """Clause: ORCL-CASE-4."""
    parent = good(
        "ball", "word.decode", stream_form(Stream("CRE")), (), size=4, requires=("handles",)
    )
    draft = spoilt(
        parent, "open", (EDIT,), requires=("components", "handles"), size=7, flags=("a", "b")
    )
    assert draft.case.requires == ("components", "handles")
    assert draft.case.size == 7
    assert draft.case.flags == ("a", "b")
    assert draft.profile == "mixed"
    assert spoilt(parent, "open", (EDIT,), size=1).case.size == 4
