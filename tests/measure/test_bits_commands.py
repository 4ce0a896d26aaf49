"""Spheres beside bounds, and the commands `bench bits` and `bench bounds` as a user runs them."""

import json
from math import log2
from pathlib import Path
from typing import Final

import numpy as np
import pytest
from matplotlib.axes import Axes
from typer.testing import CliRunner, Result

from clers.cli.loading import mesh_in
from clers.cli.main import app
from clers.cli.output import Exit
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.measure.bits.bounds import Bounds, OnMesh, OnSpheres, on_spheres, sizes
from clers.measure.bits.bounds_plot import drawn
from clers.measure.bits.costs import BEST, NAMES, measured
from clers.measure.bits.plot import svg
from clers.measure.bits.report import report

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
RING: Final = str(MESHES / "ring.off")
MOEBIUS: Final = str(MESHES / "dirty" / "moebius.off")


def surface_of(name: str) -> Surface:
    mesh = mesh_in(MESHES / name)
    assert isinstance(mesh, Accepted)
    return mesh.value.surface


def quiet(_: str) -> None:
    """Nobody watches."""


# Bounds


def test_sizes_are_even_and_within() -> None:
    """TOOL-BITS-10: half of them below the geometric middle, as on a logarithmic scale."""
    found = sizes(400, 1)
    assert found == sizes(400, 1)
    assert all(100 <= size <= 5000 and size % 2 == 0 for size in found)
    assert 160 < sum(size < 707 for size in found) < 240
    assert min(found) < 120
    assert max(found) > 4500


def test_spheres_in_plain_take_two_bits_less_two() -> None:
    """TOOL-BITS-10: the word alone is counted, (2T − 2)/T for each; golden keeps below 1.7356."""
    steps: list[str] = []
    found = {each.code: each for each in on_spheres(3, 5, steps.append)}
    assert [f"{size} faces" for size in sizes(3, 5)] == steps
    plain = found["plain"]
    assert plain.faces == tuple(sizes(3, 5))
    expected = [(2 * size - 2) / size for size in plain.faces]
    assert plain.bits_per_triangle == pytest.approx(expected)
    assert plain.guaranteed == 2
    assert max(found["golden"].bits_per_triangle) < 1.7356
    assert found["golden"].guaranteed == pytest.approx(1.73561, abs=1e-5)


def test_row_of_bounds() -> None:
    """TOOL-BITS-10."""
    two = OnSpheres("plain", 2.0, (100, 200), (1.5, 1.75))
    assert two.cells() == ["plain", "2.0000", "1.5000", "1.6250", "1.7500"]
    assert OnSpheres(BEST, None, (100,), (1.5,)).cells()[1] == "–"


def places(axes: Axes) -> list[list[list[float]]]:
    """Where the dots are, a list for each code."""
    return [np.asarray(dots.get_offsets()).tolist() for dots in axes.collections]


def test_dots_of_bounds() -> None:
    """TOOL-BITS-10: triangles across, bits per triangle upward; meshes one after another."""
    spheres = (OnSpheres("plain", 2.0, (100, 200), (1.5, 1.75)),)
    meshes = (OnMesh("first", 1.8, 1.5, None), OnMesh("second", 1.7, 1.2, 1.6))
    figure = drawn(Bounds(1, spheres, meshes, ()))
    left, right = figure.axes
    assert places(left) == [[[100, 1.5], [200, 1.75]]]
    assert places(right) == [[[0, 1.8], [1, 1.7]], [[1, 1.6]], [[0, 1.5], [1, 1.2]]]
    heights = [set(np.asarray(line.get_ydata()).tolist()) for line in left.lines]
    assert heights == [{2}, {11 / 6}, {2.5 * log2((1 + 5**0.5) / 2)}, {log2(256 / 27) / 2}]
    assert left.get_title().startswith("2 random spheres")


def test_plot_of_bounds() -> None:
    """TOOL-BITS-10: with meshes and without, with Draco's number and without."""
    spheres = (OnSpheres("plain", 2.0, (100, 200), (1.5, 1.75)),)
    meshes = (OnMesh("first", 1.8, 1.5, 1.6), OnMesh("second", 1.7, 1.2, None))
    text = svg(drawn(Bounds(1, spheres, meshes, ()))).decode()
    for name in ("first", "second", "plain", BEST, "11/6", "1.7356", "1.6226", "Draco's lesser"):
        assert f">{name}<" in text
    text = svg(drawn(Bounds(1, spheres, meshes[1:], ()))).decode()
    assert "Draco" not in text
    assert ">golden<" not in svg(drawn(Bounds(1, spheres, (), ()))).decode()


# The commands


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["bench", *arguments])


