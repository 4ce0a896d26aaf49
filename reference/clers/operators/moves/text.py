"""Moves as text, one after another: the name, then the operands.

collapse 0 1 / 0 1 2; subdivide 0 1 / 7; contract 3 / 4; split 0 / 7 / 1 2, 2 3 / 1, 3
"""

import re
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.lines import read_each, words
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Vertices,
    Weld,
)

NAMES: Final = ("collapse", "expand", "subdivide", "weld", "bistellar", "contract", "split")

_NUMBER: Final = re.compile(r"0|[1-9][0-9]{0,999}", re.ASCII)

Field = tuple[Vertices, ...]
"""An operand: simplices, most often one."""


def write(moves: tuple[Move, ...]) -> str:
    """The moves in one line. Clause: OPER-MOVE-8."""
    return "; ".join(write_one(move) for move in moves)


def write_one(move: Move) -> str:
    """The name of the move and its operands. Clause: OPER-MOVE-8."""
    fields = (", ".join(" ".join(map(str, simplex)) for simplex in f) for f in fields_of(move))
    return f"{name_of(move)} {' / '.join(fields)}".rstrip()


def read(text: str) -> Accepted[tuple[Move, ...]] | Rejected:
    """The moves that a text says. Clause: OPER-MOVE-8."""
    return read_each(text, read_one)


def read_one(piece: str, where: AtStep) -> Accepted[Move] | Rejected:
    """The move that a piece says, or the step at fault. Clause: OPER-MOVE-8."""
    name = words(piece)[0]
    if name not in NAMES:
        return Rejected(Reason.UNKNOWN_OPERATOR, Clause.OPER_MOVE_8, where, name)
    fields: list[Field] = []
    for part in piece.removeprefix(name).split("/"):
        simplices = [words(simplex) for simplex in part.split(",")] if words(part) else []
        numbers = [number for simplex in simplices for number in simplex]
        bad = next((number for number in numbers if not _NUMBER.fullmatch(number)), None)
        if bad is not None or [] in simplices:
            detail = "a simplex without vertices" if bad is None else f"{bad[:20]!r} is no number"
            return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_8, where, detail)
        fields.append(tuple(tuple(map(int, simplex)) for simplex in simplices))
    move = _move(name, fields)
    if move is None:
        detail = f"{name} with other operands than it has"
        return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_8, where, detail)
    return Accepted(move)


def _move(name: str, fields: list[Field]) -> Move | None:
    """The move with this name, if the fields have the form of its operands."""
    match name, fields:
        case "collapse", [[free], [coface]]:
            return Collapse(free, coface)
        case "expand", [[free], [coface]]:
            return Expand(free, coface)
        case "subdivide", [[simplex], [[vertex]]]:
            return Subdivide(simplex, vertex)
        case "weld", [[simplex], [[vertex]]]:
            return Weld(simplex, vertex)
        case "bistellar", [[gone], [come]]:
            return Bistellar(gone, come)
        case "contract", [[[keep]], [[gone]]]:
            return Contract(keep, gone)
        case "split", [[[vertex]], [[new]], moved, shared]:
            return Split(vertex, new, moved, shared)
        case _:
            return None


def name_of(move: Move) -> str:
    """The move's name: its class's, in lower case. Clause: OPER-MOVE-8."""
    return type(move).__name__.lower()


def fields_of(move: Move) -> tuple[Field, ...]:
    """The operands of a move, in order. Clause: OPER-MOVE-8."""
    match move:
        case Collapse(free, coface) | Expand(free, coface):
            return (free,), (coface,)
        case Subdivide(simplex, vertex) | Weld(simplex, vertex):
            return (simplex,), ((vertex,),)
        case Bistellar(gone, come):
            return (gone,), (come,)
        case Contract(keep, gone):
            return ((keep,),), ((gone,),)
        case Split(vertex, new, moved, shared):
            return ((vertex,),), ((new,),), moved, shared
        case _:
            assert_never(move)
