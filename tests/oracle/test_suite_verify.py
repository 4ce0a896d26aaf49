"""A suite that holds, and each way in which one does not: what is found, and where."""

import json
from pathlib import Path
from typing import Final

import pytest
from msgspec import Raw, UnsetType
from msgspec.structs import replace
from tampered import base, first, write, written

from clers.conformance.cases.case import Case
from clers.conventions.clause import Clause
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.records import Part, Score
from clers.oracle.suite.rendered import parts_of
from clers.oracle.suite.verify import verify

DECODED: Final = "components/word.decode.json"


def only(folder: Path) -> Problem:
    """The one problem of a suite."""
    found = verify(folder)
    assert len(found) == 1, found
    return found[0]


def good() -> Case:
    return first("word.decode", "ok", "trace")


def bad() -> Case:
    return first("word.decode", "reject")


def text(value: Raw | UnsetType) -> bytes:
    assert not isinstance(value, UnsetType)
    return bytes(value)


def with_case(case: Case) -> tuple[Part, ...]:
    """The suite with one case more."""
    cases = [(part.profile, one) for part in base().parts for one in part.cases]
    return parts_of([*cases, ("components", case)])


def test_a_suite_that_holds(tmp_path: Path) -> None:
    """ORCL-SUITE-4."""
    assert verify(written(tmp_path)) == ()


def test_each_file_is_announced(tmp_path: Path) -> None:
    said: list[str] = []
    verify(written(tmp_path), said.append)
    assert said[0] == "files"
    assert said[1:-1] == [f"components/{part.op}.json" for part in base().parts]
    assert said[-1] == "canaries.json"


def test_a_missing_file(tmp_path: Path) -> None:
    """ORCL-SUITE-4: it is the only problem, and is named."""
    (written(tmp_path) / DECODED).unlink()
    found = only(tmp_path)
    assert found.file == str(tmp_path / DECODED)
    assert found.what == "unreadable-file: No such file or directory"


def test_a_missing_input(tmp_path: Path) -> None:
    """ORCL-SUITE-2: of the other files too."""
    (written(tmp_path) / "inputs").mkdir()
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    manifest["others"].append({"path": "inputs/there.json", "sha256": "0" * 64})
    (tmp_path / "manifest.json").write_text(json.dumps(manifest))
    assert Problem("inputs/there.json", "No such file or directory", Clause.ORCL_SUITE_2) in verify(
        tmp_path
    )


def test_a_file_too_many(tmp_path: Path) -> None:
    write(written(tmp_path), {"components/notes.txt": b"mine"})
    what = "the manifest does not have it"
    assert only(tmp_path) == Problem("components/notes.txt", what, Clause.ORCL_SUITE_2)


def test_a_changed_byte(tmp_path: Path) -> None:
    """ORCL-SUITE-2: even one that means nothing."""
    file = written(tmp_path) / "flags.json"
    file.write_bytes(file.read_bytes().replace(b"\n]}", b"\n ]}"))
    assert verify(tmp_path) == (
        Problem("flags.json", "its SHA-256 is not the manifest's", Clause.ORCL_SUITE_2),
        Problem("flags.json", "it is written in another way", Clause.ORCL_SUITE_1),
    )


def test_a_file_that_is_none(tmp_path: Path) -> None:
    (written(tmp_path) / DECODED).write_text("{}")
    found = only(tmp_path)
    assert (found.file, found.clause) == (DECODED, Clause.ORCL_SUITE_1)
    assert "missing required field" in found.what


def test_another_order(tmp_path: Path) -> None:
    """ORCL-SUITE-1: under a manifest that has its checksum."""
    part = next(part for part in base().parts if part.op == "word.decode")
    others = tuple(one for one in base().parts if one is not part)
    written(tmp_path, (*others, replace(part, cases=tuple(reversed(part.cases)))))
    assert [(problem.file, problem.what) for problem in verify(tmp_path)] == [
        (DECODED, "it is written in another way"),
        ("manifest.json", "suite is not so"),
        ("manifest.json", "files is not so"),
    ]


def test_a_file_under_another_name(tmp_path: Path) -> None:
    """ORCL-SUITE-1."""
    (written(tmp_path) / DECODED).rename(tmp_path / "components" / "other.json")
    file = tmp_path / "manifest.json"
    file.write_text(file.read_text().replace(DECODED, "components/other.json"))
    what = "it has another profile or operation than its name says"
    assert verify(tmp_path)[0] == Problem("components/other.json", what, Clause.ORCL_SUITE_1)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("cases", 7),
        ("suite", "aaaaaaaaaaaa"),
        ("spec", "99"),
        ("profiles", []),
    ],
)
def test_a_manifest_that_is_not_so(tmp_path: Path, key: str, value: object) -> None:
    """ORCL-SUITE-2."""
    file = written(tmp_path) / "manifest.json"
    manifest = json.loads(file.read_text())
    file.write_text(json.dumps({**manifest, key: value}))
    assert only(tmp_path) == Problem("manifest.json", f"{key} is not so", Clause.ORCL_SUITE_2)


@pytest.mark.parametrize(("mutants", "killed"), [(3, 4), (3, -1)])
def test_a_score_that_cannot_be(tmp_path: Path, mutants: int, killed: int) -> None:
    """ORCL-SUITE-2."""
    score = Score(suite="other", mutants=mutants, killed=killed)
    written(tmp_path, mutation=score)
    assert only(tmp_path).what == "mutation is not so"


def test_a_score_that_can_be(tmp_path: Path) -> None:
    """ORCL-SUITE-2: also one of another suite, which says so."""
    assert verify(written(tmp_path, mutation=Score(suite="other", mutants=3, killed=3))) == ()
