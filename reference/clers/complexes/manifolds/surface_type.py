"""Types of connected surfaces: what a surface is up to homeomorphism."""

from dataclasses import dataclass
from typing import assert_never


@dataclass(frozen=True, slots=True)
class Orientable:
    """A sphere with so many handles and so many open discs removed. Clause: CPLX-CLASSIFY-1."""

    genus: int
    curves: int

    @property
    def euler(self) -> int:
        """χ = 2 − 2g − b. Clause: CPLX-CLASSIFY-2."""
        return 2 - 2 * self.genus - self.curves


@dataclass(frozen=True, slots=True)
class NonOrientable:
    """A sphere with so many cross-caps, one at least, and open discs removed. CPLX-CLASSIFY-1."""

    crosscaps: int
    curves: int

    @property
    def euler(self) -> int:
        """χ = 2 − k − b. Clause: CPLX-CLASSIFY-2."""
        return 2 - self.crosscaps - self.curves


SurfaceType = Orientable | NonOrientable


def in_words(of: SurfaceType) -> str:
    """The name of a type. Clause: CPLX-CLASSIFY-3."""
    match of:
        case Orientable(0, 1):
            return "disc"
        case Orientable(0, 2):
            return "annulus"
        case NonOrientable(1, 1):
            return "Möbius band"
        case Orientable(0, curves):
            return f"sphere{_removed(curves)}"
        case Orientable(1, curves):
            return f"torus{_removed(curves)}"
        case Orientable(genus, curves):
            return f"sphere with {genus} handles{_removed(curves, ' and')}"
        case NonOrientable(1, curves):
            return f"projective plane{_removed(curves)}"
        case NonOrientable(2, curves):
            return f"Klein bottle{_removed(curves)}"
        case NonOrientable(crosscaps, curves):
            return f"sphere with {crosscaps} cross-caps{_removed(curves, ' and')}"
        case _:
            assert_never(of)


def _removed(curves: int, before: str = " with") -> str:
    if curves == 0:
        return ""
    return f"{before} {curves} disc{'s' if curves > 1 else ''} removed"


def summed(first: SurfaceType, second: SurfaceType) -> SurfaceType:
    """The type of a connected sum; a handle beside a cross-cap is two. Clause: CPLX-SUM-2."""
    curves = first.curves + second.curves
    match first, second:
        case Orientable(), Orientable():
            return Orientable(first.genus + second.genus, curves)
        case _:
            return NonOrientable(_crosscaps(first) + _crosscaps(second), curves)


def _crosscaps(of: SurfaceType) -> int:
    """What a summand adds to a surface that has a cross-cap already, or is one."""
    match of:
        case Orientable(genus, _):
            return 2 * genus
        case NonOrientable(crosscaps, _):
            return crosscaps
        case _:
            assert_never(of)
