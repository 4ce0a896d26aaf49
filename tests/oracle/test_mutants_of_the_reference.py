"""Mistakes in the reference, and a small suite that notices some of them."""

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path

import msgspec
import pytest
from msgspec import UNSET, Raw
from typer.testing import CliRunner

from clers.cli.main import app
from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import named
from clers.conformance.messages import Rejection
from clers.conformance.samples import FACES
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault
from clers.conventions.result import Accepted
from clers.measure.mutation.mutant import Mutant as Drawn
from clers.measure.mutation.outcome import Subject
from clers.measure.mutation.sample import Drawn as DrawnMutant
from clers.measure.mutation.served import source_file
from clers.oracle.mutants.automatic import Sample, able, mixed, run, sample
from clers.oracle.mutants.every import BY_NAME, MUTANTS
from clers.oracle.mutants.likely import ASKED_OF, in_order
from clers.oracle.mutants.manifest import score_of, write_score
from clers.oracle.mutants.mutant import Mutant, changed
from clers.oracle.mutants.reached import Reached, reached
from clers.oracle.mutants.report import Report, report, row
from clers.oracle.mutants.trial import Fate, Tried, tried
from clers.oracle.negatives.from_mutants import drafts
from clers.oracle.positives.asked import answered
from clers.oracle.positives.from_mutants import from_mutants
from clers.oracle.suite.files import read_suite
from clers.oracle.suite.records import Part, Score, Survivor
from clers.oracle.suite.rendered import suite_files

TETRAHEDRON = {"faces": FACES, "vertices": 4}
STREAM = {"word": "CRE", "handles": [], "components_with_boundary": 0}
CHAPTERS = (
    "complexes",
    "operators",
    "edgebreaker",
    "arithmetic",
    "information",
    "codes",
    "geometry",
    "container",
)


def case(
    op: str, asks: object, gives: object, *clauses: str, rejects: Rejection | None = None
) -> Case:
    """A case, right or wrong, that somebody wrote by hand."""
    return named(
        op.replace(".", "-"),
        Case(
            id="nothing-aaaaaaaa",
            op=op,
            clauses=clauses,
            origin="hand",
            input=Raw(msgspec.json.encode(asks)),
            ok=UNSET if rejects is not None else Raw(msgspec.json.encode(gives)),
            reject=UNSET if rejects is None else rejects,
        ),
    )


COUNTS = {"faces": 4, "vertices": 4, "edges": 6, "boundary_edges": 0, "curves": 0, "genus": 0}
ENCODE = case("word.encode", TETRAHEDRON, {**STREAM, "vertex_order": [0, 1, 2, 3]}, "EB-WORD-2")
DECODE = case("word.decode", STREAM, TETRAHEDRON, "EB-DECODE-1")
CLASSIFY = case("surface.classify", TETRAHEDRON, {"components": [{**COUNTS, "euler": 2}]})
ISOLATED = case(
    "surface.classify",
    {**TETRAHEDRON, "vertices": 5},
    None,
    "CPLX-REJECT-9",
    rejects=Rejection(Fault.INVALID),
)
WRONG = case("word.decode", STREAM, {**TETRAHEDRON, "vertices": 5}, "EB-DECODE-1")
PLAIN = case("code.encode", {"code": "plain", **STREAM}, {"hex": "bc", "length": 6}, "CODE-PLAIN-1")
CASES = (ENCODE, DECODE, CLASSIFY, ISOLATED, PLAIN)


def source(module: str) -> str:
    spec = find_spec(module)
    assert spec is not None
    file = source_file(spec)
    assert file is not None
    return file.read_text(encoding="utf-8")


