"""Speeds by hand: spreads, rates, steps, ratios, slopes, families; tables, the page, the plot."""

from pathlib import Path
from typing import Final

import numpy as np
import pytest

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface, surface_of_indices
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.encode import encode
from clers.generate.families import sphere_of
from clers.kernels import COMPILED
from clers.measure.clock import Spent, Spread, now, spread
from clers.measure.path import must, timed_path
from clers.measure.speed import report as reporting
from clers.measure.speed.contender import Attempt, Contender, Given, Kind, Reading, Way
from clers.measure.speed.contender import given as given_as
from clers.measure.speed.memory import Memory, memory
from clers.measure.speed.ours import CODES, OURS, STEPS, whole
from clers.measure.speed.plot import apart, figure, largest, points
from clers.measure.speed.rates import Rate, rate, rates, sampled
from clers.measure.speed.report import (
    Machine,
    OnMesh,
    Ratio,
    Speed,
    on_mesh,
    processor,
    ratios,
    spheres,
    steps_of,
)
from clers.measure.speed.slopes import FAMILIES, Slope, rounds_at, sizes, slope, slopes
from clers.measure.speed.tables import made_by, page, refused_lines, tables


def given(name: str = "sphere", faces: int = 8) -> Given:
    return given_as(name, must(surface(sphere_of(faces))))


def quiet(_: str) -> None:
    """Nobody watches."""


# Readings


def test_spread_and_clocks() -> None:
    """TOOL-SPEED-2: the median, the least, the greatest; both clocks go on."""
    assert spread([3, 1, 2]) == Spread(2, 1, 3)
    assert spread([1, 2]) == Spread(1.5, 1, 2)
    start = now()
    sum(range(200_000))
    spent = now() - start
    assert spent.wall > 0
    assert spent.cpu > 0
    assert Spent(3, 2) - Spent(1, 0.5) == Spent(2, 1.5)


def test_a_rate_by_hand() -> None:
    """TOOL-SPEED-2: triangles per second of processor time; none where the clock stood still."""
    spent = [Spent(8, 4), Spent(1, 1), Spent(3, 2)]
    assert rate("a", Kind.CODE, Way.ENCODE, spent, 8, 5) == Rate(
        "a", Kind.CODE, Way.ENCODE, 5, Spread(4, 2, 8), Spread(2, 1, 4), Spread(3, 1, 8)
    )
    still = rate("a", Kind.CODE, Way.ENCODE, [Spent(1, 0)], 8, None)
    assert still.triangles_per_second == Spread(0, 0, 0)


class Scripted:
    """A contender that takes what it is told to, and writes down when it is asked."""

    def __init__(self, name: str, kind: Kind, told: list[tuple[Reading, ...]]) -> None:
        self.name, self.kind, self.told = name, kind, iter(told)

    def contender(self, order: list[str]) -> Contender:
        def attempt() -> Accepted[tuple[Reading, ...]]:
            order.append(self.name)
            return Accepted(next(self.told))

        return Contender(self.name, self.kind, lambda _: Accepted(attempt))


REFUSED: Final = Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_SPEED_4, detail="x")


def test_contenders_take_turns() -> None:
    """TOOL-SPEED-2: each once a round; who refuses is told of, before or at the attempt."""
    order: list[str] = []
    steps: list[str] = []

    def reading(name: str, cpu: float) -> tuple[Reading, ...]:
        return (Reading(name, Way.ENCODE, Spent(cpu, cpu), 7),)

    def fails() -> Rejected:
        return REFUSED

    def late(_: Given) -> Accepted[Attempt]:
        return Accepted(fails)

    found = sampled(
        given(),
        (
            Scripted("a", Kind.CODE, [reading("a", 1), reading("a", 2)]).contender(order),
            Contender("never", Kind.PEER, lambda _: REFUSED),
            Contender("late", Kind.PEER, late),
            Scripted("b", Kind.PEER, [reading("b", 4), reading("b", 8)]).contender(order),
        ),
        2,
        steps.append,
    )
    assert order == ["a", "b", "a", "b"]
    assert steps == ["sphere, a", "sphere, late", "sphere, b"] * 2
    assert found.refused == {"never": REFUSED.line(), "late": REFUSED.line()}
    assert found.kinds == {"a": Kind.CODE, "b": Kind.PEER}
    assert [(r.name, r.kind, r.cpu.median, r.bytes) for r in rates(found, 8)] == [
        ("a", Kind.CODE, 1.5, 7),
        ("b", Kind.PEER, 6, 7),
    ]


