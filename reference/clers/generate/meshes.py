"""Strategies for the domains of chapter 7: positions from ordinary to extreme, and meshes.

Coordinates are not drawn one by one: a few numbers are drawn, and each vertex takes one of them or
a mixture, so that drawing is fast and shrinking simplifies all vertices at once.
"""

from collections.abc import Mapping, Sequence
from math import inf, isfinite, ldexp, nextafter
from typing import Final, TypeVar

from hypothesis import strategies as st

from clers.arithmetic.bits import pack
from clers.complexes.surface import Surface
from clers.edgebreaker.encode import encode
from clers.generate.surfaces import surfaces
from clers.geometry.box import LARGEST_EXTENT, Box
from clers.geometry.given import Asked, Coding, CoordinateList, LatticeMesh, OnAxis
from clers.geometry.lattice import HIGHEST_EXPONENT, LARGEST_NUMBER, LOWEST_EXPONENT, Quantised
from clers.geometry.mesh import Mesh
from clers.geometry.order import in_creation_order
from clers.geometry.positions import Positions, Precision, narrowest

N = TypeVar("N", int, float)

FINITE: Final = st.floats(allow_nan=False, allow_infinity=False)
SINGLE: Final = st.floats(allow_nan=False, allow_infinity=False, width=32)
ORDINARY: Final = st.floats(-100.0, 100.0, allow_nan=False)
HALVES: Final = st.integers(-8, 8).map(lambda n: n / 2)

LOWS: Final = st.one_of(
    st.integers(-50, 50), st.integers(-LARGEST_NUMBER, LARGEST_NUMBER - LARGEST_EXTENT)
)
"""Where a box of lattice points may begin, whatever its extent."""

PRECISIONS: Final = st.sampled_from(Precision)


def _spread(numbers: Sequence[N], count: int, stride: int) -> tuple[N, ...]:
    """So many numbers, taken from a few by a fixed rule."""
    return tuple(numbers[(i * stride + i * i // 7) % len(numbers)] for i in range(count))


def coordinates(count: int) -> st.SearchStrategy[tuple[float, ...]]:
    """Finite coordinates: small multiples of a half, ordinary ones, binary32 ones, any."""
    palettes = [st.lists(one, min_size=1, max_size=9) for one in (HALVES, ORDINARY, SINGLE, FINITE)]
    return st.tuples(st.one_of(palettes), st.integers(1, 11)).map(
        lambda drawn: _spread(drawn[0], count, drawn[1])
    )


def positions_for(vertices: int) -> st.SearchStrategy[Positions]:
    """Positions for that many vertices, in the narrowest precision or in f64."""
    return st.tuples(coordinates(3 * vertices), st.booleans()).map(
        lambda drawn: Positions(Precision.F64 if drawn[1] else narrowest(drawn[0]), drawn[0])
    )


def meshes(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[Mesh]:
    """Surfaces with positions."""
    return of.flatmap(
        lambda surface: positions_for(surface.vertices).map(lambda p: Mesh(surface, p))
    )


@st.composite
def coordinate_lists(draw: st.DrawFn) -> CoordinateList:
    """Mostly good; sometimes of a wrong length, not finite, or no binary32 values."""
    vertices = draw(st.integers(0, 6))
    extra = draw(st.sampled_from((0, 0, 0, 1, 3)))
    drawn = draw(coordinates(3 * vertices + extra))
    flat = list(drawn)
    if draw(st.booleans()) and flat:
        flat[draw(st.integers(0, len(flat) - 1))] = draw(st.floats())
    return CoordinateList(draw(PRECISIONS), tuple(flat), vertices)


@st.composite
def on_axis(draw: st.DrawFn) -> OnAxis:
    """Any coordinate and exponent; often near a tie, half way between two lattice points."""
    exponent = draw(st.one_of(st.integers(-10, 10), st.integers(LOWEST_EXPONENT, HIGHEST_EXPONENT)))
    numerator = draw(st.one_of(st.integers(-64, 64), st.integers(-(1 << 54), 1 << 54)))
    try:
        tie = ldexp(float(numerator), exponent - 1)
    except OverflowError:
        tie = 0.0
    near = _neighbours(tie)
    return OnAxis(draw(st.one_of(st.sampled_from(near), FINITE)), exponent)


def _neighbours(x: float) -> list[float]:
    """A number, and the doubles on both sides of it, as far as they are finite."""
    around = [x, nextafter(x, inf), nextafter(x, -inf)]
    return [y for y in around if isfinite(y)] or [0.0]


def lattice_meshes(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[LatticeMesh]:
    """Surfaces in the order of creation; lattice points in small boxes and in the largest."""

    def with_points(surface: Surface) -> st.SearchStrategy[LatticeMesh]:
        ordered = in_creation_order(surface, encode(surface))
        return st.builds(
            lambda low, palette, stride, exponent: LatticeMesh(
                ordered,
                Quantised(
                    exponent,
                    tuple(
                        low[i % 3] + q
                        for i, q in enumerate(_spread(palette, 3 * ordered.vertices, stride))
                    ),
                ),
            ),
            st.tuples(LOWS, LOWS, LOWS),
            st.lists(
                st.one_of(st.integers(0, 20), st.integers(0, LARGEST_EXTENT)),
                min_size=1,
                max_size=12,
            ),
            st.integers(1, 11),
            st.one_of(st.integers(-20, 0), st.sampled_from((LOWEST_EXPONENT, HIGHEST_EXPONENT))),
        )

    return of.flatmap(with_points)


def codings(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[Coding]:
    """Surfaces in the order of creation, a box of small extents, and any bits."""
    extents = st.integers(0, 3)
    return st.builds(
        lambda surface, x, y, z, bits: Coding(
            in_creation_order(surface, encode(surface)), Box((0, 0, 0), (x, y, z)), pack(bits)
        ),
        of,
        extents,
        extents,
        extents,
        st.lists(st.integers(0, 1), max_size=60),
    )


ASKED: Final = st.builds(
    Asked,
    st.integers(0, 5).flatmap(positions_for),
    st.integers(0, 31),
    st.one_of(st.floats(), st.floats(1e-9, 10.0)),
)

SMALL: Final = surfaces(max_faces=24, genus=(0, 1), curves=(0, 2), components=(1, 2))

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "coordinate-lists": coordinate_lists(),
    "positions": st.integers(0, 6).flatmap(positions_for),
    "meshes": meshes(surfaces(max_faces=60)),
    "coordinates": on_axis(),
    "accuracies": ASKED,
    "lattice-meshes": lattice_meshes(SMALL),
    "position-codings": codings(SMALL),
    "residuals": st.one_of(st.integers(-20, 20), st.integers(-LARGEST_EXTENT, LARGEST_EXTENT)),
}
"""The domains of this module, by name."""
