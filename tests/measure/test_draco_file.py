"""Draco's connectivity section: files by hand, faults in them, and files that Draco writes."""

from pathlib import Path
from typing import Final

import pytest

from clers.cli.loading import mesh_in
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte
from clers.measure.peers.draco import bytes_at, encoded
from clers.measure.peers.draco_file import Connectivity, connectivity

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"

HEADER: Final = b"DRACO\x02\x02\x01\x01\x00\x00"

# Two split events with their two bits, then nine bytes of symbols, start faces, two seams.
STANDARD: Final = (
    HEADER
    + b"\x00\x90\x01\x08\x02\x07\x02"  # standard; 144 vertices, 8 faces, 2 seams, 7 and 2 symbols
    + b"\x02\x01\x81\x01\x03\x00\x03"  # 2 events: (1, 129), (3, 0), bits 3
    + b"\x09symbols!!"
    + b"\x80\x02ab"
    + b"\x10\x01c"
    + b"\x20\x00"
)
STANDARD_PARTS: Final = Connectivity(0, 144, 8, counts=7, splits=7, starts=4, seams=5, symbols=10)

# Three of the six valences have symbols: 1 + 13 + 2 + 8 + 6 bytes. The tables have probabilities of
# one, two and three bytes, a run of zeros, and nothing.
VALENCE: Final = (
    HEADER
    + b"\x02\x04\x04\x00\x03\x00"  # valence; 4 vertices, 4 faces, no seams, 3 and 0 symbols
    + b"\x00"  # no events
    + b"\x80\x01a"
    + b"\x00"
    + b"\x01\x01\x03\x03\x04\x05x\x06yz\x02ab"  # 3 probabilities of 1, 2 and 3 bytes, 2 of data
    + b"\x00\x00"
    + b"\x01\x01\x03\x05\x0b\x04\x08\x00"  # 5 probabilities: a run of 3 zeros, then two
    + b"\x02\x01\x03\x00\x01q"  # no probabilities at all
)
VALENCE_PARTS: Final = Connectivity(2, 4, 4, counts=6, splits=1, starts=3, seams=0, symbols=30)


def surface_of(name: str) -> Surface:
    mesh = mesh_in(MESHES / name)
    assert isinstance(mesh, Accepted)
    return mesh.value.surface


def file_of(name: str, level: int) -> bytes:
    data = encoded(surface_of(name), level)
    assert isinstance(data, Accepted)
    return data.value


def section_of(data: bytes) -> Connectivity:
    found = connectivity(data)
    assert isinstance(found, Accepted), found
    return found.value


@pytest.mark.parametrize(("data", "parts"), [(STANDARD, STANDARD_PARTS), (VALENCE, VALENCE_PARTS)])
def test_sections_by_hand(data: bytes, parts: Connectivity) -> None:
    """TOOL-BITS-2, TOOL-BITS-3: the parts are as laid out, with attribute data after or without."""
    assert parts.bytes == len(data) - len(HEADER)
    assert section_of(data) == parts
    assert section_of(data + b"attributes") == parts


@pytest.mark.parametrize("data", [STANDARD, VALENCE])
def test_every_beginning_is_truncated(data: bytes) -> None:
    """TOOL-BITS-3."""
    for length in range(5, len(data)):
        where = AtByte(length)
        detail = f"the {'header' if length < len(HEADER) else 'connectivity'} goes on"
        expected = Rejected(Reason.TRUNCATED_FILE, Clause.TOOL_BITS_3, where, detail)
        assert connectivity(data[:length]) == expected


def changed(data: bytes, at: int, value: int) -> bytes:
    return data[:at] + bytes([value]) + data[at + 1 :]


@pytest.mark.parametrize(
    ("data", "reason", "offset", "detail"),
    [
        (b"", Reason.BAD_MAGIC, 0, ""),
        (b"DRACULA, too long", Reason.BAD_MAGIC, 0, "44 52 41 43 55"),
        (changed(STANDARD, 5, 1), Reason.UNKNOWN_VERSION, 5, "version 1.2"),
        (changed(STANDARD, 6, 3), Reason.UNKNOWN_VERSION, 5, "version 2.3"),
        (changed(STANDARD, 7, 0), Reason.UNKNOWN_FORMAT, 7, "kind 0, method 1"),
        (changed(STANDARD, 8, 0), Reason.UNKNOWN_FORMAT, 7, "kind 1, method 0"),
        (changed(STANDARD, 10, 0x80), Reason.UNKNOWN_FORMAT, 9, "with metadata"),
        (changed(STANDARD, 11, 1), Reason.UNKNOWN_FORMAT, 11, "traversal 1"),
        (changed(VALENCE, 23, 0), Reason.UNKNOWN_FORMAT, 23, "symbols in the tagged scheme"),
        (
            HEADER + b"\x00\x05" + b"\xff" * 10 + b"\x01" * 30,
            Reason.BAD_NUMBER,
            13,
            "a number of more than ten bytes",
        ),
    ],
)
def test_refusals(data: bytes, reason: Reason, offset: int, detail: str) -> None:
    """TOOL-BITS-3."""
    assert connectivity(data) == Rejected(reason, Clause.TOOL_BITS_3, AtByte(offset), detail)


