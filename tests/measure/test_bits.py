"""What is counted, entropies by hand, tables and plots."""

from math import log2
from pathlib import Path
from typing import Final

import numpy as np
import pytest

from clers.cli.loading import mesh_in
from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.container.file import encode as encode_file
from clers.container.file import inspect
from clers.container.options import Options
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TETRAHEDRON, TORUS
from clers.measure.bits.costs import BEST, NAMES, Cost, Kind, Measured, code_bytes, measured
from clers.measure.bits.entropies import degrees, limit, order_entropy, valence_entropy
from clers.measure.bits.plot import figure, png, svg
from clers.measure.bits.report import Refused, Report, geometric_mean
from clers.measure.bits.tables import made_by, mean_line, page, tables

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
RING: Final = str(MESHES / "ring.off")
MOEBIUS: Final = str(MESHES / "dirty" / "moebius.off")


def surface_of(name: str) -> Surface:
    mesh = mesh_in(MESHES / name)
    assert isinstance(mesh, Accepted)
    return mesh.value.surface


def quiet(_: str) -> None:
    """Nobody watches."""


# What is counted


@pytest.mark.parametrize("code", CodeName)
@pytest.mark.parametrize("name", ["ring.off", "eight.off", "cube.ply"])
def test_payloads_of_the_file_without_positions(name: str, code: CodeName) -> None:
    """TOOL-BITS-1: what `inspect` finds in the file that `encode` writes."""
    given = surface_of(name)
    data = encode_file(given, None, Options(code))
    found = code_bytes(given, encode(given), code)
    if isinstance(data, Accepted):
        described = inspect(data.value)
        assert isinstance(described, Accepted)
        framing = 9 + 16 * len(described.value.sections)  # magic, version; tag, length, two seals
        assert found == Accepted(len(data.value) - framing)
    else:
        assert found == data


def test_plain_tetrahedron_by_hand() -> None:
    """TOOL-BITS-1: HEAD has two kinds and five counts, WORD a count and the six bits."""
    assert code_bytes(TETRAHEDRON, encode(TETRAHEDRON), CodeName.PLAIN) == Accepted(7 + 2)


def test_degrees_by_sets_of_edges() -> None:
    """TOOL-BITS-5: closed and with boundary."""
    for name in ("ring.off", "elephant-with-holes.off", "tetrahedron-and-triangle.off"):
        given = surface_of(name)
        edges = {frozenset((a, b)) for t in given.triangles() for a in t for b in t if a != b}
        count = [0] * given.vertices
        for edge in edges:
            for v in edge:
                count[v] += 1
        assert degrees(given) == count


def test_valence_entropy_by_hand() -> None:
    """TOOL-BITS-5: all degrees of the tetrahedron and of Möbius' torus are the same.

    Two triangles on an edge have the degrees 2, 2, 3, 3: one bit a vertex.
    """
    assert valence_entropy(TETRAHEDRON) == 0
    assert valence_entropy(TORUS) == 0
    two = surface(FaceList(((0, 1, 2), (2, 1, 3)), 4))
    assert isinstance(two, Accepted)
    assert valence_entropy(two.value) == pytest.approx(4)


def test_order_entropies_by_hand() -> None:
    """TOOL-BITS-5: after C come C and R alike, after R only R; after two symbols, one each."""
    assert [order_entropy("CCRR", k) for k in range(4)] == pytest.approx([4, 2, 0, 0])
    assert order_entropy("CRCRCRCR", 0) == pytest.approx(8)
    assert order_entropy("CRCRCRCR", 1) == 0
    assert order_entropy("CCCR", 0) == pytest.approx(4 * (0.75 * log2(4 / 3) + 0.25 * 2))
    assert order_entropy("", 3) == 0


def test_limit() -> None:
    """TOOL-BITS-5: Tutte's number, to seven places."""
    assert limit(TETRAHEDRON) == pytest.approx(4 * 1.6225562, abs=1e-6)


