"""Pairs of meshes: the same under other names, tiny ones of any kind, and planted differences."""

from collections.abc import Callable, Mapping, Sequence
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.complexes.corner_table import face_list
from clers.complexes.face_list import FaceList
from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Kind
from clers.conformance.judging.comparing.soup import Face, Place
from clers.conformance.judging.laws_meshes import MeshPair, Planted
from clers.generate.face_lists import face_lists
from clers.generate.surfaces import small_surfaces

EXACT: Final = (0.0, 0.0, 0.0)
LOOSE: Final = (0.25, 0.0, 0.25)
SEEDS: Final = st.integers(0, 1 << 16)

Loose = tuple[tuple[Face, ...], tuple[Place, ...]]
"""Faces, and a place for each vertex."""


def mesh(faces: Sequence[Face], places: Sequence[Place] | None, vertices: int) -> form.MeshForm:
    """The mesh as a message has it, with places or without."""
    if places is None:
        return form.MeshForm(faces=tuple(faces), vertices=vertices)
    at = form.Places(precision="f32", coordinates=tuple(x for place in places for x in place))
    return form.MeshForm(faces=tuple(faces), vertices=vertices, positions=at)


def renamed(
    faces: Sequence[Face], places: Sequence[Place] | None, vertices: int, seed: int
) -> form.MeshForm:
    """The mesh with vertices and faces in another order, and faces turned; 0 leaves it as it is."""
    if not seed:
        return mesh(faces, places, vertices)
    dice = Random(seed)
    order = list(range(vertices))
    dice.shuffle(order)
    named = [(order[a], order[b], order[c]) for a, b, c in faces]
    turned = [dice.choice(((a, b, c), (b, c, a), (c, a, b))) for a, b, c in named]
    dice.shuffle(turned)
    if places is None:
        return mesh(turned, None, vertices)
    moved = [place for _, place in sorted(zip(order, places, strict=True))]
    return mesh(turned, moved, vertices)


