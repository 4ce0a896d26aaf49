"""The survey of other codecs: what is found, how small, and the page in the repository."""

import json
import re
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Difference, Kind
from clers.conformance.messages import Rejection
from clers.conformance.outcome import (
    Answered,
    Crash,
    Declined,
    Erred,
    Flaky,
    NoProcess,
    Outcome,
    ProtocolError,
    TimedOut,
    Unsupported,
)
from clers.conventions.reason import Fault
from clers.oracle.codecs import survey as survey_module
from clers.oracle.codecs.asking import Became, became
from clers.oracle.codecs.given import files_of, in_files
from clers.oracle.codecs.made import by_hand, loose, on_curve, placed
from clers.oracle.codecs.page import cells, page
from clers.oracle.codecs.remarks import REMARKS, UNKNOWN, remark
from clers.oracle.codecs.settings import SETTINGS
from clers.oracle.codecs.smallest import smallest
from clers.oracle.codecs.survey import Row, Shown, Survey, installed, steps_of, survey

ROOT: Final = Path(__file__).parents[2]
MESHES: Final = ROOT / "corpus" / "meshes"
PAGE: Final = (ROOT / "corpus" / "findings.md").read_text(encoding="utf-8")
SUFFIXES: Final = (".ply", ".off", ".obj", ".stl")
SOLID: Final = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
EXACT: Final = (0.0, 0.0, 0.0)


def test_page_is_what_the_command_prints() -> None:
    """ORCL-CODEC-15: the rows of all but the large meshes, and every smallest mesh."""
    meshes, left = in_files(files_of([MESHES, MESHES / "dirty"], SUFFIXES))
    few = [(name, mesh) for name, mesh in meshes if len(mesh.faces) < 500]
    found = survey((*few, *by_hand(), *loose()), left, SETTINGS, lambda _: None)
    assert found.missing == ()
    printed = page(found, "clers bench codecs corpus/meshes corpus/meshes/dirty -o page.md")
    mine, theirs = _parts(printed), _parts(PAGE)
    assert mine["table"] <= theirs["table"]
    assert len(mine["table"]) > 40
    assert {line.split(" | ")[0][2:] for line in theirs["table"] - mine["table"]} == {
        name for name, mesh in meshes if len(mesh.faces) >= 500
    }
    assert mine["rest"] == theirs["rest"]


def _parts(text: str) -> dict[str, frozenset[str]]:
    """The table of meshes by lines; and all else, without how many meshes show a difference."""
    head, table, rest = re.split(r"^## (?:Meshes|Differences)", text, flags=re.MULTILINE)
    lines = [re.sub(r"^On .* of \d+ meshes", "On", line) for line in rest.splitlines()]
    keep = [line for line in head.splitlines() if not line.startswith("    clers bench")]
    return {
        "table": frozenset(line for line in table.splitlines() if line.startswith("| ")),
        "rest": frozenset(enumerate_lines(keep + lines)),
    }


def enumerate_lines(lines: list[str]) -> list[str]:
    return [f"{k} {line}" for k, line in enumerate(lines)]


def test_large_meshes_of_the_page() -> None:
    """ORCL-CODEC-15: their rows say what all three packages were asked."""
    rows = [line for line in PAGE.splitlines() if line.startswith("| b9.off |")]
    assert rows == ["| b9.off | 5951 | 10174 | = | = | = | = | = | = |"]


# smallest meshes


def test_smallest_of_many_faces() -> None:
    """ORCL-CODEC-14: two faces on one edge, from a strip of fifty."""
    strip = tuple((k, k + 1, k + 2) for k in range(50))
    asked: list[form.MeshForm] = []

    def shows(mesh: form.MeshForm) -> bool:
        asked.append(mesh)
        edges = [frozenset((a, b)) for x, y, z in mesh.faces for a, b in ((x, y), (y, z), (z, x))]
        return any(edges.count(edge) > 1 and len(edge) == 2 for edge in edges)

    found = smallest(placed(strip, on_curve(60)), shows)
    assert found == placed(((0, 0, 1),), on_curve(2))
    assert len(asked) < 300


