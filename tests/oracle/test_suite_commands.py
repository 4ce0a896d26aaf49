"""`clers vectors`, as a user runs it: output, JSON and exit codes."""

import json
import shutil
from pathlib import Path

import pytest
from msgspec.structs import replace
from tampered import base, written
from test_suite_generate import found_case
from typer.testing import CliRunner, Result

from clers import SPEC_VERSION
from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance.judging.judged import Judged, Status
from clers.oracle.finding import Finding, Party, bytes_of
from clers.oracle.positives.echoes import echoes
from clers.oracle.suite import files as suite_files
from clers.oracle.suite import generated
from clers.oracle.suite.files import DEFAULT
from clers.oracle.suite.records import Retired


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["vectors", *arguments])


def lines(done: Result) -> list[str]:
    return done.stdout.splitlines()


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(generated, "FAMILIES", {"echoes": lambda _: echoes()})
    monkeypatch.setattr(generated, "negatives", lambda _: ())


@pytest.mark.usefixtures("few")
def test_generate_and_compare(tmp_path: Path) -> None:
    """ORCL-SUITE-5, ORCL-SUITE-12."""
    folder = str(tmp_path)
    names = ["canaries.json", "core/echo.json", "flags.json", "manifest.json", "retired.json"]
    checked = clers("generate", folder, "--check")
    assert checked.exit_code == Exit.NOT_CONFORMING
    assert lines(checked)[:-1] == [f"{name}: differs" for name in names]
    assert not any(tmp_path.iterdir())
    made = clers("generate", folder)
    assert made.exit_code == Exit.CONFORMING
    assert lines(made)[:-1] == [f"{name}: written" for name in names]
    size = sum((tmp_path / name).stat().st_size for name in names)
    assert lines(made)[-1] == f"{folder}: 5 files, {size} bytes, 5 changed"
    again = clers("generate", folder, "--check", "--json")
    assert again.exit_code == Exit.CONFORMING
    assert json.loads(again.stdout) == {
        "folder": folder,
        "files": 5,
        "bytes": size,
        "changed": [],
    }
    file = tmp_path / "core" / "echo.json"
    file.write_bytes(file.read_bytes() + b" ")
    changed = clers("generate", folder, "--check", "--json")
    assert changed.exit_code == Exit.NOT_CONFORMING
    assert json.loads(changed.stdout)["changed"] == ["core/echo.json"]


@pytest.mark.usefixtures("few")
def test_generate_retires_only_with_a_reason(tmp_path: Path) -> None:
    """ORCL-SUITE-6, ORCL-SUITE-12."""
    folder = str(written(tmp_path))
    before = {path: path.read_bytes() for path in tmp_path.rglob("*.json")}
    count = len(base().cases)
    refused = clers("generate", folder)
    assert refused.exit_code == Exit.NOT_CONFORMING
    said = refused.stderr.splitlines()
    assert said[0] == (
        f"{base().cases[0].id}: gone, and not retired: say why with --retire [ORCL-SUITE-6]"
    )
    assert said[-1] == f"{folder}: {count} cases, nothing written"
    as_json = clers("generate", folder, "--json")
    assert json.loads(as_json.stdout)["unretired"] == [case.id for case in base().cases]
    assert before == {path: path.read_bytes() for path in tmp_path.rglob("*.json")}
    done = clers("generate", folder, "--retire", "not wanted")
    assert done.exit_code == Exit.CONFORMING
    assert "components/word.decode.json: written" in lines(done)
    assert not (tmp_path / "components" / "word.decode.json").exists()
    gone = json.loads((tmp_path / "retired.json").read_text())["retired"]
    assert len(gone) == count
    assert clers("verify", folder).exit_code == Exit.NOT_CONFORMING  # flags that none has


@pytest.mark.usefixtures("few")
def test_generate_uses_no_id_again(tmp_path: Path) -> None:
    """ORCL-SUITE-6."""
    folder = str(tmp_path)
    assert clers("generate", folder).exit_code == Exit.CONFORMING
    name = json.loads((tmp_path / "core" / "echo.json").read_text())["cases"][3]["id"]
    gone = {"retired": [{"id": name, "reason": "it was wrong"}]}
    (tmp_path / "retired.json").write_text(json.dumps(gone))
    refused = clers("generate", folder, "--retire", "why not")
    assert refused.exit_code == Exit.NOT_CONFORMING
    assert refused.stderr.splitlines() == [
        f"{name}: its id is retired [ORCL-SUITE-6]",
        f"{folder}: 1 cases, nothing written",
    ]
    assert json.loads(clers("generate", folder, "--json").stdout)["reused"] == [name]