def test_ring_beside_draco() -> None:
    """TOOL-BITS-1, -2, -7, -8: each name once, in order; Draco's ring is 17 bytes at both levels.

    Six counts, 4 for an event, the length and 24 bits of symbols, three for the start face.
    """
    told: list[str] = []
    found = measured("ring", surface_of("ring.off"), told.append)
    assert (found.mesh, found.vertices, found.faces) == ("ring", 6, 6)
    assert (found.components, found.genus, found.curves) == (1, 0, 2)
    assert tuple((cost.name, cost.kind) for cost in found.costs) == NAMES
    assert told == [name for name, kind in NAMES if kind is not Kind.MEASURE]
    by_name = {cost.name: cost for cost in found.costs}
    for name in ("draco-standard", "draco-valence"):
        assert by_name[name] == Cost(name, Kind.PEER, 136, 136 / 6, 136 / 6, "")
    best = found.bits(BEST)
    assert best is not None
    assert found.ratio == best / 136
    assert found.bits("none such") is None
    assert by_name["limit"].bits == limit(surface_of("ring.off"))
    word = encode(surface_of("ring.off")).stream.word
    assert by_name["order-0"].bits == order_entropy(word, 0)
    assert by_name["order-5"].bits == order_entropy(word, 5)
    assert by_name["valence-entropy"].bits == valence_entropy(surface_of("ring.off"))


def test_handles_and_parts_are_counted() -> None:
    """TOOL-BITS-8."""
    found = measured("eight", surface_of("eight.off"), quiet)
    assert (found.genus, found.components, found.curves) == (2, 1, 0)
    assert found.bits("draco-standard") == 8 * 186


def test_geometric_mean() -> None:
    """TOOL-BITS-7."""
    assert geometric_mean([0.5, 2.0, 1.0]) == pytest.approx(1)
    assert geometric_mean([4.0, 9.0]) == pytest.approx(6)
    assert geometric_mean([]) is None


# What is printed


def row(mesh: str, ours: float | None, standard: float | None, valence: float | None) -> Measured:
    """A mesh of 4 vertices and 8 faces with these bits of best and Draco, and 16 of the rest."""
    told = {BEST: ours, "draco-standard": standard, "draco-valence": valence}
    whys = {BEST: "unsupported: not-representable here", "draco-standard": "not-obtainable"}
    bits = {name: told.get(name, 16.0) for name, _ in NAMES}
    costs = tuple(
        Cost(name, kind, b, b / 4, b / 8, "")
        if (b := bits[name]) is not None
        else Cost(name, kind, None, None, None, whys.get(name, "not-obtainable"))
        for name, kind in NAMES
    )
    lesser = min((x for x in (standard, valence) if x is not None), default=None)
    ratio = None if ours is None or lesser is None else ours / lesser
    return Measured(mesh, 4, 8, 1, 2, 3, costs, ratio)


def told(*rows: Measured, mean: float | None = None, refused: tuple[Refused, ...] = ()) -> Report:
    packages = {"DracoPy": "2.2.0", "zstandard": "not installed"}
    return Report("0.1", "3.11", "x, 2 cores", "2026-01-02", packages, rows, mean, refused)


def test_tables_by_hand() -> None:
    """TOOL-BITS-6, TOOL-BITS-8: ratios, then each kind per vertex and per triangle."""
    a, b = row("a", 24, 40, 32), row("b", None, None, None)
    found = list(tables(told(a, b, mean=0.75)))
    assert [t.title for t in found] == [
        f"bits of connectivity, and {BEST} divided by Draco's lesser",
        "bits per vertex: codes",
        "bits per triangle: codes",
        "bits per vertex: peers",
        "bits per triangle: peers",
        "bits per vertex: entropies and the limit (no codes)",
        "bits per triangle: entropies and the limit (no codes)",
    ]
    assert found[0].heads == (
        "mesh", "vertices", "faces", "components", "genus", "curves", BEST, "draco", "ratio",
    )  # fmt: skip
    assert found[0].rows == (
        ("a", "4", "8", "1", "2", "3", "24", "32", "0.750"),
        ("b", "4", "8", "1", "2", "3", "–", "–", "–"),
    )
    assert found[1].heads == ("mesh", *CodeName)
    best = 1 + list(CodeName).index(CodeName(BEST))
    assert (found[1].rows[0][best], found[2].rows[0][best]) == ("6.000", "3.000")
    assert found[1].rows[1][best] == "–"
    assert found[3].heads[:3] == ("mesh", "draco-standard", "draco-valence")
    assert found[3].rows[0][:4] == ("a", "10.000", "8.000", "4.000")
    assert found[4].rows[0][:4] == ("a", "5.000", "4.000", "2.000")
    assert found[3].rows[1][:4] == ("b", "not installed", "not installed", "4.000")
    assert found[5].heads[-1] == "limit"


