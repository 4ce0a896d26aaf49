"""OPER-EFFECT-2: the table in the code is the table in the chapter, and it is consistent."""

from pathlib import Path
from typing import Final

from clers.operators.sheets.effects import TABLE, rows
from clers.operators.sheets.numbers import Numbers
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
    TwoHandle,
    Undo,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)

CHAPTER: Final = Path(__file__).parents[3] / "spec" / "04-handles.md"

NAMES: Final[dict[str, tuple[Constructive, ...]]] = {
    "M STV, 0-handle": (MakeSTV(0, 1, 2), ZeroHandle(0, 1, 2)),
    "0-handle with a polygon of $p$ edges": (ZeroHandlePolygon((0, 1, 2, 3, 4, 5, 6)),),
    "M EV": (MakeEV(0, 1, 2),),
    "M TE, completing": (MakeTE(0, 1, 2), Complete(0, 1, 2)),
    "M SG, 2-handle": (MakeSG(0, 1, 2), TwoHandle(0, 1, 2)),
    "gluing": (Glue(0, 1, 2),),
    "1-handle": (Join(0, 1, 2, 3),),
    "lower 1-handle": (Lower(0, 1, 2, 3),),
    "upper 1-handle": (Upper(0, 1, 2, 3),),
    "1-handle of two triangles": (JoinStrip(0, 1, 2, 3),),
    "lower 1-handle of two triangles": (LowerStrip(0, 1, 2, 3),),
    "upper 1-handle of two triangles": (UpperStrip(0, 1, 2, 3),),
}
EKL: Final = ("M EKL, loops of one component", "M EKL, loops of two components")


def printed() -> dict[str, Numbers]:
    """The rows of the chapter, with p = 7."""
    _, _, clause = CHAPTER.read_text(encoding="utf-8").partition("**OPER-EFFECT-2.**")
    table = [line for line in clause.split("\n\n")[0].splitlines() if line.startswith("> |")]
    cells = [line.strip("> |").split(" | ") for line in table[2:]]
    return {
        name: Numbers(*(int(x.replace("−", "-").replace("p", "7")) for x in numbers))
        for name, *numbers in cells
    }


def test_table_of_the_chapter() -> None:
    """OPER-EFFECT-2, with p = 7."""
    found = printed()
    assert found.keys() == {*NAMES, *EKL}
    for name, operators in NAMES.items():
        for operator in operators:
            assert rows(operator) == (found[name],)
            assert rows(Undo(operator)) == (-found[name],)
    assert rows(MakeEKL(0, 1, 2, 3)) == tuple(found[name] for name in EKL)
    assert {type(o) for some in NAMES.values() for o in some} | {MakeEKL} == TABLE.keys()


def test_the_table_keeps_the_formula() -> None:
    """OPER-EFFECT-2, OPER-SHEET-3: χ = #0 − #1 + #2 = 2c − 2g − b in every row."""
    for n in printed().values():
        assert n.euler == n.vertices - n.edges + n.faces
        assert n.euler == 2 * n.components - 2 * n.genus - n.loops
