"""Suites as files: their one string of bytes, how they are read, written, copied and compared."""

import json
from pathlib import Path

import pytest
from msgspec import Raw
from msgspec.structs import replace
from tampered import CRE, base, written

from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import identity, named
from clers.conformance.messages import Rejection, Step
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.files import Suite, read_suite
from clers.oracle.suite.profiles import profile_of
from clers.oracle.suite.records import Flag, Retired, Score
from clers.oracle.suite.rendered import name_of, parts_of, suite_files
from clers.oracle.suite.written import differing, write_suite


def test_the_id_of_a_case() -> None:
    """ORCL-CASE-2: as `sha256sum` and `base32` of the shell give it for this text."""
    assert identity("tetrahedron", CRE) == CRE.id
    echo = replace(CRE, op="echo", input=Raw(b'{"a":1}'), ok=Raw(b""), compare="isomorphic")
    assert identity("x-y", replace(echo, ok=CRE.reject)) == "x-y-34cildlr"


def test_the_id_of_a_rejected_case() -> None:
    """ORCL-CASE-2: with its rejection, and a trace."""
    case = Case(
        id="",
        op="word.decode",
        clauses=(),
        origin="hand",
        input=Raw(b'{"word":"","handles":[],"components_with_boundary":0}'),
        reject=Rejection(Fault.INVALID, "empty-word"),
        trace=(Step(0, "C"),),
    )
    assert identity("empty", case) == "empty-4k5z3kms"


def test_what_an_id_does_not_depend_on() -> None:
    """ORCL-CASE-2: clauses, origin, size, flags, requirements and comment may change."""
    other = replace(
        CRE, clauses=(), origin="real", size=9, flags=("a",), requires=("handles",), comment="x"
    )
    assert identity("tetrahedron", other) == CRE.id


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (b'{"a": 1, "b":[ ]}', b'{"a":1,"b":[]}'),
        (b'{"b":1,"a":2}', b'{"b":1,"a":2}'),
        (b'{"a":1e22,"b":1E-7,"c":-0.0,"d":1.50}', b'{"a":1e+22,"b":1e-07,"c":-0.0,"d":1.5}'),
        (b'{"a":"\\u00e4\\u2028\\u0001"}', b'{"a":"\xc3\xa4\xe2\x80\xa8\\u0001"}'),
        (b'{"a":9007199254740993}', b'{"a":9007199254740993}'),
    ],
)
def test_the_one_text_of_a_value(text: bytes, plain: bytes) -> None:
    """ORCL-CASE-8."""
    case = named("x", replace(CRE, input=Raw(text), ok=Raw(text)))
    assert (case.input, case.ok) == (Raw(plain), Raw(plain))
    assert case.id == identity("x", case)


@pytest.mark.parametrize(
    ("op", "requires", "profile"),
    [
        ("echo", (), "core"),
        ("word.decode", (), "core"),
        ("word.decode", ("handles",), "handles"),
        ("word.encode", ("boundaries.one",), "boundaries"),
        ("surface.classify", ("boundaries.many",), "boundaries"),
        ("word.decode", ("components",), "components"),
        ("word.decode", ("boundaries.one", "handles"), "mixed"),
        ("word.decode", ("boundaries.many", "components", "handles"), "mixed"),
        ("arithmetic.encode", ("coder.rans",), "codes"),
        ("code.decode", ("code.plain", "handles"), "codes"),
        ("operator.apply", (), "operators"),
        ("mesh.decode", ("components", "handles"), "geometry"),
        ("codec.roundtrip", ("handles",), "geometry"),
    ],
)
def test_the_profile_of_a_case(op: str, requires: tuple[str, ...], profile: str) -> None:
    """ORCL-SUITE-3."""
    assert profile_of(replace(CRE, op=op, requires=requires)) == profile


def test_a_file_of_cases_by_hand() -> None:
    """ORCL-SUITE-1, ORCL-CASE-1: each case on a line, in this order of keys, nothing else."""
    echo = replace(
        CRE, id="said-aaaaaaaa", op="word.decode", size=3, flags=("f",), requires=("handles",),
        compare="isomorphic", comment="ä",
    )  # fmt: skip
    files = suite_files(parts_of([("core", CRE), ("core", echo)]), (), (), (), {})
    assert files["core/word.decode.json"].decode() == (
        '{"profile":"core","op":"word.decode","cases":[\n'
        '{"id":"said-aaaaaaaa","op":"word.decode","clauses":["EB-DECODE-1"],"origin":"hand",'
        '"requires":["handles"],"size":3,"flags":["f"],'
        '"in":{"word":"CRE","handles":[],"components_with_boundary":0},'
        '"ok":{"faces":[[0,1,2],[3,2,1],[0,3,1],[2,3,0]],"vertices":4},'
        '"compare":"isomorphic","comment":"ä"},\n'
        '{"id":"tetrahedron-cud5sz5x","op":"word.decode","clauses":["EB-DECODE-1"],'
        '"origin":"hand","size":4,'
        '"in":{"word":"CRE","handles":[],"components_with_boundary":0},'
        '"ok":{"faces":[[0,1,2],[3,2,1],[0,3,1],[2,3,0]],"vertices":4}}\n'
        "]}\n"
    )
    assert files["flags.json"] == b'{"flags":[]}\n'
    assert files["retired.json"] == b'{"retired":[]}\n'
    assert files["canaries.json"] == b'{"cases":[]}\n'


