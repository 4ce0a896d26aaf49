"""Random surfaces, face lists and relabellings, as Hypothesis strategies.

Every surface comes from a script of operators, so it is valid by construction, and it shrinks: with
nothing asked of it, to a tetrahedron.
"""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import surface
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.generate.bounds import Bounds, Grown, Range
from clers.generate.scripts import grown
from clers.operators.script import Script


def scripts(
    max_faces: int = 120,
    genus: Range = (0, 5),
    curves: Range = (0, 6),
    components: Range = (1, 4),
) -> st.SearchStrategy[Script]:
    """Scripts whose surface is within ranges; genus and curves summed over the components.

    The topology comes first: where `max_faces` is too few for what a range demands, the surface
    has as many faces as the demand takes.
    """
    return grown(Bounds(max_faces, components, genus, curves)).map(lambda result: result.script)


def surfaces(
    max_faces: int = 120,
    genus: Range = (0, 5),
    curves: Range = (0, 6),
    components: Range = (1, 4),
) -> st.SearchStrategy[Surface]:
    """Surfaces within ranges (lowest, highest); see `scripts`."""
    return grown(Bounds(max_faces, components, genus, curves)).map(_accepted)


def closed_surfaces(
    max_faces: int = 120, genus: Range = (0, 5), components: Range = (1, 4)
) -> st.SearchStrategy[Surface]:
    """Surfaces without boundary."""
    return surfaces(max_faces, genus, (0, 0), components)


def spheres(max_faces: int = 120) -> st.SearchStrategy[Surface]:
    """Closed connected surfaces of genus 0."""
    return surfaces(max_faces, (0, 0), (0, 0), (1, 1))


def small_surfaces(max_faces: int = 40) -> st.SearchStrategy[Surface]:
    """Surfaces small enough for definitions that try everything."""
    return surfaces(max_faces, (0, 1), (0, 3), (1, 2))


def _accepted(result: Grown) -> Surface:
    built = surface(result.mesh)
    if isinstance(built, Accepted):
        return built.value
    raise AssertionError(f"{result.script} is no surface: {built.line()}")


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "surfaces": surfaces(),
    "closed-surfaces": closed_surfaces(),
    "connected-surfaces": surfaces(components=(1, 1)),
    "spheres": spheres(),
    "small-surfaces": small_surfaces(),
}
"""The domains of this module, by name."""