@pytest.mark.usefixtures("few")
@pytest.mark.parametrize("path", ["flags.json", "inputs/shrunk.json"])
def test_generate_from_what_cannot_be_read(tmp_path: Path, path: str) -> None:
    """ORCL-SUITE-12, TOOL-OUTPUT-2."""
    file = written(tmp_path) / path
    file.parent.mkdir(exist_ok=True)
    file.write_text("[]")
    done = clers("generate", str(tmp_path))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert f"{path}: Expected `object`, got `array`" in done.stderr


def test_verify(tmp_path: Path) -> None:
    """ORCL-SUITE-4, ORCL-SUITE-12."""
    folder = str(written(tmp_path))
    good = clers("verify", folder)
    assert (good.exit_code, good.stdout) == (Exit.CONFORMING, f"{folder}: no problems\n")
    (tmp_path / "more.txt").write_text("")
    bad = clers("verify", folder)
    assert bad.exit_code == Exit.NOT_CONFORMING
    assert lines(bad) == [
        "more.txt: the manifest does not have it [ORCL-SUITE-2]",
        f"{folder}: 1 problem",
    ]
    (tmp_path / "less.txt").write_text("")
    assert lines(clers("verify", folder))[-1] == f"{folder}: 2 problems"
    document = json.loads(clers("verify", folder, "--json").stdout)
    assert document["folder"] == folder
    assert document["problems"][0] == {
        "file": "less.txt",
        "what": "the manifest does not have it",
        "clause": "ORCL-SUITE-2",
    }


def test_diff(tmp_path: Path) -> None:
    """ORCL-SUITE-8, ORCL-SUITE-12."""
    one = written(tmp_path / "one")
    same = clers("diff", str(one), str(one))
    assert same.exit_code == Exit.CONFORMING
    assert same.stdout == "0 added, 0 retired, 0 removed, 0 changed\n"
    part, *others = base().parts
    a, b, c, *rest = part.cases
    fresh = replace(b, id="new-aaaaaaaa")
    cases = (replace(a, comment="new"), fresh, *rest)
    gone = [Retired(id=b.id, reason="wrong", successor=fresh.id)]
    two = written(tmp_path / "two", (replace(part, cases=cases), *others), retired=gone)
    done = clers("diff", str(one), str(two))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert lines(done) == [
        "added    new-aaaaaaaa",
        f"retired  {b.id}: wrong, now new-aaaaaaaa",
        f"removed  {c.id}: ",
        f"changed  {a.id}: comment",
        "1 added, 1 retired, 1 removed, 1 changed",
    ]
    document = json.loads(clers("diff", str(one), str(two), "--json").stdout)
    assert document["first"] == str(one)
    assert document["second"] == str(two)
    assert document["difference"] == {
        "added": ["new-aaaaaaaa"],
        "retired": [{"id": b.id, "reason": "wrong", "successor": "new-aaaaaaaa"}],
        "removed": [{"id": c.id}],
        "changed": [{"id": a.id, "keys": ["comment"]}],
    }


def test_diff_of_what_is_no_suite(tmp_path: Path) -> None:
    """TOOL-OUTPUT-2."""
    done = clers("diff", str(written(tmp_path / "one")), str(tmp_path))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert done.stderr.startswith(f"{tmp_path}: malformed: unreadable-file")


def test_list(tmp_path: Path) -> None:
    """ORCL-SUITE-10, ORCL-SUITE-12."""
    folder = str(written(tmp_path))
    done = clers("list", folder, "--op", "word.encode", "--profile", "components")
    assert done.exit_code == Exit.CONFORMING
    wanted = [case for case in base().cases if case.op == "word.encode"]
    assert [line.split()[0] for line in lines(done)[1:-1]] == [case.id for case in wanted]
    assert lines(done)[0].split() == ["case", "operation", "profile", "size", "clauses", "flags"]
    said = lines(done)[1].split()
    case = wanted[0]
    assert said[1:4] == ["word.encode", "components", str(case.size)]
    assert said[4:] == [*case.clauses, *case.flags]
    assert lines(done)[-1] == f"{len(wanted)} of {len(base().cases)} cases"
    clause, flag = case.clauses[0], next(flag for one in wanted for flag in one.flags)
    some = json.loads(clers("list", folder, "--clause", clause, "--json").stdout)
    assert [one["case"]["id"] for one in some] == [
        one.id for one in base().cases if clause in one.clauses
    ]
    assert {one["profile"] for one in some} == {"components"}
    flagged = json.loads(clers("list", folder, "--flag", flag, "--json").stdout)
    assert [one["case"]["id"] for one in flagged] == [
        one.id for one in base().cases if flag in one.flags
    ]


