"""Each bad adapter fails the checks foreseen for it, and no other; a good one fails none."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Final

import pytest
from bad_commands import FOLDER, bad
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance.bounds import Bounds
from clers.conformance.doctor import CHECKS, NEED_ECHO, Finding, examine
from clers.conformance.outcome import NoProcess

BOUNDS: Final = Bounds(start=20.0, request=15.0, farewell=10.0, memory=400 << 20, output=3_000_000)
HASTY: Final = Bounds(start=20.0, request=0.5, farewell=0.5)
NOT_ASKED: Final = {name for name, _ in NEED_ECHO}
ECHO: Final = {"echo", *NOT_ASKED}
ENDS: Final = {"bye", "end-of-input"}

FORESEEN: Final[dict[str, tuple[Bounds, set[str]]]] = {
    "good": (BOUNDS, set()),
    "accepts_everything": (BOUNDS, {"undeclared-operations", "garbage", "same-process"}),
    "answers_twice": (BOUNDS, ECHO),
    "changes_its_mind": (BOUNDS, {"hello-again", *ENDS}),
    "chats": (BOUNDS, ECHO),
    "closes_its_output": (BOUNDS, ECHO),
    "crashes_on_the_seventh": (BOUNDS, {"ids", "undeclared-operations", "same-process"}),
    "drops_an_id": (BOUNDS, ECHO),
    "eats_memory": (BOUNDS, ECHO),
    "floods": (BOUNDS, ECHO),
    "hangs": (HASTY, ECHO),
    "leaves_a_child": (BOUNDS, ENDS),
    "leaves_a_child_and_crashes": (BOUNDS, ECHO),
    "loses_letters": (BOUNDS, {"unicode", "numbers", "big-message"}),
    "reads_nothing": (HASTY, {*ECHO, "other-protocol", *ENDS}),
    "rejects_everything": (
        BOUNDS,
        {"unknown-operation", "undeclared-operations", "declared-operations"},
    ),
    "starts_slowly": (BOUNDS, set()),
    "stays_after_bye": (replace(BOUNDS, farewell=0.5), ENDS),
    "talks_back": (BOUNDS, {"unknown-operation", "undeclared-operations"}),
}
NOBODY: Final = {"exits_at_hello", "prints_a_banner", "speaks_another_version"}
OTHERWISE: Final = {"answers_again_later", "answers_late", "crashes_once"}


def test_every_bad_adapter_is_foreseen() -> None:
    """ORCL-DOCTOR-1."""
    assert {path.stem for path in FOLDER.glob("*.py")} == {*FORESEEN, *NOBODY, *OTHERWISE}


def test_the_checks_are_those_of_the_specification() -> None:
    """ORCL-DOCTOR-1: in its order."""
    page = (Path(__file__).parents[2] / "spec" / "09-conformance.md").read_text()
    clause = page.partition("**ORCL-DOCTOR-1.**")[2].partition(". It prints")[0]
    names = clause.partition("in this order: ")[2].split(", ")
    assert [f"`{name}`" for name, _ in CHECKS] == names


def failed(command: tuple[str, ...], bounds: Bounds) -> dict[str, Finding]:
    found = examine(command, bounds)
    assert not isinstance(found, NoProcess), found
    assert [finding.check for finding in found] == [name for name, _ in CHECKS]
    return {finding.check: finding for finding in found if not finding.passed}


@pytest.mark.parametrize("name", FORESEEN)
def test_as_foreseen(name: str) -> None:
    """Clauses: ORCL-DOCTOR-1, ORCL-DOCTOR-2, ORCL-REPLY-3, ORCL-HELLO-3, ORCL-BYE-1."""
    bounds, wanted = FORESEEN[name]
    found = failed(bad(name), bounds)
    assert set(found) == wanted
    skipped = {check for check in found if found[check].found == "not asked, for echo failed"}
    assert skipped == (NOT_ASKED if "echo" in wanted else set())


@pytest.mark.parametrize("name", sorted(NOBODY))
def test_nobody_there(name: str) -> None:
    """ORCL-DOCTOR-3."""
    assert isinstance(examine(bad(name), BOUNDS), NoProcess)


def test_late_answers_and_second_ones(tmp_path: Path) -> None:
    """Clauses: ORCL-DOCTOR-1, ORCL-RUN-3, ORCL-RUN-4, ORCL-RUN-5."""
    late = failed(bad("answers_late", "2.5"), Bounds(start=20.0, request=1.5, farewell=5.0))
    assert set(late) == {"unicode", "same-process"}
    assert "one-reply" in failed(bad("answers_again_later"), BOUNDS)
    once = failed(bad("crashes_once", str(tmp_path / "done")), BOUNDS)
    assert set(once) == ECHO
    assert "flaky: first crash" in once["echo"].found


def doctor(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["adapter", "doctor", *arguments])


def line(*command: str) -> str:
    return " ".join(f"'{word}'" for word in command)


def test_the_reference_is_well() -> None:
    """Clauses: ORCL-SERVE-1, ORCL-DOCTOR-2, ORCL-DOCTOR-3: all it declares is asked."""
    code = "from clers.cli.main import main; main()"
    reference = (sys.executable, "-c", code, "adapter", "reference")
    done = doctor("-a", line(*reference).replace(f"'{code}'", f'"{code}"'), "--seconds", "30")
    assert done.exit_code == Exit.CONFORMING, done.stdout
    rows = {row.split()[0]: row for row in done.stdout.splitlines()}
    assert rows["declared-operations"].endswith("11 of 11 answered")
    assert rows["garbage"].endswith("11 inputs rejected")
    assert rows["undeclared-operations"].endswith("0 unsupported")
    assert done.stdout.splitlines()[-1] == "16 of 16 checks passed"


def test_a_failed_check_in_a_table_and_as_json() -> None:
    """Clauses: ORCL-DOCTOR-1, ORCL-DOCTOR-3, TOOL-OUTPUT-1."""
    command = bad("talks_back")
    table = doctor("--adapter", line(*command))
    assert table.exit_code == Exit.NOT_CONFORMING
    assert "unknown-operation      FAILED  doctor.unknown: not unsupported, but" in table.stdout
    assert table.stdout.splitlines()[-1] == "14 of 16 checks passed"
    document = json.loads(doctor("-a", line(*command), "--json").stdout)
    assert (document["adapter"], document["failed"]) == ([*command], 2)
    assert document["checks"][1] == {
        "check": "echo",
        "passed": True,
        "found": "came back as it went",
    }


def test_no_process_in_words_and_as_json() -> None:
    """ORCL-DOCTOR-3."""
    command = bad("exits_at_hello")
    done = doctor("-a", line(*command))
    assert (done.exit_code, done.stdout) == (Exit.ADAPTER, "")
    assert "no answer to hello: crash: exit code 5" in done.stderr
    as_json = doctor("-a", line(*command), "--json")
    assert as_json.exit_code == Exit.ADAPTER
    assert json.loads(as_json.stdout) == {
        "adapter": [*command],
        "why": "no answer to hello: crash: exit code 5",
        "errors": "",
    }


def test_the_bounds_can_be_set() -> None:
    """Clauses: ORCL-RUN-2, ORCL-RUN-7."""
    slow = line(*bad("starts_slowly", "30"))
    assert "time-out: no reply in 0.3 s" in doctor("-a", slow, "--start", "0.3").stderr
    hungry = doctor("-a", line(*bad("eats_memory")), "--memory", "300")
    assert "MemoryError" in hungry.stdout
    assert (
        "time-out: no reply in 0.3 s"
        in doctor("-a", line(*bad("hangs")), "--seconds", "0.3").stdout
    )


@pytest.mark.parametrize("command", ["", "  ", "'unclosed"])
def test_no_command(command: str) -> None:
    """TOOL-EXIT-1."""
    assert doctor("-a", command).exit_code == Exit.USAGE
