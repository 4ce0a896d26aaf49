"""`clers explain`, run as a user runs it. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-5."""

import json
import shlex
import sys
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import msgspec
import pytest
from judged_by_hand import case_of
from small_suite import CANARIES, CODED, WORDS, small_suite
from typer.testing import CliRunner, Result
from typing_extensions import override

from clers.cli.explain_text import LONGEST, ROWS
from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case, Edit, FaultForm
from clers.conformance.cases.identity import named
from clers.conformance.judging.judged import Judged, Status
from clers.oracle.finding import Finding, Party, bytes_of

MISTAKEN = Path(__file__).parent / "mistaken_adapter.py"
TETRAHEDRON, NO_SYMBOL = WORDS


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def adapter(*mistakes: str) -> str:
    """The command line of the reference with mistakes; without, of one that makes none."""
    return shlex.join((sys.executable, str(MISTAKEN), *(mistakes or ("none",))))


@pytest.fixture
def vectors(tmp_path: Path) -> str:
    """The folder of a small suite."""
    folder = tmp_path / "vectors"
    fault = FaultForm(
        kind="letter",
        parent=TETRAHEDRON.id,
        undo=(Edit(path="/word", at=2, remove=msgspec.Raw(b'"X"'), insert=msgspec.Raw(b'"E"')),),
    )
    bad = msgspec.structs.replace(NO_SYMBOL, fault=fault)
    reject = (
        msgspec.structs.replace(NO_SYMBOL.reject, at={"symbol": 2}, clause="EB-GRAMMAR-1")
        if not isinstance(NO_SYMBOL.reject, msgspec.UnsetType)
        else None
    )
    assert reject is not None
    small_suite(folder, words=(TETRAHEDRON, named("no-symbol", _with(bad, reject=reject))))
    return str(folder)


def _with(case: Case, **changes: object) -> Case:
    return msgspec.structs.replace(case, **changes)


def test_a_case_is_explained(vectors: str) -> None:
    """Clauses: ORCL-EXPLAIN-1, ORCL-EXPLAIN-2."""
    done = clers("explain", TETRAHEDRON.id, "--vectors", vectors)
    assert done.exit_code == Exit.CONFORMING
    lines = done.stdout.splitlines()
    assert lines[:3] == [
        f"{TETRAHEDRON.id}  word.decode  (hand, size 0)",
        "asks:   word CRE, no handle data, 0 with boundary",
        "right:  4 faces on 4 vertices: (0,1,2) (3,2,1) (0,3,1) (2,3,0)",
    ]
    assert "clauses:" in lines
    assert any(text.startswith("  EB-DECODE-1  ") and len(text) > 40 for text in lines)
    assert lines[-4:] == [
        "0     P       0     –     0     0      1  0 1 2",
        "1     C       1     2→1   3     0      1  3",
        "2     R       2     3→1   0     0      1",
        "3     E       3     3→0   2     0      2",
    ]


def test_the_walk_is_that_of_clers_trace(vectors: str, tmp_path: Path) -> None:
    """Clauses: ORCL-EXPLAIN-2, EB-TRACE-1."""
    mesh = tmp_path / "tetrahedron.off"
    mesh.write_text("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 3 2 1\n3 0 3 1\n3 2 3 0\n")
    traced = clers("trace", str(mesh)).stdout
    explained = clers("explain", TETRAHEDRON.id, "--vectors", vectors).stdout
    assert traced.splitlines() == explained.splitlines()[-5:]