def _apart(vertices: int, crowd: int) -> tuple[Place, ...]:
    """Places a unit apart; with a crowd, so many vertices at each."""
    return tuple((float(v // crowd), float(v * v % 7), -0.5 * (v % 3)) for v in range(vertices))


def _renamed(of: FaceList, crowd: int, loose: bool, seed: int) -> MeshPair:
    faces = [face for face in of.faces if all(0 <= v < of.vertices for v in face)]
    if not crowd:
        return MeshPair(
            mesh(faces, None, of.vertices), renamed(faces, None, of.vertices, seed), EXACT
        )
    at = _apart(of.vertices, crowd)
    off = 0.25 if loose else 0.0
    back = [(x - off, -0.0 if y == 0 else y, z + off) for x, y, z in at]
    error = LOOSE if loose else EXACT
    return MeshPair(mesh(faces, at, of.vertices), renamed(faces, back, of.vertices, seed), error)


_FACE: Final = st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(0, 4))
_PLACE: Final = st.tuples(
    st.sampled_from((0.0, 0.5, 1.0, 1.5, -0.0)), st.just(0.0), st.sampled_from((0.0, 0.5))
)


@st.composite
def _tiny(draw: st.DrawFn) -> MeshPair:
    """Any triples of five vertices at few places; the other mesh is them with a change or none."""
    vertices = draw(st.integers(1, 5))
    faces = [
        (a % vertices, b % vertices, c % vertices) for a, b, c in draw(st.lists(_FACE, max_size=5))
    ]
    some = draw(st.lists(_PLACE, min_size=vertices, max_size=vertices))
    places = some if draw(st.booleans()) else None
    others, there = list(faces), None if places is None else list(places)
    for at in draw(st.lists(st.integers(0, 20), max_size=2)):
        connected = draw(st.booleans())
        if connected and others:
            a, b, c = others[at % len(others)]
            others[at % len(others)] = draw(
                st.sampled_from(((a, c, b), (a, a, b), others[0], (a, b, (c + 1) % vertices)))
            )
        elif there is not None:
            there[at % vertices] = draw(_PLACE)
    if places is not None and draw(st.integers(0, 9)) == 0:
        there = None
    error = draw(st.sampled_from((EXACT, (0.5, 0.0, 0.0), (0.5, 0.5, 0.5))))
    came = renamed(others, there, vertices, draw(SEEDS))
    return MeshPair(mesh(faces, places, vertices), came, error)


def _beside(of: Loose, faces: Sequence[Face], places: Sequence[Place]) -> Loose:
    """More faces, of vertices of their own, far from the others."""
    n = len(of[1])
    more = tuple((a + n, b + n, c + n) for a, b, c in faces)
    far = tuple((x - 90.0, y, z) for x, y, z in places)
    return (*of[0], *more), (*of[1], *far)


_CORNER: Final = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_SOLID: Final = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
_OVER: Final = tuple((a, c, b) for a, b, c in _SOLID)
_FAN: Final = ((0, 1, 2), (0, 3, 4), (5, 1, 4), (5, 2, 3))
"""Two vertices, 0 and 5, with two faces each; they will be at one place."""
_FANNED: Final = ((0, 1, 2), (5, 3, 4), (5, 1, 4), (0, 2, 3))
_AROUND: Final = (*_CORNER, (5.0, 0.0, 0.0), _CORNER[0])

Known = tuple[tuple[Kind, int], ...]
Plant = Callable[[Loose, int], tuple[Loose, Loose, Known]]


def _without(of: Loose, t: int) -> tuple[Loose, bool]:
    """The mesh without a face, and whether that was all of its component."""
    gone = of[0][t]
    alone = not any(set(gone) & set(face) for i, face in enumerate(of[0]) if i != t)
    return ((*of[0][:t], *of[0][t + 1 :]), of[1]), alone


def _face_lost(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    less, alone = _without(of, i % len(of[0]))
    return of, less, ((Kind.COMPONENTS_LOST if alone else Kind.FACES_LOST, 1),)


def _face_added(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    return _without(of, i % len(of[0]))[0], of, ((Kind.FACES_ADDED, 1),)


def _turned(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    t = i % len(of[0])
    a, b, c = of[0][t]
    less, alone = _without(of, t)
    kind = Kind.COMPONENTS_MIRRORED if alone else Kind.ORIENTATION
    return of, ((*less[0], (c, b, a)), of[1]), ((kind, 1),)


def _more(of: Loose, *faces: Face) -> Loose:
    return (*of[0], *faces), of[1]


def _at_one_place(of: Loose, i: int) -> tuple[Loose, Loose]:
    """A tetrahedron that touches a vertex, by a vertex of its own or by that vertex."""
    n, v = len(of[1]), i % len(of[1])
    apart, places = _beside(of, _SOLID, _CORNER)
    touching = (*places[:n], of[1][v], *places[n + 1 :])
    names = [*range(n), v, *range(n, n + 3)]
    merged = tuple((names[a], names[b], names[c]) for a, b, c in apart)
    return (apart, touching), (merged, (*of[1], *touching[n + 1 :]))


def _merged(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    return *_at_one_place(of, i), ((Kind.MERGED, 1),)


def _split(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    apart, one = _at_one_place(of, i)
    return one, apart, ((Kind.SPLIT, 1),)


def _moved(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    v = i % len(of[1])
    x, y, z = of[1][v]
    places = (*of[1][:v], (x, y - 40.5, z), *of[1][v + 1 :])
    return of, (of[0], places), ((Kind.MOVED, 1),)


def _moved_and_lost(of: Loose, i: int) -> tuple[Loose, Loose, Known]:
    """A tetrahedron beside: a corner moved, the face against it lost."""
    more = _beside(of, _SOLID, _CORNER)
    sent, came, known = _moved(more, len(of[1]) + i % 4)
    against = {len(of[1]) + k for k in range(4) if k != i % 4}
    kept = tuple(face for face in came[0] if set(face) != against)
    return sent, (kept, came[1]), ((Kind.FACES_LOST, 1), *known)


def _all_moved(of: Loose, _: int) -> tuple[Loose, Loose, Known]:
    places = tuple((x + 300.5, y, z) for x, y, z in of[1])
    return of, (of[0], places), ((Kind.MOVED, len(of[1])),)


PLANTS: Final[Mapping[str, Plant]] = {
    "isolated": lambda of, i: (
        (of[0], (*of[1], *_CORNER[: i % 3 + 1])), of, ((Kind.ISOLATED_LOST, i % 3 + 1),)
    ),
    "isolated-there": lambda of, _: (of, (of[0], (*of[1], (7.5, 7.5, 7.5))),
                                     ((Kind.VERTICES_ADDED, 1),)),
    "degenerate": lambda of, i: (
        _more(of, (i % len(of[1]), i % len(of[1]), 0)), of, ((Kind.DEGENERATE_DROPPED, 1),)
    ),
    "duplicate": lambda of, i: (
        _more(of, of[0][i % len(of[0])]), of, ((Kind.DUPLICATES_DROPPED, 1),)
    ),
    "two-kinds": lambda of, i: (
        _more(of, of[0][i % len(of[0])], (0, 0, 1)), of,
        ((Kind.DEGENERATE_DROPPED, 1), (Kind.DUPLICATES_DROPPED, 1)),
    ),
    "face-lost": _face_lost,
    "face-added": _face_added,
    "face-turned": _turned,
    "component": lambda of, _: (
        _beside(of, _SOLID, _CORNER), of, ((Kind.COMPONENTS_LOST, 1), (Kind.VERTICES_LOST, 4))
    ),
    "component-there": lambda of, _: (
        of, _beside(of, _SOLID, _CORNER), ((Kind.FACES_ADDED, 4), (Kind.VERTICES_ADDED, 4))
    ),
    "mirrored": lambda of, _: (
        _beside(of, _SOLID, _CORNER), _beside(of, _OVER, _CORNER), ((Kind.COMPONENTS_MIRRORED, 1),)
    ),
    "merged": _merged,
    "split": _split,
    "moved": _moved,
    "moved-and-lost": _moved_and_lost,
    "all-moved": _all_moved,
    "exchanged": lambda of, _: (
        _beside(of, _FAN, _AROUND), _beside(of, _FANNED, _AROUND),
        ((Kind.REJOINED, len(of[0]) + 4),),
    ),
}  # fmt: skip
"""What can happen to a mesh on its way, by name, and what is to be said of it."""


def _planted(of: FaceList, name: str, i: int, seed: int) -> Planted:
    sent, came, known = PLANTS[name]((of.faces, _apart(of.vertices, 1)), i)
    pair = MeshPair(mesh(*sent, len(sent[1])), renamed(*came, len(came[1]), seed), EXACT)
    return Planted(pair, known)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "mesh-pairs-renamed": st.builds(
        _renamed, face_lists(), st.integers(0, 3), st.booleans(), SEEDS
    ),
    "mesh-pairs-tiny": _tiny(),
    "mesh-pairs-planted": st.builds(
        _planted,
        small_surfaces().map(face_list),
        st.sampled_from(sorted(PLANTS)),
        st.integers(0, 100),
        SEEDS,
    ),
}
"""The domains of this module, by name."""
