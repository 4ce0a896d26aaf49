"""Quantised positions to their box and bits, and back: prediction and residual coder together."""

from dataclasses import dataclass

from clers.arithmetic.bits import Bits
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry import residual
from clers.geometry.box import LARGEST_EXTENT, Box, Boxed, boxed, unboxed
from clers.geometry.lattice import (
    HIGHEST_EXPONENT,
    LARGEST_NUMBER,
    LOWEST_EXPONENT,
    Quantised,
)
from clers.geometry.predict import indices_from, residuals


@dataclass(frozen=True, slots=True)
class Coded:
    """What is stored of quantised positions. Clause: GEOM-CODE-4."""

    exponent: int
    box: Box
    bits: Bits


def encode(surface: Surface, given: Quantised) -> Accepted[Coded] | Rejected:
    """Positions in the order of creation, as box and coded residuals. Clause: GEOM-CODE-4."""
    if len(given.numbers) != 3 * surface.vertices:
        detail = f"{len(given.numbers)} numbers for {surface.vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.GEOM_MESH_1, detail=detail)
    return and_then(boxed(given), lambda found: _encode_boxed(surface, found))


def _encode_boxed(surface: Surface, given: Boxed) -> Accepted[Coded] | Rejected:
    bits = residual.encode(surface, given.box, residuals(surface, given.box, given.indices))
    return and_then(bits, lambda b: Accepted(Coded(given.exponent, given.box, b)))


def decode(surface: Surface, given: Coded) -> Accepted[Quantised] | Rejected:
    """The lattice numbers that were encoded.

    Clauses: GEOM-LATTICE-1, GEOM-BOX-2, GEOM-CODE-5, GEOM-RESIDUAL-2.
    """
    fault = bad_lattice(given)
    if fault is not None:
        return fault
    found = residual.decode(surface, given.box, given.bits)
    indices = and_then(found, lambda rs: indices_from(surface, given.box, rs))
    return and_then(indices, lambda qs: Accepted(unboxed(Boxed(given.exponent, given.box, qs))))


def bad_lattice(given: Coded) -> Rejected | None:
    """Whether an exponent or a box from outside is on no lattice.

    Clauses: GEOM-LATTICE-1, GEOM-BOX-2.
    """
    if not LOWEST_EXPONENT <= given.exponent <= HIGHEST_EXPONENT:
        detail = f"exponent {given.exponent}"
        return Rejected(Reason.BAD_LATTICE, Clause.GEOM_LATTICE_1, detail=detail)
    for axis, low, extent in zip("xyz", given.box.low, given.box.extent, strict=True):
        if not 0 <= extent <= LARGEST_EXTENT:
            detail = f"extent {extent} on {axis}"
            return Rejected(Reason.BAD_LATTICE, Clause.GEOM_BOX_2, detail=detail)
        if low < -LARGEST_NUMBER or low + extent > LARGEST_NUMBER:
            detail = f"numbers {low} to {low + extent} on {axis}"
            return Rejected(Reason.BAD_LATTICE, Clause.GEOM_LATTICE_1, detail=detail)
    return None
