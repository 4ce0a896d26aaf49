"""Peers as contenders, Draco timed from inside, and `clers bench speed` as a user runs it."""

import json
import sys
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from types import ModuleType
from typing import Final

import DracoPy
import numpy as np
import numpy.typing as npt
import pytest
import zstandard
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.complexes.corner_table import surface, surface_of_indices
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.generate.families import sphere_of
from clers.measure.path import must
from clers.measure.peers import draco_inside
from clers.measure.peers.draco import arrays, encoded, encoded_arrays
from clers.measure.peers.draco_inside import watched
from clers.measure.speed import peers
from clers.measure.speed.contender import Given, Kind, Way
from clers.measure.speed.contender import given as given_as
from clers.measure.speed.memory import Memory
from clers.measure.speed.peers import PEERS, WHOLE_CALL
from clers.measure.speed.rates import Samples, sampled
from clers.measure.speed.slopes import FAMILIES

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
RING: Final = str(MESHES / "ring.off")
MOEBIUS: Final = str(MESHES / "dirty" / "moebius.off")

Indices = npt.NDArray[np.uint32]


def given(faces: int = 2000) -> Given:
    return given_as("sphere", must(surface(sphere_of(faces))))


def quiet(_: str) -> None:
    """Nobody watches."""


def asked(name: str, of: Given) -> Samples:
    (contender,) = (each for each in PEERS if each.name == name)
    return sampled(of, [contender], 1, quiet)


def size(found: Samples, name: str) -> int | None:
    ((there,), (back,)) = found.readings[name, Way.ENCODE], found.readings[name, Way.DECODE]
    assert back.bytes is None
    assert min(there.spent.wall, back.spent.wall) > 0
    assert set(found.kinds.values()) == {Kind.PEER}
    return there.bytes


@pytest.mark.parametrize(
    ("name", "level"), [("draco-standard", 5), ("draco-valence", 7), ("draco-10", 10)]
)
def test_draco(name: str, level: int) -> None:
    """TOOL-SPEED-4: connectivity alone is less than the whole, in time and in bytes."""
    of = given()
    found = asked(name, of)
    whole = encoded(of.surface, level)
    assert size(found, name + WHOLE_CALL) == len(must(whole))
    inside = size(found, name)
    assert inside is not None
    assert 0 < inside < len(must(whole))
    for way in Way:
        (part,) = found.readings[name, way]
        (all_of_it,) = found.readings[name + WHOLE_CALL, way]
        assert 0 < part.spent.wall < all_of_it.spent.wall


def test_draco_is_as_it_was_before() -> None:
    """TOOL-SPEED-4: nothing is seen after a call, and the files are the same."""
    made = arrays(given().surface)
    before = encoded_arrays(made, 7)
    with watched() as watch:
        assert encoded_arrays(made, 7) == before
        seen = watch.spent
    assert seen is not None
    watch.spent = None
    assert encoded_arrays(made, 7) == before
    assert watch.spent is None


def test_where_draco_cannot_be_watched(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-4: another version, or none: the whole call is all there is."""

    def other(_: str) -> str:
        return "2.3.0"

    def none(package: str) -> str:
        raise PackageNotFoundError(package)

    for version in (other, none):
        monkeypatch.setattr(draco_inside, "version", version)
        found = asked("draco-standard", given())
        assert {name for name, _ in found.readings} == {"draco-standard" + WHOLE_CALL}
        assert found.refused == {}


def test_index_codec_and_zstd() -> None:
    """TOOL-SPEED-4: the codec's own bytes, and the compressor's."""
    of = given()
    listed = np.array(of.surface.vertex, dtype="<u4").tobytes()
    packed = zstandard.ZstdCompressor(level=19).compress(listed)
    assert size(asked("zstd", of), "zstd") == len(packed)
    found = size(asked("meshoptimizer", of), "meshoptimizer")
    assert found is not None
    assert of.surface.faces < found < 2 * of.surface.faces


class Lossy(ModuleType):
    """Peers that lose what they were given."""

    class Mesh:
        faces = ()

    @staticmethod
    def encode(*given: object, **options: object) -> bytes:
        return bytes(DracoPy.encode(*given, **options))

    @staticmethod
    def decode(_: bytes) -> Mesh:
        return Lossy.Mesh()

    @staticmethod
    def decode_index_buffer(count: int, _: int, __: bytes) -> Indices:
        return np.zeros(count, dtype=np.uint32)

    class ZstdCompressor:
        def __init__(self, level: int) -> None:
            self.level = level

        def compress(self, data: bytes) -> bytes:
            return data

    class ZstdDecompressor:
        def decompress(self, data: bytes) -> bytes:
            return data[1:]


@pytest.mark.parametrize(
    ("package", "name"),
    [("DracoPy", "draco-valence"), ("meshoptimizer", "meshoptimizer"), ("zstandard", "zstd")],
)
def test_peers_that_lose_faces(package: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-4: what did not come back was not coded."""
    lossy = Lossy(package)
    if package == "meshoptimizer":
        import meshoptimizer

        monkeypatch.setattr(meshoptimizer, "decode_index_buffer", Lossy.decode_index_buffer)
    else:
        monkeypatch.setattr(draco_inside, "_possible", lambda: False)
        monkeypatch.setitem(sys.modules, package, lossy)
    found = asked(name, given())
    told = Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_SPEED_4, detail=name)
    assert found.refused == {name: told.line()}
    assert not found.readings


