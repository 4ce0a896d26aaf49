"""The reasons for which no operation of the protocol rejects anything. Clause: ORCL-FAULT-5."""

from collections.abc import Mapping
from typing import Final

from clers.conventions.reason import Reason

_COMPLEXES: Final = "only complexes that are given by their simplices, which no operation takes"
_CELLS: Final = "only cell complexes and half-edges, which no operation takes"
_COMMANDS: Final = "only commands and the files that people have"

NOT_GIVEN: Final[Mapping[Reason, str]] = {
    Reason.NON_ORIENTABLE: "only repairs, for which there is no operation: to an operation such "
    "faces are an edge run twice in one direction",
    Reason.EMPTY_SIMPLEX: _COMPLEXES,
    Reason.SHARED_VERTEX: _COMPLEXES,
    Reason.NOT_PURE: _COMPLEXES,
    Reason.MISSING_FACE: _COMPLEXES,
    Reason.DEGENERATE_SIMPLEX: _COMPLEXES,
    Reason.SIMPLICES_OVERLAP: _COMPLEXES,
    Reason.UNSUPPORTED_DIMENSION: _COMPLEXES,
    Reason.NOT_A_MANIFOLD: _COMPLEXES,
    Reason.BAD_FRONTIER: _CELLS,
    Reason.INCOHERENT_CELLS: _CELLS,
    Reason.HAS_BOUNDARY: _CELLS,
    Reason.BROKEN_INVARIANT: _CELLS,
    Reason.TOO_MANY_BYTES: "a file of more than 2^31 bytes is longer than the protocol carries",
    Reason.UNREADABLE_FILE: _COMMANDS,
    Reason.UNKNOWN_FORMAT: _COMMANDS,
    Reason.NOT_TRIANGLES: _COMMANDS,
    Reason.UNWRITABLE_FILE: _COMMANDS,
    Reason.NOT_OBTAINABLE: _COMMANDS,
    Reason.NOT_DRAWABLE: _COMMANDS,
    Reason.NO_SUCH_STEP: _COMMANDS,
    Reason.CAME_BACK_CHANGED: "what a codec is told when it has failed, and not what it says",
}
"""Why the suite has no case for each of these. Clause: ORCL-FAULT-5."""
