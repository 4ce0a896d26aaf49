"""Files by their names: formats, and what is no file that can be read."""

import os
from pathlib import Path

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Positions, Precision
from clers.meshfile import read
from clers.meshfile.formats import Format, format_of
from clers.meshfile.mesh import judged, unjudged
from clers.meshfile.reading import contents

TRIANGLE = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


@pytest.mark.parametrize(
    ("name", "known"),
    [("a.ply", Format.PLY), ("b.OFF", Format.OFF), ("c.d.Obj", Format.OBJ), ("e.stl", Format.STL)],
)
def test_the_suffix_tells_the_format(name: str, known: Format) -> None:
    """Clause: TOOL-READ-1."""
    assert format_of(Path(name)) == Accepted(known)


@pytest.mark.parametrize("name", ["a.gltf", "ply", "off.txt", ".obj", "a.", "a.ply/b"])
def test_other_suffixes_are_unknown(name: str, tmp_path: Path) -> None:
    """Clause: TOOL-READ-1: said before the file is looked for."""
    result = read(tmp_path / name)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause) == (Reason.UNKNOWN_FORMAT, Clause.TOOL_READ_1)


def test_a_file_is_read_and_judged(tmp_path: Path) -> None:
    """Clauses: TOOL-READ-2, TOOL-READ-5."""
    path = tmp_path / "triangle.off"
    path.write_text(TRIANGLE)
    raw = read(path)
    assert isinstance(raw, Accepted)
    mesh = judged(raw.value)
    assert isinstance(mesh, Accepted)
    assert mesh.value.surface.faces == 1
    places = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    assert mesh.value.positions == Positions(Precision.F32, places)
    assert unjudged(raw.value.faces, Positions(Precision.F32, places)) == raw.value


def unreadable(path: Path, says: str) -> None:
    result = read(path)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause) == (Reason.UNREADABLE_FILE, Clause.TOOL_READ_5)
    assert says in result.detail


def test_what_is_no_file(tmp_path: Path) -> None:
    """Clause: TOOL-READ-5: nothing, a folder, a loop of links, a pipe, a name that cannot be."""
    (tmp_path / "folder.ply").mkdir()
    (tmp_path / "loop.ply").symlink_to(tmp_path / "loop.ply")
    os.mkfifo(tmp_path / "pipe.ply")
    unreadable(tmp_path / "none.ply", "No such file")
    unreadable(tmp_path / "folder.ply", "not a regular file")
    unreadable(tmp_path / "folder.ply" / "x" / "y.ply", "No such file")
    unreadable(tmp_path / "loop.ply", "symbolic links")
    unreadable(tmp_path / "pipe.ply", "not a regular file")
    unreadable(tmp_path / "null\0byte.ply", "null")
    unreadable(tmp_path / f"{'a' * 300}.ply", "too long")


def test_no_permission(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: TOOL-READ-5. The one who runs the tests may be one who may read everything."""
    path = tmp_path / "secret.off"
    path.write_text(TRIANGLE)

    def refuse(_: Path) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", refuse)
    unreadable(path, "Permission denied")


def test_a_file_over_the_limit_is_not_opened(tmp_path: Path) -> None:
    """Clause: TOOL-READ-6. The file is sparse: nothing of it is on the disk."""
    path = tmp_path / "long.ply"
    with path.open("wb") as file:
        file.truncate((1 << 32) + 1)
    result = contents(path)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause) == (Reason.TOO_MANY_BYTES, Clause.TOOL_READ_6)
    path.write_bytes(b"12345")
    assert contents(path, longest=5) == Accepted(b"12345")