def test_the_first_number_that_is_too_long() -> None:
    """TOOL-BITS-3: whatever is wrong after it: another such number, a tagged scheme, the end."""
    long = b"\xff" * 10
    for rest in (b"\x01" + long, b"\x01\x00\x01\x00\x00\x00\x00\x01\x00", b""):
        found = connectivity(HEADER + b"\x02" + long + rest)
        assert isinstance(found, Rejected)
        assert (found.reason, found.where) == (Reason.BAD_NUMBER, AtByte(12))


def test_other_flags_are_no_metadata() -> None:
    """TOOL-BITS-3: of the flags only the highest bit says metadata."""
    assert section_of(changed(changed(STANDARD, 9, 0xFF), 10, 0x7F)) == STANDARD_PARTS


def test_ten_bytes_are_a_number() -> None:
    """TOOL-BITS-3: the longest number is one, and skipping so much is beyond the end."""
    huge = HEADER + b"\x00\x04\x04\x00\x03\x00\x00" + b"\xff" * 9 + b"\x01" + b"rest"
    found = connectivity(huge)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.TRUNCATED_FILE


def test_counts_that_are_only_said_cost_no_time() -> None:
    """TOOL-BITS-3: 2^63 events, or probabilities, in a short file are not waited for."""
    count = b"\xff" * 8 + b"\x7f"
    events = HEADER + b"\x00\x04\x04\x00\x03\x00" + count + b"\x01" * 20
    table = VALENCE[:25] + count + b"\x01" * 20
    for data in (events, table):
        found = connectivity(data)
        assert isinstance(found, Rejected)
        assert found.reason is Reason.TRUNCATED_FILE


# One attribute decoder, of the vertices, depth first; one attribute: positions of three binary32,
# not normalised, number 0; quantised. So the attribute data of these files begin.
ATTRIBUTES: Final = bytes.fromhex("01 ff 00 00 01 00 09 03 00 00 02")


@pytest.mark.parametrize("level", [5, 7])
@pytest.mark.parametrize(
    "name", ["bunny.obj", "cheese.ply", "elephant-with-holes.off", "teapot.ply", "ring.off"]
)
def test_attributes_begin_where_the_section_ends(name: str, level: int) -> None:
    """TOOL-BITS-2: with handles, curves and components, standard and valence."""
    data, surface = file_of(name, level), surface_of(name)
    found = section_of(data)
    assert data[11 + found.bytes :].startswith(ATTRIBUTES)
    assert (found.vertices, found.faces) == (surface.vertices, surface.faces)
    assert bytes_at(level)(surface) == Accepted(found.bytes)
    assert found.traversal == (2 if level == 7 and surface.faces >= 1000 else 0)


@pytest.mark.parametrize("name", ["cube.ply", "sphere.ply", "blobby.off", "bunny.obj"])
def test_standard_edgebreaker_of_spheres_by_counting(name: str) -> None:
    """TOOL-BITS-2: T − 1 symbols, V − 3 of them C of one bit, the others of three.

    The first face is not coded. Around the bits: their length in bytes as a number, no split
    events (one byte), one start face (probability, length, one byte), and the counts.
    """
    surface = surface_of(name)
    vertices, faces = surface.vertices, surface.faces
    bits = (vertices - 3) + 3 * (faces - 1 - (vertices - 3))
    symbols = -(-bits // 8)
    found = section_of(file_of(name, 5))
    assert found.symbols == symbols + (1 if symbols < 128 else 2)
    assert (found.splits, found.starts, found.seams) == (1, 3, 0)


def test_the_cube_takes_fourteen_bytes() -> None:
    """TOOL-BITS-2: six counts, no events, 5 · 1 + 6 · 3 bits and their length, a start face."""
    assert bytes_at(5)(surface_of("cube.ply")) == Accepted(6 + 1 + (1 + 3) + 3)
    assert bytes_at(7)(surface_of("cube.ply")) == Accepted(14)


def test_another_mesh_than_asked_for_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BITS-2."""
    ring, cube = surface_of("ring.off"), file_of("cube.ply", 5)
    monkeypatch.setattr("clers.measure.peers.draco.encoded", lambda *_: Accepted(cube))
    expected = Rejected(
        Reason.COUNT_MISMATCH, Clause.TOOL_BITS_2, detail="Draco has 8 vertices and 12 faces"
    )
    assert bytes_at(5)(ring) == expected
