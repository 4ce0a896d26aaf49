"""Fetching, with clients made here: the network has no part in it."""

import base64
import io
import sys
import tarfile
from collections.abc import Mapping
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from struct import pack

import pytest
from typer.testing import CliRunner

import clers
from clers.cli.corpus import app
from clers.complexes.face_list import FaceList
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.corpus import npm_module
from clers.corpus.fetch import converted, fetch
from clers.corpus.manifest import Client, Entry, Source
from clers.corpus.obtain import obtain, obtaining
from clers.geometry.positions import Precision
from clers.meshfile.mesh import RawMesh

ROOT = Path(clers.__file__).parents[2]
OFF = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0.1\n3 0 1 2\n"
MODULE = b"exports.positions=[[0,0,0],[1,0,0],[0,1,1e-1]]\nexports.cells = [[0,1,2]];\n"
OBJ = b"v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 1.0 0.1\nf 1 2 3\n"


def digest(data: bytes) -> str:
    return sha256(data).hexdigest()


def tar(files: Mapping[str, bytes], mode: str = "w:gz") -> bytes:
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w:gz" if mode == "w:gz" else "w") as archive:
        for name, data in files.items():
            info = tarfile.TarInfo(name)
            info.size = len(data)
            archive.addfile(info, io.BytesIO(data))
        folder = tarfile.TarInfo("package/folder")
        folder.type = tarfile.DIRTYPE
        archive.addfile(folder)
    return made.getvalue()


NPM = Source(Client.NPM, "thing", "1.0.0", "package/thing.js", digest(MODULE))
DEBIAN = Source(
    Client.DEBIAN, "thing-data", "2-1", "usr/share/data.tar.gz", digest(OFF), "data/thing.off"
)


def entry(source: Source, file: str, data: bytes) -> Entry:
    return Entry("thing", file, digest(data), len(data), source, "someone", "free", "a triangle")


BY_NPM = entry(NPM, "thing.obj", OBJ)
BY_DEBIAN = entry(DEBIAN, "thing.off", OFF)

CLIENT = """#!{python}
import sys
from pathlib import Path
here = Path(__file__).parent
with (here / "calls").open("a") as calls:
    print(*sys.argv[1:], file=calls)
if "--fsys-tarfile" in sys.argv:
    sys.stdout.buffer.write((here / "tree").read_bytes())
elif (here / "fail").exists():
    sys.exit("first line\\n  E: no such\\tversion")
else:
    Path("made{suffix}").write_bytes((here / "archive").read_bytes())
"""