def test_list_of_what_there_is_not(tmp_path: Path) -> None:
    """ORCL-SUITE-12."""
    folder = str(written(tmp_path))
    done = clers("list", folder, "--profile", "wings")
    assert done.exit_code == Exit.USAGE
    assert "no case has 'wings'" in done.stderr
    (tmp_path / "flags.json").unlink()
    assert clers("list", folder).exit_code == Exit.NOT_CONFORMING


def test_copy(tmp_path: Path) -> None:
    """ORCL-SUITE-9, ORCL-SUITE-12."""
    source, into = written(tmp_path / "one"), tmp_path / "two"
    done = clers("copy", str(into), "--vectors", str(source))
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout == f"{into}: 7 files written\n"
    assert clers("diff", str(source), str(into)).exit_code == Exit.CONFORMING
    again = clers("copy", str(into), "--vectors", str(source))
    assert again.exit_code == Exit.NOT_CONFORMING
    assert "it is not empty" in again.stderr
    shutil.rmtree(into)
    some = clers(
        "copy", str(into), "--vectors", str(source), "--profile", "components", "--profile",
        "core", "--json",
    )  # fmt: skip
    document = json.loads(some.stdout)
    assert document["folder"] == str(into)
    assert "components/word.decode.json" in document["files"]
    none = clers("copy", str(tmp_path / "three"), "--profile", "wings")
    assert none.exit_code == Exit.USAGE
    assert not (tmp_path / "three").exists()


def finding(folder: Path) -> Path:
    """A finding of somebody's adapter, as a file."""
    case = found_case()
    request = f'{{"op":"word.decode","id":5,"trace":"none","in":{bytes(case.input).decode()}}}'
    judged = Judged(id=case.id, op=case.op, clauses=case.clauses, status=Status.FAIL)
    found = Finding(
        request=request,
        case=case,
        judged=judged,
        outcome="{}",
        protocol=1,
        spec=SPEC_VERSION,
        adapter=Party(command=("x",), name="x", version="1", language="c"),
    )
    file = folder / "fuzz.json"
    file.write_bytes(bytes_of(found))
    return file


@pytest.mark.usefixtures("few")
def test_add(tmp_path: Path) -> None:
    """ORCL-SUITE-11, ORCL-SUITE-12: then the suite has it, after it is generated."""
    folder, file = tmp_path / "suite", finding(tmp_path)
    assert clers("generate", str(folder)).exit_code == Exit.CONFORMING
    done = clers("add", str(file), "--slug", "two-alone", "--vectors", str(folder))
    assert done.exit_code == Exit.CONFORMING
    kept = json.loads((folder / "inputs" / "shrunk.json").read_text())["found"]
    name = kept[0]["case"]["id"]
    assert name.startswith("two-alone-")
    place = folder / "inputs" / "shrunk.json"
    assert done.stdout == f"{place}: {name} written. Then: clers vectors generate\n"
    again = clers("add", str(file), "--vectors", str(folder))
    assert again.exit_code == Exit.NOT_CONFORMING
    assert f"{name} asks that already" in again.stderr
    assert clers("generate", str(folder)).exit_code == Exit.CONFORMING
    listed = json.loads(clers("list", str(folder), "--profile", "mixed", "--json").stdout)
    assert [one["case"]["id"] for one in listed] == [name]
    assert listed[0]["case"]["origin"] == "shrunk"


@pytest.mark.usefixtures("few")
def test_add_under_its_own_slug(tmp_path: Path) -> None:
    """ORCL-SUITE-11."""
    folder = str(tmp_path / "suite")
    assert clers("generate", folder).exit_code == Exit.CONFORMING
    done = clers("add", str(finding(tmp_path)), "--vectors", folder, "--json")
    document = json.loads(done.stdout)
    assert document["folder"] == folder
    assert document["case"].startswith("found-word-decode-")


@pytest.mark.parametrize("bad", ["finding", "suite", "inputs"])
def test_add_what_cannot_be_read(tmp_path: Path, bad: str) -> None:
    """ORCL-SUITE-12, TOOL-OUTPUT-2."""
    folder, file = written(tmp_path / "suite"), finding(tmp_path)
    (folder / "inputs").mkdir()
    places = {
        "finding": file,
        "suite": folder / "retired.json",
        "inputs": folder / "inputs" / "shrunk.json",
    }
    places[bad].write_text("[]")
    done = clers("add", str(file), "--vectors", str(folder))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert len(done.stderr.splitlines()) == 1


def test_the_suite_of_the_checkout(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """ORCL-SUITE-10: without a folder it is that one."""
    assert Path(__file__).parents[2] / "corpus" / "vectors" == DEFAULT
    monkeypatch.setattr(suite_files, "DEFAULT", written(tmp_path))
    assert lines(clers("list"))[-1].endswith(f"of {len(base().cases)} cases")
