"""Small meshes of every kind, made here: what codecs may stumble over. Clause: ORCL-CODEC-14."""

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import Final

from clers.conformance import payloads as form
from clers.generate.families import grid_torus

Face = tuple[int, int, int]
Place = tuple[float, float, float]

LOOSE: Final = 60
"""So many meshes of loose triples."""

LOOSE_NAME: Final = "loose triples"

SEED: Final = 1962


def on_curve(vertices: int) -> tuple[Place, ...]:
    """Places of which no three are on one line: (k, k², 0)."""
    return tuple((float(k), float(k * k), 0.0) for k in range(vertices))


def placed(faces: Sequence[Face], places: Sequence[Place]) -> form.MeshForm:
    """The mesh in binary32."""
    at = tuple(x for place in places for x in place)
    return form.MeshForm(
        faces=tuple(faces),
        vertices=len(places),
        positions=form.Places(precision="f32", coordinates=at),
    )


_SOLID: Final = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
_P2: Final = (
    (0, 1, 4), (0, 1, 5), (0, 2, 3), (0, 2, 5), (0, 3, 4),
    (1, 2, 3), (1, 2, 4), (1, 3, 5), (2, 4, 5), (3, 4, 5),
)  # fmt: skip

_BY_HAND: Final[Mapping[str, tuple[Sequence[Face], int]]] = {
    "nothing": ((), 0),
    "three vertices, no face": ((), 3),
    "triangle": (((0, 1, 2),), 3),
    "tetrahedron": (_SOLID, 4),
    "tetrahedron mirrored": (tuple((a, c, b) for a, b, c in _SOLID), 4),
    "tetrahedron and a vertex": (_SOLID, 5),
    "face twice": ((*_SOLID, (1, 2, 0)), 4),
    "face and its mirror image": ((*_SOLID, (0, 2, 1)), 4),
    "two faces back to back": (((0, 1, 2), (0, 2, 1)), 3),
    "face with a corner twice": ((*_SOLID, (0, 0, 1)), 4),
    "face with one corner thrice": ((*_SOLID, (0, 0, 0)), 4),
    "three faces at an edge": (((0, 1, 2), (1, 0, 3), (0, 1, 4)), 5),
    "edge run twice one way": (((0, 1, 2), (0, 1, 3)), 4),
    "two triangles at a vertex": (((0, 1, 2), (0, 3, 4)), 5),
    "two tetrahedra at a vertex": ((*_SOLID, (0, 4, 5), (6, 5, 4), (0, 6, 4), (5, 6, 0)), 7),
    "strip": (tuple((k, k + 1, k + 2) if k % 2 else (k + 1, k, k + 2) for k in range(6)), 8),
    "Möbius strip": (tuple((k, (k + 1) % 5, (k + 2) % 5) for k in range(5)), 5),
    "projective plane": (_P2, 6),
    "torus": (grid_torus(3, 4).faces, 12),
}


def _places(of: Sequence[int]) -> tuple[Place, ...]:
    """One place for each number, on the curve."""
    known = on_curve(max(of, default=0) + 1)
    return tuple(known[k] for k in of)


def _coinciding() -> Iterator[tuple[str, form.MeshForm]]:
    """Vertices at one place, and signs of zero."""
    yield (
        "two triangles, a place in common",
        placed(((0, 1, 2), (3, 4, 5)), _places((0, 1, 2, 0, 3, 4))),
    )
    yield (
        "two triangles, an edge in common by place",
        placed(((0, 1, 2), (3, 4, 5)), _places((0, 1, 2, 1, 0, 3))),
    )
    yield (
        "two triangles at the same places",
        placed(((0, 1, 2), (3, 4, 5)), _places((0, 1, 2, 0, 1, 2))),
    )
    yield "triangle with two corners at one place", placed(((0, 1, 2),), _places((0, 0, 1)))
    origin, *rest = _places((0, 1, 2, 0, 3, 4))
    minus = tuple(-x for x in origin)
    signed = (origin, *rest[:2], (minus[0], minus[1], minus[2]), *rest[3:])
    yield "two triangles, at 0 and at −0", placed(((0, 1, 2), (3, 4, 5)), signed)


def by_hand() -> Iterator[tuple[str, form.MeshForm]]:
    """Small meshes, each with a name."""
    for name, (faces, vertices) in _BY_HAND.items():
        yield name, placed(faces, on_curve(vertices))
    yield from _coinciding()


def loose() -> Iterator[tuple[str, form.MeshForm]]:
    """Any triples of few vertices, at any of few places."""
    dice = Random(SEED)

    def below(n: int) -> int:
        return int(dice.random() * n)

    for number in range(LOOSE):
        vertices = 3 + below(4)
        triples = [(below(vertices), below(vertices), below(vertices)) for _ in range(1 + below(7))]
        crowd = [k if below(8) else below(vertices) for k in range(vertices)]
        yield f"{LOOSE_NAME} {number}", placed(triples, _places(crowd))
