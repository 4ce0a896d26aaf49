"""Pairs of surfaces to compare, and face lists to repair, as Hypothesis strategies."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import surface
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList
from clers.complexes.given import Pair
from clers.complexes.matching import mates
from clers.complexes.relabel import mirror
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.generate.relabelled import pair, relabelled
from clers.generate.scripts import CHOICES
from clers.generate.surfaces import face_list_of, small_surfaces
from clers.operators.subdivide import flip_edge, relabel

SEEDS: Final = st.integers(0, 1 << 16)


def surface_pairs(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[Pair]:
    """A surface and, under other names: itself, its mirror image, or itself with edges flipped.

    Or one drawn apart from it. Which of these are isomorphic is for the laws to find out.
    """
    return st.one_of(
        relabelled(of),
        relabelled(of).map(lambda both: (both[0], mirror(both[1]))),
        st.builds(_flipped, of, st.lists(CHOICES, min_size=1, max_size=3), SEEDS),
        st.tuples(of, of),
    )


def _flipped(of: Surface, edges: list[int], seed: int) -> Pair:
    mesh = face_list_of(of)
    for edge in edges:
        mesh = flip_edge(mesh, edge).mesh
    return of, pair(_accepted(mesh), seed)[1]


def _accepted(mesh: FaceList) -> Surface:
    built = surface(mesh)
    if isinstance(built, Accepted):
        return built.value
    raise AssertionError(f"a flip made no surface: {built.line()}")


@st.composite
def repairable(draw: st.DrawFn) -> FaceList:
    """A small surface with faces turned over, vertices pinched together, and isolated vertices.

    Vertices are identified only where no edge and no face falls upon another.
    """
    mesh = face_list_of(draw(small_surfaces()))
    for i, j in draw(st.lists(st.tuples(CHOICES, CHOICES), max_size=4)):
        pinched = _identified(mesh, i % mesh.vertices, j % mesh.vertices)
        if isinstance(mates(pinched, DEFAULT_LIMITS), Accepted):
            mesh = pinched
    turns = draw(st.lists(st.booleans(), min_size=len(mesh.faces), max_size=len(mesh.faces)))
    faces = tuple(
        (a, c, b) if turn else (a, b, c) for (a, b, c), turn in zip(mesh.faces, turns, strict=True)
    )
    isolated = draw(st.integers(0, 3))
    return relabel(FaceList(faces, mesh.vertices + isolated), draw(SEEDS)).mesh


def _identified(mesh: FaceList, keep: int, gone: int) -> FaceList:
    """Two vertices become one; the one that goes stays behind, isolated."""
    name = [keep if v == gone else v for v in range(mesh.vertices)]
    faces = tuple((name[a], name[b], name[c]) for a, b, c in mesh.faces)
    return FaceList(faces, mesh.vertices)


def tiny_surfaces() -> st.SearchStrategy[Surface]:
    """Surfaces of six vertices at most: few enough to try all permutations."""
    return small_surfaces(8).filter(lambda drawn: drawn.vertices <= 6)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "surface-pairs": surface_pairs(small_surfaces()),
    "tiny-surface-pairs": surface_pairs(tiny_surfaces()),
    "repairable-face-lists": repairable(),
}
"""The domains of this module, by name."""