def test_the_order_of_files_and_of_entries() -> None:
    """ORCL-SUITE-1: profiles and operations in their order; flags and retired by name."""
    cases = [
        ("handles", replace(CRE, op="word.encode")),
        ("handles", CRE),
        ("core", replace(CRE, op="word.encode")),
        ("codes", replace(CRE, op="code.encode")),
    ]
    flags = [Flag(name=name, mistake="m", matters="w") for name in "ba"]
    gone = [Retired(id=f"{name}-aaaaaaaa", reason="r") for name in "ba"]
    files = suite_files(parts_of(cases), flags, gone, (), {"inputs/b": b"2", "inputs/a": b"1"})
    assert list(files) == [
        "core/word.encode.json",
        "handles/word.encode.json",
        "handles/word.decode.json",
        "codes/code.encode.json",
        "flags.json",
        "retired.json",
        "canaries.json",
        "inputs/a",
        "inputs/b",
        "manifest.json",
    ]
    assert files["flags.json"].index(b'"a"') < files["flags.json"].index(b'"b"')
    assert files["retired.json"].index(b'"a-') < files["retired.json"].index(b'"b-')


def test_the_manifest_by_hand() -> None:
    """ORCL-SUITE-2: the name is what the shell gives for `tetrahedron-cud5sz5x` and a line feed."""
    score = Score(suite="else", mutants=2, killed=1)
    files = suite_files(parts_of([("core", CRE)]), (), (), (CRE,), {"inputs/a": b"1"}, score)
    manifest = json.loads(files["manifest.json"])
    assert files["manifest.json"].startswith(b'{\n  "format": 1,\n')
    assert list(manifest) == [
        "format", "spec", "suite", "cases", "profiles", "files", "others", "mutation",
    ]  # fmt: skip
    assert manifest["cases"] == 1
    assert manifest["suite"] == SHELL_NAME
    assert [(one["name"], one["cases"]) for one in manifest["profiles"]][:2] == [
        ("core", 1),
        ("handles", 0),
    ]
    assert all(one["about"] for one in manifest["profiles"])
    assert [one["path"] for one in manifest["files"]] == ["core/word.decode.json"]
    assert [one["path"] for one in manifest["others"]] == [
        "flags.json", "retired.json", "canaries.json", "inputs/a",
    ]  # fmt: skip
    assert manifest["others"][3]["sha256"] == SHELL_DIGEST
    assert manifest["mutation"] == {"suite": "else", "mutants": 2, "killed": 1, "survivors": []}


SHELL_NAME = "keylfi6t3zzw"
SHELL_DIGEST = "6b86b273ff34fce19d6b804eff5a3f5747ada4eaa22f1d49c01e52ddb7875b4b"


def test_the_name_depends_on_the_order() -> None:
    """ORCL-SUITE-2."""
    other = replace(CRE, id="other-aaaaaaaa")
    assert len({name_of([CRE, other]), name_of([other, CRE]), name_of([CRE])}) == 3


def rejected(found: Accepted[Suite] | Rejected) -> tuple[Reason, Clause, str]:
    assert isinstance(found, Rejected), found
    return found.reason, found.clause, found.detail


def test_a_suite_is_read(tmp_path: Path) -> None:
    """ORCL-SUITE-1, ORCL-SUITE-2."""
    found = read_suite(written(tmp_path))
    assert isinstance(found, Accepted)
    suite = found.value
    assert (suite.parts, suite.flags, suite.canaries) == (
        base().parts,
        base().flags,
        base().canaries,
    )
    assert suite.manifest.count == len(suite.cases) == len(base().cases)
    assert suite.cases[0] == suite.parts[0].cases[0]
    assert suite.cases[-1] == suite.parts[-1].cases[-1]


def test_no_folder(tmp_path: Path) -> None:
    """ORCL-SUITE-1."""
    reason, clause, detail = rejected(read_suite(tmp_path / "none"))
    assert (reason, clause) == (Reason.UNREADABLE_FILE, Clause.ORCL_SUITE_1)
    assert detail == f"{tmp_path / 'none' / 'manifest.json'}: No such file or directory"


