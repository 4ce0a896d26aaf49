"""Residuals as one arithmetic-coded message: for each a learnt class, then its bits in it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry.box import Box
from clers.geometry.predict import NONE, parallelogram_corners
from clers.information.adaptive import Adaptive
from clers.information.combined import Refined, joined, pieces, raw
from clers.information.model import Model
from clers.information.static import END

INCREMENT: Final = 8
LIMIT: Final = 1 << 13

LONGEST: Final = 3
"""Symbols of a residual at most: its class, and 30 bits in pieces of 16. Clause: GEOM-CODE-3."""


def fold(residual: int) -> int:
    """0, −1, 1, −2, 2, … as 0, 1, 2, 3, 4, … Clause: GEOM-CODE-1."""
    return 2 * residual if residual >= 0 else -2 * residual - 1


def unfold(folded: int) -> int:
    """The residual that was folded. Clause: GEOM-CODE-1."""
    return -(folded + 1) // 2 if folded % 2 else folded // 2


@dataclass(frozen=True, slots=True)
class Scheduled:
    """Symbol j belongs to the model that the schedule names; ends with it. Clause: GEOM-CODE-2."""

    models: tuple[Model, ...]
    schedule: bytes
    index: int = 0

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the model whose symbol it is."""
        if self.index == len(self.schedule):
            return END.cumulative
        return self.models[self.schedule[self.index]].cumulative

    def after(self, symbol: int) -> "Scheduled":
        """That model learns the symbol."""
        m = self.schedule[self.index]
        learnt = self.models[m].after(symbol)
        models = (*self.models[:m], learnt, *self.models[m + 1 :])
        return Scheduled(models, self.schedule, self.index + 1)


def classes(extent: int) -> int:
    """How many classes the residuals of an axis have. Clause: GEOM-CODE-3."""
    return (2 * extent).bit_length() + 1


def model(surface: Surface, box: Box) -> Model:
    """What coder and decoder expect of all residuals. Clauses: GEOM-CODE-2, GEOM-CODE-3."""
    sizes = [classes(extent) for extent in box.extent]
    learnt = [Adaptive(tuple(range(k + 1)), INCREMENT, LIMIT) for k in (*sizes, *sizes)]
    schedule = b"".join(
        b"\3\4\5" if corner == NONE else b"\0\1\2" for corner in parallelogram_corners(surface)
    )
    within = tuple(raw(max(0, k - 1)) for k in range(max(sizes)))
    return Refined(Scheduled(tuple(learnt), schedule), within)


def symbols(residuals: Sequence[int]) -> Iterator[int]:
    """For each residual its class, then its bits. Clauses: GEOM-CODE-1, GEOM-CODE-3."""
    for residual in residuals:
        folded = fold(residual)
        k = folded.bit_length()
        yield k
        if k > 1:
            yield from pieces(folded - (1 << (k - 1)), k - 1)


def residuals_in(message: Sequence[int]) -> tuple[int, ...]:
    """The residuals of a message that the model allows. Clauses: GEOM-CODE-1, GEOM-CODE-3."""
    found: list[int] = []
    at = 0
    while at < len(message):
        k = message[at]
        upto = at + 1 + len(pieces(0, max(0, k - 1)))
        folded = (1 << (k - 1)) + joined(message[at + 1 : upto]) if k else 0
        found.append(unfold(folded))
        at = upto
    return tuple(found)


def encode(surface: Surface, box: Box, residuals: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The residuals as bits. Clauses: GEOM-CODE-1 … GEOM-CODE-4."""
    if len(residuals) != 3 * surface.vertices:
        detail = f"{len(residuals)} residuals for {surface.vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.GEOM_CODE_4, detail=detail)
    return coder.encode(model(surface, box), tuple(symbols(residuals)))


def decode(surface: Surface, box: Box, bits: Bits) -> Accepted[tuple[int, ...]] | Rejected:
    """The residuals that these bits, and no others, encode. Clause: GEOM-CODE-5."""
    longest = LONGEST * 3 * surface.vertices
    message = coder.decode(model(surface, box), bits, longest)
    return and_then(message, lambda found: Accepted(residuals_in(found)))