def test_our_codes() -> None:
    """TOOL-SPEED-1, TOOL-SPEED-3: whole ways and steps, by the names that they go by."""
    found = sampled(given(), OURS, 1, quiet)
    assert found.refused == {}
    expected = [(str(code), way) for code in CODES for way in Way]
    expected += [(f"{code}: {step}", way) for code in CODES for step, way in STEPS.items()]
    assert {key: len(of) for key, of in found.readings.items()} == dict.fromkeys(expected, 1)
    assert CODES == (CodeName.GOLDEN, CodeName.BEST)
    for code in CODES:
        (there,), (back,) = found.readings[code, Way.ENCODE], found.readings[code, Way.DECODE]
        assert there.bytes is not None
        assert there.bytes > 40
        assert back.bytes is None
        assert min(there.spent.wall, back.spent.wall) > 0


def test_a_surface_that_comes_back_changed() -> None:
    """TOOL-SPEED-1: another number of faces is no result."""
    other = given(faces=32)
    swapped = Given("swapped", given().indices, other.surface)
    refused = sampled(swapped, [whole(CodeName.GOLDEN)], 1, quiet).refused
    told = Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_SPEED_1, detail="swapped")
    assert refused == {"golden": told.line()}


def test_the_path_is_timed_step_by_step() -> None:
    """TOOL-SPEED-3: the first steps are those that are taken apart."""
    timed = list(timed_path(given().indices, CodeName.BEST))
    assert [each.step for each in timed][: len(STEPS)] == list(STEPS)
    assert [each.step for each in timed][len(STEPS) :] == ["write file", "read file"]
    assert all(each.spent.wall > 0 for each in timed)


def scripted_path() -> list[Contender]:
    """Two rounds of a code of 10 and 20 seconds, whose steps take 4 and 3, then 6 and 4."""

    def whole_way(there: float, back: float) -> tuple[Reading, ...]:
        return (
            Reading("golden", Way.ENCODE, Spent(there, there), 12),
            Reading("golden", Way.DECODE, Spent(back, back)),
        )

    def parts(surface: float, walk: float, back: float) -> tuple[Reading, ...]:
        return (
            Reading("golden: surface", Way.ENCODE, Spent(surface, surface)),
            Reading("golden: walk", Way.ENCODE, Spent(walk, walk)),
            Reading("golden: decode walk", Way.DECODE, Spent(back, back)),
        )

    def peer(there: float) -> tuple[Reading, ...]:
        return (Reading("peer", Way.ENCODE, Spent(there, there), 24),)

    order: list[str] = []
    return [
        Scripted("golden", Kind.CODE, [whole_way(10, 5), whole_way(20, 7)]).contender(order),
        Scripted("s", Kind.STEP, [parts(4, 3, 2), parts(6, 4, 1)]).contender(order),
        Scripted("peer", Kind.PEER, [peer(30), peer(60)]).contender(order),
    ]


