"""A mesh made as small as it can be while a codec still does what it did. Clause: ORCL-CODEC-14."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.soup import Face, Place, soup
from clers.oracle.codecs.made import on_curve, placed

MOST: Final = 4000
"""So often a codec is asked for one mesh."""

Shows = Callable[[form.MeshForm], bool]
"""Whether a mesh still shows what is looked for."""


@dataclass(frozen=True, slots=True)
class Loose:
    """Faces, and a place for each vertex."""

    faces: tuple[Face, ...]
    places: tuple[Place, ...]

    def mesh(self) -> form.MeshForm:
        """As a message has it, in binary32."""
        return placed(self.faces, self.places)


def smallest(mesh: form.MeshForm, shows: Shows, most: int = MOST) -> form.MeshForm:
    """The mesh, smaller, still showing it; nothing single can be taken away any more.

    Faces go in halves, quarters, … and one by one; then vertices without faces; then two vertices
    become one; then places become simple. From the start again until nothing goes, or until the
    codec was asked so often. Clause: ORCL-CODEC-14.
    """
    begun = soup(mesh)
    now = Loose(begun.faces, begun.places or on_curve(begun.vertices))
    left = [most]
    while True:
        before = now
        for next_ones in (_fewer_faces, _fewer_vertices, _merged, _simple):
            now = _as_far_as_it_goes(now, next_ones, shows, left)
        if now == before or left[0] <= 0:
            return now.mesh()


def _as_far_as_it_goes(
    of: Loose, next_ones: Callable[[Loose], Iterator[Loose]], shows: Shows, left: list[int]
) -> Loose:
    """Take the first smaller mesh that shows it, again and again."""
    found: Loose | None = of
    while found is not None:
        of, found = found, None
        for candidate in next_ones(of):
            if left[0] <= 0:
                break
            left[0] -= 1
            if shows(candidate.mesh()):
                found = candidate
                break
    return of


def _fewer_faces(of: Loose) -> Iterator[Loose]:
    """Without a block of faces, large blocks first."""
    size = len(of.faces)
    while size:
        for start in range(0, len(of.faces), size):
            yield Loose((*of.faces[:start], *of.faces[start + size :]), of.places)
        size //= 2


def _fewer_vertices(of: Loose) -> Iterator[Loose]:
    """Without all vertices that are in no face; without one of them."""
    used = {v for face in of.faces for v in face}
    lonely = [v for v in range(len(of.places)) if v not in used]
    if len(lonely) > 1:
        yield _without(of, lonely)
    for v in lonely:
        yield _without(of, (v,))


def _without(of: Loose, gone: Sequence[int]) -> Loose:
    kept = [v for v in range(len(of.places)) if v not in set(gone)]
    name = {v: k for k, v in enumerate(kept)}
    faces = tuple((name[a], name[b], name[c]) for a, b, c in of.faces)
    return Loose(faces, tuple(of.places[v] for v in kept))


def _merged(of: Loose) -> Iterator[Loose]:
    """Two vertices made one; of large meshes only neighbours."""
    pairs = (
        ((v, w) for w in range(len(of.places)) for v in range(w))
        if len(of.places) < 40
        else ((min(a, b), max(a, b)) for a, b, _ in of.faces if a != b)
    )
    for v, w in pairs:
        faces = tuple(
            (v if a == w else a, v if b == w else b, v if c == w else c) for a, b, c in of.faces
        )
        yield _without(Loose(faces, of.places), (w,))


def _simple(of: Loose) -> Iterator[Loose]:
    """Places on a curve, equal ones still equal; then vertices in the order of faces."""
    number = {place: k for k, place in enumerate(dict.fromkeys(of.places))}
    curve = on_curve(len(number))
    simple = Loose(of.faces, tuple(curve[number[place]] for place in of.places))
    if simple != of:
        yield simple
    order = list(dict.fromkeys((*(v for face in of.faces for v in face), *range(len(of.places)))))
    name = {v: k for k, v in enumerate(order)}
    faces = tuple((name[a], name[b], name[c]) for a, b, c in of.faces)
    named = Loose(faces, tuple(of.places[v] for v in order))
    if named != of:
        yield named
