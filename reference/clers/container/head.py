"""The HEAD section: how the rest is coded, and how much of it there is."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from clers.codes.registry import CodeName
from clers.complexes.face_list import Limits
from clers.container.layout import Layout, pair, renamed, times
from clers.container.numbers import one_of, varint
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte

CODES: Final = (
    CodeName.PLAIN,
    CodeName.GOLDEN,
    CodeName.HUFFMAN,
    CodeName.ADAPTIVE_1,
    CodeName.ADAPTIVE_3,
    CodeName.ADAPTIVE_6,
    CodeName.KING_ROSSIGNAC,
    CodeName.MINIMAX_3,
    CodeName.MINIMAX_8,
    CodeName.CONTEXT,
    CodeName.ENUMERATIVE,
    CodeName.BEST,
)
"""The codes of the word, numbered from 1. Clause: FILE-HEAD-2."""


class PositionCoding(StrEnum):
    """How positions are stored, numbered from 1. Clause: FILE-HEAD-3."""

    NONE = "none"
    EXACT_F32 = "exact-f32"
    EXACT_F64 = "exact-f64"
    LATTICE = "lattice"


@dataclass(frozen=True, slots=True)
class Head:
    """What a file says of itself. Clause: FILE-HEAD-1."""

    code: CodeName
    positions: PositionCoding
    faces: int
    vertices: int
    components_with_boundary: int
    symbols: int
    records: int


Parts = tuple[tuple[CodeName, PositionCoding], tuple[int, ...]]


def _build(parts: Parts) -> Accepted[Head] | Rejected:
    (code, positions), (faces, vertices, components, symbols, records) = parts
    return Accepted(Head(code, positions, faces, vertices, components, symbols, records))


def _take_apart(head: Head) -> Parts:
    counts = (head.faces, head.vertices, head.components_with_boundary, head.symbols, head.records)
    return (head.code, head.positions), counts


HEAD: Final[Layout[Head]] = renamed(
    pair(pair(one_of(CODES), one_of(tuple(PositionCoding))), times(5, varint(32))),
    _build,
    _take_apart,
)
"""Clause: FILE-HEAD-1."""


def over_limits(head: Head, limits: Limits, where: AtByte) -> Rejected | None:
    """Whether the HEAD at this place declares more than a reader will hold. FILE-LIMIT-2."""
    if max(head.faces, head.symbols) > limits.faces:
        detail = f"{head.faces} faces, {head.symbols} symbols, the limit is {limits.faces}"
        return Rejected(Reason.TOO_MANY_FACES, Clause.FILE_LIMIT_2, where, detail)
    if head.vertices > limits.vertices:
        detail = f"{head.vertices} vertices, the limit is {limits.vertices}"
        return Rejected(Reason.TOO_MANY_VERTICES, Clause.FILE_LIMIT_2, where, detail)
    return None