@pytest.fixture
def clients(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with clients that give the archives laid beside them, as the only programs."""
    folder = tmp_path / "clients"
    folder.mkdir()
    for name, suffix in (("npm", ".tgz"), ("apt-get", ".deb"), ("dpkg-deb", "")):
        program = folder / name
        program.write_text(CLIENT.format(python=sys.executable, suffix=suffix))
        program.chmod(0o755)
    (folder / "archive").write_bytes(tar({"package/thing.js": MODULE}))
    inner = tar({"data/thing.off": OFF})
    (folder / "tree").write_bytes(tar({"./usr/share/data.tar.gz": inner}, "w"))
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)
    return folder


def calls(folder: Path) -> list[str]:
    return (folder / "calls").read_text().splitlines()


def test_npm(clients: Path, tmp_path: Path) -> None:
    """Clauses: TOOL-CORPUS-6, TOOL-CORPUS-2."""
    into = tmp_path / "new" / "cache"
    assert fetch(BY_NPM, into, obtain) == Accepted(into / "thing.obj")
    assert (into / "thing.obj").read_bytes() == OBJ
    assert calls(clients) == ["pack --silent thing@1.0.0"]
    assert [path.name for path in into.iterdir()] == ["thing.obj"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["clients", "new"]


def test_debian(clients: Path, tmp_path: Path) -> None:
    """Clause: TOOL-CORPUS-6."""
    into = tmp_path / "cache"
    assert fetch(BY_DEBIAN, into, obtain) == Accepted(into / "thing.off")
    assert (into / "thing.off").read_bytes() == OFF
    assert calls(clients) == ["download -qq thing-data=2-1", "--fsys-tarfile made.deb"]


def test_a_file_that_is_there_needs_no_client(clients: Path, tmp_path: Path) -> None:
    """Clause: TOOL-CORPUS-6; one that is changed is made anew."""
    (tmp_path / "thing.off").write_bytes(OFF)
    assert isinstance(fetch(BY_DEBIAN, tmp_path, obtain), Accepted)
    assert not (clients / "calls").exists()
    (tmp_path / "thing.off").write_bytes(OFF[:-1])
    assert isinstance(fetch(BY_DEBIAN, tmp_path, obtain), Accepted)
    assert (tmp_path / "thing.off").read_bytes() == OFF


def test_a_package_is_obtained_once(clients: Path) -> None:
    """Clause: TOOL-CORPUS-6."""
    by = obtaining()
    for _ in range(3):
        assert by(NPM) == Accepted(MODULE)
    assert len(calls(clients)) == 1
    assert by(replace(NPM, version="1.0.1")) == Accepted(MODULE)
    assert len(calls(clients)) == 2


def refused(given: Entry, into: Path, reason: Reason, says: str) -> None:
    result = fetch(given, into, obtain)
    assert isinstance(result, Rejected)
    assert result.reason is reason
    assert says in result.detail
    assert "\n" not in result.line()
    assert not (into / given.file).exists()


def test_what_cannot_be_obtained(clients: Path, tmp_path: Path) -> None:
    """Clause: TOOL-CORPUS-6: each in one line, nothing left behind."""
    no = Reason.NOT_OBTAINABLE
    into = tmp_path / "cache"
    moved = replace(BY_NPM, source=replace(NPM, path="package/other.js"))
    refused(moved, into, no, "package/other.js is not in the package")
    folder = replace(BY_NPM, source=replace(NPM, path="package/folder"))
    refused(folder, into, no, "package/folder is no file")
    inner = replace(BY_DEBIAN, source=replace(DEBIAN, member="data/other.off"))
    refused(inner, into, no, "data/other.off is not in the package")
    (clients / "archive").write_bytes(b"no archive")
    refused(BY_NPM, into, no, "package/thing.js")
    (clients / "fail").touch()
    refused(BY_NPM, into, no, "npm pack --silent thing@1.0.0: E: no such version")
    refused(BY_DEBIAN, into, no, "E: no such version")
    (clients / "npm").unlink()
    refused(BY_NPM, into, no, "npm is not installed")
    (clients / "dpkg-deb").unlink()
    (clients / "fail").unlink()
    refused(BY_DEBIAN, into, no, "dpkg-deb is not installed")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["clients"]


def test_other_bytes_are_refused(clients: Path, tmp_path: Path) -> None:
    """Clause: TOOL-CORPUS-6: at the source, and after it was converted."""
    assert clients.exists()
    other = digest(b"other")
    source = replace(BY_NPM, source=replace(NPM, sha256=other))
    refused(
        source, tmp_path, Reason.BAD_CHECKSUM, f"SHA-256 is {digest(MODULE)}, stated is {other}"
    )
    result = replace(BY_NPM, sha256=other)
    refused(result, tmp_path, Reason.BAD_CHECKSUM, f"SHA-256 is {digest(OBJ)}, stated is {other}")


def test_a_folder_that_cannot_be_made(clients: Path, tmp_path: Path) -> None:
    """Clauses: TOOL-CORPUS-6, TOOL-WRITE-4."""
    assert clients.exists()
    (tmp_path / "file").touch()
    result = fetch(BY_NPM, tmp_path / "file" / "cache", obtain)
    assert isinstance(result, Rejected)
    assert result.reason is Reason.UNWRITABLE_FILE


TRIANGLE = FaceList(((0, 1, 2),), 3)
PACKED = pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0.5)
TYPED = (
    ';exports.positions = require("./load")(Float32Array, "%s")\n'
    ';exports.cells = require("./load")(Uint32Array, "%s")'
)


def typed(positions: bytes, cells: bytes) -> bytes:
    return (TYPED % tuple(base64.b64encode(x).decode() for x in (positions, cells))).encode()


def test_modules() -> None:
    """Clause: TOOL-CORPUS-2."""
    places = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    assert npm_module.parse(MODULE) == Accepted(RawMesh(TRIANGLE, (*places, 0.1), Precision.F64))
    half = RawMesh(TRIANGLE, (*places, 0.5), Precision.F32)
    assert npm_module.parse(MODULE.replace(b"1e-1", b"0.5")) == Accepted(half)
    assert npm_module.parse(typed(PACKED, pack("<3I", 0, 1, 2))) == Accepted(half)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff\x00",
        MODULE.replace(b"cells", b"faces"),
        MODULE.replace(b"positions", b"places"),
        MODULE.replace(b"[0,1,2]", b"[0,1]"),
        MODULE.replace(b"[0,1,2]", b"[0,1,2.5]"),
        MODULE.replace(b"[1,0,0]", b"[1,0,[0]]"),
        MODULE.replace(b"[1,0,0]", b"[1,0,--0]"),
        MODULE.replace(b"[[0,1,2]]", b"make()"),
        typed(PACKED, pack("<4I", 0, 1, 2, 3)),
        typed(PACKED[:-1], pack("<3I", 0, 1, 2)),
        typed(PACKED, b"").replace(b'""', b'"A"'),
    ],
)
def test_what_is_no_module(data: bytes) -> None:
    """Clauses: TOOL-CORPUS-2, TOOL-READ-5."""
    result = npm_module.parse(data)
    assert isinstance(result, Rejected)
    assert result.reason is Reason.UNREADABLE_FILE


def test_conversion() -> None:
    """Clause: TOOL-CORPUS-2."""
    assert converted(OFF, Path("a/b.off"), Path("c.off")) == Accepted(OFF)
    assert converted(b"any", Path("a.stl"), Path("c.stl")) == Accepted(b"any")
    assert converted(OFF, Path("a/b.off"), Path("c.obj")) == Accepted(OBJ)
    assert isinstance(converted(OFF, Path("a/b.off"), Path("c.xyz")), Rejected)
    assert isinstance(converted(OFF, Path("a/b.vtk"), Path("c.obj")), Rejected)


RUNNER = CliRunner()


def test_the_commands(clients: Path, tmp_path: Path) -> None:
    """Clauses: TOOL-CORPUS-1, TOOL-CORPUS-5, TOOL-CORPUS-6, TOOL-EXIT-1."""
    root = ["--root", str(ROOT)]
    into = ["--into", str(tmp_path / "cache")]
    listed = RUNNER.invoke(app, ["list", *root])
    assert listed.exit_code == 0
    assert "elephant-with-holes" in listed.stdout
    assert RUNNER.invoke(app, ["verify", *root]).stdout == "26 meshes, 0 not as stated\n"
    unknown = RUNNER.invoke(app, ["fetch", "none", *root, *into])
    assert unknown.exit_code == 2
    (clients / "npm").unlink()
    absent = RUNNER.invoke(app, ["fetch", "bunny", *root, *into])
    assert absent.exit_code == 1
    assert "npm is not installed" in absent.stderr
    (tmp_path / "cache").mkdir()
    bunny = (ROOT / "corpus" / "meshes" / "bunny.obj").read_bytes()
    (tmp_path / "cache" / "bunny.obj").write_bytes(bunny)
    there = RUNNER.invoke(app, ["fetch", "bunny", *root, *into, "--json"])
    assert there.exit_code == 0
    assert "bunny.obj" in there.stdout
