"""The same surface under other names: vertices and faces permuted, faces turned."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import face_list, surface
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.generate.surfaces import surfaces
from clers.operators.subdivide import relabel


def relabelled(
    source: st.SearchStrategy[Surface] | None = None,
) -> st.SearchStrategy[tuple[Surface, Surface]]:
    """Pairs of a surface and the same surface relabelled; seed 0 leaves it as it is."""
    seeds = st.integers(0, 1 << 16)
    return st.builds(pair, surfaces() if source is None else source, seeds)


def pair(of: Surface, seed: int) -> tuple[Surface, Surface]:
    """A surface and its relabelling by a seed (OPER-REFINE-4)."""
    built = surface(relabel(face_list(of), seed).mesh)
    if isinstance(built, Accepted):
        return of, built.value
    raise AssertionError(f"a relabelled surface is none: {built.line()}")


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "relabelled-surfaces": relabelled(),
}
"""The domains of this module, by name."""
