"""Scripts as text, one line an operator: how a shrunk counterexample is kept and sent.

split-face 0; open-curve 3; add-handle 1 4
"""

import re
from collections.abc import Callable, Mapping
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.lines import read_each, words
from clers.operators.script import (
    AddEar,
    AddHandle,
    AddTetrahedron,
    Bridge,
    CloseCurve,
    CutEdge,
    FillCorner,
    FlipEdge,
    JoinComponents,
    OpenCurve,
    Operator,
    Relabel,
    RemoveFace,
    RemoveStar,
    Script,
    SplitEdge,
    SplitFace,
)

WITH_ONE: Final[Mapping[str, Callable[[int], Operator]]] = {
    "split-face": SplitFace,
    "split-edge": SplitEdge,
    "flip-edge": FlipEdge,
    "relabel": Relabel,
    "add-ear": AddEar,
    "fill-corner": FillCorner,
    "close-curve": CloseCurve,
    "open-curve": OpenCurve,
    "remove-face": RemoveFace,
    "remove-star": RemoveStar,
    "cut-edge": CutEdge,
}
"""The operators of one integer, by name. Clause: OPER-SCRIPT-7."""

WITH_TWO: Final[Mapping[str, Callable[[int, int], Operator]]] = {
    "add-handle": AddHandle,
    "join-components": JoinComponents,
    "bridge": Bridge,
}
WITH_NONE: Final[Mapping[str, Callable[[], Operator]]] = {"add-tetrahedron": AddTetrahedron}

_NUMBER: Final = re.compile(r"0|-?[1-9][0-9]{0,999}", re.ASCII)


def write(script: Script) -> str:
    """The script in one line. Clause: OPER-SCRIPT-6."""
    return "; ".join(
        " ".join([name_of(operator), *map(str, operands(operator))]) for operator in script
    )


def read(text: str) -> Accepted[Script] | Rejected:
    """The script that a text says. Clause: OPER-SCRIPT-6."""
    return read_each(text, _operator)


def _operator(piece: str, where: AtStep) -> Accepted[Operator] | Rejected:
    name, *numbers = words(piece)
    if name not in WITH_NONE and name not in WITH_ONE and name not in WITH_TWO:
        return Rejected(Reason.UNKNOWN_OPERATOR, Clause.OPER_SCRIPT_6, where, name)
    bad = [number for number in numbers if not _NUMBER.fullmatch(number)]
    if bad:
        detail = f"{bad[0][:20]!r} is no number"
        return Rejected(Reason.BAD_OPERAND, Clause.OPER_SCRIPT_6, where, detail)
    match [int(number) for number in numbers]:
        case [] if name in WITH_NONE:
            return Accepted(WITH_NONE[name]())
        case [choice] if name in WITH_ONE:
            return Accepted(WITH_ONE[name](choice))
        case [first, second] if name in WITH_TWO:
            return Accepted(WITH_TWO[name](first, second))
        case others:
            detail = f"{name} with {len(others)} numbers"
            return Rejected(Reason.BAD_OPERAND, Clause.OPER_SCRIPT_6, where, detail)


def name_of(operator: Operator) -> str:
    """The operator's name: its class's, in lower case with hyphens. Clause: OPER-SCRIPT-6."""
    return re.sub(r"(?<!^)([A-Z])", r"-\1", type(operator).__name__).lower()


def operands(operator: Operator) -> tuple[int, ...]:
    """The integers of an operator, in order. Clause: OPER-SCRIPT-6."""
    match operator:
        case AddTetrahedron():
            return ()
        case AddHandle(first, second) | JoinComponents(first, second) | Bridge(first, second):
            return first, second
        case (
            SplitFace(choice)
            | SplitEdge(choice)
            | FlipEdge(choice)
            | Relabel(choice)
            | AddEar(choice)
            | FillCorner(choice)
            | CloseCurve(choice)
            | OpenCurve(choice)
            | RemoveFace(choice)
            | RemoveStar(choice)
            | CutEdge(choice)
        ):
            return (choice,)
        case _:
            assert_never(operator)