@pytest.mark.parametrize(
    ("package", "lost"),
    [
        ("DracoPy", {"draco-standard", "draco-valence", "draco-10"}),
        ("meshoptimizer", {"meshoptimizer"}),
        ("zstandard", {"zstd"}),
    ],
)
def test_a_missing_peer(package: str, lost: set[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-4: it is named; the others are timed."""
    monkeypatch.setitem(sys.modules, package, None)
    monkeypatch.setattr(draco_inside, "_possible", lambda: False)
    found = sampled(given(100), PEERS, 1, quiet)
    assert set(found.refused) == lost
    assert all(f"{package} is not installed" in why for why in found.refused.values())
    assert len(found.readings) == 2 * (len(PEERS) - len(lost))


def test_faces_from_any_corner_on() -> None:
    """TOOL-SPEED-4: a face may begin with another of its corners, but not run backward."""
    faces = np.array([0, 1, 2, 3, 4, 5], dtype=np.uint32)
    same = peers._same_faces
    assert same(faces, np.array([0, 1, 2, 3, 4, 5], dtype=np.uint32))
    assert same(faces, np.array([1, 2, 0, 5, 3, 4], dtype=np.uint32))
    assert not same(faces, np.array([1, 0, 2, 3, 4, 5], dtype=np.uint32))
    assert not same(faces, np.array([3, 4, 5, 0, 1, 2], dtype=np.uint32))


# The command


@pytest.fixture
def _quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Memory, and all families, have tests of their own."""
    monkeypatch.setattr("clers.measure.speed.report.memory", lambda _, code: Memory(code, 1, 2, 3))
    monkeypatch.setattr("clers.measure.speed.slopes.FAMILIES", {"nested S": FAMILIES["nested S"]})


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["bench", "speed", *arguments])


@pytest.mark.usefixtures("_quickly")
def test_speed_as_json(tmp_path: Path) -> None:
    """TOOL-SPEED-7, TOOL-SPEED-8: the shape; the page and the plot beside it."""
    out, plot = tmp_path / "a.md", tmp_path / "a.svg"
    done = clers(
        RING, "--faces", "1000", "--rounds", "1", "--json", "-o", str(out), "--plot", str(plot)
    )
    assert done.exit_code == Exit.CONFORMING
    document = json.loads(done.stdout)
    assert set(document) == {"machine", "rounds", "meshes", "slopes"}
    assert [mesh["mesh"] for mesh in document["meshes"]] == ["ring", "sphere-100", "sphere-1000"]
    ring = document["meshes"][0]
    assert (ring["vertices"], ring["faces"]) == (6, 6)
    assert {"golden", "best", "golden: walk", "golden: container", "zstd"} <= {
        rate["name"] for rate in ring["rates"]
    }
    assert set(ring["rates"][0]) == {
        "name", "kind", "way", "bytes", "triangles_per_second", "cpu", "wall",
    }  # fmt: skip
    text = out.read_text()
    command = f"{RING} --faces 1000 --rounds 1 -o {out} --plot {plot}"
    assert f"\n    clers bench speed {command}\n" in text
    assert "## Sphere-1000: a peer's time divided by ours\n" in text
    drawing = plot.read_text()
    assert "sphere-1000: " in drawing
    assert ">golden<" in drawing


@pytest.mark.usefixtures("_quickly")
def test_speed_for_people(tmp_path: Path) -> None:
    """TOOL-SPEED-7, TOOL-SPEED-8."""
    plot = tmp_path / "a.PNG"
    done = clers("--faces", "1000", "--rounds", "1", "--plot", str(plot))
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout.startswith("clers ")
    for title in ("sphere-1000: million triangles a second", "microseconds a triangle as meshes"):
        assert title in done.stdout
    assert plot.read_bytes().startswith(b"\x89PNG")


@pytest.mark.usefixtures("_quickly")
def test_who_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-4: on standard error, a line for each mesh."""
    monkeypatch.setitem(sys.modules, "zstandard", None)
    done = clers("--faces", "1000", "--rounds", "1")
    assert done.exit_code == Exit.CONFORMING
    assert "sphere-1000: zstd: " in done.stderr
    assert "zstandard is not installed" in done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ("-o", "a.svg"),
        ("--plot", "a.md"),
        ("--faces", "999"),
        ("--rounds", "0"),
        ("no-such-file.off",),
    ],
)
def test_wrong_usage(arguments: tuple[str, ...]) -> None:
    """TOOL-SPEED-1, TOOL-SPEED-8."""
    assert clers(*arguments).exit_code == Exit.USAGE


def test_a_rejected_file() -> None:
    """TOOL-SPEED-1: before anything is timed."""
    done = clers(RING, MOEBIUS)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "moebius.off: invalid: edge-twice-in-one-direction" in done.stderr
    assert done.stdout == ""


def test_faces_of_files_are_those_of_the_mesh() -> None:
    """TOOL-SPEED-1: in the file's order."""
    from clers.cli.speed import _read

    (read,) = _read([Path(RING)], as_json=False)
    assert (read.name, read.indices.vertices, read.indices.faces) == ("ring", 6, 6)
    assert read.surface == must(surface_of_indices(read.indices))
