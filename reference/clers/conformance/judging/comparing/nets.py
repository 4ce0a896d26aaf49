"""What a mesh is made of when its names are forgotten: faces with their number, and components."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from clers.conformance.judging.comparing.soup import Face, begun_at_least

Unit = tuple[int, ...]
"""A face, begun at the least of its turns; or one vertex that is in no face."""

ROUNDS: Final = 8
"""Colours need not be stable: they only save work."""


@dataclass(frozen=True, slots=True)
class Net:
    """The units of a mesh, each once with how often it is there; the units at each vertex; and

    `parts`, the units of each component: what vertices link. Clause: ORCL-CODEC-5.
    """

    units: tuple[Unit, ...]
    times: tuple[int, ...]
    at: tuple[tuple[int, ...], ...]
    parts: tuple[tuple[int, ...], ...]


def net(faces: Sequence[Face], vertices: int) -> Net:
    """The net of faces that name only vertices that are there. Linear."""
    counted = Counter(map(begun_at_least, faces))
    used = {v for face in counted for v in face}
    counted.update((v,) for v in range(vertices) if v not in used)
    units = tuple(counted)
    at: list[list[int]] = [[] for _ in range(vertices)]
    for u, unit in enumerate(units):
        for v in dict.fromkeys(unit):
            at[v].append(u)
    incident = tuple(map(tuple, at))
    return Net(units, tuple(counted.values()), incident, _parts(units, incident))


def _parts(units: Sequence[Unit], at: Sequence[Sequence[int]]) -> tuple[tuple[int, ...], ...]:
    seen = [False] * len(units)
    parts: list[tuple[int, ...]] = []
    for start in range(len(units)):
        if seen[start]:
            continue
        seen[start] = True
        found = [start]
        for u in found:  # which grows on the way
            for v in units[u]:
                for other in at[v]:
                    if not seen[other]:
                        seen[other] = True
                        found.append(other)
        parts.append(tuple(sorted(found)))
    return tuple(parts)


def mirrored(of: Net) -> Net:
    """The same net with each face turned over. Clause: ORCL-CODEC-6."""
    return Net(tuple(begun_at_least(u[::-1]) for u in of.units), of.times, of.at, of.parts)


def coloured(nets: Sequence[Net], begin: Sequence[Sequence[int]]) -> list[list[int]]:
    """Colours of the vertices of several nets: what an isomorphism that keeps `begin` keeps too.

    Each round a vertex takes up the colours before and after it in its faces. ORCL-CODEC-5.
    """
    colours = [list(some) for some in begin]
    classes = len({c for some in colours for c in some})
    for _ in range(ROUNDS):
        names: dict[tuple[int, tuple[tuple[int, ...], ...]], int] = {}
        colours = [
            [names.setdefault(sign, len(names)) for sign in _signs(of, colour)]
            for of, colour in zip(nets, colours, strict=True)
        ]
        if len(names) == classes:
            break
        classes = len(names)
    return colours


def _signs(of: Net, colour: Sequence[int]) -> list[tuple[int, tuple[tuple[int, ...], ...]]]:
    seen: list[list[tuple[int, ...]]] = [[] for _ in of.at]
    for unit, times in zip(of.units, of.times, strict=True):
        for i, v in enumerate(unit):
            seen[v].append((times, *(colour[w] for w in unit[i + 1 :] + unit[:i])))
    return [(c, tuple(sorted(around))) for c, around in zip(colour, seen, strict=True)]