def written(folder: Path, cases: Sequence[Case]) -> Path:
    """A suite of some cases."""
    parts = tuple(
        Part(profile="core", op=op, cases=tuple(sorted(here, key=lambda c: c.id)))
        for op in ("surface.classify", "word.encode", "word.decode", "code.encode")
        if (here := [c for c in cases if c.op == op])
    )
    for path, data in suite_files(parts, (), (), (), {}).items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_bytes(data)
    return folder


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A small suite in a folder."""
    return written(tmp_path, CASES)


def test_each_mistake_has_its_place() -> None:
    """Clause: ORCL-MUTANT-1."""
    assert len(MUTANTS) >= 60
    assert list(BY_NAME.values()) == list(MUTANTS)
    for mutant in MUTANTS:
        assert re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", mutant.name)
        assert re.fullmatch(r"[A-Z].*[^.]\.", mutant.mistake), mutant.name
        new = changed(mutant, source(mutant.module))
        assert new is not None, f"{mutant.name}: its place is not there, or not once"
        assert new != source(mutant.module)
        compile(new, mutant.name, "exec")
    assert len({(m.module, m.before, m.after) for m in MUTANTS}) == len(MUTANTS), "none twice"
    of_chapter = {m.module.split(".")[1] for m in MUTANTS}
    assert of_chapter >= set(CHAPTERS)


def test_a_place_that_is_there_twice_is_none() -> None:
    """Clause: ORCL-MUTANT-1."""
    mutant = Mutant("name", Clause.EB_WORD_1, "module", "a = 1\n", "a = 2\n", "It is two.")
    assert changed(mutant, "b = 1\na = 1\n") == "b = 1\na = 2\n"
    assert changed(mutant, "a = 1\nb = 1\na = 1\n") is None
    assert changed(mutant, "b = 1\n") is None


def test_likely_killers_come_first() -> None:
    """Clause: ORCL-MUTANT-4."""
    mutant = Mutant("name", Clause.CPLX_REJECT_9, "clers.edgebreaker.encode", "a", "b", "No.")
    assert in_order(CASES, mutant) == (ISOLATED, ENCODE, DECODE, CLASSIFY, PLAIN)
    elsewhere = Mutant("name", Clause.CONV_LAW_1, "clers.conventions.reason", "a", "b", "No.")
    by_turns = (ENCODE, DECODE, CLASSIFY, PLAIN, ISOLATED)
    assert in_order(CASES, elsewhere) == by_turns
    assert mixed(CASES) == by_turns
    known = {op for _, ops in ASKED_OF for op in ops}
    assert known == {
        "surface.classify", "word.encode", "word.decode", "operator.apply", "arithmetic.encode",
        "arithmetic.decode", "code.encode", "code.decode", "mesh.encode", "mesh.decode",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("name", "killer"),
    [
        ("mirrored-letters", ENCODE),
        ("outer-triangle-turned", DECODE),
        ("codewords-swapped", PLAIN),
        ("isolated-vertex-accepted", ISOLATED),
        ("border-edges-uncounted", None),
        ("carry-lost", None),
    ],
)
def test_a_mistake_is_seen_where_it_matters(name: str, killer: Case | None) -> None:
    """The judging process has the reference as it is. Clauses: ORCL-MUTANT-2, ORCL-MUTANT-3."""
    found = tried([name], CASES)
    if killer is None:
        assert found == Tried(Fate.SURVIVED, len(CASES))
    else:
        assert (found.fate, found.by, found.status) == (Fate.KILLED, killer.id, "fail")
        assert found.asked == CASES.index(killer) + 1
        assert "expected" in found.why


ASKED_FOR = (*(draft.case for draft in drafts()), *map(answered, from_mutants()))


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("degenerate-face-accepted", "tetrahedron-and-triangle-triangle-folded"),
        ("lower-half-too-wide", "arithmetic-ends-just-over-half"),
        ("bridge-onto-edge", "bridge-onto-edge"),
        ("link-condition-forgotten", "circle-of-three-edges-contracted"),
    ],
)
def test_a_mistake_asks_for_a_case(name: str, words: str) -> None:
    """And among the cases so asked for it is seen there first. Clause: ORCL-MUTANT-8."""
    found = tried([name], ASKED_FOR)
    assert found.fate is Fate.KILLED
    assert re.fullmatch(rf"{words}-[a-z2-7]{{8}}", found.by), found.by


def test_without_a_name_there_is_no_mistake() -> None:
    """Clause: ORCL-MUTANT-2."""
    assert tried([], CASES) == Tried(Fate.SURVIVED, len(CASES))


def test_a_case_that_the_reference_fails_kills_nobody() -> None:
    """Clause: ORCL-MUTANT-3."""
    assert tried([], [WRONG]).fate is Fate.SURVIVED
    assert tried(["outer-triangle-turned"], [WRONG]).fate is Fate.SURVIVED
    assert tried(["outer-triangle-turned"], [WRONG, DECODE]).by == DECODE.id


@pytest.mark.parametrize(
    "words", [["no-such-mutant"], ["clers.no_such_module", "FILE"], ["one", "two", "three"]]
)
def test_who_does_not_say_hello_is_stillborn(words: list[str], tmp_path: Path) -> None:
    """Clause: ORCL-MUTANT-3."""
    file = tmp_path / "source.py"
    file.write_text("")
    found = tried([str(file) if word == "FILE" else word for word in words], [DECODE])
    assert found.fate is Fate.STILLBORN
    assert "hello" in found.why
    assert found.asked == 0


def test_a_module_that_cannot_be_imported_is_stillborn(tmp_path: Path) -> None:
    """Clauses: ORCL-MUTANT-3, ORCL-MUTANT-7."""
    file = tmp_path / "source.py"
    for module in ("clers.edgebreaker.encode", "clers.kernels.walk", "clers.kernels"):
        file.write_text("raise ValueError\n")
        assert tried([module, str(file)], [DECODE]).fate is Fate.STILLBORN
        file.write_text(source(module))
        assert tried([module, str(file)], CASES).fate is Fate.SURVIVED
    # What the adapter itself uses cannot be exchanged any more.
    file.write_text(source("clers.oracle.mutants.mutant"))
    assert tried(["clers.oracle.mutants.mutant", str(file)], [DECODE]).fate is Fate.STILLBORN


ONE, TWO = MUTANTS[:2]
KILLED = Tried(Fate.KILLED, 3, "a-case", "fail", "symbol 0: expected C, got S")
SURVIVED = Tried(Fate.SURVIVED, 7)


def reported(*fates: Tried, why: str = "", of: int = 0) -> Report:
    explained = {ONE.name: why} if why else {}
    rows = [row(ONE, fate, explained) for fate in fates]
    return report("abcdefghijkl", 7, [ONE] * max(of, len(fates)), rows)


def test_what_a_report_says() -> None:
    """Clauses: ORCL-MUTANT-5, ORCL-MUTANT-6."""
    assert reported(KILLED).good
    assert not reported(SURVIVED, *[KILLED] * 98).good, "it is not explained"
    assert reported(SURVIVED, *[KILLED] * 49, why="it is").good, "98 % are enough"
    assert not reported(SURVIVED, *[KILLED] * 48, why="it is").good
    assert not reported(KILLED, of=2).good, "it was interrupted"
    assert not reported(Tried(Fate.STILLBORN, 0), *[KILLED] * 98, why="it is").good
    assert not reported().good
    assert row(ONE, KILLED, {ONE.name: "it is"}).explained == "", "it did not survive"
    found = reported(SURVIVED, KILLED, why="it is")
    assert (found.killed, found.mutants, float(found.score)) == (1, 2, 0.5)
    assert score_of(found) == Score(
        suite="abcdefghijkl",
        mutants=2,
        killed=1,
        survivors=(Survivor(mutant=ONE.name, why="it is"),),
    )


def test_the_score_goes_into_the_manifest(small: Path) -> None:
    """And nothing else changes. Clause: ORCL-MUTANT-6."""
    before = read_suite(small)
    assert isinstance(before, Accepted)
    score = score_of(reported(KILLED))
    assert isinstance(write_score(small, score), Accepted)
    after = read_suite(small)
    assert isinstance(after, Accepted)
    assert after.value.manifest == msgspec.structs.replace(before.value.manifest, mutation=score)
    (small / "flags.json").write_text("{}")
    assert not isinstance(write_score(small, score), Accepted), "the suite is not good"


def test_the_command_prints_what_was_found(small: Path) -> None:
    """Clause: ORCL-MUTANT-5."""
    args = ["mutants", "--vectors", str(small), "--workers", "1"]
    done = CliRunner().invoke(app, [*args, "--only", "mirrored-letters"])
    assert done.exit_code == 0, done.output
    assert ENCODE.id in done.output
    assert "1 of 1 mutants killed by the 5 cases of " in done.output
    assert "100.0 %" in done.output
    done = CliRunner().invoke(app, [*args, "--only", "car*-lost", "--json"])
    assert done.exit_code == 1
    said = msgspec.json.decode(done.stdout)
    assert said["rows"][0]["name"] == "carry-lost"
    assert said["rows"][0]["fate"] == "survived"
    assert (said["killed"], said["mutants"], said["cases"]) == (0, 1, 5)
    done = CliRunner().invoke(app, [*args, "--only", "car*-lost"])
    assert "survived carry-lost [ARITH-RANGE-5]: NOT EXPLAINED" in done.output


def test_wrong_usage_of_the_command(small: Path) -> None:
    """Clauses: ORCL-MUTANT-5, ORCL-MUTANT-6, ORCL-MUTANT-7."""
    args = ["mutants", "--vectors", str(small)]
    for more in (
        ["--only", "nothing-like-this"],
        ["--only", "carry-lost", "--write"],
        ["--automatic", "2", "--write"],
        ["--automatic", "2", "--only", "carry-lost"],
    ):
        assert CliRunner().invoke(app, [*args, *more]).exit_code == 2, more
    assert CliRunner().invoke(app, ["mutants", "--vectors", str(small / "core")]).exit_code == 1


def test_the_cases_that_can_tell() -> None:
    """Clause: ORCL-MUTANT-7."""
    lines = {3: (-1,), 4: (2, 5), 5: (1, 2), 7: (-1, 4)}

    def at(first: int, last: int) -> tuple[int, ...]:
        mutant = Drawn(first, 0, last, 1, "constant", "1", "2", first, last)
        return able(DrawnMutant(Subject("module", "module.py", ""), mutant), lines, 6)

    assert at(4, 4) == (2, 5)
    assert at(4, 5) == (1, 2, 5)
    assert at(6, 6) == ()
    assert at(3, 3) == at(7, 7) == (0, 1, 2, 3, 4, 5)


def test_mutants_that_a_tool_makes(small: Path) -> None:
    """Clause: ORCL-MUTANT-7."""
    known = reached(small)
    assert isinstance(known, Reached)
    some = {"clers.edgebreaker.encode", "clers.codes.plain", "clers.kernels.walk"}
    assert some < set(known.modules)
    assert "clers.kernels" not in known.modules, "it only says how kernels are found"
    assert "clers.geometry.predict" not in known.modules, "no case needs it"
    suite = read_suite(small)
    assert isinstance(suite, Accepted)
    cases = suite.value.cases
    plain = known.modules["clers.codes.plain"]
    encoding = [n for n, line in enumerate(source("clers.codes.plain").split("\n"), 1)
                if "return Accepted(pack(" in line]  # fmt: skip
    assert plain[encoding[0]] == (cases.index(PLAIN),)

    only = Reached({"clers.codes.plain": plain})
    few = sample(only, 5, 1)
    assert few.mutants > 30
    assert sample(only, 2, 1).drawn == few.drawn[:2], "a smaller sample begins a larger one"
    assert sample(only, 5, 2).drawn != few.drawn

    def of(module: str, text: str, before: str, after: str) -> DrawnMutant:
        whole = source(module)
        line = next(n for n, x in enumerate(whole.split("\n"), 1) if text in x)
        column = whole.split("\n")[line - 1].index(before)
        subject = Subject(module, "", whole)
        changes = (line, column, line, column + len(before), "comparison", before, after)
        return DrawnMutant(subject, Drawn(*changes, line, line))

    module = "clers.codes.plain"
    chosen = Sample(
        3,
        (
            of(module, "fault is not None", "is not", "is"),
            of(module, "if at + width > len(digits)", ">", ">="),
            of(module, '"E": "111"', '"111"', '"110"'),
        ),
    )
    found = list(run(chosen, known, small, len(cases), 1))
    assert [one.tried.fate for one in found] == [Fate.KILLED, Fate.UNREACHED, Fate.KILLED]
    assert found[0].tried.by == PLAIN.id
    assert found[0].tried.asked == 1, "only this case can tell"
    assert found[0].difference.count("\n") == 1
    assert (found[1].module, found[1].kind) == (module, "comparison")


def test_the_command_draws_by_a_seed(tmp_path: Path) -> None:
    """Clause: ORCL-MUTANT-7."""
    folder = written(tmp_path, [PLAIN])
    args = ["mutants", "--vectors", str(folder), "--workers", "1", "--automatic", "2"]
    done = CliRunner().invoke(app, [*args, "--seed", "3", "--json"])
    assert done.exit_code == 0, done.output
    said = msgspec.json.decode(done.stdout)
    assert (said["seed"], len(said["tried"])) == (3, 2)
    (folder / "flags.json").write_text("{}")
    assert isinstance(reached(folder), str), "the suite is not good"


def test_lines_that_cannot_be_counted(small: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: ORCL-MUTANT-7."""
    monkeypatch.setattr("clers.oracle.mutants.reached.reached", lambda _: "no coverage")
    done = CliRunner().invoke(app, ["mutants", "--vectors", str(small), "--automatic", "2"])
    assert (done.exit_code, done.stdout, done.stderr) == (4, "", "clers mutants: no coverage\n")


