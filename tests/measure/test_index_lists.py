"""The list of vertex numbers by general compressors, and peers that are not installed."""

import lzma
import sys
import zlib
from importlib.metadata import PackageNotFoundError
from types import ModuleType
from typing import Final

import numpy as np
import numpy.typing as npt
import pytest
import zstandard

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.examples import TETRAHEDRON
from clers.measure.bits.costs import PEERS, Kind, measured
from clers.measure.bits.report import report
from clers.measure.bits.spheres import random_sphere
from clers.measure.peers.draco import DRACO, encoded
from clers.measure.peers.index_list import (
    by_lzma,
    by_meshoptimizer,
    by_zlib,
    by_zstd,
    index_list,
    reordered,
)

Indices = npt.NDArray[np.uint32]

LIST: Final = b"".join(number.to_bytes(4, "little") for number in TETRAHEDRON.vertex)


def test_the_list_is_of_little_endian_words() -> None:
    """TOOL-BITS-4."""
    assert len(LIST) == 48
    assert index_list(TETRAHEDRON).tobytes() == LIST


def test_general_compressors() -> None:
    """TOOL-BITS-4: what each writes can be read again as the list."""
    written = [zlib.compress(LIST, 9), lzma.compress(LIST, preset=9)]
    written.append(zstandard.ZstdCompressor(level=19).compress(LIST))
    asked = [by_zlib(TETRAHEDRON), by_lzma(TETRAHEDRON), by_zstd(TETRAHEDRON)]
    assert asked == [Accepted(len(data)) for data in written]


class PretendedMeshoptimizer(ModuleType):
    """Turns the list of faces round, names vertices by first use, writes a byte a number."""

    @staticmethod
    def optimize_vertex_cache_strip(to: Indices, given: Indices, count: int, vertices: int) -> None:
        assert (count, vertices) == (12, 4)
        to[:] = given.reshape(-1, 3)[::-1].reshape(-1)

    @staticmethod
    def optimize_vertex_fetch_remap(to: Indices, given: Indices, count: int, vertices: int) -> None:
        assert (len(to), count, vertices) == (4, 12, 4)
        for name, v in enumerate(dict.fromkeys(given.tolist())):
            to[v] = name

    @staticmethod
    def remap_index_buffer(to: Indices, given: Indices, count: int, names: Indices) -> None:
        assert count == 12
        to[:] = names[given]

    @staticmethod
    def encode_index_buffer(given: Indices, count: int, vertices: int) -> bytes:
        assert (count, vertices) == (12, 4)
        return bytes(given.tolist())


def test_meshoptimizer_is_asked_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BITS-4: reordered, then renumbered by first use, then coded, then zstd."""
    monkeypatch.setitem(sys.modules, "meshoptimizer", PretendedMeshoptimizer("meshoptimizer"))
    backward = [v for face in list(TETRAHEDRON.triangles())[::-1] for v in face]
    names = {v: name for name, v in enumerate(dict.fromkeys(backward))}
    expected = bytes(names[v] for v in backward)
    assert expected != bytes(backward)
    assert reordered(TETRAHEDRON) == Accepted(expected)
    packed = zstandard.ZstdCompressor(level=19).compress(expected)
    assert by_meshoptimizer(TETRAHEDRON) == Accepted(len(packed))


class PretendedDraco(ModuleType):
    """Writes down what it is asked."""

    asked: Final[list[tuple[list[list[float]], list[list[int]], int, int]]] = []

    @staticmethod
    def encode(
        places: npt.NDArray[np.float32],
        faces: npt.NDArray[np.uint32],
        quantization_bits: int,
        compression_level: int,
    ) -> bytes:
        PretendedDraco.asked.append(
            (places.tolist(), faces.tolist(), quantization_bits, compression_level)
        )
        return b"a file"


def test_draco_is_given_a_place_for_each_vertex(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BITS-2: rows of 4096, so that binary32 has all of them and no two are the same."""
    monkeypatch.setitem(sys.modules, "DracoPy", PretendedDraco("DracoPy"))
    many = random_sphere(2 * 8200 - 4, 1)
    assert many.vertices == 8200
    assert encoded(many, 7) == Accepted(b"a file")
    ((places, faces, bits, level),) = PretendedDraco.asked
    assert places == [[i % 4096, i // 4096, 0] for i in range(8200)]
    assert faces == [list(face) for face in many.triangles()]
    assert (bits, level) == (1, 7)
    assert [peer.name for peer in DRACO] == ["draco-standard", "draco-valence"]


@pytest.mark.parametrize("package", ["DracoPy", "meshoptimizer", "zstandard"])
def test_a_missing_package_is_an_answer(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BITS-6: its peers have a rejection that names it; the others are measured."""
    monkeypatch.setitem(sys.modules, "meshoptimizer", PretendedMeshoptimizer("meshoptimizer"))
    monkeypatch.setitem(sys.modules, package, None)
    told = f"{package} is not installed"
    missing = Rejected(Reason.NOT_OBTAINABLE, Clause.TOOL_BITS_6, detail=told)
    lost = {peer.name for peer in PEERS if peer.bytes_for(TETRAHEDRON) == missing}
    needs_zstd = {"meshopt-zstd"} if package == "zstandard" else set()
    assert lost == {peer.name for peer in PEERS if peer.package == package} | needs_zstd
    found = measured("tetrahedron", TETRAHEDRON, lambda _: None)
    without = {cost.name for cost in found.costs if cost.kind is Kind.PEER and cost.bits is None}
    assert without == lost
    assert {cost.why_not for cost in found.costs if cost.name in lost} == {missing.line()}
    assert (found.ratio is None) == (package == "DracoPy")


def test_versions_that_there_are_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BITS-6, TOOL-BITS-8: the report says of each package its version, or that it lacks."""

    def version(package: str) -> str:
        if package == "DracoPy":
            raise PackageNotFoundError(package)
        return f"9.{len(package)}"

    monkeypatch.setattr("clers.measure.bits.report.version", version)
    packages = report((), lambda _: None).packages
    assert packages == {"DracoPy": "not installed", "meshoptimizer": "9.13", "zstandard": "9.9"}
