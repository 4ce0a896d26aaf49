"""A run for people at a terminal, for build systems, and line by line."""

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as Xml

import msgspec
import pytest
from msgspec import UNSET
from small_suite import ECHOES, RETIRED, WORDS

from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import GOOD, Divergence, Judged, Status
from clers.conformance.serve import INTRODUCTION
from clers.conventions.result import Accepted, Rejected
from clers.oracle.reports.report import Report, Ruling
from clers.oracle.runs.baseline import Stale
from clers.oracle.runs.events import Came, Sang
from clers.oracle.runs.minutes import Minutes
from clers.oracle.runs.reports.asked import AskedFor, NoReport, asked_for, write
from clers.oracle.runs.reports.document import document
from clers.oracle.runs.reports.jsonl import Lines
from clers.oracle.runs.reports.junit import ELEMENT, junit
from clers.oracle.runs.reports.terminal import BLOCKS, blocks, tail
from clers.oracle.runs.selection import Chosen, Selected

PARTED = Divergence(
    kind="face", place="symbol 5 (S), face 6", expected="(4, 9, 2)", got="(4, 2, 9)"
)


def ruling(case: Case, status: Status, profile: str = "core", **more: str) -> Ruling:
    judged = Judged(
        id=case.id,
        op=case.op,
        clauses=case.clauses,
        status=status,
        why=more.get("why", ""),
        signature=more.get("signature", ""),
        divergence=PARTED if status is Status.FAIL else UNSET,
    )
    return Ruling(profile, case, judged)


def report(*rulings: Ruling, command: tuple[str, ...] = ("./mine", "--fast")) -> Report:
    return Report(
        suite="abcabcabcabc",
        specification="1.0",
        adapter=INTRODUCTION,
        command=command,
        rulings=rulings,
    )


def test_a_block() -> None:
    """ORCL-REPORT-2."""
    said = report(
        ruling(WORDS[0], Status.FAIL, signature="word.decode fail face"),
        ruling(ECHOES[0], Status.CRASH, signature="echo crash", why="crash: exit code 3"),
        ruling(WORDS[1], Status.FAIL, signature="word.decode fail face"),
        ruling(ECHOES[1], Status.PASS),
        ruling(ECHOES[2], Status.SKIP, why="skipped"),
        ruling(ECHOES[3], Status.XFAIL, why="known"),
    )
    texts = {
        "EB-DECODE-1": "From a word and its handle data the decoder makes faces, in this order: …"
    }
    assert tuple(blocks(replace(said, texts=texts))) == (
        f"FAIL {WORDS[0].id}  word.decode  "
        'EB-DECODE-1 "From a word and its handle data the decoder makes faces, in…"',
        "  first divergence: symbol 5 (S), face 6: expected (4, 9, 2), got (4, 2, 9)",
        "  and 1 more like it",
        f"  more: clers explain {WORDS[0].id} -a './mine --fast'",
        "",
        f"CRASH {ECHOES[0].id}  echo  ORCL-OP-1",
        "  crash: exit code 3",
        f"  more: clers explain {ECHOES[0].id} -a './mine --fast'",
        "",
    )
    short = replace(said, texts={"ORCL-OP-1": "short"})
    assert list(blocks(short))[5] == f'CRASH {ECHOES[0].id}  echo  ORCL-OP-1 "short"'
    for length, shown in ((60, "x" * 60), (61, "x" * 59 + "…")):
        edge = replace(said, texts={"ORCL-OP-1": "x" * length})
        assert list(blocks(edge))[5].endswith(f'ORCL-OP-1 "{shown}"')
    assert list(blocks(report(ruling(ECHOES[1], Status.PASS)))) == []


def test_a_command_is_one_word_of_a_shell() -> None:
    """ORCL-REPORT-2: it can be pasted as it stands."""
    said = report(ruling(ECHOES[0], Status.ERROR), command=("node", "my adapter.js"))
    assert list(blocks(said))[2].endswith(""" -a 'node '"'"'my adapter.js'"'"''""")


def test_a_block_for_each_signature() -> None:
    """ORCL-REPORT-2: twenty of them, and how many more there are."""
    kinds = [ruling(ECHOES[0], Status.ERROR, signature=f"echo error {k}") for k in range(23)]
    lines = list(blocks(report(*kinds, *kinds)))
    assert sum(line.startswith("ERROR ") for line in lines) == BLOCKS == 20
    assert lines.count("  and 1 more like it") == 20
    assert lines[-2:] == ["… and 3 more kinds of failure: see --report html=FILE", ""]
    assert len(list(blocks(report(*kinds[:20])))) == 20 * 4