def adapters_with(mark: str) -> list[int]:
    """The adapters of mutants that run with a mark in their environment."""
    found: list[int] = []
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            marked = mark.encode() in (place / "environ").read_bytes()
            if marked and b"clers.oracle.mutants.adapter" in (place / "cmdline").read_bytes():
                found.append(int(place.name))
    return found


def test_an_interrupted_campaign(small: Path) -> None:
    """What is known is printed, and nobody is left. Clauses: ORCL-MUTANT-5, ORCL-RUN-9."""
    mark = f"CLERS_TEST_MARK={small}"
    main = "from clers.cli.main import main; main()"
    command = (sys.executable, "-c", main, "mutants", "--vectors", str(small))
    environment = {**os.environ, "CLERS_TEST_MARK": str(small)}
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment
    ) as campaign:
        deadline = time.monotonic() + 60
        while not adapters_with(mark):
            assert time.monotonic() < deadline
            time.sleep(0.05)
        campaign.send_signal(signal.SIGINT)
        out, errors = campaign.communicate(timeout=60)
    assert campaign.returncode == 130, errors
    assert f"of {len(MUTANTS)} mutants" not in out.decode()
    assert re.search("interrupted: [0-9]+ mutants were not tried\n$", out.decode())
    assert errors == b"clers: interrupted\n"
    assert adapters_with(mark) == []
