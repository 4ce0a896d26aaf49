"""Draco's Edgebreaker, standard and valence, by the package DracoPy."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.measure.peers.draco_file import Connectivity, connectivity
from clers.measure.peers.index_list import index_list
from clers.measure.peers.peer import Peer, not_installed

PACKAGE: Final = "DracoPy"
ROW: Final = 4096


@dataclass(frozen=True, slots=True)
class Arrays:
    """What DracoPy is given: a place for each vertex, and three vertices for each face."""

    places: npt.NDArray[np.float32]
    faces: npt.NDArray[np.uint32]


def arrays(surface: Surface) -> Arrays:
    """Each vertex at a place of its own. Clause: TOOL-BITS-2."""
    numbers = np.arange(surface.vertices)
    places = np.stack((numbers % ROW, numbers // ROW, 0 * numbers), axis=1).astype(np.float32)
    return Arrays(places, index_list(surface).reshape(-1, 3))


def encoded(surface: Surface, level: int) -> Accepted[bytes] | Rejected:
    """The Draco file of a surface, each vertex at a place of its own. Clause: TOOL-BITS-2."""
    return encoded_arrays(arrays(surface), level)


def encoded_arrays(given: Arrays, level: int) -> Accepted[bytes] | Rejected:
    """The Draco file of arrays that are there already. Clauses: TOOL-BITS-2, TOOL-SPEED-4."""
    try:
        import DracoPy
    except ImportError:
        return not_installed(PACKAGE)
    places, faces = given.places, given.faces
    data = DracoPy.encode(places, faces, quantization_bits=1, compression_level=level)
    return Accepted(bytes(data))


def bytes_at(level: int) -> Callable[[Surface], Accepted[int] | Rejected]:
    """The bytes of Draco's connectivity at a compression level. Clause: TOOL-BITS-2."""

    def ask(surface: Surface) -> Accepted[int] | Rejected:
        def compare(found: Connectivity) -> Accepted[int] | Rejected:
            if (found.vertices, found.faces) == (surface.vertices, surface.faces):
                return Accepted(found.bytes)
            detail = f"Draco has {found.vertices} vertices and {found.faces} faces"
            return Rejected(Reason.COUNT_MISMATCH, Clause.TOOL_BITS_2, detail=detail)

        return and_then(and_then(encoded(surface, level), connectivity), compare)

    return ask


DRACO: Final = (
    Peer("draco-standard", PACKAGE, bytes_at(5)),
    Peer("draco-valence", PACKAGE, bytes_at(7)),
)
"""Clause: TOOL-BITS-2."""
