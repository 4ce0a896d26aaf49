"""What is written: the bytes themselves, what is refused, and files whole or not at all."""

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path
from struct import pack

import pytest

from clers.complexes.face_list import FaceList
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtFace, AtVertex, Where
from clers.geometry.positions import Precision
from clers.meshfile import RawMesh, read, write
from clers.meshfile.atomic import write_bytes
from clers.meshfile.formats import Format
from clers.meshfile.rendering import render

ONE = FaceList(((0, 1, 2),), 3)
UNUSED = FaceList(((0, 1, 3),), 4)
PLACES = (0.0, -0.0, 0.5, 1.0, 0.25, 1e-05, 3.0, 2.0, 1e22)
F64 = RawMesh(ONE, PLACES, Precision.F64)
F32 = RawMesh(ONE, (0.0, -0.0, 0.5, 1.0, 0.25, 0.125, 3.0, 2.0, 1.0), Precision.F32)


def ply(kind: str, places: bytes) -> bytes:
    lines = (
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
        f"property {kind} x\nproperty {kind} y\nproperty {kind} z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    )
    return lines.encode() + places + pack("<B3i", 3, 0, 1, 2)


@pytest.mark.parametrize(
    ("known", "mesh", "data"),
    [
        (Format.PLY, F64, ply("double", pack("<9d", *F64.coordinates))),
        (Format.PLY, F32, ply("float", pack("<9f", *F32.coordinates))),
        (Format.OFF, F64, b"OFF\n3 1 0\n0.0 -0.0 0.5\n1.0 0.25 1e-05\n3.0 2.0 1e+22\n3 0 1 2\n"),
        (Format.OBJ, F64, b"v 0.0 -0.0 0.5\nv 1.0 0.25 1e-05\nv 3.0 2.0 1e+22\nf 1 2 3\n"),
        (
            Format.STL,
            F32,
            b"binary STL".ljust(80, b"\0") + pack("<I12fH", 1, 0, 0, 0, *F32.coordinates, 0),
        ),
    ],
)
def test_the_bytes(known: Format, mesh: RawMesh, data: bytes) -> None:
    """Clause: TOOL-WRITE-1."""
    assert render(known, mesh) == Accepted(data)


def refused(known: Format, mesh: RawMesh, reason: Reason, clause: Clause, where: Where) -> str:
    result = render(known, mesh)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause, result.where) == (reason, clause, where)
    return result.detail


@pytest.mark.parametrize("known", Format)
def test_what_no_format_holds(known: Format) -> None:
    """Clause: TOOL-WRITE-2."""
    short = RawMesh(ONE, PLACES[:8], Precision.F64)
    refused(known, short, Reason.COUNT_MISMATCH, Clause.TOOL_WRITE_2, WHOLE)
    for bad in (-1, 3):
        faces = FaceList(((0, 1, 2), (0, bad, 1)), 3)
        mesh = RawMesh(faces, F32.coordinates, Precision.F32)
        refused(known, mesh, Reason.INDEX_OUT_OF_RANGE, Clause.TOOL_WRITE_2, AtFace(1))
    wide = RawMesh(ONE, PLACES, Precision.F32)
    clause = Clause.TOOL_WRITE_2
    assert "1e-05" in refused(known, wide, Reason.NOT_REPRESENTABLE, clause, AtVertex(1))


@pytest.mark.parametrize(
    ("mesh", "vertex", "says"),
    [
        (F64, 1, "1e-05 is no binary32 value"),
        (
            RawMesh(FaceList(((0, 1, 3),), 4), (*F32.coordinates, 1.0, 1.0, 1.0), Precision.F32),
            2,
            "without faces",
        ),
        (RawMesh(FaceList(((0, 1, 2),), 3), (0.0, 1.0, 0.0) * 3, Precision.F32), 1, "of vertex 0"),
        (
            RawMesh(ONE, (5.0, 0.0, 0.0, 1.0, -0.0, 0.0, 1.0, 0.0, -0.0), Precision.F64),
            2,
            "of vertex 1",
        ),
    ],
)
def test_what_stl_would_lose(mesh: RawMesh, vertex: int, says: str) -> None:
    """Clause: TOOL-WRITE-3."""
    clause = Clause.TOOL_WRITE_3
    where = AtVertex(vertex)
    assert says in refused(Format.STL, mesh, Reason.NOT_REPRESENTABLE, clause, where)