@pytest.mark.parametrize(
    ("shows", "faces", "vertices"),
    [
        (lambda mesh: len(mesh.faces) >= 2, ((0, 0, 0), (0, 0, 0)), 1),
        (lambda mesh: int(mesh.vertices) >= 3, (), 3),
        (lambda mesh: len(set(_corners(mesh))) >= 4, ((0, 1, 2), (1, 3, 2)), 4),
        (lambda _: True, (), 0),
    ],
)
def test_smallest(
    shows: Callable[[form.MeshForm], bool], faces: tuple[tuple[int, int, int], ...], vertices: int
) -> None:
    """ORCL-CODEC-14: faces, vertices without faces, and vertices that can be one all go."""
    strip = tuple((k, k + 1, k + 2) if k % 2 == 0 else (k, k + 2, k + 1) for k in range(9))
    found = smallest(placed(strip, on_curve(13)), shows)
    assert len(found.faces) == len(faces)
    assert int(found.vertices) == vertices
    assert len(set(_corners(found))) == len({v for face in faces for v in face})


def _corners(mesh: form.MeshForm) -> list[int]:
    return [int(v) for face in mesh.faces for v in face]


def test_vertices_without_faces_go_at_once() -> None:
    """ORCL-CODEC-14: all of them with one question, if they all can."""
    asked: list[int] = []

    def shows(mesh: form.MeshForm) -> bool:
        asked.append(int(mesh.vertices))
        return len(mesh.faces) == 1 and len(set(_corners(mesh))) == 3

    assert int(smallest(placed(((0, 1, 2),), on_curve(500)), shows).vertices) == 3
    assert asked[:3] == [500, 3, 2]
    assert len(asked) < 12


def test_smallest_keeps_places_together() -> None:
    """ORCL-CODEC-14: places become simple, equal ones still equal; names go by the faces."""

    def shows(mesh: form.MeshForm) -> bool:
        if not isinstance(mesh.positions, form.Places) or len(mesh.faces) != 1:
            return False
        at = mesh.positions.coordinates
        used = [at[3 * v : 3 * v + 3] for v in _corners(mesh)]
        return len(set(_corners(mesh))) == 3 and len(set(used)) == 2

    far = ((7.5, 1.0, 2.0), (9.0, 9.0, 9.0), (7.5, 1.0, 2.0), (4.0, 4.0, 4.0))
    found = smallest(placed(((3, 2, 0), (0, 1, 3)), far), shows)
    assert found.faces == ((0, 1, 2),)
    assert isinstance(found.positions, form.Places)
    places = found.positions.coordinates
    assert sorted({places[0:3], places[3:6], places[6:9]}) == [(0.0, 0.0, 0.0), (1.0, 1.0, 0.0)]


def test_smallest_gives_up() -> None:
    """ORCL-CODEC-14: after so many questions it is left as it is."""
    asked: list[int] = []

    def shows(mesh: form.MeshForm) -> bool:
        asked.append(len(mesh.faces))
        return len(mesh.faces) > 2

    strip = tuple((k, k + 1, k + 2) for k in range(64))
    found = smallest(placed(strip, on_curve(66)), shows, 5)
    assert len(asked) == 5
    assert len(found.faces) == min(faces for faces in asked if faces > 2)


# what became of a mesh


@pytest.mark.parametrize(
    ("outcome", "word", "why"),
    [
        (Declined(Rejection(Fault.INVALID, "empty-mesh", detail="no")), "refused", "no"),
        (Declined(Rejection(Fault.INVALID, "empty-mesh")), "refused", "empty-mesh"),
        (Unsupported("error"), "unsupported", "error"),
        (Crash(-11, ""), "crash", "crash: "),
        (TimedOut(5.0, ""), "time-out", ""),
        (Erred("broken"), "error", "error: broken"),
        (ProtocolError("a line", "", ""), "error", ""),
        (NoProcess("gone"), "error", ""),
        (Answered({}), "error", ""),
        (Flaky(Crash(1, ""), Answered({})), "error", ""),
    ],
)
def test_what_became_of_a_mesh(outcome: Outcome, word: str, why: str) -> None:
    """ORCL-CODEC-14: every outcome has its word."""
    found = became(placed(SOLID, on_curve(4)), outcome, EXACT)
    assert found.word == word
    assert found.why.startswith(why)
    assert found.came is None
    quiet = word in ("refused", "unsupported")
    assert found.findings == (frozenset() if quiet else frozenset((word,)))