def test_the_rest_and_ratios(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-3, TOOL-SPEED-4: round by round what steps leave; a peer's time by ours."""
    monkeypatch.setattr(reporting, "memory", lambda _, code: Memory(code, 1, 2, 3))
    steps: list[str] = []
    found = on_mesh(given(), scripted_path(), 2, steps.append)
    there = found.find("golden: container", Way.ENCODE)
    back = found.find("golden: decode container", Way.DECODE)
    assert there is not None
    assert back is not None
    assert there.cpu == Spread(6.5, 3, 10)  # 10 − 4 − 3 and 20 − 6 − 4
    assert back.cpu == Spread(4.5, 3, 6)
    assert (there.kind, there.bytes) == (Kind.STEP, None)
    assert found.ratios == (Ratio("golden", "peer", Way.ENCODE, 3.0),)
    assert found.bytes_per_vertex("golden") == 2
    assert found.bytes_per_vertex("peer") == 4
    assert found.bytes_per_vertex("golden: walk") is None
    assert found.bytes_per_vertex("nobody") is None
    assert found.memory == tuple(Memory(code, 1, 2, 3) for code in CODES)
    assert steps[-2:] == ["sphere, memory of golden", "sphere, memory of best"]


def test_no_ratio_to_a_clock_that_stood_still() -> None:
    """TOOL-SPEED-4."""
    still = rate("golden", Kind.CODE, Way.ENCODE, [Spent(1, 0)], 8, 1)
    peer = rate("peer", Kind.PEER, Way.ENCODE, [Spent(1, 1)], 8, 1)
    assert list(ratios([still, peer])) == []


def test_memory_of_processes() -> None:
    """TOOL-SPEED-6: the indices take twelve bytes, in pages; corners eight, kept twice."""
    found = memory(given(faces=200_000), CodeName.GOLDEN)
    assert found.code == "golden"
    assert 10 < found.index_list < 30
    assert 48 < found.encode < 200
    assert 48 < found.decode < 200


# Growth


def test_slope_by_hand() -> None:
    """TOOL-SPEED-5: 1 for a line, 2 for a square; time per triangle, last by first, at worst."""
    line = slope("f", "golden", Way.ENCODE, [(10, 1.0), (100, 10.0), (1000, 100.0)])
    assert line.slope == pytest.approx(1)
    assert line.ratio == pytest.approx(1)
    assert line.worst == pytest.approx(1)
    square = slope("f", "golden", Way.DECODE, [(10, 1.0), (100, 100.0)])
    assert (square.family, square.name, square.way) == ("f", "golden", Way.DECODE)
    assert (square.faces, square.seconds_per_triangle) == ((10, 100), (0.1, 1.0))
    assert square.slope == pytest.approx(2)
    assert square.ratio == pytest.approx(10)
    assert square.worst == pytest.approx(10)
    dip = slope("f", "golden", Way.DECODE, [(1, 4.0), (10, 10.0), (100, 300.0), (1000, 2000.0)])
    assert dip.ratio == pytest.approx(0.5)
    assert dip.worst == pytest.approx(3)


@pytest.mark.parametrize("faces", [100, 2000])
def test_families_are_what_they_are_called(faces: int) -> None:
    """TOOL-SPEED-5: about so many faces; words and topology as promised."""
    made = {name: make(faces) for name, make in FAMILIES.items()}
    for mesh in made.values():
        assert 0.9 * faces <= mesh.faces <= 1.5 * faces
    built = {name: must(surface_of_indices(mesh)) for name, mesh in made.items()}
    words = {name: encode(each).stream.word for name, each in built.items()}
    assert words["nested S"].count("S") == faces // 4
    half = faces // 2
    assert "C" * (half - 4) in words["one run of C"]
    parts = {name: components(each) for name, each in built.items()}
    assert sum(part.genus for part in parts["handles"]) == max(faces // 102, 1)
    assert len(parts["components"]) == faces // 8
    assert sum(part.curves for part in parts["curves"]) == faces // 100
    assert made["irregular, shuffled"] != made["irregular sphere"]
    assert parts["irregular, shuffled"] == parts["irregular sphere"]


def test_sizes_and_spheres() -> None:
    """TOOL-SPEED-1, TOOL-SPEED-5: tenths, and never too small to be made."""
    assert sizes(4_000_000) == (10_000, 100_000, 1_000_000, 4_000_000)
    assert sizes(1_000_000) == (10_000, 100_000, 1_000_000)
    assert sizes(10_001) == (10_000, 10_001)
    assert sizes(10_000) == (1000, 10_000)
    assert sizes(500) == (100, 500)
    found = list(spheres(2001))
    assert [(each.name, each.surface.faces) for each in found] == [
        ("sphere-200", 200), ("sphere-2000", 2000),
    ]  # fmt: skip
    assert all(each.surface == must(surface_of_indices(each.indices)) for each in found)


def test_every_family_at_every_size() -> None:
    """TOOL-SPEED-5: a row for each family, code and way."""
    steps: list[str] = []
    found = slopes((200, 400), [whole(CodeName.GOLDEN)], 1, steps.append)
    assert [(row.family, row.way) for row in found] == [
        (family, way) for family in FAMILIES for way in Way
    ]
    assert all(len(row.faces) == 2 for row in found)
    assert len(steps) == 2 * len(FAMILIES)


def test_small_meshes_are_coded_more_often(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-5: up to a tenth of the greatest size ten times; then the least time counts."""
    assert [rounds_at(size, 1000, 3) for size in (99, 100, 101, 1000)] == [30, 30, 3, 3]
    one = {"nested S": FAMILIES["nested S"]}
    monkeypatch.setattr("clers.measure.speed.slopes.FAMILIES", one)
    seconds = [*range(40, 10, -1), 60, 50, 70]
    told: list[tuple[Reading, ...]] = [
        (Reading("a", Way.ENCODE, Spent(cpu + 1, cpu)),) for cpu in seconds
    ]
    order: list[str] = []
    (found,) = slopes((100, 1000), [Scripted("a", Kind.CODE, told).contender(order)], 3, quiet)
    assert len(order) == 30 + 3
    assert found.faces == (104, 1004)
    assert found.seconds_per_triangle == pytest.approx((11 / 104, 50 / 1004))


# What is printed


MACHINE: Final = Machine(
    "0.1.0", "3.11.7", "compiled", "a processor", 2, "Linux x86_64", "2026-11-22",
    {"DracoPy": "2.2.0", "zstandard": "not installed"}, (0.5, 1.25),
)  # fmt: skip


def flat(name: str, kind: Kind, way: Way, cpu: float, size: int | None) -> Rate:
    return rate(name, kind, way, [Spent(2 * cpu, cpu)], 8, size)


def told(*more: OnMesh) -> Speed:
    timed = (
        flat("golden", Kind.CODE, Way.ENCODE, 4e-6, 12),
        flat("golden", Kind.CODE, Way.DECODE, 2e-6, None),
        flat("peer", Kind.PEER, Way.ENCODE, 8e-6, 24),
        flat("golden: walk", Kind.STEP, Way.ENCODE, 1e-6, None),
    )
    mesh = OnMesh(
        "m", 6, 8, timed, (Ratio("golden", "peer", Way.ENCODE, 2.0),), {"zstd": "why"},
        (Memory("golden", 100.4, 50, 25),),
    )  # fmt: skip
    row = Slope("nested S", "golden", Way.ENCODE, (10, 100), (2e-6, 3e-6), 1.176, 1.5, 1.6)
    return Speed(MACHINE, 3, (mesh, *more), (row,))


def test_tables_by_hand() -> None:
    """TOOL-SPEED-7."""
    speeds, against, steps, most, growth = tables(told())
    assert speeds.title == "m: million triangles a second (8 triangles)"
    assert speeds.rows == (
        ("golden", "2.000", "2.00", "2.00 … 2.00", "1.00", "4.00", "4.00 … 4.00", "2.00"),
        ("peer", "4.000", "1.00", "1.00 … 1.00", "0.50", "–", "–", "–"),
    )
    assert against.heads == (
        "peer", "golden, encode", "golden, decode", "best, encode", "best, decode",
    )  # fmt: skip
    assert against.rows == (("peer", "2.00", "–", "–", "–"),)
    assert steps.rows == (("golden: walk", "0.125", "0.125 … 0.125", "0.250"),)
    assert most.rows == (("m", "golden", "100", "50", "25"),)
    assert growth.heads[3:5] == ("at 10", "at 100")
    assert growth.rows == (
        ("nested S", "golden", "encode", "2.000", "3.000", "1.176", "1.50", "1.60"),
    )
    for each in tables(told()):
        assert {len(row) for row in each.rows} == {len(each.heads)}


def test_page_by_hand() -> None:
    """TOOL-SPEED-7, TOOL-SPEED-8: the command, the machine, each table, who was not measured."""
    assert made_by(MACHINE, 3) == (
        "clers 0.1.0, kernels compiled; Python 3.11.7; a processor, 2 cores, Linux x86_64; "
        "2026-11-22; rounds: 3; load at begin and end: 0.50 and 1.25; "
        "DracoPy 2.2.0, zstandard not installed"
    )
    text = page(told(), "clers bench speed -o a.md")
    assert "\n    clers bench speed -o a.md\n" in text
    assert f"{made_by(MACHINE, 3)}.\n" in text
    assert "| peer | 2.00 | – | – | – |" in text
    assert text.count("\n## ") == 6
    assert refused_lines(told()) == ["m: zstd: why"]
    assert text.endswith("## Not measured\n\n- m: zstd: why\n")


def test_plot_of_the_largest_mesh() -> None:
    """TOOL-SPEED-8: a panel for each way; a named point for each coder with both numbers."""
    small = OnMesh("small", 4, 4, (), (), {}, ())
    of = told(small)
    assert largest(of).mesh == "m"
    shown = list(points(of.meshes[0], Way.ENCODE))
    assert [(name, kind) for name, kind, _, _ in shown] == [
        ("golden", Kind.CODE), ("peer", Kind.PEER),
    ]  # fmt: skip
    numbers = [number for _, _, across, upward in shown for number in (across, upward)]
    assert numbers == pytest.approx([2, 2, 4, 1])
    left, right = figure(of).axes
    assert (left.get_xscale(), left.get_yscale()) == ("log", "log")
    assert (left.get_title(), right.get_title()) == ("encode", "decode")
    assert [text.get_text() for text in left.texts] == ["golden", "peer"]
    dots = [np.asarray(dots.get_offsets()).tolist() for dots in left.collections]
    assert dots == [[[2, pytest.approx(2)]], [[4, pytest.approx(1)]]]
    assert [text.get_text() for text in right.texts] == ["golden"]
    empty = figure(Speed(MACHINE, 1, (small,), ()))
    assert all(not axes.texts for axes in empty.axes)


def test_names_of_points_stand_apart() -> None:
    """TOOL-SPEED-8: in their order, each at its point or above it."""
    heights = [1.0, 100.0, 1.01, 1.02]
    stand = apart(heights)
    assert stand[0] == 1
    assert stand[1] == 100
    assert 1.15 < stand[2] / stand[0] < 1.3
    assert stand[3] / stand[2] == pytest.approx(stand[2] / stand[0])


def test_the_machine(tmp_path: Path) -> None:
    """TOOL-SPEED-7: the processor by the system's file, or as Python knows it."""
    (tmp_path / "cpu").write_text("vendor_id : x\nmodel name\t: One, Fast\nmodel name\t: Two\n")
    assert processor(tmp_path / "cpu") == "One, Fast"
    assert processor(tmp_path / "none")
    (tmp_path / "cpu").write_text("nothing here\n")
    assert processor(tmp_path / "cpu") == processor(tmp_path / "none")
    found = reporting.machine((1.0,))
    assert found.kernels == ("compiled" if COMPILED else "interpreted")
    assert set(found.packages) == {"DracoPy", "librt", "meshoptimizer", "numpy", "zstandard"}
    assert found.load == (1.0,)
    assert found.cores >= 1


def test_every_step_is_foretold(monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-SPEED-2: as many steps as the progress bar was told of."""
    monkeypatch.setattr(reporting, "memory", lambda _, code: Memory(code, 1, 2, 3))
    families = {name: FAMILIES[name] for name in ("nested S", "curves")}
    for module in ("report", "slopes"):
        monkeypatch.setattr(f"clers.measure.speed.{module}.FAMILIES", families)
    steps: list[str] = []
    found = reporting.measure([given("t")], 1000, 1, steps.append)
    assert len(steps) == steps_of(1, 1000, 1)
    assert (found.rounds, [each.mesh for each in found.meshes]) == (1, ["t"])
    assert len(found.slopes) == 2 * len(CODES) * len(families)