def test_words_on_the_whole() -> None:
    """TOOL-BITS-7, TOOL-BITS-8."""
    some = told(row("a", 24, 40, 32), row("b", None, 40, 32), mean=0.75)
    assert mean_line(some) == "geometric mean of the ratio over 1 meshes: 0.750"
    assert mean_line(told()) == f"no mesh has both {BEST} and Draco"
    assert made_by(some) == (
        "clers 0.1, Python 3.11, x, 2 cores, 2026-01-02; DracoPy 2.2.0, zstandard not installed"
    )


def test_page_by_hand() -> None:
    """TOOL-BITS-9: the command, the versions, the mean, each table, and what was refused."""
    of = told(row("a", 24, 40, 32), mean=0.75, refused=(Refused("c", "invalid: empty-mesh"),))
    lines = page(of, "clers bench bits a.off -o a.md").split("\n")
    assert lines[0] == "# Bits of connectivity, measured"
    assert "    clers bench bits a.off -o a.md" in lines
    assert f"{made_by(of)}." in lines
    assert "Geometric mean of the ratio over 1 meshes: 0.750." in lines
    at = lines.index(f"## Bits of connectivity, and {BEST} divided by Draco's lesser")
    assert lines[at + 1 : at + 6] == [
        "",
        f"| mesh | vertices | faces | components | genus | curves | {BEST} | draco | ratio |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
        "| a | 4 | 8 | 1 | 2 | 3 | 24 | 32 | 0.750 |",
        "",
    ]
    assert sum(line.startswith("## ") for line in lines) == 8
    assert lines[-4:] == ["## Refused", "", "- c: invalid: empty-mesh", ""]
    assert "## Refused" not in page(told(), "command")


def test_dots_of_the_plot() -> None:
    """TOOL-BITS-9: a row for each mesh, the cheapest in `best` highest; bits per vertex across."""
    of = told(row("cheap", 16, 40, 32), row("dear", 24, None, 20))
    (axes,) = figure(of).axes
    assert axes.get_xlim() == (0, 8)
    assert [label.get_text() for label in axes.get_yticklabels()] == ["dear", "cheap"]
    dots = {dots.get_label(): np.asarray(dots.get_offsets()).tolist() for dots in axes.collections}
    assert dots[BEST] == [[6, 0], [4, 1]]
    assert dots["draco-standard"] == [[10, 1]]
    assert dots["draco-valence"] == [[5, 0], [8, 1]]
    assert dots["limit"] == [[4, 0], [4, 1]]


def test_plots_show_every_mesh_and_code() -> None:
    """TOOL-BITS-9: names stand in the SVG as text; the same bytes each time; a PNG is one."""
    of = told(row("first", 24, 40, 32), row("second", None, None, 16))
    drawing = svg(figure(of))
    assert drawing == svg(figure(of))
    text = drawing.decode()
    left_out = {"zlib", "zstd", "lzma", *(f"order-{k}" for k in range(6))}
    for name in ["first", "second", *(name for name, _ in NAMES if name not in left_out)]:
        assert f">{name}<" in text
    for name in left_out:
        assert f">{name}<" not in text
    assert png(figure(of)).startswith(b"\x89PNG")
