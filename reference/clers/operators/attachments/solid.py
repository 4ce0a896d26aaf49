"""Handles of every dimension as prisms, and what they do to a 3-manifold."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Final

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import Complex, Simplex, boundary, closure, euler, pieces
from clers.operators.attachments.attachment import Attachment, Vertices, attachment, common
from clers.operators.attachments.classes import handles
from clers.operators.attachments.operator import Handle


def prism(near: Vertices, far: Vertices) -> tuple[Vertices, ...]:
    """The n simplices of the prism between two (n−1)-simplices, in order. Clause: OPER-SOLID-4.

    Number i has the last n − i vertices of `near` and the first i + 1 of `far`.
    """
    return tuple((*near[i:], *far[: i + 1]) for i in range(len(near)))


def handle(k: Complex, simplices: tuple[Vertices, ...]) -> Handle:
    """The handle of simplices glued one after the other; there is at least one. OPER-SOLID-1."""
    glued: list[Attachment] = []
    for simplex in simplices:
        glued.append(attachment(k, simplex))
        k = Complex(k.simplices | closure([simplex]).simplices)
    return Handle(glued[0], tuple(glued[1:]))


class SolidCase(StrEnum):
    """What a handle or an attachment of a tetrahedron is to a 3-manifold. OPER-SOLID-5."""

    ZERO = "0-handle"
    EULER = "Euler attachment"
    ONE_OF_TWO = "1-handle between two components"
    ONE_BETWEEN = "1-handle between two boundary surfaces of a component"
    ONE_AT = "1-handle at one boundary surface"
    TWO_SPLITS = "2-handle that splits its boundary surface"
    TWO_OPENS = "2-handle that does not"
    THREE = "3-handle"


@dataclass(frozen=True, slots=True)
class SolidChange:
    """Changes of a 3-manifold. Clause: OPER-SOLID-5.

    `surfaces` counts the components of the boundary; `genus` is half the first Betti number over
    GF(2) of the boundary, which for orientable surfaces is the sum of their genera.
    """

    euler: int
    components: int
    surfaces: int
    genus: int


TABLE: Final[Mapping[SolidCase, SolidChange]] = MappingProxyType(
    {
        SolidCase.ZERO: SolidChange(1, 1, 1, 0),
        SolidCase.EULER: SolidChange(0, 0, 0, 0),
        SolidCase.ONE_OF_TWO: SolidChange(-1, -1, -1, 0),
        SolidCase.ONE_BETWEEN: SolidChange(-1, 0, -1, 0),
        SolidCase.ONE_AT: SolidChange(-1, 0, 0, 1),
        SolidCase.TWO_SPLITS: SolidChange(1, 0, 1, 0),
        SolidCase.TWO_OPENS: SolidChange(1, 0, 0, -1),
        SolidCase.THREE: SolidChange(-1, 0, -1, 0),
    }
)
"""The rows of OPER-SOLID-5."""


def solid_change(before: Complex, after: Complex) -> SolidChange:
    """The differences between two 3-manifolds, counted. Clause: OPER-SOLID-5."""
    rims = boundary(before), boundary(after)
    rounds = [sum(betti(rim, Field.GF2)[1:2]) for rim in rims]
    return SolidChange(
        euler(after) - euler(before),
        len(pieces(after)) - len(pieces(before)),
        len(pieces(rims[1])) - len(pieces(rims[0])),
        (rounds[1] - rounds[0]) // 2,
    )


def solid_case(before: Complex, operator: Handle) -> SolidCase | None:
    """Which row of the table an operator belongs to, told before it is applied. OPER-SOLID-5.

    None where the first attachment is several handles at once.
    """
    match handles(operator.first):
        case 1, 0, 0, 0:
            return SolidCase.ZERO
        case 0, 0, 0, 0:
            return SolidCase.EULER
        case 0, 1, 0, 0:
            return _one(before, operator)
        case 0, 0, 1, 0:
            return SolidCase.TWO_SPLITS if _splits(before, operator) else SolidCase.TWO_OPENS
        case 0, 0, 0, 1:
            return SolidCase.THREE
        case _:
            return None


def _one(before: Complex, operator: Handle) -> SolidCase:
    def touched(parts: tuple[Complex, ...]) -> int:
        return sum(not part.simplices.isdisjoint(there) for part in parts)

    there = common(operator.first).simplices
    if touched(pieces(before)) > 1:
        return SolidCase.ONE_OF_TWO
    if touched(pieces(boundary(before))) > 1:
        return SolidCase.ONE_BETWEEN
    return SolidCase.ONE_AT


def _splits(before: Complex, operator: Handle) -> bool:
    """Does the boundary fall apart without the triangles along which the handle is glued?"""
    handle_faces: set[Simplex] = set()
    for glued in (operator.first, *operator.then):
        handle_faces |= common(glued).simplices
    triangles = {s for s in boundary(before).simplices if len(s) == 3}
    return _across_edges(triangles - handle_faces) > _across_edges(triangles)


def _across_edges(triangles: set[Simplex]) -> int:
    """The number of parts into which triangles fall that are neighbours at edges alone."""
    left, parts = set(triangles), 0
    while left:
        parts += 1
        reached = [left.pop()]
        while reached:
            triangle = reached.pop()
            near = {other for other in left if len(other & triangle) == 2}
            left -= near
            reached += near
    return parts
