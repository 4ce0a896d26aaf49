"""What all commands share in printing."""

import io
import json
import sys

import pytest
import typer

from clers.cli.output import line, progress, reject, table, where_record
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import (
    WHOLE,
    AtByte,
    AtCell,
    AtEdge,
    AtEntry,
    AtFace,
    AtPair,
    AtRecord,
    AtSimplex,
    AtStep,
    AtSymbol,
    AtVertex,
    Where,
)

PINCHED = Rejected(Reason.PINCHED_VERTEX, Clause.CONV_RESULT_4, AtVertex(3), "two fans\nat it")


def test_reject_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    """Clauses: TOOL-OUTPUT-2, TOOL-EXIT-1."""
    with pytest.raises(typer.Exit) as ended:
        reject("toy.ply", PINCHED)
    said = "toy.ply: invalid: pinched-vertex at vertex 3 [CONV-RESULT-4]: two fans at it\n"
    assert (ended.value.exit_code, *capsys.readouterr()) == (1, "", said)


def test_reject_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    """Clauses: TOOL-OUTPUT-1, TOOL-EXIT-1."""
    with pytest.raises(typer.Exit) as ended:
        reject("toy.ply", PINCHED, as_json=True)
    out, err = capsys.readouterr()
    assert (ended.value.exit_code, err) == (1, "")
    assert json.loads(out) == {
        "source": "toy.ply",
        "reject": {
            "class": "invalid",
            "reason": "pinched-vertex",
            "at": {"vertex": 3},
            "clause": "CONV-RESULT-4",
            "detail": "two fans\nat it",
        },
    }


@pytest.mark.parametrize(
    ("where", "record"),
    [
        (WHOLE, {}),
        (AtFace(0), {"face": 0}),
        (AtVertex(1), {"vertex": 1}),
        (AtEdge(1, 2, 0), {"tail": 1, "head": 2, "face": 0}),
        (AtSymbol(4), {"symbol": 4}),
        (AtRecord(5), {"record": 5}),
        (AtStep(6), {"step": 6}),
        (AtByte(7, "word"), {"byte": 7, "section": "word"}),
        (AtSimplex((8, 9)), {"simplex": [8, 9]}),
        (AtPair((8, 9), (10,)), {"simplex": [8, 9], "other": [10]}),
        (AtCell(2, 11), {"cell": 11, "dimension": 2}),
        (AtEntry("twin", 12), {"array": "twin", "entry": 12}),
    ],
)
def test_where(where: Where, record: dict[str, int | str | list[int]]) -> None:
    """Clause: CONV-RESULT-2."""
    assert where_record(where) == record


def test_table(capsys: pytest.CaptureFixture[str]) -> None:
    """No cell is cut, however long."""
    table(["a", "word"], [[1, "x" * 200], [22, "y"]])
    assert capsys.readouterr().out == f"a   word\n1   {'x' * 200}\n22  y\n"


def test_progress_is_silent_in_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    """Clause: TOOL-OUTPUT-3."""
    with progress("laws", 2) as step:
        step("one")
    assert capsys.readouterr() == ("", "")


def test_progress_on_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Clause: TOOL-OUTPUT-3."""
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("TERM", "xterm")
    with progress("laws", 2) as step:
        step("euler")
        line("a result")
    assert "laws: euler" in terminal.getvalue()
    assert capsys.readouterr().out == "a result\n"
