"""Random spheres and real meshes beside what codes guarantee: bits per triangle, measured."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import exp, fsum, log, log2, sqrt
from random import Random
from typing import Final

from clers.codes.registry import CodeName
from clers.codes.registry import encode as encode_word
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.encode import encode
from clers.measure.bits.costs import BEST, code_bytes, least_of_draco
from clers.measure.bits.entropies import PER_TRIANGLE
from clers.measure.bits.report import Given, Refused
from clers.measure.bits.spheres import random_sphere
from clers.measure.path import must
from clers.measure.peers.draco import DRACO

GUARANTEED: Final[dict[str, float]] = {
    "plain": 2,
    "king-rossignac": float(Fraction(11, 6)),
    "golden": 2.5 * log2((1 + sqrt(5)) / 2),
    "enumerative": PER_TRIANGLE,
}
"""Bits per triangle that a code keeps to on every sphere, in the limit. Clause: TOOL-BITS-10."""

DRAWN: Final = (*GUARANTEED, BEST)
"""The codes that are tried on spheres, if there are such."""

FEWEST: Final = 100
MOST: Final = 5000
SMALLEST: Final = 500
"""A mesh of fewer faces is left out: its counts are most of what it takes."""


@dataclass(frozen=True, slots=True)
class OnSpheres:
    """One code on all the spheres: for each its triangles, and the word's bits for each of them."""

    code: str
    guaranteed: float | None
    faces: tuple[int, ...]
    bits_per_triangle: tuple[float, ...]

    def cells(self) -> list[str]:
        """The row for people: code, guarantee, least, mean and most."""
        found = self.bits_per_triangle
        promised = "–" if self.guaranteed is None else f"{self.guaranteed:.4f}"
        three = (min(found), fsum(found) / len(found), max(found))
        return [self.code, promised, *(f"{value:.4f}" for value in three)]


@dataclass(frozen=True, slots=True)
class OnMesh:
    """A mesh: bits per triangle of `golden`, of `best`, and of the lesser of Draco's two."""

    mesh: str
    golden: float
    best: float
    draco: float | None


@dataclass(frozen=True, slots=True)
class Bounds:
    """`clers bench bounds --json`. Clause: TOOL-BITS-10."""

    seed: int
    spheres: tuple[OnSpheres, ...]
    meshes: tuple[OnMesh, ...]
    refused: tuple[Refused, ...]


def sizes(count: int, seed: int) -> list[int]:
    """Even numbers of faces, evenly on a logarithmic scale. Clause: TOOL-BITS-10."""
    draw = Random(seed).random
    return [2 * round(exp(log(FEWEST / 2) + draw() * log(MOST / FEWEST))) for _ in range(count)]


def on_spheres(count: int, seed: int, step: Callable[[str], None]) -> tuple[OnSpheres, ...]:
    """Code random spheres, by every code drawn. Clause: TOOL-BITS-10."""
    codes = [code for code in CodeName if code in DRAWN]
    faces = sizes(count, seed)
    found: dict[CodeName, list[float]] = {code: [] for code in codes}
    for k, number in enumerate(faces):
        step(f"{number} faces")
        stream = encode(random_sphere(number, seed + k)).stream
        for code in codes:
            found[code].append(must(encode_word(code, stream)).length / number)
    return tuple(
        OnSpheres(code, GUARANTEED.get(code), tuple(faces), tuple(found[code])) for code in codes
    )


def on_meshes(
    given: Iterable[Given], step: Callable[[str], None]
) -> tuple[tuple[OnMesh, ...], tuple[Refused, ...]]:
    """Meshes by TOOL-BITS-1, the cheapest last, and those that are none. Clause: TOOL-BITS-10."""
    rows: list[OnMesh] = []
    refused: list[Refused] = []
    for name, surface in given:
        step(name)
        match surface:
            case Accepted(value):
                if value.faces >= SMALLEST:
                    rows.append(_on_mesh(name, value))
            case Rejected() as rejected:
                refused.append(Refused(name, rejected.line()))
    return tuple(sorted(rows, key=lambda row: -row.best)), tuple(refused)


def _on_mesh(name: str, surface: Surface) -> OnMesh:
    encoding = encode(surface)
    golden, best = (
        8 * must(code_bytes(surface, encoding, code)) / surface.faces
        for code in (CodeName.GOLDEN, CodeName.BEST)
    )
    answers = {peer.name: peer.bytes_for(surface) for peer in DRACO}
    asked = {
        peer: 8.0 * answer.value if isinstance(answer, Accepted) else None
        for peer, answer in answers.items()
    }
    theirs = least_of_draco(asked)
    return OnMesh(name, golden, best, None if theirs is None else theirs / surface.faces)