def test_as_json(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    done = clers("explain", "tetra", "--vectors", vectors, "--json")
    document = json.loads(done.stdout)
    assert (document["id"], document["op"]) == (TETRAHEDRON.id, "word.decode")
    assert document["clauses"][0]["name"] == "EB-DECODE-1"
    assert len(document["tables"][0]["rows"]) == 4
    assert "heard" not in document


def test_a_canary_is_explained_too(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    assert clers("explain", CANARIES[0].id, "--vectors", vectors).exit_code == Exit.CONFORMING


def test_a_fault(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-3."""
    done = clers("explain", "no-symbol", "--vectors", vectors)
    assert "right:  reject invalid: unknown-symbol at symbol 2 [EB-GRAMMAR-1]" in done.stdout
    assert "fault: letter; to blame: symbol 2" in done.stdout
    assert f"  without it: {TETRAHEDRON.id}" in done.stdout
    assert '  to undo it: /word, from 2 on: "X" becomes "E"' in done.stdout


def test_an_adapter_that_is_right(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-4."""
    done = clers("explain", TETRAHEDRON.id, "--vectors", vectors, "-a", adapter())
    assert done.exit_code == Exit.CONFORMING
    assert "clers 0.1.0: PASS" in done.stdout
    assert "first divergence" not in done.stdout


def test_an_adapter_that_goes_astray(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-4."""
    done = clers("explain", CODED[0].id, "--vectors", vectors, "-a", adapter("bits"))
    assert done.exit_code == Exit.NOT_CONFORMING
    lines = done.stdout.splitlines()
    at = lines.index("clers 0.1.0: FAIL")
    assert lines[at + 1 : at + 5] == [
        "  first divergence: bit 5, written at symbol 2 (E)",
        "    expected  1",
        "    got       nothing more",
        '  answered: {"hex":"b8","length":5}',
    ]
    assert lines[at + 6].startswith('  {"op":"code.encode","id":1,')
    request = json.loads(lines[at + 6])
    assert request["in"]["word"] == "CRE"


def test_reasons_are_judged_if_that_is_asked_for(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-4."""
    asked = ("explain", "no-symbol", "--vectors", vectors, "-a", adapter(), "--json")
    document = json.loads(clers(*asked).stdout)
    assert document["heard"]["judged"]["status"] == "pass"
    assert document["heard"]["command"][0] == sys.executable
    strict = json.loads(clers(*asked, "--strict-reasons").stdout)
    assert strict["heard"]["judged"]["status"] == "pass"
    wrong = clers(*asked[:5], adapter("classes"), "--json")
    assert wrong.exit_code == Exit.NOT_CONFORMING
    judged = json.loads(wrong.stdout)["heard"]["judged"]
    assert judged["signature"] == "word.decode fail malformed instead of invalid"


def test_a_verdict_without_a_divergence_says_why(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-4."""
    slow = clers(
        "explain", TETRAHEDRON.id, "--vectors", vectors, "--seconds", "0.2",
        "-a", shlex.join((sys.executable, str(MISTAKEN), "hang")),
    )  # fmt: skip
    assert slow.exit_code == Exit.NOT_CONFORMING
    assert "clers 0.1.0: TIMEOUT" in slow.stdout
    assert "  time-out: no reply in 0.2 s" in slow.stdout


def test_no_adapter(vectors: str) -> None:
    """Clause: ORCL-EXPLAIN-4."""
    done = clers("explain", TETRAHEDRON.id, "--vectors", vectors, "-a", "/no/such/program")
    assert done.exit_code == Exit.ADAPTER
    assert done.stderr.startswith("/no/such/program: ")


def test_pictures(vectors: str, tmp_path: Path) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    svg, png = tmp_path / "a.svg", tmp_path / "a.png"
    asked = ("explain", TETRAHEDRON.id, "--vectors", vectors)
    assert clers(*asked, "-o", str(png)).exit_code == Exit.CONFORMING
    assert png.read_bytes().startswith(b"\x89PNG")
    wrong = clers(*asked, "-a", adapter("letters", "turned"), "-o", str(svg))
    assert wrong.exit_code == Exit.NOT_CONFORMING
    text = "".join(ElementTree.parse(svg).getroot().itertext())
    assert "expected (0, 1, 2)" in text
    assert "got (1, 2, 0)" in text
    fault = clers("explain", "no-symbol", "--vectors", vectors, "-o", str(svg))
    assert fault.exit_code == Exit.CONFORMING
    assert "to blame: symbol 2" in svg.read_text()


def test_what_cannot_be_drawn_is_not_written(vectors: str, tmp_path: Path) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    out = tmp_path / "a.svg"
    done = clers("explain", "echo-0", "--vectors", vectors, "-o", str(out))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "not-drawable" in done.stderr
    assert not out.exists()


class _Tags(HTMLParser):
    """The tags of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.feed(text)

    @override
    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)


def test_a_page(vectors: str, tmp_path: Path) -> None:
    """Clauses: ORCL-EXPLAIN-5, ORCL-HTML-3: with the picture, or without where there is none."""
    out = tmp_path / "a.html"
    asked = ("explain", TETRAHEDRON.id, "--vectors", vectors, "-o", str(out))
    assert clers(*asked, "-a", adapter("turned")).exit_code == Exit.NOT_CONFORMING
    page = out.read_text()
    assert _Tags(page).tags.count("svg") == 1
    assert "clers 0.1.0: fail" in page
    assert "<dt>first divergence</dt><dd>face 0, made by P</dd>" in page
    assert page.count("<tr>") == 5
    assert clers(*asked).exit_code == Exit.CONFORMING
    assert "The adapter" not in out.read_text()
    assert clers("explain", "echo-0", "--vectors", vectors, "-o", str(out)).exit_code == 0
    assert "svg" not in _Tags(out.read_text()).tags
    assert clers("explain", "no-symbol", "--vectors", vectors, "-o", str(out)).exit_code == 0
    page = out.read_text()
    assert "<dt>to blame</dt><dd>symbol 2</dd>" in page
    assert "&#34;X&#34; becomes &#34;E&#34;" in page


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("explain", "nothing-like-it"), "no case"),
        (("explain", "echo-"), "10 cases begin with 'echo-'"),
        (("explain", "echo-0", "-o", "a.txt"), "a.txt is none of .svg, .png, .html"),
        (("explain", "echo-0", "-a", "'"), "No closing quotation"),
    ],
)
def test_wrong_usage(vectors: str, arguments: tuple[str, ...], said: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    done = clers(*arguments, "--vectors", vectors)
    assert done.exit_code == Exit.USAGE
    assert said in done.stderr


def test_a_suite_that_is_not_there(tmp_path: Path) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    done = clers("explain", "echo", "--vectors", str(tmp_path / "none"))
    assert done.exit_code == Exit.SELF_CHECK


def test_a_finding_is_explained(tmp_path: Path) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    finding = Finding(
        request='{"op":"word.decode","id":4,"in":' + bytes(TETRAHEDRON.input).decode() + "}",
        case=TETRAHEDRON,
        judged=Judged(id=TETRAHEDRON.id, op="word.decode", clauses=(), status=Status.FAIL),
        outcome="",
        adapter=Party(command=("x",), name="x", version="0", language="c"),
        protocol=1,
        spec="0",
    )
    file = tmp_path / "finding.json"
    file.write_bytes(bytes_of(finding))
    done = clers("explain", str(file))
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout.startswith(TETRAHEDRON.id)
    file.write_text("{}")
    assert clers("explain", str(file)).exit_code == Exit.NOT_CONFORMING


def test_long_tables_and_requests_are_cut_for_people(tmp_path: Path) -> None:
    """Clauses: ORCL-EXPLAIN-2, ORCL-EXPLAIN-4."""
    script = "; ".join(["split-face 0"] * 200)
    request = message.Apply(id=0, input=form.ScriptForm(script=script))
    case = _with(
        case_of(request), flags=("deaf",), comment="A comment.", requires=(), compare="isomorphic"
    )
    small_suite(tmp_path, words=(*WORDS, _with(named("long", case), op="operator.apply")))
    asked = ("explain", "long", "--vectors", str(tmp_path), "-a", adapter())
    done = clers(*asked)
    assert f"… and {201 - ROWS} more rows; --json has them all" in done.stdout
    assert "A comment." in done.stdout
    assert "  deaf" in done.stdout
    assert "(labels and orders are free)" in done.stdout
    assert done.stdout.splitlines()[-1].endswith("…")
    assert len(done.stdout.splitlines()[-1]) == LONGEST + 3
    assert len(json.loads(clers(*asked, "--json").stdout)["tables"][0]["rows"]) == 201
