"""What can be different when a mesh comes back, by name. Clause: ORCL-CODEC-6."""

from dataclasses import dataclass
from enum import StrEnum

from clers.conventions.where import WHOLE, Where, in_words


class Kind(StrEnum):
    """The differences, in the order in which they are named. Clause: ORCL-CODEC-6."""

    STRAY_INDEX = "index-out-of-range"
    COORDINATE_COUNT = "coordinate-count"
    POSITIONS_LOST = "positions-lost"
    POSITIONS_ADDED = "positions-added"
    COMPONENTS_LOST = "components-lost"
    FACES_LOST = "faces-lost"
    DEGENERATE_DROPPED = "dropped-degenerate-faces"
    DUPLICATES_DROPPED = "dropped-duplicate-faces"
    FACES_ADDED = "faces-added"
    COMPONENTS_MIRRORED = "components-mirrored"
    ORIENTATION = "orientation-changed"
    MERGED = "vertices-merged"
    SPLIT = "vertices-split"
    ISOLATED_LOST = "lost-isolated-vertices"
    VERTICES_LOST = "vertices-lost"
    VERTICES_ADDED = "vertices-added"
    MOVED = "position-moved"
    REJOINED = "connectivity-changed"


class Of(StrEnum):
    """Which of the two meshes an element is of."""

    SENT = "sent"
    CAME = "given back"


@dataclass(frozen=True, slots=True)
class Difference:
    """A kind of difference, how often it is there, and the first element that shows it.

    `at` is an element of the mesh `of`. A position has moved `by` so much, at most, along `axis`;
    otherwise these are 0 and empty. Clauses: ORCL-CODEC-6, ORCL-CODEC-7.
    """

    kind: Kind
    count: int
    of: Of = Of.SENT
    at: Where = WHOLE
    detail: str = ""
    by: float = 0.0
    axis: str = ""

    def line(self) -> str:
        """The difference in one line."""
        tail = f": {self.detail}" if self.detail else ""
        return f"{self.kind}, {self.count}, first {in_words(self.at)} of the mesh {self.of}{tail}"