def minutes_of(counted: int, *rulings: Ruling) -> Minutes:
    chosen = tuple(Chosen(of.profile, of.case) for of in rulings)
    minutes = Minutes(Selected(chosen, counted))
    for of in rulings:
        minutes.take(Came(of.judged, of.judged))
    return minutes


def test_the_last_lines() -> None:
    """Clauses: ORCL-REPORT-2, ORCL-CHECK-3, ORCL-CHECK-11."""
    rulings = (
        ruling(WORDS[0], Status.PASS),
        ruling(ECHOES[0], Status.SKIP, why="code.plain is not declared"),
        ruling(ECHOES[1], Status.SKIP, why="handles is not declared"),
        ruling(ECHOES[2], Status.SKIP, why="code.plain is not declared"),
    )
    minutes = minutes_of(4, *rulings)
    skips = ["skipped 2: code.plain is not declared", "skipped 1: handles is not declared"]
    who = f"{INTRODUCTION.name} {INTRODUCTION.version}"
    assert list(tail(report(*rulings), minutes)) == [*skips, f"{who} conforms: 1 pass, 3 skip"]
    minutes.take(Sang(ruling(ECHOES[3], Status.FAIL).judged))
    minutes.take(Sang(ruling(ECHOES[4], Status.PASS).judged))
    assert list(tail(report(*rulings), minutes)) == [
        *skips,
        "canaries: 1 of 2 wrong vectors passed",
        f"{who} was not judged: the oracle's own check failed: "
        f"wrong vectors passed: {ECHOES[4].id}",
    ]
    failed = ruling(WORDS[0], Status.FAIL)
    assert list(tail(report(failed), minutes_of(1, failed))) == [
        f"{who} does not conform: 1 of 1 cases"
    ]


EVERY = [ruling(ECHOES[k], status, why=f"why {k}") for k, status in enumerate(Status)]


def test_junit_says_what_its_readers_read() -> None:
    """ORCL-REPORT-6: the shape that Jenkins, GitLab and GitHub's readers take."""
    other = ruling(WORDS[0], Status.FAIL, "handles", why="it parts", signature="word fail")
    root = Xml.fromstring(junit(report(*EVERY, other)))
    assert root.tag == "testsuites"
    assert [suite.get("name") for suite in root] == ["core", "handles"]
    for element in (root, *root):
        cases = list(element.iter("testcase"))
        for attribute, tag in (
            ("failures", "failure"),
            ("errors", "error"),
            ("skipped", "skipped"),
        ):
            assert int(element.attrib[attribute]) == sum(
                len(case.findall(tag)) for case in cases
            ), attribute
        assert int(element.attrib["tests"]) == len(cases)
    found = {case.get("name"): [child.tag for child in case] for case in root.iter("testcase")}
    assert [*found] == [*(case.id for case in ECHOES), WORDS[0].id]
    tags = dict(zip(Status, (found[case.id] for case in ECHOES), strict=True))
    assert tags == {
        Status.PASS: [],
        Status.FAIL: ["failure"],
        Status.SKIP: ["skipped"],
        Status.CRASH: ["error"],
        Status.TIMEOUT: ["error"],
        Status.PROTOCOL: ["error"],
        Status.ERROR: ["error"],
        Status.FLAKY: ["error"],
        Status.XFAIL: ["skipped"],
        Status.XPASS: ["failure"],
    }
    failed = root[1][0]
    assert failed.attrib == {"classname": "handles.word.decode", "name": WORDS[0].id}
    assert failed[0].attrib == {"message": "it parts", "type": "fail"}
    assert failed[0].text == "word fail\nclauses: EB-DECODE-1"
    skipped = next(case for case in root[0] if case.get("name") == ECHOES[2].id)[0]
    assert (skipped.attrib, skipped.text) == ({"message": "why 2"}, None)


def test_junit_is_xml_whatever_was_said() -> None:
    """ORCL-REPORT-6."""
    said = 'it said "<&>\x00\x1b[0m\udc80\ufffe ok\t\U0001f600'
    root = Xml.fromstring(junit(report(ruling(ECHOES[0], Status.ERROR, why=said))))
    message = root[0][0][0].get("message")
    assert message == 'it said "<&>\ufffd\ufffd[0m\ufffd\ufffd ok\t\U0001f600'
    assert {*ELEMENT} == {*Status} - {Status.PASS}


