"""Draco through its adapter, and the same without."""

from importlib.metadata import version

import DracoPy
import msgspec
import numpy as np
import pytest
from through_codecs import (
    BARE,
    CORNERS,
    SEQUENTIAL,
    SOLID,
    STANDARD,
    VALENCE,
    kinds,
    mesh,
    served,
    through,
)

from clers.conformance import payloads as form
from clers.conformance.judging.meshes import Same, compare
from clers.conformance.messages import Lacking, Rejection
from clers.conventions.reason import Fault
from clers.oracle.codecs import draco as draco_module
from clers.oracle.codecs.codec import Codec
from clers.oracle.codecs.draco import draco, promise


def test_draco_says_what_it_is() -> None:
    """ORCL-CODEC-9."""
    codec = served(draco("sequential", 11))
    assert (codec.name, codec.language) == ("draco", "c++")
    assert codec.version == f"DracoPy {version('DracoPy')}"
    assert codec.policy == {"method": "sequential", "bits": "11"}
    assert served(STANDARD).policy == {"method": "edgebreaker-standard", "bits": "from the error"}


@pytest.mark.parametrize("codec", [STANDARD, VALENCE, SEQUENTIAL])
def test_draco_gives_a_tetrahedron_back(codec: Codec) -> None:
    """ORCL-CODEC-11: nothing is quantised where no error is allowed."""
    assert kinds(codec, mesh()) == []
    assert kinds(codec, BARE) == []
    back = codec.through(BARE)
    assert isinstance(back, form.MeshForm)
    assert back.positions is msgspec.UNSET


def test_differences_of_draco() -> None:
    """ORCL-CODEC-11: what Edgebreaker drops and splits, the sequential method keeps."""
    isolated = mesh(at=(5.0, 5.0, 5.0))
    thin = mesh((0, 0, 1))
    twice = mesh((1, 2, 0))
    assert kinds(STANDARD, isolated) == [("lost-isolated-vertices", 1)]
    assert kinds(STANDARD, thin) == [("dropped-degenerate-faces", 1)]
    assert kinds(STANDARD, twice) == [("vertices-split", 3)]
    assert kinds(VALENCE, isolated) == [("lost-isolated-vertices", 1)]
    assert [kinds(SEQUENTIAL, each) for each in (isolated, thin, twice)] == [[], [], []]
    touching = mesh((4, 5, 6), at=(0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 3.0, 3.0))
    assert kinds(SEQUENTIAL, touching) == [("vertices-merged", 1)]


def test_draco_without_the_adapter() -> None:
    """The same findings by DracoPy alone: they are not the adapter's. Clause: ORCL-CODEC-11."""
    places = np.array([*CORNERS, 5, 5, 5], dtype=np.float32).reshape(-1, 3)
    faces = np.array(SOLID, dtype=np.uint32)
    for level, vertices in ((5, 4), (7, 4), (0, 5)):
        data = DracoPy.encode(places, faces, quantization_bits=0, compression_level=level)
        assert len(DracoPy.decode(data).points) == vertices
    for more, shape in (((0, 0, 1), (4, 4)), ((1, 2, 0), (7, 5))):
        faces = np.array((*SOLID, more), dtype=np.uint32)
        data = DracoPy.encode(places[:4], faces, quantization_bits=0, compression_level=5)
        found = DracoPy.decode(data)
        assert (len(found.points), len(found.faces)) == shape


@pytest.mark.parametrize(("method", "coded"), [("sequential", 0), ("edgebreaker-standard", 1)])
def test_method_of_draco(method: str, coded: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-11: byte 8 of a Draco file names the method."""
    written: list[bytes] = []
    encode = DracoPy.encode

    def seen(*given: object, **named: object) -> bytes:
        written.append(bytes(encode(*given, **named)))
        return written[-1]

    monkeypatch.setattr(DracoPy, "encode", seen)
    assert kinds(draco(method, None), mesh()) == []
    assert [data[8] for data in written] == [coded]


def test_valence_method_of_draco() -> None:
    """ORCL-CODEC-11: the level at which Draco takes valences, from 1000 faces on."""
    assert draco_module.LEVELS["edgebreaker-valence"] == 7


@pytest.mark.parametrize("bits", [1, 4, 11, 20])
def test_promise_of_draco(bits: int) -> None:
    """ORCL-CODEC-11: no coordinate moves further than half a step, and a little for rounding."""
    places = [((i * 37) % 101 / 7, (i * 53) % 97 / 3, i / 11) for i in range(60)]
    singles = tuple(float(np.float32(x)) for place in places for x in place)
    strip = tuple((i, i + 1, i + 2) for i in range(58))
    bound = promise(np.array(singles).reshape(-1, 3), bits)
    extent = max(max(singles[k::3]) - min(singles[k::3]) for k in range(3))
    most = max(map(abs, singles))
    assert bound == pytest.approx(extent / (2**bits - 1) / 2 + most / 2**22)
    at = form.Places(precision="f32", coordinates=singles)
    given = form.ThroughForm(faces=strip, vertices=60, positions=at)
    back = through(draco("sequential", bits), given)
    assert isinstance(back, form.MeshForm)
    assert isinstance(back.positions, form.Places)
    moved = [abs(x - y) for x, y in zip(singles, back.positions.coordinates, strict=True)]
    assert max(moved) <= bound
    assert max(moved) > bound / 3


@pytest.mark.parametrize(("room", "bits"), [(0.5, 1), (0.26, 2), (0.1, 3), (0.0, 0), (1e-12, 0)])
def test_bits_from_the_error(room: float, bits: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-11: the fewest bits whose half step is small enough; none if none are."""
    asked: list[object] = []
    encode = DracoPy.encode

    def seen(*given: object, quantization_bits: int, compression_level: int) -> bytes:
        asked.append(quantization_bits)
        return bytes(
            encode(*given, quantization_bits=quantization_bits, compression_level=compression_level)
        )

    monkeypatch.setattr(DracoPy, "encode", seen)
    given = mesh(error=(1.0, room * 1.000001, 1.0))
    back = through(STANDARD, given)
    assert isinstance(back, form.MeshForm)
    assert asked == [bits]
    assert isinstance(compare(given, back, (1.0, room * 1.000001, 1.0)), Same)


def test_draco_knows_binary32_alone() -> None:
    """ORCL-CODEC-1, ORCL-CODEC-11: what rounding moves too far is not supported."""
    fine = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True)
    assert through(SEQUENTIAL, fine) == Lacking("error")
    off = abs(float(np.float32(0.1)) - 0.1)
    wide = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True, error=(off, 0.0, 0.0))
    assert isinstance(through(SEQUENTIAL, wide), form.MeshForm)
    tight = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True, error=(off / 2, 9.0, 9.0))
    assert through(SEQUENTIAL, tight) == Lacking("error")
    assert isinstance(through(draco("sequential", 20), fine), form.MeshForm)


def test_draco_refuses() -> None:
    """ORCL-CODEC-11: all faces degenerate, or nothing at all; faces alone may be none."""
    thin = form.ThroughForm(faces=((0, 0, 1),), vertices=2)
    assert through(STANDARD, thin) == Rejection(
        Fault.INVALID, detail="DracoPy: EncodingFailedException: Invalid mesh"
    )
    nothing = through(SEQUENTIAL, form.ThroughForm(faces=(), vertices=0))
    assert isinstance(nothing, Rejection)
    assert nothing.detail.startswith("DracoPy: ValueError: ")
    cloud = through(SEQUENTIAL, form.ThroughForm(faces=(), vertices=3))
    assert cloud == form.MeshForm(faces=(), vertices=3)
