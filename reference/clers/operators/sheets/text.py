"""Scripts on sheets as text, one operator after another.

zero-handle 0 1 2; glue 1 0 3; kill-te 1 0 3
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import astuple
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.lines import read_each, words
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Glue,
    Join,
    JoinStrip,
    Lower,
    LowerStrip,
    MakeEKL,
    MakeEV,
    MakeSG,
    MakeSTV,
    MakeTE,
    Operator,
    Script,
    TwoHandle,
    Undo,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)

WITH_THREE: Final[Mapping[str, Callable[[int, int, int], Constructive]]] = {
    "make-stv": MakeSTV,
    "make-ev": MakeEV,
    "make-te": MakeTE,
    "make-sg": MakeSG,
    "zero-handle": ZeroHandle,
    "complete": Complete,
    "glue": Glue,
    "two-handle": TwoHandle,
}
WITH_FOUR: Final[Mapping[str, Callable[[int, int, int, int], Constructive]]] = {
    "make-ekl": MakeEKL,
    "join": Join,
    "lower": Lower,
    "upper": Upper,
    "join-strip": JoinStrip,
    "lower-strip": LowerStrip,
    "upper-strip": UpperStrip,
}
POLYGON: Final = "zero-handle-polygon"

NAME: Final[Mapping[type[Constructive], str]] = {
    MakeSTV: "make-stv",
    MakeEV: "make-ev",
    MakeTE: "make-te",
    MakeSG: "make-sg",
    MakeEKL: "make-ekl",
    ZeroHandle: "zero-handle",
    ZeroHandlePolygon: POLYGON,
    Complete: "complete",
    Glue: "glue",
    Join: "join",
    Lower: "lower",
    Upper: "upper",
    TwoHandle: "two-handle",
    JoinStrip: "join-strip",
    LowerStrip: "lower-strip",
    UpperStrip: "upper-strip",
}

_NUMBER: Final = re.compile(r"0|[1-9][0-9]{0,999}", re.ASCII)


def write(script: Script) -> str:
    """The script in one line. Clause: OPER-BUILD-5."""
    return "; ".join(
        " ".join([name_of(operator), *map(str, operands(operator))]) for operator in script
    )


def name_of(operator: Operator) -> str:
    """The operator's name. Clause: OPER-BUILD-5."""
    if not isinstance(operator, Undo):
        return NAME[type(operator)]
    return _undo(NAME[type(operator.of)])


def _undo(name: str) -> str:
    return name.replace("make-", "kill-") if name.startswith("make-") else f"undo-{name}"


UNDONE: Final[Mapping[str, str]] = {_undo(name): name for name in NAME.values()}
"""The name of what is undone, by the name of the operator that undoes it."""


def operands(operator: Operator) -> tuple[int, ...]:
    """The vertices of an operator, in order. Clause: OPER-BUILD-5."""
    what = operator.of if isinstance(operator, Undo) else operator
    if isinstance(what, ZeroHandlePolygon):
        return what.polygon
    vertices: tuple[int, ...] = astuple(what)
    return vertices


def read(text: str) -> Accepted[Script] | Rejected:
    """The script that a text says. Clause: OPER-BUILD-5."""
    return read_each(text, _operator)


def _operator(piece: str, where: AtStep) -> Accepted[Operator] | Rejected:
    name, *numbers = words(piece)
    clause = Clause.OPER_BUILD_5
    if UNDONE.get(name, name) not in NAME.values():
        return Rejected(Reason.UNKNOWN_OPERATOR, clause, where, name)
    bad = [number for number in numbers if not _NUMBER.fullmatch(number)]
    if bad:
        return Rejected(Reason.BAD_OPERAND, clause, where, f"{bad[0][:20]!r} is no vertex")
    operator = named(name, [int(number) for number in numbers])
    if operator is None:
        detail = f"{name} with {len(numbers)} vertices"
        return Rejected(Reason.BAD_OPERAND, clause, where, detail)
    return Accepted(operator)


def named(name: str, vertices: Sequence[int]) -> Operator | None:
    """The operator of a name on some vertices; None where it takes more or fewer."""
    made = UNDONE.get(name, name)
    operator: Constructive
    match vertices:
        case polygon if made == POLYGON:
            operator = ZeroHandlePolygon(tuple(polygon))
        case [a, b, c] if made in WITH_THREE:
            operator = WITH_THREE[made](a, b, c)
        case [a, b, c, d] if made in WITH_FOUR:
            operator = WITH_FOUR[made](a, b, c, d)
        case _:
            return None
    return operator if name == made else Undo(operator)