def test_lines_are_there_at_once(tmp_path: Path) -> None:
    """ORCL-REPORT-5."""
    paths = (tmp_path / "one.jsonl", tmp_path / "two.jsonl")
    with Lines(paths) as lines:
        for k, of in enumerate(EVERY, 1):
            lines.add(of.judged)
            for path in paths:
                read = [
                    msgspec.json.decode(line, type=Judged)
                    for line in path.read_bytes().splitlines()
                ]
                assert read == [of.judged for of in EVERY[:k]]
    with pytest.raises(OSError, match="No such file"):
        Lines((tmp_path / "none" / "file",))


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        ([], ()),
        (["junit=a.xml"], (("junit", "a.xml"),)),
        (["junit=a,b.xml,jsonl=c=d.jsonl"], (("junit", "a,b.xml"), ("jsonl", "c=d.jsonl"))),
        (["jsonl=x", "jsonl=y"], (("jsonl", "x"), ("jsonl", "y"))),
    ],
)
def test_reports_that_are_asked_for(
    texts: list[str], expected: tuple[tuple[str, str], ...]
) -> None:
    """ORCL-REPORT-4."""
    assert asked_for(texts) == tuple(AskedFor(kind, Path(path)) for kind, path in expected)


@pytest.mark.parametrize("text", ["", "junit", "junit=", "pdf=a.pdf", "=a", "a.xml"])
def test_what_is_no_report(text: str) -> None:
    """ORCL-REPORT-4."""
    found = asked_for(["jsonl=fine", text])
    assert isinstance(found, NoReport)
    assert repr(text) in found.why


@pytest.mark.parametrize("kind", ["md", "html"])
def test_pages_for_people(kind: str, tmp_path: Path) -> None:
    """Clauses: ORCL-REPORT-1, ORCL-REPORT-4, ORCL-REPORT-7: all cases that are not good."""
    file = tmp_path / "page"
    assert write(AskedFor(kind, file), report(*EVERY)) == Accepted(file)
    text = file.read_text(encoding="utf-8")
    for of in EVERY:
        assert (of.judged.id in text) is (of.judged.status not in GOOD)


def test_a_report_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    """ORCL-REPORT-7."""
    file = tmp_path / "report.xml"
    said = report(*EVERY)
    assert write(AskedFor("junit", file), said) == Accepted(file)
    assert file.read_bytes() == junit(said)
    assert isinstance(write(AskedFor("junit", tmp_path / "none" / "file"), said), Rejected)
    streamed = tmp_path / "lines"
    assert write(AskedFor("jsonl", streamed), said) == Accepted(streamed)
    assert not streamed.exists()


def as_json(judged: Judged) -> object:
    return msgspec.json.decode(msgspec.json.encode(judged), type=object)


def test_the_document() -> None:
    """ORCL-REPORT-3."""
    rulings = (
        ruling(WORDS[0], Status.FAIL),
        ruling(WORDS[1], Status.PASS),
        ruling(ECHOES[0], Status.SKIP, "codes", why="code.plain is not declared"),
        ruling(ECHOES[1], Status.SKIP, "codes", why="code.plain is not declared"),
    )
    minutes = minutes_of(5, *rulings)
    sang = ruling(ECHOES[3], Status.FAIL).judged
    minutes.take(Sang(sang))
    stale = (Stale(RETIRED[0].id, "retired"),)
    said = msgspec.json.encode(document(report(*rulings), minutes, stale))
    assert msgspec.json.decode(said) == {
        "suite": "abcabcabcabc",
        "specification": "1.0",
        "command": ["./mine", "--fast"],
        "adapter": msgspec.json.decode(msgspec.json.encode(INTRODUCTION)),
        "conforms": False,
        "ending": "was not judged: the oracle's own check failed",
        "why": "4 results, 5 cases by the manifest: they are not in the files",
        "cases": 4,
        "missing": 1,
        "counts": {"fail": 1, "pass": 1, "skip": 2},
        "profiles": [
            {"profile": "core", "counts": {"fail": 1, "pass": 1}},
            {"profile": "codes", "counts": {"skip": 2}},
        ],
        "lacking": {"code.plain is not declared": 2},
        "canaries": [as_json(sang)],
        "stale": [{"id": RETIRED[0].id, "fate": "retired"}],
        "results": [as_json(of.judged) for of in rulings if of.judged.status is not Status.PASS],
    }