@pytest.mark.parametrize(
    "path",
    ["manifest.json", "flags.json", "retired.json", "canaries.json", "components/word.encode.json"],
)
def test_files_that_are_not_what_they_should_be(tmp_path: Path, path: str) -> None:
    """ORCL-SUITE-1, ORCL-SUITE-2: of no form; not there; of another checksum."""
    file = written(tmp_path) / path
    data = file.read_bytes()
    file.write_bytes(b"[]")
    reason, _, detail = rejected(read_suite(tmp_path))
    assert reason is Reason.UNREADABLE_FILE
    assert detail == f"{path}: Expected `object`, got `array`"
    file.unlink()
    assert rejected(read_suite(tmp_path))[0] is Reason.UNREADABLE_FILE
    file.write_bytes(data + b" ")
    if path != "manifest.json":
        what = f"{path}: its SHA-256 is not the manifest's"
        assert rejected(read_suite(tmp_path)) == (
            Reason.BAD_CHECKSUM,
            Clause.ORCL_SUITE_1,
            what,
        )


def edited(folder: Path, key: str, value: object) -> Path:
    """The suite with another value of its manifest."""
    file = written(folder) / "manifest.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), key: value}))
    return folder


def test_another_format(tmp_path: Path) -> None:
    """ORCL-SUITE-2."""
    reason, _, detail = rejected(read_suite(edited(tmp_path, "format", 2)))
    assert (reason, detail) == (Reason.UNKNOWN_VERSION, "manifest.json: format 2, not 1")


def test_another_number_of_cases(tmp_path: Path) -> None:
    """ORCL-SUITE-2: of the whole, and of a file."""
    reason, _, detail = rejected(read_suite(edited(tmp_path, "cases", 3)))
    assert (reason, detail) == (
        Reason.COUNT_MISMATCH,
        "manifest.json: its files have other than 3",
    )
    files = json.loads((tmp_path / "manifest.json").read_text())["files"]
    files[0]["cases"] += 1
    reason, _, detail = rejected(read_suite(edited(tmp_path, "files", files)))
    count = len(base().parts[0].cases)
    assert (reason, detail) == (
        Reason.COUNT_MISMATCH,
        f"components/surface.classify.json: {count} cases, {count + 1} by the manifest",
    )


@pytest.mark.parametrize("path", ["/etc/hosts", "../up.json", "a/../../up.json"])
def test_paths_that_lead_out(tmp_path: Path, path: str) -> None:
    """ORCL-SUITE-1."""
    others = [{"path": path, "sha256": "0" * 64}]
    reason, _, detail = rejected(read_suite(edited(tmp_path, "others", others)))
    assert reason is Reason.UNREADABLE_FILE
    assert detail == f"{path}: leads out of the folder"


def test_a_path_that_is_none(tmp_path: Path) -> None:
    """ORCL-SUITE-1."""
    others = [{"path": "a\0b", "sha256": "0" * 64}]
    reason, _, detail = rejected(read_suite(edited(tmp_path, "others", others)))
    assert reason is Reason.UNREADABLE_FILE
    assert detail.endswith(": embedded null byte")


def test_only_what_changed_is_written(tmp_path: Path) -> None:
    """ORCL-SUITE-5: what is stale goes, and what is of somebody else stays."""
    files = {"manifest.json": b"m", "a/b.json": b"1", "c.json": b"2"}
    assert write_suite(tmp_path, files) == Accepted(("a/b.json", "c.json", "manifest.json"))
    assert write_suite(tmp_path, files) == Accepted(())
    before = (tmp_path / "c.json").stat().st_mtime_ns
    (tmp_path / "d.json").write_bytes(b"more")
    (tmp_path / "e.json").write_bytes(b"mine")
    changed = {**files, "a/b.json": b"3"}
    stale = ("d.json", "c.json", "gone.json")
    assert differing(tmp_path, changed, stale) == ("a/b.json", "d.json")
    assert write_suite(tmp_path, changed, stale) == Accepted(("a/b.json", "d.json"))
    assert differing(tmp_path, changed, stale) == ()
    assert (tmp_path / "c.json").stat().st_mtime_ns == before
    assert (tmp_path / "e.json").read_bytes() == b"mine"
    assert not (tmp_path / "d.json").exists()


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    """ORCL-SUITE-5: a file stands where a folder should, or a folder where a file should."""
    (tmp_path / "a").write_bytes(b"mine")
    found = write_suite(tmp_path, {"a/b.json": b"1"})
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNWRITABLE_FILE
    assert found.detail.startswith("a/b.json: ")
    assert (tmp_path / "a").read_bytes() == b"mine"
    (tmp_path / "c").mkdir()
    found = write_suite(tmp_path, {"c": b"1"})
    assert isinstance(found, Rejected)
    assert (found.reason, found.detail) == (Reason.UNWRITABLE_FILE, "c: a folder")
