"""Solids that another library made, kept literally in `inputs/solids.json`."""

from collections.abc import Iterator, Mapping
from typing import Final

import msgspec

from clers.complexes.face_list import FaceList
from clers.conformance import payloads as form
from clers.oracle.positives.placed import Placed
from clers.oracle.positives.shuffled import built

FILE: Final = "inputs/solids.json"


class Solid(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The boundary of a solid, its faces in the library's order, and how it was made."""

    slug: str
    made: str
    faces: tuple[tuple[int, int, int], ...]
    coordinates: tuple[float, ...]


class Solids(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file: by what library and version, and the solids."""

    by: str
    solids: tuple[Solid, ...]


def solids(inputs: Mapping[str, bytes]) -> Iterator[Placed]:
    """The solids of the file, if there is one. Clause: ORCL-SUITE-5."""
    if FILE not in inputs:
        return
    read = msgspec.json.decode(inputs[FILE], type=Solids)
    for solid in read.solids:
        surface = built(FaceList(solid.faces, len(solid.coordinates) // 3))
        positions = form.Places(precision="f64", coordinates=solid.coordinates)
        yield Placed(solid.slug, surface, positions, "generated", (), f"{solid.made}; by {read.by}")
