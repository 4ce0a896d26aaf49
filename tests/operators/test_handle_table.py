"""OPER-EFFECT-1: the table in the code is the table in the chapter."""

from pathlib import Path
from typing import Final

from clers.operators.handle_table import TABLE, Change, row
from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    LowerHandle,
    OneHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
    ZeroHandlePolygon,
)

CHAPTER: Final = Path(__file__).parents[2] / "spec" / "04-handles.md"

NAMES: Final[dict[str, tuple[Operator, ...]]] = {
    "0-handle": (ZeroHandle(),),
    "0-handle with a polygon of $p$ edges": (ZeroHandlePolygon(7),),
    "attachment": (Attach(),),
    "completing": (CompleteAfter(), CompleteBefore()),
    "lower 1-handle": (LowerHandle(3),),
    "upper 1-handle": (UpperHandle(1, 0),),
    "1-handle between components": (OneHandle(),),
    "2-handle": (TwoHandle(),),
}


def test_table_of_the_chapter() -> None:
    """OPER-EFFECT-1, with p = 7."""
    _, _, clause = CHAPTER.read_text(encoding="utf-8").partition("**OPER-EFFECT-1.**")
    lines = (line.strip("> |\n").split(" | ") for line in clause.splitlines()[4:])
    found = {
        name: [int(x.replace("−", "-").replace("p", "7")) for x in cells] for name, *cells in lines
    }
    assert found.keys() == NAMES.keys()
    for name, operators in NAMES.items():
        assert [row(operator) for operator in operators] == [Change(*found[name])] * len(operators)
    assert {type(operator) for some in NAMES.values() for operator in some} == TABLE.keys()
