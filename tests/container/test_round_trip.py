"""What a round trip says of a mesh, counted by hand; and that a wrong one is seen."""

from dataclasses import replace

import pytest
from by_hand import HEAD, TETRAHEDRON, WORD, file

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.isomorphism import is_isomorphism
from clers.complexes.surface import Surface
from clers.container.file import decode, encode
from clers.container.options import Options
from clers.container.trip import Trip, certificate, isomorphic_by_orders, round_trip
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Holds
from clers.conventions.where import AtByte
from clers.edgebreaker.encode import encode as streamed
from clers.generate.families import grid_torus, strip, with_holes
from clers.geometry.mesh import Mesh

PLAIN = Options(CodeName.PLAIN)
FRAMES = 9 + 16 + 7 + 16
"""Magic and version; HEAD with the seven bytes of small numbers; the frame of WORD."""


def made(given: FaceList) -> Surface:
    """A surface that is known to be one."""
    found = surface(given)
    assert isinstance(found, Accepted)
    return found.value


FACES = FaceList(((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)), 4)
TURNED = FaceList(((2, 1, 3), (0, 1, 2), (3, 0, 2), (1, 0, 3)), 4)
HOLED = with_holes(grid_torus(5, 5), 2)


def test_a_tetrahedron() -> None:
    """Clauses: TOOL-ROUND-1, FILE-ROUND-1."""
    trip = Trip(4, 4, 1, 0, 0, len(bytes.fromhex(WORD)), len(TETRAHEDRON))
    assert round_trip(Mesh(made(FACES)), PLAIN) == Accepted(trip)


def test_a_strip() -> None:
    """Four triangles in a row have six vertices and a border. Clause: TOOL-ROUND-1."""
    found = round_trip(Mesh(made(strip(4))), PLAIN)
    assert isinstance(found, Accepted)
    trip = found.value
    assert (trip.vertices, trip.faces, trip.components, trip.genus, trip.curves) == (6, 4, 1, 0, 1)
    assert trip.file_bytes == FRAMES + trip.connectivity_bytes


def test_a_torus_with_holes() -> None:
    """25 vertices and 50 faces, two of them left out; handle data have a frame. TOOL-ROUND-1."""
    found = round_trip(Mesh(made(HOLED)), PLAIN)
    assert isinstance(found, Accepted)
    trip = found.value
    assert (trip.vertices, trip.faces, trip.components, trip.genus, trip.curves) == (
        25,
        48,
        1,
        1,
        2,
    )
    assert trip.file_bytes == FRAMES + 16 + trip.connectivity_bytes


@pytest.mark.parametrize("given", [FACES, TURNED, HOLED])
def test_the_orders_are_an_isomorphism(given: FaceList) -> None:
    """EB-DECODE-1: the one onto the decoded surface; with two vertices swapped it is none."""
    mesh = Mesh(made(given))
    data = encode(mesh.surface, options=PLAIN)
    assert isinstance(data, Accepted)
    assert isomorphic_by_orders(mesh, data.value) == Holds()
    decoded = decode(data.value)
    assert isinstance(decoded, Accepted)
    claim = certificate(mesh.surface, streamed(mesh.surface))
    assert is_isomorphism(mesh.surface, decoded.value.surface, claim) == Holds()
    one, two, *others = claim.vertices
    wrong = replace(claim, vertices=(two, one, *others))
    assert isinstance(is_isomorphism(mesh.surface, decoded.value.surface, wrong), Fails)


def test_what_cannot_be_read_did_not_come_back() -> None:
    """Clause: TOOL-ROUND-1."""
    mesh = Mesh(made(FACES))
    assert isomorphic_by_orders(mesh, TETRAHEDRON) == Holds()
    found = isomorphic_by_orders(mesh, file(("HEAD", HEAD)))
    assert isinstance(found, Fails)
    assert found.expected == "a mesh"
    assert "bad-section" in found.got
    assert found.where == AtByte(32)
