"""Pairs of surfaces to compare, and face lists to repair, as Hypothesis strategies."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import face_list, surface
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList
from clers.complexes.given import Pair
from clers.complexes.matching import mates
from clers.complexes.relabel import mirror
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.generate.relabelled import pair, relabelled
from clers.generate.scripts import CHOICES
from clers.generate.surfaces import small_surfaces
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


def unions(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[Surface]:
    """Two or three surfaces side by side, as the components of one."""
    return st.lists(of, min_size=2, max_size=3).map(_beside)


def _beside(parts: list[Surface]) -> Surface:
    faces: list[tuple[int, int, int]] = []
    n = 0
    for part in parts:
        faces += [(a + n, b + n, c + n) for a, b, c in part.triangles()]
        n += part.vertices
    return _accepted(FaceList(tuple(faces), n))


def _flipped(of: Surface, edges: list[int], seed: int) -> Pair:
    mesh = face_list(of)
    for edge in edges:
        mesh = flip_edge(mesh, edge).mesh
    return of, pair(_accepted(mesh), seed)[1]


def _accepted(mesh: FaceList) -> Surface:
    built = surface(mesh)
    if isinstance(built, Accepted):
        return built.value
    raise AssertionError(f"no surface was made: {built.line()}")


@st.composite
def repairable(draw: st.DrawFn) -> FaceList:
    """A small surface with faces turned over, vertices pinched together, and isolated vertices.

    Vertices are identified only where no edge and no face falls upon another.
    """
    mesh = face_list(draw(small_surfaces()))
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


PROJECTIVE_PLANE: Final = (
    *((0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 2, 4)),
    *((2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)),
)
"""The projective plane on six vertices, without its tenth face 0, 1, 2."""


@st.composite
def crosscapped(draw: st.DrawFn) -> FaceList:
    """A repairable face list in which some faces were replaced by cross-caps."""
    mesh = draw(repairable())
    for choice in draw(st.lists(CHOICES, max_size=2)):
        mesh = _with_crosscap(mesh, choice % len(mesh.faces))
    return relabel(mesh, draw(SEEDS)).mesh


def _with_crosscap(mesh: FaceList, t: int) -> FaceList:
    n = mesh.vertices
    name = (*mesh.faces[t], n, n + 1, n + 2)
    cap = tuple((name[a], name[b], name[c]) for a, b, c in PROJECTIVE_PLANE)
    return FaceList((*mesh.faces[:t], *mesh.faces[t + 1 :], *cap), n + 3)


def tiny_surfaces() -> st.SearchStrategy[Surface]:
    """Surfaces of six vertices at most: few enough to try all permutations."""
    return small_surfaces(8).filter(lambda drawn: drawn.vertices <= 6)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "surface-pairs": surface_pairs(st.one_of(small_surfaces(), unions(tiny_surfaces()))),
    "tiny-surface-pairs": surface_pairs(tiny_surfaces()),
    "repairable-face-lists": repairable(),
    "crosscapped-face-lists": crosscapped(),
}
"""The domains of this module, by name."""
