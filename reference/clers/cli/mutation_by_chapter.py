"""`python -m clers.cli.mutation_by_chapter --sample 30 --seed 1`, from the folder of a checkout."""

import os
import signal
import subprocess
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Annotated

import msgspec
import typer

import clers
from clers.cli.output import Exit, line, note, progress, stop
from clers.conventions.result import Rejected
from clers.oracle.mutants.by_chapter import CHAPTERS, Chapter, Result, Row, asked, tried
from clers.oracle.mutants.chapters_page import page
from clers.oracle.mutants.reached import reached
from clers.oracle.suite.files import DEFAULT, read_suite

Step = Callable[[str], None]


def main(
    sample: Annotated[int, typer.Option(min=1, help="Draw so many of each chapter.")] = 30,
    seed: Annotated[int, typer.Option(help="Of the draw.")] = 1,
    only: Annotated[str, typer.Option(help="Chapters whose names have this in them.")] = "",
    keep: Annotated[
        Path | None, typer.Option(help="A folder of results: what was noticed is not tried again.")
    ] = None,
    cases: Annotated[bool, typer.Option(help="Ask the cases what the tests let pass.")] = True,
) -> None:
    """Change each chapter in one place at a time: do its tests notice, or else the cases?

    Clause: ORCL-MUTANT-9.
    """
    chosen = [chapter for chapter in CHAPTERS if only in chapter.name]
    if not chosen:
        raise typer.BadParameter(f"no chapter is named {only}", param_hint="--only")
    results: list[Result] = []
    with progress("mutants", sample * len(chosen)) as step:
        for chapter in chosen:
            found = tried(chapter, sample, seed, kept(keep, chapter), step)
            if isinstance(found, str):
                note(f"{chapter.name}: {found}")
                stop(Exit.SELF_CHECK)
            results.append(found)
            put(keep, found)
            if len(found.rows) < found.drawn:
                break
        complete = len(results) == len(chosen) and len(results[-1].rows) == results[-1].drawn
        if cases and complete:
            results = by_cases(results, step)
            for found in results:
                put(keep, found)
    known = keep is not None
    for text in page(results, sample, seed, cases=cases, kept=known, commit=commit()):
        line(text)
    if not complete:
        line("")
        line("Interrupted: this is not all.")
        stop(Exit.INTERRUPTED)


def kept(folder: Path | None, chapter: Chapter) -> tuple[Row, ...]:
    """What is known of a chapter from an earlier run; nothing if it cannot be read."""
    with suppress(OSError, msgspec.DecodeError):
        if folder is not None:
            return msgspec.json.decode(file(folder, chapter).read_bytes(), type=Result).rows
    return ()


def put(folder: Path | None, found: Result) -> None:
    """Keep what is known of a chapter, if it is to be kept."""
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        data = msgspec.json.format(msgspec.json.encode(found), indent=1)
        file(folder, found.chapter).write_bytes(data)


def file(folder: Path, chapter: Chapter) -> Path:
    """Where it is kept."""
    return folder / f"{chapter.package}.json"


def commit() -> str:
    """The last commit that changed a package of a chapter; empty if git does not say."""
    here = Path(clers.__file__).parent
    folders = [str(here / chapter.package.partition(".")[2]) for chapter in CHAPTERS]
    command = ("git", "-C", str(here), "log", "-1", "--format=%h", "--", *folders)
    with suppress(OSError, subprocess.CalledProcessError):
        return subprocess.run(command, capture_output=True, check=True, text=True).stdout.strip()
    return ""


def by_cases(results: Sequence[Result], step: Step) -> list[Result]:
    """What the tests let pass, beside the cases of this checkout's suite. Clause: ORCL-MUTANT-9."""
    suite = read_suite(DEFAULT)
    if isinstance(suite, Rejected):
        note(suite.line())
        stop(Exit.SELF_CHECK)
    known = reached(DEFAULT)
    if isinstance(known, str):
        note(known)
        stop(Exit.SELF_CHECK)
    count = suite.value.manifest.count
    return [asked(result, known, DEFAULT, count, step) for result in results]


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    os.environ["CLERS_KERNELS"] = "interpreted"  # as their text stands, changed or not
    typer.run(main)
