"""Suites compared, some of their cases, and copies."""

from pathlib import Path

import pytest
from msgspec.structs import replace
from tampered import CRE, base, first, whole, write, written

from clers.conformance.cases.case import Case, FaultForm
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.difference import Changed, Gone, difference
from clers.oracle.suite.files import Suite, read_suite
from clers.oracle.suite.records import Part, Retired, Score
from clers.oracle.suite.rendered import parts_of
from clers.oracle.suite.selected import copy_suite, matching, some_profiles, unknown
from clers.oracle.suite.verify import verify


def suite_of(cases: list[Case], retired: list[Retired], profile: str = "core") -> Suite:
    return Suite(
        base().manifest, parts_of([(profile, case) for case in cases]), (), tuple(retired), ()
    )


def test_what_became_of_cases() -> None:
    """ORCL-SUITE-8."""
    a, b, c, d, e = (replace(CRE, id=f"{name}-aaaaaaaa") for name in "abcde")
    first_suite = suite_of([a, b, c, d], [])
    gone = Retired(id=b.id, reason="wrong", successor=e.id)
    second = suite_of([a, replace(d, clauses=("EB-WORD-1",), comment="new"), e], [gone])
    found = difference(first_suite, second)
    assert found.added == (e.id,)
    assert found.retired == (Gone(b.id, "wrong", e.id),)
    assert found.removed == (Gone(c.id),)
    assert found.changed == (Changed(d.id, ("clauses", "comment")),)
    assert not found.none
    assert difference(first_suite, first_suite).none
    back = difference(second, first_suite)
    assert back.removed == (Gone(e.id),)
    assert back.added == (b.id, c.id)


def test_another_profile_is_a_change() -> None:
    """ORCL-SUITE-8."""
    found = difference(suite_of([CRE], []), suite_of([CRE], [], "handles"))
    assert found.changed == (Changed(CRE.id, ("profile",)),)
    assert not found.none


@pytest.mark.parametrize("part", ["added", "retired", "removed", "changed"])
def test_any_difference_is_one(part: str) -> None:
    """ORCL-SUITE-8."""
    none = difference(suite_of([CRE], []), suite_of([CRE], []))
    assert none.none
    some = {"changed": Changed("x", ("op",)), "added": "x"}.get(part, Gone("x"))
    assert not replace(none, **{part: (some,)}).none


def test_cases_that_match() -> None:
    """ORCL-SUITE-10."""
    suite = base()
    cases = [(part.profile, case) for part in suite.parts for case in part.cases]
    assert list(matching(suite)) == cases
    assert list(matching(suite, profile="components")) == cases
    assert list(matching(suite, profile="core")) == []
    decoded = [pair for pair in cases if pair[1].op == "word.decode"]
    assert list(matching(suite, op="word.decode")) == decoded
    clause = decoded[0][1].clauses[0]
    assert list(matching(suite, op="word.decode", clause=clause)) == [
        pair for pair in decoded if clause in pair[1].clauses
    ]
    flag = next(flag for _, case in decoded for flag in case.flags)
    found = list(matching(suite, flag=flag))
    assert found == [pair for pair in cases if flag in pair[1].flags]
    assert 0 < len(found) < len(cases)


@pytest.mark.parametrize(
    ("words", "stranger"),
    [
        (("", "", "", ""), ""),
        (("components", "word.decode", "EB-DECODE-1", ""), ""),
        (("core", "", "", ""), "core"),
        (("", "echo", "", ""), "echo"),
        (("", "", "NONE-SUCH-1", ""), "NONE-SUCH-1"),
        (("", "", "", "no-flag"), "no-flag"),
    ],
)
def test_words_that_no_case_has(words: tuple[str, str, str, str], stranger: str) -> None:
    """ORCL-SUITE-10."""
    assert unknown(base(), *words) == stranger


def test_a_copy_is_the_same(tmp_path: Path) -> None:
    """ORCL-SUITE-9."""
    score = Score(suite="else", mutants=2, killed=1)
    source = written(tmp_path / "one", mutation=score)
    suite = read_suite(source)
    assert isinstance(suite, Accepted)
    into = tmp_path / "two"
    copied = copy_suite(source, suite.value, into)
    assert isinstance(copied, Accepted)
    for path in copied.value:
        assert (into / path).read_bytes() == (source / path).read_bytes()
    assert read_suite(into) == suite


def test_a_copy_of_some_profiles(tmp_path: Path) -> None:
    """ORCL-SUITE-9: a suite of its own, in which all holds."""
    copied = copy_suite(tmp_path, whole(), tmp_path / "some", ("limits",))
    assert isinstance(copied, Accepted)
    assert verify(tmp_path / "some") == ()
    found = read_suite(tmp_path / "some")
    assert isinstance(found, Accepted)
    wanted = [case for part in whole().parts if part.profile == "limits" for case in part.cases]
    held = [case for part in found.value.parts if part.profile == "limits" for case in part.cases]
    assert held == wanted
    assert found.value.canaries == whole().canaries
    assert not (tmp_path / "some" / "inputs").exists()


def test_what_comes_with_some_profiles() -> None:
    """ORCL-SUITE-9: parents of faults; of what is retired, successors that are there."""
    bad = first("word.decode", "reject", "fault")
    assert isinstance(bad.fault, FaultForm)
    parents = {case.id: case for case in whole().cases}
    gone = (
        Retired(id="one-aaaaaaaa", reason="r", successor="nobody-aaaaaaaa"),
        Retired(id="two-aaaaaaaa", reason="r", successor=bad.id),
        Retired(id="three-aaaaaaaa", reason="r", successor="two-aaaaaaaa"),
    )
    of = suite_of([parents[bad.fault.parent]], list(gone))
    both = Suite(
        of.manifest,
        (*of.parts, Part(profile="limits", op="word.decode", cases=(bad,))),
        whole().flags,
        of.retired,
        (),
    )
    some = some_profiles(both, ("limits",))
    assert [case.id for case in some.cases] == [of.cases[0].id, bad.id]
    assert [entry.successor for entry in some.retired] == ["", bad.id, "two-aaaaaaaa"]
    assert {flag.name for flag in some.flags} == {*of.cases[0].flags, *bad.flags}
    assert some_profiles(both, ("core",)).cases == of.cases
    assert some_profiles(both, ("mixed",)).cases == ()


@pytest.mark.parametrize("there", ["file", "folder"])
def test_a_copy_overwrites_nothing(tmp_path: Path, there: str) -> None:
    """ORCL-SUITE-9."""
    into = tmp_path / "two"
    if there == "file":
        into.write_bytes(b"mine")
    else:
        write(into, {"mine": b"mine"})
    found = copy_suite(written(tmp_path / "one"), base(), into)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNWRITABLE_FILE
    assert found.detail == f"{into}: it is not empty"


def test_a_copy_of_what_cannot_be_read(tmp_path: Path) -> None:
    """ORCL-SUITE-9."""
    source = written(tmp_path / "one")
    suite = read_suite(source)
    assert isinstance(suite, Accepted)
    (source / "flags.json").unlink()
    found = copy_suite(source, suite.value, tmp_path / "two")
    assert isinstance(found, Rejected)
    assert not (tmp_path / "two").exists()
