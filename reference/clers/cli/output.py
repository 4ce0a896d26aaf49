"""How commands print: lines, tables, JSON, one line for a rejection, and a progress bar."""

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import IntEnum
from typing import NoReturn

import typer

from clers.conventions.result import Rejected
from clers.conventions.where_record import where_record as where_record


class Exit(IntEnum):
    """What a command's exit code says. Clause: TOOL-EXIT-1."""

    CONFORMING = 0
    NOT_CONFORMING = 1
    USAGE = 2
    ADAPTER = 3
    SELF_CHECK = 4
    INTERRUPTED = 130


def stop(code: Exit) -> NoReturn:
    """End the command with this exit code."""
    raise typer.Exit(int(code))


def line(text: str) -> None:
    """Print one line of result on standard output, as it is."""
    sys.stdout.write(f"{text}\n")


def note(text: str) -> None:
    """Print one line for people on standard error; no result."""
    sys.stderr.write(f"{text}\n")


def json(value: object) -> None:
    """Print a value as one JSON document on standard output. Clause: TOOL-OUTPUT-1.

    Frozen dataclasses, mappings, tuples, enumerations and numbers are printed as `msgspec` does.
    """
    import msgspec

    line(msgspec.json.format(msgspec.json.encode(value), indent=2).decode())


def table(heads: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print rows in aligned columns under their heads; no column is cut off or folded."""
    cells = [[str(cell) for cell in row] for row in (heads, *rows)]
    widths = [max(len(row[column]) for row in cells) for column in range(len(heads))]
    for row in cells:
        line("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())


def reject(source: str, rejected: Rejected, *, as_json: bool = False) -> NoReturn:
    """Say in one line what is wrong with `source` (a file's name), and exit 1.

    As JSON the document goes to standard output. Clauses: CONV-RESULT-4, TOOL-OUTPUT-2.
    """
    if as_json:
        json(
            {
                "source": source,
                "reject": {
                    "class": rejected.fault,
                    "reason": str(rejected.reason),
                    "at": where_record(rejected.where),
                    "clause": rejected.clause,
                    "detail": rejected.detail,
                },
            }
        )
    else:
        note(f"{source}: {rejected.line()}")
    stop(Exit.NOT_CONFORMING)


@contextmanager
def progress(what: str, total: int) -> Iterator[Callable[[str], None]]:
    """A progress bar on standard error, silent where that is no terminal. Clause: TOOL-OUTPUT-3.

    The body calls what it is given with a word on the step that begins.
    """
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    from rich.console import Console
    from rich.progress import Progress

    console, same = Console(stderr=True), sys.stdout.isatty()
    with Progress(console=console, transient=True, redirect_stdout=same) as bar:
        task = bar.add_task(what, total=total + 1)

        def step(word: str) -> None:
            bar.update(task, advance=1, description=f"{what}: {word}")

        yield step
