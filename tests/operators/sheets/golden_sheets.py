"""Sheets that several tests share, from scripts as text."""

from clers.conventions.result import Accepted, Rejected
from clers.operators.sheets.apply import apply, run
from clers.operators.sheets.operator import Operator, Script
from clers.operators.sheets.sheet import Sheet
from clers.operators.sheets.text import read

NOTHING = ""
TRIANGLE = "zero-handle 0 1 2"
TWO_TRIANGLES = "zero-handle 0 1 2; zero-handle 3 4 5"
DISK = "zero-handle 0 1 2; glue 2 1 3; glue 2 3 4; glue 4 3 5"
"""Four triangles in a row; its loop is [0, 2, 4, 5, 3, 1]."""

ANNULUS = f"{DISK}; lower-strip 1 0 4 5"
"""Six triangles; its loops are [1, 5, 3] and [4, 0, 2]."""

PINCHED = f"{DISK}; lower 1 0 4 5"
"""Five triangles; its loops are [1, 4, 5, 3] and [4, 0, 2], which both pass 4."""

POLYGON = "zero-handle-polygon 0 1 2 3"
SPIKE = f"{TRIANGLE}; make-ev 0 2 3"
"""A triangle and an edge; its loop is [0, 3, 0, 2, 1]."""


def script(text: str) -> Script:
    """The script that a text says."""
    result = read(text)
    assert isinstance(result, Accepted), result
    return result.value


def sheet(text: str) -> Sheet:
    """The sheet that a script makes of nothing."""
    result = run(script(text))
    assert isinstance(result, Accepted), result
    return result.value


def after(start: str, operator: str) -> Accepted[Sheet] | Rejected:
    """What one operator makes of the sheet of a script."""
    (one,) = script(operator)
    return apply(one, sheet(start))


def only(text: str) -> Operator:
    """The one operator that a text says."""
    (one,) = script(text)
    return one