def test_what_came_back() -> None:
    """ORCL-CODEC-14: within the error or not; undecided too."""
    sent, less = placed(SOLID, on_curve(4)), placed(SOLID[1:], on_curve(4))
    same = became(sent, Answered(sent), EXACT)
    assert same == Became("same", came=sent)
    assert same.findings == frozenset()
    lost = became(sent, Answered(less), EXACT)
    assert (lost.word, lost.came, lost.findings) == ("different", less, frozenset(("faces-lost",)))
    assert lost.why == "faces-lost, 1, first at face 0 of the mesh sent: face (0, 1, 2)"
    near = tuple((x + 0.25, y, z) for x, y, z in on_curve(4))
    assert became(sent, Answered(placed(SOLID, near)), (0.25, 0.0, 0.0)).word == "same"
    assert became(sent, Answered(placed(SOLID, near)), EXACT).word == "different"
    many = form.MeshForm(faces=(), vertices=1 << 40)
    assert became(sent, Answered(many), EXACT).word == "undecided"


def test_meshes_that_show_little_beside_come_first(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-14: the smallest mesh is made of one that shows the difference alone."""
    two = placed(((0, 1, 2), (0, 0, 1)), on_curve(3))
    alone = placed((*SOLID, (0, 0, 1)), on_curve(4))
    answers = {
        2: Became("different", differences=(_one(Kind.MERGED), _one(Kind.SPLIT))),
        5: Became("different", differences=(_one(Kind.SPLIT),)),
    }

    def asking(*_: object) -> Callable[[form.MeshForm], Became]:
        return lambda mesh: answers.get(len(mesh.faces), Became("same"))

    monkeypatch.setattr(survey_module, "asking", asking)
    steps: list[str] = []
    found = survey([("two", two), ("alone", alone)], [("x", "y")], SETTINGS[:1], steps.append)
    assert steps == ["draco-sequential, two", "draco-sequential, alone"]
    assert steps_of([("two", two), ("alone", alone)], SETTINGS[:1]) == 2
    assert [(s.finding, s.meshes, len(s.smallest.faces)) for s in found.shown] == [
        ("vertices-merged", ("two",), 2),
        ("vertices-split", ("two", "alone"), 5),
    ]
    assert found.left_out == (("x", "y"),)
    assert found.commands == ("clers adapter draco --method sequential",)
    assert [(row.mesh, row.vertices, row.faces) for row in found.rows] == [
        ("two", 3, 2), ("alone", 4, 5),
    ]  # fmt: skip


def _one(kind: Kind) -> Difference:
    return Difference(kind, 1)


def test_packages_that_are_not_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-14, ORCL-CODEC-15: they are named and not asked."""
    versions = {"DracoPy": "1"}

    def version(name: str) -> str:
        if name in versions:
            return versions[name]
        raise PackageNotFoundError

    monkeypatch.setattr(survey_module, "version", version)
    assert installed(SETTINGS) == {"DracoPy": "1"}
    monkeypatch.setattr(survey_module, "asking", lambda *_: lambda _: Became("same"))
    found = survey([("a", placed(SOLID, on_curve(4)))], [], SETTINGS, lambda _: None)
    assert found.missing == ("meshopt-triangles", "meshopt-sequence")
    assert "Not installed, so not asked: meshopt-triangles, meshopt-sequence." in page(found, "x")
    assert all(len(row.became) == 4 for row in found.rows)
    assert steps_of([("a", placed((), ()))], SETTINGS) == 4


# settings and meshes


def test_settings_promise() -> None:
    """ORCL-CODEC-14, ORCL-CODEC-11: exact, or half a step of 11 bits."""
    by_name = {setting.name: setting for setting in SETTINGS}
    long = placed((), ((0.0, 0.0, 0.0), (1.0, 0.0, 2047.0)))
    exact = [s.allowed(long) for s in SETTINGS if s.name != "draco-standard-11-bits"]
    assert exact == [EXACT] * 5
    bound = by_name["draco-standard-11-bits"].allowed(long)
    assert bound == pytest.approx((0.5, 0.5, 0.5), rel=1e-2)
    assert by_name["draco-standard-11-bits"].allowed(form.MeshForm(faces=(), vertices=1)) == EXACT
    assert by_name["draco-valence"].command[-3:] == ("draco", "--method", "edgebreaker-valence")


def test_made_meshes() -> None:
    """ORCL-CODEC-14: each with its own name, the same each time, and of many kinds."""
    hand, any_ones = list(by_hand()), list(loose())
    assert len(any_ones) == 60
    assert (hand, any_ones) == (list(by_hand()), list(loose()))
    names = [name for name, _ in (*hand, *any_ones)]
    assert len(set(names)) == len(names)
    for _, mesh in (*hand, *any_ones):
        assert isinstance(mesh.positions, form.Places)
        assert len(mesh.positions.coordinates) == 3 * int(mesh.vertices)
        assert all(0 <= v < int(mesh.vertices) for v in _corners(mesh))
    assert len({(mesh.faces, mesh.positions) for _, mesh in any_ones}) == 60
    crowded = [_coinciding(mesh) for _, mesh in any_ones]
    assert 5 < sum(crowded) < 55
    signed = dict(hand)["two triangles, at 0 and at −0"]
    assert isinstance(signed.positions, form.Places)
    assert str(signed.positions.coordinates[9:12]) == "(-0.0, -0.0, -0.0)"


def _coinciding(mesh: form.MeshForm) -> bool:
    assert isinstance(mesh.positions, form.Places)
    at = mesh.positions.coordinates
    return len(set(zip(at[0::3], at[1::3], at[2::3], strict=True))) < int(mesh.vertices)


def test_meshes_of_files(tmp_path: Path) -> None:
    """ORCL-CODEC-14: as they stand there, in binary32; what cannot be sent is left out."""
    fine = tmp_path / "fine.off"
    fine.write_text("OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 0 1\n")
    (tmp_path / "far.off").write_text("OFF\n1 0 0\n1e300 0 0\n")
    (tmp_path / "bad.off").write_text("OFF\n")
    (tmp_path / "notes.txt").write_text("")
    files = files_of([tmp_path, fine], SUFFIXES)
    assert [file.name for file in files] == ["bad.off", "far.off", "fine.off", "fine.off"]
    meshes, left = in_files(files[:3])
    assert [name for name, _ in meshes] == ["fine.off"]
    mesh = meshes[0][1]
    assert (mesh.faces, mesh.vertices) == (((0, 0, 1),), 3)
    assert mesh.positions == form.Places(
        precision="f32",
        coordinates=(0.10000000149011612, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    )
    assert [name for name, _ in left] == ["bad.off", "far.off"]
    assert left[0][1].startswith("malformed: unreadable-file")
    assert left[1][1] == "a coordinate is no finite binary32 value"


# the page


def test_remarks() -> None:
    """ORCL-CODEC-15: by setting, then by codec; else that nothing is known."""
    assert remark("draco-valence", "vertices-split") == REMARKS["draco", "vertices-split"]
    merged = remark("draco-sequential", "vertices-merged")
    assert merged == REMARKS["draco-sequential", "vertices-merged"]
    assert merged != remark("draco-standard", "vertices-merged")
    assert remark("meshopt-triangles", "vertices-split") == UNKNOWN


def small_survey() -> Survey:
    less = placed(((0, 1, 2),), on_curve(3))
    lost = Became("different", "x", (_one(Kind.SPLIT), Difference(Kind.MOVED, 7)), less)
    broken = Became("crash", "crash: exit code 3")
    rows = (
        Row("first", 4, 4, (Became("same"), lost)),
        Row("second", 1, 0, (Became("refused", "empty"), broken)),
        Row("loose triples 0", 1, 0, (Became("same"), Became("same"))),
        Row("loose triples 1", 1, 0, (Became("refused", "empty"), Became("same"))),
    )
    shown = (
        Shown("meshopt-x", "vertices-split", ("first",), placed(SOLID, on_curve(4)), lost),
        Shown("meshopt-x", "crash", ("second",), placed((), on_curve(1)), broken),
    )
    return Survey(
        "0", {"DracoPy": "1"}, ("good", "meshopt-x"), ("clers adapter good", "clers adapter x"),
        (), rows, shown, (("a.off", "torn"),),
    )  # fmt: skip


def test_page_of_a_small_survey() -> None:
    """ORCL-CODEC-15: every part of it."""
    text = page(small_survey(), "clers bench codecs x")
    assert "\n    clers bench codecs x\n\nclers 0; DracoPy 1.\n" in text
    assert "\n| good | `clers adapter good` |\n| meshopt-x | `clers adapter x` |\n" in text
    assert "\n| mesh | vertices | faces | good | meshopt-x |\n" in text
    assert "\n| first | 4 | 4 | = | vertices-split 1, position-moved 7 |\n" in text
    assert "\n| second | 1 | 0 | refused | crash |\n" in text
    assert "\n| 2 meshes of loose triples |  |  | refused 1, same 1 | same 2 |\n" in text
    assert "\nNone was found on `good`.\n" in text
    assert f"### `vertices-split`: meshopt-x\n\nOn 1 of 4 meshes. {UNKNOWN}\n" in text
    assert (
        "sent\n  vertex 0  (0, 0, 0)\n  vertex 1  (1, 1, 0)\n  vertex 2  (2, 4, 0)\n"
        "  vertex 3  (3, 9, 0)\n  face 0    0 1 2\n  face 1    3 2 1\n  face 2    0 3 1\n"
        "  face 3    2 3 0\nthrough meshopt-x\n  vertex 0  (0, 0, 0)\n" in text
    )
    assert "vertices-split, 1, first of the whole input of the mesh sent\nposition-moved" in text
    assert "through meshopt-x\n  crash: exit code 3\n```\n" in text
    assert "\n| empty | 2, the first second | good |\n" in text
    assert "\n| a.off | torn |\n" in text
    assert "| crash: exit code 3 |" not in text
    assert "Not installed" not in text


def test_cells_of_a_row() -> None:
    """ORCL-CODEC-15."""
    row = Row("m", 2, 1, (Became("same"), Became("undecided", "w")))
    assert cells(row) == ["m", "2", "1", "=", "undecided"]


# the command


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["bench", "codecs", *arguments])


def test_command(tmp_path: Path) -> None:
    """ORCL-CODEC-14, ORCL-CODEC-15: a table, a page, and the same as JSON."""
    dirty = str(MESHES / "dirty" / "isolated-vertex.obj")
    torn = str(MESHES / "dirty" / "truncated.off")
    out = tmp_path / "page.md"
    ran = run(dirty, torn, "--no-made", "-o", str(out))
    assert ran.exit_code == Exit.CONFORMING
    assert "isolated-vertex.obj" in ran.stdout
    assert "draco-valence: lost-isolated-vertices, 1 meshes; smallest: 0-1-2" in ran.stdout
    assert ran.stderr == "truncated.off: malformed: unreadable-file of the whole input " + (
        "[TOOL-READ-5]: 3 of 4 faces\n"
    )
    command = f"clers bench codecs {dirty} {torn} --no-made -o {out}"
    assert f"    {command}\n" in out.read_text(encoding="utf-8")


def test_command_as_json(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-14, TOOL-OUTPUT-1."""
    monkeypatch.setattr("clers.oracle.codecs.settings.SETTINGS", SETTINGS[2:3])
    ran = run(str(MESHES / "dirty" / "isolated-vertex.obj"), "--no-made", "--json")
    found = json.loads(ran.stdout)
    assert found["settings"] == ["draco-valence"]
    assert [row["mesh"] for row in found["rows"]] == ["isolated-vertex.obj"]
    assert found["shown"][0]["finding"] == "lost-isolated-vertices"


def test_page_has_a_suffix(tmp_path: Path) -> None:
    """TOOL-EXIT-1."""
    assert run("-o", str(tmp_path / "page.txt")).exit_code == Exit.USAGE
    assert run(str(tmp_path / "nothing.off")).exit_code == Exit.USAGE


def test_no_package_at_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-14: each codec that is not there is named on standard error."""
    monkeypatch.setattr(survey_module, "installed", lambda _: {})
    ran = run(str(MESHES / "ring.off"), "--no-made")
    assert ran.exit_code == Exit.CONFORMING
    assert ran.stderr.splitlines() == [
        f"{setting.name}: its package is not installed" for setting in SETTINGS
    ]
