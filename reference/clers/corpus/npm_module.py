"""Meshes that npm packages carry as JavaScript modules, read without running them.

Clause: TOOL-CORPUS-2.
"""

import binascii
import re
from struct import iter_unpack
from typing import Final

import msgspec

from clers.complexes.face_list import FaceList
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Precision, narrowest
from clers.meshfile.faults import unreadable
from clers.meshfile.mesh import RawMesh

Positions = tuple[tuple[float, float, float], ...]
Cells = tuple[tuple[int, int, int], ...]

_ARRAY: Final = rb"exports\.%s\s*=\s*(\[[-+.,\[\]0-9eE\s]*\])"
_BASE64: Final = rb'exports\.%s\s*=\s*require\("\./load"\)\(%s, "([A-Za-z0-9+/]*={0,2})"\)'


def parse(data: bytes) -> Accepted[RawMesh] | Rejected:
    """The mesh of a module's `positions` and `cells`. Clause: TOOL-CORPUS-2."""
    try:
        cells = _cells(data)
        positions = _positions(data)
    except (msgspec.DecodeError, RecursionError, binascii.Error) as error:
        return unreadable(str(error))
    if cells is None or positions is None:
        return unreadable("no exports.positions and exports.cells of triples")
    precision, places = positions
    coordinates = tuple(x for place in places for x in place)
    return Accepted(
        RawMesh(FaceList(cells, len(places)), coordinates, precision or narrowest(coordinates))
    )


def _positions(data: bytes) -> tuple[Precision | None, Positions] | None:
    """The positions, and their precision where the module gives them a type."""
    packed = _packed(data, b"positions", b"Float32Array")
    if packed is not None:
        return Precision.F32, tuple((x, y, z) for x, y, z in iter_unpack("<3f", packed))
    found = re.search(_ARRAY % b"positions", data)
    return None if found is None else (None, msgspec.json.decode(found[1], type=Positions))


def _cells(data: bytes) -> Cells | None:
    packed = _packed(data, b"cells", b"Uint32Array")
    if packed is not None:
        return tuple((a, b, c) for a, b, c in iter_unpack("<3I", packed))
    found = re.search(_ARRAY % b"cells", data)
    return None if found is None else msgspec.json.decode(found[1], type=Cells)


def _packed(data: bytes, name: bytes, kind: bytes) -> bytes | None:
    """The bytes of a typed array of triples of four-byte numbers."""
    found = re.search(_BASE64 % (name, kind), data)
    packed = binascii.a2b_base64(found[1]) if found else None
    return packed if packed is not None and len(packed) % 12 == 0 else None
