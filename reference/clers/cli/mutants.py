"""`clers mutants`: do the vectors bring mistakes to light? Clauses: ORCL-MUTANT-5 … -7."""

from collections.abc import Generator, Sequence
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, progress, reject, stop, table

if TYPE_CHECKING:
    from clers.oracle.mutants.automatic import Found
    from clers.oracle.mutants.report import Report
    from clers.oracle.suite.records import Manifest

A = TypeVar("A")


def mutants(
    only: Annotated[str, typer.Option(metavar="GLOB", help="Mutants of such names alone.")] = "*",
    vectors: Annotated[Path | None, typer.Option(help="The suite; else this checkout's.")] = None,
    workers: Annotated[int, typer.Option(min=1, help="Mutants tried at a time.")] = 2,
    write: Annotated[
        bool, typer.Option("--write", help="Put the score into the suite's manifest.")
    ] = False,
    automatic: Annotated[
        int, typer.Option(metavar="N", min=0, help="Draw so many that a tool makes, instead.")
    ] = 0,
    seed: Annotated[int, typer.Option(help="Of the draw.")] = 1,
    as_json: AsJson = False,
) -> None:
    """Put known mistakes into the reference, and see which case notices. Clause: ORCL-MUTANT-5."""
    from clers.conventions.result import Rejected
    from clers.oracle.suite.files import DEFAULT, read_suite

    if automatic and (write or only != "*"):
        raise typer.BadParameter(
            "neither --only nor --write goes with it", param_hint="--automatic"
        )
    folder = DEFAULT if vectors is None else vectors
    suite = read_suite(folder)
    if isinstance(suite, Rejected):
        reject(str(folder), suite, as_json=as_json)
    if automatic:
        _automatic(folder, suite.value.manifest, automatic, seed, workers, as_json)
    else:
        _by_hand(folder, suite.value.manifest, only, workers, write, as_json)


def _by_hand(
    folder: Path, said: "Manifest", only: str, workers: int, write: bool, as_json: bool
) -> None:
    """Clauses: ORCL-MUTANT-5, ORCL-MUTANT-6."""
    from fnmatch import fnmatchcase

    from clers.conventions.result import Rejected
    from clers.oracle.mutants.campaign import run
    from clers.oracle.mutants.every import MUTANTS
    from clers.oracle.mutants.explained import EXPLAINED
    from clers.oracle.mutants.manifest import score_of, write_score
    from clers.oracle.mutants.report import report, row

    chosen = [mutant for mutant in MUTANTS if fnmatchcase(mutant.name, only)]
    if not chosen:
        raise typer.BadParameter(f"no mutant is named {only}", param_hint="--only")
    if write and len(chosen) < len(MUTANTS):
        raise typer.BadParameter("only the score of all mutants is kept", param_hint="--write")
    names = [mutant.name for mutant in chosen]
    fates = _gathered(run(names, folder, workers), names)
    rows = [row(m, fate, EXPLAINED) for m, fate in zip(chosen, fates, strict=False)]
    found = report(said.suite, said.count, chosen, rows)
    if as_json:
        json(found)
    else:
        _show(found)
    if not found.complete:
        stop(Exit.INTERRUPTED)
    if write and found.good:
        written = write_score(folder, score_of(found))
        if isinstance(written, Rejected):
            reject(str(folder), written, as_json=as_json)
        note(f"{written.value}: the score is written")
    elif write:
        note("the score is not written: too low, or a survivor is not explained [ORCL-MUTANT-6]")
    stop(Exit.CONFORMING if found.good else Exit.NOT_CONFORMING)


def _gathered(found: Generator[A, None, None], names: Sequence[str]) -> list[A]:
    """What comes, until there is no more or an interrupt, under a progress bar.

    Then nothing runs any more.
    """
    there: list[A] = []
    with progress("mutants", len(names)) as step, closing(found):
        try:
            step(names[0])
            for one in found:
                there.append(one)
                step(names[len(there) - 1])
        except KeyboardInterrupt:
            pass
    return there


def _show(found: "Report") -> None:
    """A table of all mutants, then the survivors, each explained, then the score."""
    from clers.oracle.mutants.trial import Fate

    table(
        ("mutant", "clause", "killed by", "status", "mistake"),
        [
            (row.name, row.clause, row.by or str(row.fate).upper(), row.status, row.mistake)
            for row in found.rows
        ],
    )
    for row in found.rows:
        if row.fate is not Fate.KILLED:
            why = row.explained or row.why or "NOT EXPLAINED"
            line(f"{row.fate} {row.name} [{row.clause}]: {why}")
    line(
        f"{found.killed} of {len(found.rows)} mutants killed by the {found.cases} cases of "
        f"{found.suite}: {100 * float(found.score):.1f} %"
    )
    if not found.complete:
        line(f"interrupted: {found.mutants - len(found.rows)} mutants were not tried")


def _automatic(
    folder: Path, said: "Manifest", number: int, seed: int, workers: int, as_json: bool
) -> None:
    """Clause: ORCL-MUTANT-7."""
    from clers.oracle.mutants.automatic import run, sample
    from clers.oracle.mutants.reached import reached

    known = reached(folder)
    if isinstance(known, str):
        note(f"clers mutants: {known}")
        stop(Exit.SELF_CHECK)
    of = sample(known, number, seed)
    names = [f"{drawn.subject.module}:{drawn.mutant.place}" for drawn in of.drawn]
    found = _gathered(run(of, known, folder, said.count, workers), names)
    if as_json:
        json({"suite": said.suite, "mutants": of.mutants, "seed": seed, "tried": found})
    else:
        _show_automatic(found, of.mutants, said)
    stop(Exit.CONFORMING if len(found) == len(of.drawn) else Exit.INTERRUPTED)


def _show_automatic(found: list["Found"], mutants: int, said: "Manifest") -> None:
    """The survivors and the unreached, each with its change, then the counts."""
    from collections import Counter

    from clers.oracle.mutants.trial import Fate

    for one in found:
        if one.tried.fate is not Fate.KILLED:
            line(f"{one.tried.fate} {one.module}:{one.place} {one.kind} {one.tried.why}".rstrip())
            line(one.difference)
    fates = Counter(one.tried.fate for one in found)
    tried = fates[Fate.KILLED] + fates[Fate.SURVIVED]
    counts = ", ".join(f"{fates[fate]} {fate}" for fate in Fate)
    line(
        f"{len(found)} of {mutants} mutants, {said.count} cases of {said.suite}: {counts}; "
        f"score {100 * fates[Fate.KILLED] / max(1, tried):.1f} %"
    )
