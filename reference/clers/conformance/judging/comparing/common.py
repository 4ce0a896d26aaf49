"""Common names for the vertices of two meshes, as far as they can be had: sites."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from clers.conformance.judging.comparing.embedding import Budget, Coloured
from clers.conformance.judging.comparing.matching import matched
from clers.conformance.judging.comparing.nets import Net, coloured, mirrored, net
from clers.conformance.judging.comparing.sites import Bound, sites
from clers.conformance.judging.comparing.soup import Face, Soup, begun_at_least

ROUNDS: Final = 8
"""So far from known vertices are others named by their faces."""


@dataclass(frozen=True, slots=True)
class Named:
    """A site for each vertex of two meshes; pairs that connectivity alone has brought together.

    They are strangers if, without places, components of both are like none of the other.
    Clause: ORCL-CODEC-6.
    """

    sent: tuple[int, ...]
    came: tuple[int, ...]
    paired: tuple[tuple[int, int], ...] = ()
    strangers: bool = False


def by_place(sent: Soup, came: Soup, bound: Bound) -> Named:
    """Sites by places alone; all vertices are at one site if a mesh has no places."""
    if sent.places is None or came.places is None:
        return Named((0,) * sent.vertices, (0,) * came.vertices)
    one, other = sites(sent.places, came.places, bound)
    return Named(tuple(one), tuple(other))


def common(sent: Soup, came: Soup, bound: Bound, budget: Budget) -> Named:
    """Sites by places; vertices without a partner near, by the connectivity of what is sound.

    Sound are faces with three corners, each once. Components are matched as they are, then turned
    over. Without places, vertices that are left after that are paired as they come: one is like
    the other. Clause: ORCL-CODEC-6.
    """
    placed = by_place(sent, came, bound)
    known = sent.places is not None and came.places is not None
    both = set(placed.sent) & set(placed.came) if known else set[int]()
    one, other = ([s if s in both else -1 for s in names] for names in (placed.sent, placed.came))
    if known and (-1 not in one or -1 not in other):
        return placed
    nets = _sound(sent), _sound(came)
    image = _by_connectivity(*nets, (one, other), budget)
    pairs = {v: w for v, w in image.items() if one[v] == other[w] == -1}
    _name(pairs, one, other)
    for _ in range(ROUNDS):
        new = by_faces(sent.faces, came.faces, one, other)
        _name(new, one, other)
        pairs |= new
    here = [v for v, site in enumerate(one) if site == -1]
    there = [w for w, site in enumerate(other) if site == -1]
    strangers = not known and _in_faces(nets[0], here) and _in_faces(nets[1], there)
    if not known and not strangers:
        _name(dict(zip(here, there, strict=False)), one, other)
    return Named(
        tuple(-2 - v if s == -1 else s for v, s in enumerate(one)),
        tuple(-2 - sent.vertices - w if s == -1 else s for w, s in enumerate(other)),
        tuple(sorted(pairs.items())),
        strangers,
    )


def _name(pairs: Mapping[int, int], one: list[int], other: list[int]) -> None:
    """Give each pair a site of its own."""
    for v, w in pairs.items():
        one[v] = other[w] = -2 - v


def by_faces(
    faces: Sequence[Face], others: Sequence[Face], one: Sequence[int], other: Sequence[int]
) -> dict[int, int]:
    """Pairs of vertices that have no site yet, and faces on the same sites; most faces first.

    Clause: ORCL-CODEC-6.
    """
    there: dict[tuple[int, int], list[int]] = {}
    for edge, w in _tips(others, other):
        there.setdefault(edge, []).append(w)
    votes = Counter((v, w) for edge, v in _tips(faces, one) for w in there.get(edge, ()))
    pairs: dict[int, int] = {}
    taken: set[int] = set()
    for (v, w), _ in sorted(votes.items(), key=lambda vote: (-vote[1], vote[0])):
        if v not in pairs and w not in taken:
            pairs[v] = w
            taken.add(w)
    return pairs


def _tips(faces: Sequence[Face], site: Sequence[int]) -> Iterator[tuple[tuple[int, int], int]]:
    """The faces with one vertex that has no site: the sites of the edge against it, and it."""
    for a, b, c in faces:
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            if site[r] == -1 and site[p] != -1 and site[q] != -1:
                yield (site[p], site[q]), r


def _by_connectivity(
    one: Net, other: Net, begin: tuple[Sequence[int], Sequence[int]], budget: Budget
) -> dict[int, int]:
    """The images of vertices whose components are alike."""
    over = mirrored(other)
    colours = coloured((one, other, over), (*begin, begin[1]))
    first, second, third = map(Coloured, (one, other, over), colours)
    parts = range(len(one.parts)), range(len(other.parts))
    straight = matched(first, parts[0], second, parts[1], anywhere, budget)
    taken = set(straight.partner.values())
    left = [p for p in parts[0] if p not in straight.partner]
    free = [p for p in parts[1] if p not in taken]
    return straight.image | matched(first, left, third, free, anywhere, budget).image


def _in_faces(of: Net, some: Sequence[int]) -> bool:
    """Whether any of these vertices is in a face."""
    return any(len(of.units[of.at[v][0]]) == 3 for v in some)


def anywhere(_: int, __: int) -> bool:
    """Any vertex may become any other one of its colour."""
    return True


def _sound(of: Soup) -> Net:
    """Each oriented face with three corners, once."""
    faces = {begun_at_least(face): face for face in of.faces if len(set(face)) == 3}
    return net(list(faces.values()), of.vertices)