@pytest.mark.parametrize("name", ["mesh.ply", "mesh.off", "mesh.obj", "mesh.stl"])
def test_written_and_read(name: str, tmp_path: Path) -> None:
    """Clauses: TOOL-WRITE-1, TOOL-WRITE-4."""
    path = tmp_path / name
    assert write(path, F32) == Accepted(path)
    assert read(path) == Accepted(F32)
    assert [file.name for file in tmp_path.iterdir()] == [name]


def test_a_refused_mesh_writes_nothing(tmp_path: Path) -> None:
    """Clauses: TOOL-WRITE-3, TOOL-READ-1."""
    assert isinstance(write(tmp_path / "a.stl", F64), Rejected)
    assert isinstance(write(tmp_path / "a.xyz", F64), Rejected)
    assert list(tmp_path.iterdir()) == []


def unwritable(path: Path, says: str) -> None:
    result = write_bytes(path, b"new")
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause) == (Reason.UNWRITABLE_FILE, Clause.TOOL_WRITE_4)
    assert says in result.detail


def test_names_that_cannot_be_written(tmp_path: Path) -> None:
    """Clause: TOOL-WRITE-4."""
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    unwritable(tmp_path / "folder", "a folder")
    unwritable(tmp_path / "pipe", "not a regular file")
    unwritable(Path(os.devnull), "not a regular file")
    unwritable(tmp_path / "none" / "file", "No such file")
    unwritable(tmp_path / "null\0byte", "null")
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["folder", "pipe"]


def test_links_and_permissions(tmp_path: Path) -> None:
    """Clause: TOOL-WRITE-4: new files get what the process gives them, old ones keep theirs."""
    real, link = tmp_path / "real", tmp_path / "link"
    ordinary = tmp_path / "ordinary"
    ordinary.write_bytes(b"")
    assert write_bytes(real, b"1") == Accepted(real)
    assert real.stat().st_mode == ordinary.stat().st_mode
    real.chmod(0o640)
    link.symlink_to("real")
    assert write_bytes(link, b"2") == Accepted(link)
    assert link.is_symlink()
    assert real.read_bytes() == b"2"
    assert stat.S_IMODE(real.stat().st_mode) == 0o640


@pytest.mark.parametrize("step", ["fsync", "replace"])
@pytest.mark.parametrize("raised", [KeyboardInterrupt(), OSError(28, "No space left on device")])
@pytest.mark.parametrize("old", [b"old", None])
def test_whole_or_not_at_all(
    step: str,
    raised: BaseException,
    old: bytes | None,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Clause: TOOL-WRITE-4: whatever stops it, the old file stays and the new one goes."""
    path = tmp_path / "file"
    if old is not None:
        path.write_bytes(old)

    def stop(*_: object) -> None:
        assert len(list(tmp_path.iterdir())) == (1 if old is None else 2)
        raise raised

    if step == "fsync":
        monkeypatch.setattr(os, "fsync", stop)
    else:
        monkeypatch.setattr(Path, "replace", stop)
    if isinstance(raised, OSError):
        unwritable(path, "No space left")
    else:
        with pytest.raises(KeyboardInterrupt):
            write_bytes(path, b"new")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == (
        {} if old is None else {"file": old}
    )


WRITER = """
import os, sys, time
from pathlib import Path
from clers.meshfile.atomic import write_bytes
flush = os.fsync
def slow(opened):
    print("writing", flush=True)
    time.sleep(60)
os.fsync = slow
write_bytes(Path(sys.argv[1]), b"new")
"""


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_a_process_that_is_ended(how: signal.Signals, tmp_path: Path) -> None:
    """Clause: TOOL-WRITE-4: after Ctrl-C nothing is left, after a kill the old file is."""
    path = tmp_path / "file"
    path.write_bytes(b"old")
    command = [sys.executable, "-c", WRITER, str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"writing\n"
        process.send_signal(how)
        assert process.wait(timeout=30) != 0
    assert path.read_bytes() == b"old"
    if how is signal.SIGINT:
        assert [file.name for file in tmp_path.iterdir()] == ["file"]
