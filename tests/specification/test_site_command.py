"""`clers spec site`: what it prints, writes, refuses, and ends with."""

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from toy_repository import edited, write
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.site.folder import write_site


def call(root: Path, *arguments: str) -> Result:
    return CliRunner().invoke(app, ["spec", "site", "--root", str(root), *arguments])


def names(folder: Path) -> list[str]:
    """All files below a folder."""
    return sorted(
        path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()
    )


def test_checked_and_not_written(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-1."""
    root = write(tmp_path / "toys")
    before = names(root)
    done = call(root)
    assert done.exit_code == Exit.CONFORMING, done.output
    assert done.stdout.startswith("19 files, ")
    assert done.stdout.endswith(" bytes, 4 clauses, 0 findings, not written\n")
    assert names(root) == before


def test_written_and_told(tmp_path: Path) -> None:
    """Clauses: TOOL-SITE-1, TOOL-OUTPUT-1."""
    out = tmp_path / "a" / "site"
    done = call(write(tmp_path / "toys"), "-o", str(out), "--json")
    assert done.exit_code == Exit.CONFORMING, done.output
    told = json.loads(done.stdout)
    assert told["folder"] == str(out)
    assert (told["files"], told["clauses"], told["findings"]) == (19, 4, [])
    assert (
        told["bytes"]
        == sum((out / name).stat().st_size for name in names(out))
        - (out / "site.json").stat().st_size
    )
    assert len(names(out)) == 20
    assert names(out.parent) == [f"site/{name}" for name in names(out)]


def test_the_same_bytes_from_every_process(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-11: whatever order sets have there."""
    root, found = write(tmp_path / "toys"), list[dict[str, str]]()
    for seed in ("1", "2"):
        out = tmp_path / seed
        code = "from clers.cli.main import main; main()"
        line = [sys.executable, "-c", code, "spec", "site", "--root", str(root), "-o", str(out)]
        subprocess.run(
            line, check=True, capture_output=True, env={**os.environ, "PYTHONHASHSEED": seed}
        )
        found.append(
            {name: hashlib.sha256((out / name).read_bytes()).hexdigest() for name in names(out)}
        )
    assert found[0] == found[1]
    assert len(found[0]) == 20


def test_nothing_is_written_of_a_site_at_fault(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-8."""
    root = write(tmp_path / "toys", edited(("spec/01-boxes.md", "#conventions)", "#gone)")))
    out = tmp_path / "site"
    done = call(root, "-o", str(out))
    assert done.exit_code == Exit.NOT_CONFORMING
    line = "link to 00-conventions.html#gone: no such anchor [site]"
    assert [words.partition(": ")[2] for words in done.stdout.splitlines()[:-1]] == [line]
    assert done.stdout.endswith("1 findings, not written\n")
    assert not out.exists()


def test_a_site_takes_the_place_of_one_before(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-12."""
    out = tmp_path / "site"
    assert call(write(tmp_path / "toys"), "-o", str(out)).exit_code == Exit.CONFORMING
    (out / "index.html").write_text("changed")
    (out / "laws.html").unlink()
    assert call(tmp_path / "toys", "-o", str(out)).exit_code == Exit.CONFORMING
    assert "changed" not in (out / "index.html").read_text(encoding="utf-8")[:10]
    assert (out / "laws.html").is_file()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["site", "toys"]


@pytest.mark.parametrize("name", ["notes.txt", "clause/mine.html", ".hidden", "empty/"])
@pytest.mark.parametrize("after", [False, True], ids=["of others", "of a site"])
def test_no_other_file_is_touched(tmp_path: Path, name: str, after: bool) -> None:
    """Clause: TOOL-SITE-12."""
    out = tmp_path / "site"
    if after:
        write_site(out, {"index.html": b"old"})
    path = out / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.mkdir(parents=True) if name.endswith("/") else path.write_text("mine")
    before = {item: (out / item).read_bytes() for item in names(out)}
    done = call(write(tmp_path / "toys"), "-o", str(out))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "unwritable-file" in done.stderr
    assert "TOOL-SITE-12" in done.stderr
    assert (name.strip("/") if after else "site.json") in done.stderr
    assert done.stderr.count("\n") == 1
    assert {item: (out / item).read_bytes() for item in names(out)} == before
    assert path.exists()


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    """Clauses: TOOL-SITE-12, TOOL-OUTPUT-2."""
    out = tmp_path / "site"
    out.write_text("mine")
    done = call(write(tmp_path / "toys"), "-o", str(out), "--json")
    assert done.exit_code == Exit.NOT_CONFORMING
    assert json.loads(done.stdout)["reject"]["reason"] == "unwritable-file"
    assert out.read_text() == "mine"


def test_an_empty_folder_will_do(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-12."""
    out = tmp_path / "site"
    out.mkdir()
    assert call(write(tmp_path / "toys"), "-o", str(out)).exit_code == Exit.CONFORMING


def test_what_fails_midway_leaves_the_old_site(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Clause: TOOL-SITE-12."""
    out = tmp_path / "site"
    write_site(out, {"index.html": b"old"})

    def full(path: Path, data: bytes) -> int:
        if path.name == "laws.html":
            raise OSError(28, "No space left on device")
        return len(data)

    monkeypatch.setattr(Path, "write_bytes", full)
    done = call(write(tmp_path / "toys"), "-o", str(out))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "No space left on device" in done.stderr
    assert (out / "index.html").read_bytes() == b"old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["site", "toys"]


@pytest.mark.parametrize("package", ["latex2mathml", "mdit_py_plugins", "pygments"])
def test_a_package_that_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, package: str
) -> None:
    """Clause: TOOL-SITE-13."""
    monkeypatch.setitem(sys.modules, package, None)
    done = call(write(tmp_path / "toys"), "-o", str(tmp_path / "site"))
    assert done.exit_code == Exit.USAGE
    assert (
        done.stderr == f"clers spec site needs the package {package}: pip install 'clers[site]'\n"
    )
    assert not (tmp_path / "site").exists()
