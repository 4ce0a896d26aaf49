"""Adapters that are wrong in ways that people are, each seen for what it is; and bad plumbing."""

from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import pytest
from msgspec import UNSET, UnsetType
from small_suite import (
    ECHOES,
    HASTY,
    PATIENT,
    WORDS,
    adapter,
    bad_adapter,
    right,
    wrong_adapter,
)

from clers.conformance.bounds import Bounds
from clers.conformance.cases.case import Case, right_result
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.outcome import NoProcess
from clers.conformance.payloads import Faces
from clers.conformance.results import RESULTS
from clers.conformance.serve import INTRODUCTION
from clers.conventions.result import Accepted
from clers.oracle.pool.place import Local
from clers.oracle.runs.events import Came
from clers.oracle.runs.pieces import Adapter, meet
from clers.oracle.runs.run import Plan, run
from clers.oracle.suite.files import DEFAULT, Suite, read_suite

A_FILE = 10
"""So many cases of each file of the suite."""


@pytest.fixture(scope="module")
def suite() -> Suite:
    found = read_suite(DEFAULT)
    assert isinstance(found, Accepted), found
    return found.value


@pytest.fixture(scope="module")
def some(suite: Suite) -> tuple[Case, ...]:
    """A few cases of each file, the larger ones later."""
    return tuple(
        case for part in suite.parts for case in part.cases[:: -(-len(part.cases) // A_FILE)]
    )


def like_the_reference(*command: str) -> Adapter:
    """Their hello is the reference's: this spares a process."""
    return Adapter(wrong_adapter(*command), INTRODUCTION, PATIENT)


def last_words(who: Adapter, cases: tuple[Case, ...]) -> tuple[Judged, ...]:
    events = run(Plan(who, Local(1)), cases)
    return tuple({event.raw.id: event.raw for event in events if isinstance(event, Came)}.values())


def failures(judged: tuple[Judged, ...]) -> dict[str, set[Status]]:
    """What is not good, by operation."""
    found: defaultdict[str, set[Status]] = defaultdict(set)
    for each in judged:
        if each.status not in GOOD:
            found[each.op].add(each.status)
    return found


FAIL = {Status.FAIL}
FORESEEN: dict[str, dict[str, set[Status]]] = {
    "reference": {},
    "mirrors": {"word.encode": FAIL, "word.decode": FAIL},
    "miscounts_handles": {"word.encode": FAIL},
    "forgets_the_last_bit": {"arithmetic.encode": FAIL, "code.encode": FAIL},
}


@pytest.mark.parametrize("name", FORESEEN)
def test_wrong_about_one_thing(name: str, some: tuple[Case, ...]) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-ORDER-2: seen in the operations that show it, and no other."""
    judged = last_words(like_the_reference(name), some)
    assert len(judged) == len(some)
    assert failures(judged) == FORESEEN[name]


def faces(case: Case) -> int:
    result = right_result(case)
    return len(result.faces) if isinstance(result, Faces) else 0


def test_a_leak_that_the_order_hides(suite: Suite) -> None:
    """Clauses: ORCL-ORDER-1, ORCL-ORDER-2: all pass while meshes grow, but not when they shrink."""
    words = [case for case in suite.cases if case.op == "word.decode"]
    growing = tuple(sorted(words[:: len(words) // 30], key=faces))
    judged = last_words(like_the_reference("keeps_old_faces"), growing)
    assert len(judged) == len(growing)
    assert failures(judged) == {"word.decode": {Status.FLAKY}}
    leaks = [each for each in judged if each.status is Status.FLAKY]
    assert len(leaks) >= 3
    assert all(each.why.startswith("state leaks: first pass; in another") for each in leaks)


def test_right_answers_of_other_cases(some: tuple[Case, ...]) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-ORDER-2."""
    judged = last_words(like_the_reference("answers_the_one_before"), some)
    found = failures(judged)
    assert {*found} == {*RESULTS}
    assert set().union(*found.values()) == {Status.FAIL, Status.FLAKY}


@pytest.mark.parametrize(
    "command",
    [
        ("accepts_all",),
        ("rejects_all", "invalid"),
        ("rejects_all", "malformed"),
    ],
    ids=" ".join,
)
def test_who_looks_at_nothing(
    command: tuple[str, ...], some: tuple[Case, ...], suite: Suite
) -> None:
    """ORCL-CHECK-13: there is a failure in each profile; limits may all be rejected."""
    profiles = {case.id: part.profile for part in suite.parts for case in part.cases}
    judged = last_words(like_the_reference(*command), some)
    failed = {profiles[each.id] for each in judged if each.status is Status.FAIL}
    rejecting = {"limits"} if command[0] == "rejects_all" else set()
    assert failed | rejecting == {part.profile for part in suite.parts}


def test_no_profile_can_be_passed_blindly(suite: Suite) -> None:
    """ORCL-CHECK-13: in each is something to reject or two results, and more than one class."""
    results: defaultdict[str, set[tuple[str, bytes]]] = defaultdict(set)
    classes: defaultdict[str, set[str]] = defaultdict(set)
    for part in suite.parts:
        for case in part.cases:
            if isinstance(case.reject, UnsetType):
                assert case.ok is not UNSET
                results[part.profile].add((part.op, bytes(case.ok)))
                classes[part.profile].add("ok")
            else:
                classes[part.profile].add(str(case.reject.fault))
    for part in suite.parts:
        rejected = classes[part.profile] - {"ok"}
        ops = {op for op, _ in results[part.profile]}
        assert rejected or len(results[part.profile]) > len(ops), part.profile
        assert len(classes[part.profile]) > 1, part.profile
        assert ("ok" in classes[part.profile]) is (part.profile != "limits")


LETTERS = right("letters", "echo", {"χ": "χ"}, {"χ": "χ"})
SMALL = replace(PATIENT, farewell=0.5, output=2_000_000, memory=200 << 20)
PASS, FLAKY, CRASH = {Status.PASS}, {Status.PASS, Status.FLAKY}, {Status.CRASH}
PROTOCOL = {Status.PROTOCOL}
PLUMBING: dict[str, tuple[Bounds, set[Status]]] = {
    "good": (SMALL, PASS),
    "accepts_everything": (SMALL, PASS | FAIL),
    "answers_twice": (SMALL, PROTOCOL),
    "changes_its_mind": (SMALL, {Status.ERROR}),
    "chats": (SMALL, PROTOCOL),
    "closes_its_output": (SMALL, CRASH),
    "crashes_on_the_seventh": (SMALL, FLAKY),
    "drops_an_id": (SMALL, PROTOCOL),
    "eats_memory": (SMALL, CRASH),
    "floods": (SMALL, PROTOCOL),
    "hangs": (HASTY, {Status.TIMEOUT}),
    "leaves_a_child": (SMALL, PASS),
    "leaves_a_child_and_crashes": (SMALL, CRASH),
    "loses_letters": (SMALL, PASS | FAIL),
    "reads_nothing": (HASTY, {Status.TIMEOUT}),
    "rejects_everything": (SMALL, PASS | FAIL),
    "starts_slowly": (SMALL, PASS),
    "stays_after_bye": (SMALL, PASS),
    "talks_back": (SMALL, PASS),
}
"""What the statuses of some echoes are, and of two words where they are declared."""
NOBODY = {"exits_at_hello", "prints_a_banner", "speaks_another_version"}
OTHERWISE = {"answers_again_later", "answers_late", "crashes_once"}


def test_all_bad_plumbing_is_foreseen() -> None:
    """ORCL-CHECK-1."""
    folder = Path(bad_adapter("good")[1]).parent
    assert {path.stem for path in folder.glob("*.py")} == {*PLUMBING, *NOBODY, *OTHERWISE}


@pytest.mark.parametrize("name", PLUMBING)
def test_bad_plumbing(name: str) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-10, ORCL-JUDGE-10."""
    bounds, expected = PLUMBING[name]
    echoes = ECHOES[:6] if name == "crashes_on_the_seventh" else ECHOES[:2]
    judged = last_words(adapter(bad_adapter(name), bounds), (LETTERS, *echoes, *WORDS))
    assert {each.status for each in judged} - {Status.SKIP} == expected


@pytest.mark.parametrize("name", sorted(NOBODY))
def test_nobody_to_ask(name: str) -> None:
    """ORCL-CHECK-10."""
    assert isinstance(meet(bad_adapter(name), SMALL), NoProcess)


def test_late_and_flaky(tmp_path: Path) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-RUN-3, ORCL-RUN-5."""
    late = last_words(adapter(bad_adapter("answers_late", "1"), HASTY), ECHOES[:3])
    assert Status.TIMEOUT in {each.status for each in late}
    once = last_words(adapter(bad_adapter("crashes_once", str(tmp_path / "mark"))), ECHOES[:3])
    assert [each.status for each in once] == [Status.FLAKY, Status.PASS, Status.PASS]
    again = last_words(adapter(bad_adapter("answers_again_later")), ECHOES[:3])
    assert Status.PROTOCOL in {each.status for each in again}
