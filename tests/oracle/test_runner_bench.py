"""`clers bench bits` over workers: the same report."""

import json
import os
import signal
from pathlib import Path

import pytest
from typer.testing import CliRunner

from clers.cli import bits_spread
from clers.cli.bits_spread import Item, one, report_of
from clers.cli.main import app
from clers.cli.output import Exit
from clers.measure.bits.report import Refused, Row
from clers.oracle.pool.place import Local


def bits(*arguments: str) -> dict[str, object]:
    done = CliRunner().invoke(app, ["bench", "bits", *arguments, "--json"])
    assert done.exit_code == Exit.NOT_CONFORMING, done.output
    document: dict[str, object] = json.loads(done.stdout)
    del document["day"]
    return document


def test_the_report_of_one_process(tmp_path: Path) -> None:
    """Clauses: TOOL-BITS-11, ORCL-POOL-1: spheres and meshes that are none among them."""
    broken = tmp_path / "broken.off"
    broken.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n")
    good = tmp_path / "tetrahedron.off"
    corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    good.write_text(f"OFF\n4 4 0\n{corners}3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
    arguments = (str(broken), str(good), "--sphere", "20")
    alone = bits(*arguments)
    assert bits(*arguments, "--workers", "2") == alone
    rows = alone["meshes"]
    assert isinstance(rows, list)
    assert [row["mesh"] for row in rows] == ["tetrahedron", "sphere-20"]


def fatal(item: Item) -> tuple[Row]:
    if item.name == "fatal":
        os.kill(os.getpid(), signal.SIGKILL)
    return one(item)


def test_a_mesh_that_kills_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clauses: TOOL-BITS-11, ORCL-POOL-2."""
    monkeypatch.setattr(bits_spread, "one", fatal)
    words: list[str] = []
    items = [Item("fatal", None, 4, 1), Item("small", None, 4, 1)]
    found = report_of(items, Local(2), words.append)
    why = "3 workers ended over it, the last with code -9"
    assert found.refused == (Refused("fatal", why),)
    assert [mesh.mesh for mesh in found.meshes] == ["small"]
    assert words == ["fatal", "small"]


def test_no_scheduler(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-POOL-3."""
    monkeypatch.setattr("clers.oracle.pool.cluster.PATIENCE", 0.2)
    arguments = ["bench", "bits", "--sphere", "4", "--scheduler", "tcp://127.0.0.1:1"]
    assert CliRunner().invoke(app, arguments).exit_code == Exit.USAGE