def test_bits_as_json(tmp_path: Path) -> None:
    """TOOL-BITS-8: the shape; a sphere beside a mesh."""
    done = clers("bits", RING, "--sphere", "8", "--json", "-o", str(tmp_path / "a.md"))
    assert done.exit_code == Exit.CONFORMING
    document = json.loads(done.stdout)
    assert set(document) == {
        "clers", "python", "machine", "day", "packages", "meshes", "mean_ratio", "refused",
    }  # fmt: skip
    assert [mesh["mesh"] for mesh in document["meshes"]] == ["ring", "sphere-8"]
    ring, sphere = document["meshes"]
    assert (sphere["vertices"], sphere["faces"], sphere["curves"]) == (6, 8, 0)
    assert [cost["name"] for cost in ring["costs"]] == [name for name, _ in NAMES]
    cost = next(c for c in ring["costs"] if c["name"] == "draco-standard")
    assert cost == {
        "name": "draco-standard", "kind": "peer", "bits": 136.0, "why_not": "",
        "bits_per_vertex": 136 / 6, "bits_per_triangle": 136 / 6,
    }  # fmt: skip
    ratios = [ring["ratio"], sphere["ratio"]]
    assert document["mean_ratio"] == pytest.approx((ratios[0] * ratios[1]) ** 0.5)
    written = (tmp_path / "a.md").read_text()
    assert f"    clers bench bits {RING} --sphere 8 -o {tmp_path / 'a.md'}\n" in written
    assert "| sphere-8 | 6 | 8 |" in written


def test_bits_for_people(tmp_path: Path) -> None:
    """TOOL-BITS-8, TOOL-BITS-9: tables, plots, a folder, and a rejected mesh in one line."""
    (tmp_path / "in" / "deeper").mkdir(parents=True)
    (tmp_path / "in" / "b.off").write_bytes(Path(RING).read_bytes())
    (tmp_path / "in" / "a.OFF").write_bytes(Path(MOEBIUS).read_bytes())
    (tmp_path / "in" / "deeper" / "c.off").write_bytes(Path(RING).read_bytes())
    (tmp_path / "in" / "notes.txt").write_text("no mesh")
    plots = [tmp_path / "p.svg", tmp_path / "p.PNG"]
    done = clers("bits", str(tmp_path / "in"), "-o", str(plots[0]), "-o", str(plots[1]))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "a: invalid: edge-twice-in-one-direction" in done.stderr
    assert "bits per triangle: peers" in done.stdout
    assert "geometric mean of the ratio over 1 meshes" in done.stdout
    assert plots[0].read_bytes().startswith(b"<?xml")
    assert plots[1].read_bytes().startswith(b"\x89PNG")


def test_only_rejected_meshes(tmp_path: Path) -> None:
    """TOOL-BITS-8: no tables of nothing."""
    done = clers("bits", MOEBIUS)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "bits per" not in done.stdout


@pytest.mark.parametrize(
    "arguments",
    [
        ("bits",),
        ("bits", RING, "-o", "a.pdf"),
        ("bits", "--sphere", "7"),
        ("bits", "--sphere", "2"),
        ("bounds", "-o", "a.md"),
        ("bounds", "--spheres", "0"),
    ],
)
def test_wrong_usage(arguments: tuple[str, ...]) -> None:
    """TOOL-BITS-8, TOOL-BITS-9, TOOL-BITS-10."""
    assert clers(*arguments).exit_code == Exit.USAGE


def test_bounds(tmp_path: Path) -> None:
    """TOOL-BITS-10: small meshes are left out, rejected ones are named."""
    out = tmp_path / "b.svg"
    meshes = [RING, str(MESHES / "anchor.off"), str(MESHES / "helmet.off")]
    done = clers("bounds", *meshes, "--spheres", "2", "-o", str(out), "--json")
    assert done.exit_code == Exit.CONFORMING
    document = json.loads(done.stdout)
    assert set(document) == {"seed", "spheres", "meshes", "refused"}
    assert {mesh["mesh"] for mesh in document["meshes"]} == {"anchor", "helmet"}
    best = [mesh["best"] for mesh in document["meshes"]]
    assert best == sorted(best, reverse=True)
    helmet = next(mesh for mesh in document["meshes"] if mesh["mesh"] == "helmet")
    weighed = measured("helmet", surface_of("helmet.off"), quiet)
    named = {cost.name: cost.bits_per_triangle for cost in weighed.costs}
    assert helmet["draco"] == named["draco-valence"]
    assert (helmet["golden"], helmet["best"]) == (named["golden"], named[BEST])
    assert out.read_bytes().startswith(b"<?xml")


def test_bounds_for_people(tmp_path: Path) -> None:
    """TOOL-BITS-10."""
    out = tmp_path / "b.png"
    done = clers("bounds", MOEBIUS, "--spheres", "2", "--seed", "3", "-o", str(out))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert done.stdout.startswith("2 random spheres of 100 to 5000 faces, seed 3\n")
    assert "moebius: invalid" in done.stderr
    assert out.read_bytes().startswith(b"\x89PNG")


def test_nothing_to_report() -> None:
    """TOOL-BITS-7."""
    assert report((), quiet).mean_ratio is None
