"""Faces over common vertices: lost, added, turned over, and by what name each is called."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from clers.conformance.judging.comparing.difference import Difference, Kind, Of
from clers.conformance.judging.comparing.soup import Soup, begun_at_least
from clers.conventions.where import AtFace

Sides = dict[tuple[int, ...], tuple[list[int], list[int]]]
"""For each orientation of three sites: the faces sent, and those given back."""


@dataclass(slots=True)
class Sorted:
    """Faces by what became of them: those sent, and of those given back the ones added."""

    lost: list[int] = field(default_factory=list)
    degenerate: list[int] = field(default_factory=list)
    duplicate: list[int] = field(default_factory=list)
    turned: list[int] = field(default_factory=list)
    added: list[int] = field(default_factory=list)


def of_faces(
    sent: Soup, came: Soup, sites: Sequence[int], others: Sequence[int]
) -> Iterator[Difference]:
    """The differences of faces, when a site of each vertex is known for both meshes.

    Clauses: ORCL-CODEC-6, ORCL-CODEC-7.
    """
    found = _sorted(sent, came, sites, others)
    component = _components(sent)
    proper = [t for t, face in enumerate(sent.faces) if len({sites[v] for v in face}) == 3]
    whole = _wholes(component, found.lost, proper)
    faces = [t for t in found.lost if component[t] not in whole]
    yield from _some(Kind.COMPONENTS_LOST, whole, sent, sorted(whole.values()))
    yield from _some(Kind.FACES_LOST, faces, sent, faces)
    yield from _some(Kind.DEGENERATE_DROPPED, found.degenerate, sent, found.degenerate)
    yield from _some(Kind.DUPLICATES_DROPPED, found.duplicate, sent, found.duplicate)
    yield from _some(Kind.FACES_ADDED, found.added, came, found.added, Of.CAME)
    mirrored = _wholes(component, found.turned, proper)
    turned = [t for t in found.turned if component[t] not in mirrored]
    yield from _some(Kind.COMPONENTS_MIRRORED, mirrored, sent, sorted(mirrored.values()))
    yield from _some(Kind.ORIENTATION, turned, sent, turned)


def _some(
    kind: Kind, counted: Mapping[int, int] | Sequence[int], of: Soup, shown: Sequence[int],
    whose: Of = Of.SENT,
) -> Iterator[Difference]:  # fmt: skip
    if counted:
        first = min(shown)
        detail = f"face {of.faces[first]}"
        yield Difference(kind, len(counted), whose, AtFace(first), detail)


def _sorted(sent: Soup, came: Soup, sites: Sequence[int], others: Sequence[int]) -> Sorted:
    """Within three sites, faces are matched in their orientation, then turned over."""
    keyed: dict[tuple[int, ...], Sides] = {}
    for side, (mesh, names) in enumerate(((sent, sites), (came, others))):
        for t, (a, b, c) in enumerate(mesh.faces):
            named = begun_at_least((names[a], names[b], names[c]))
            key = tuple(sorted(named))
            keyed.setdefault(key, {}).setdefault(named, ([], []))[side].append(t)
    found = Sorted()
    for key, sides in keyed.items():
        lost = {way: these[len(those) :] for way, (these, those) in sides.items()}
        added = {way: those[len(these) :] for way, (these, those) in sides.items()}
        for way, these in lost.items():
            back = added.get(begun_at_least(way[::-1]), [])
            pairs = min(len(these), len(back))
            found.turned += these[:pairs]
            del these[:pairs], back[:pairs]
        rest = [t for these in lost.values() for t in these]
        kept = any(those for _, those in sides.values())
        if kept:
            found.duplicate += rest
        elif len(set(key)) < 3:
            found.degenerate += rest
        else:
            found.lost += rest
        found.added += [t for those in added.values() for t in those]
    return found


def _wholes(component: Sequence[int], some: Sequence[int], of: Sequence[int]) -> dict[int, int]:
    """The components all of whose faces among `of` are among some, with their first face."""
    size: dict[int, int] = {}
    for t in of:
        size[component[t]] = size.get(component[t], 0) + 1
    inside: dict[int, list[int]] = {}
    for t in some:
        inside.setdefault(component[t], []).append(t)
    return {c: min(faces) for c, faces in inside.items() if len(faces) == size[c]}


def _components(of: Soup) -> list[int]:
    """The component of each face: what common vertices link."""
    root = list(range(of.vertices))

    def top(v: int) -> int:
        while root[v] != v:
            root[v] = root[root[v]]
            v = root[v]
        return v

    for a, b, c in of.faces:
        root[top(b)] = top(a)
        root[top(c)] = top(a)
    return [top(a) for a, _, _ in of.faces]
