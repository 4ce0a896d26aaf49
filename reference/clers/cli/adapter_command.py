"""The option that names an adapter, for all commands that ask one, and what if nobody is there."""

import shlex
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from clers.cli.output import Exit, json, note, stop

if TYPE_CHECKING:
    from clers.conformance.outcome import NoProcess

Command = Annotated[
    str, typer.Option("--adapter", "-a", help="The adapter's command line, as in a shell.")
]


def words_of(command: str) -> list[str]:
    """The words of a command line; wrong usage if there is none. Clause: TOOL-EXIT-1."""
    try:
        words = shlex.split(command)
    except ValueError as fault:
        raise typer.BadParameter(str(fault), param_hint="--adapter") from fault
    if not words:
        raise typer.BadParameter("it is empty", param_hint="--adapter")
    return words


def nobody(found: "NoProcess", *, as_json: bool) -> NoReturn:
    """There is nobody to ask; exit 3. Clause: ORCL-FUZZ-6."""
    if as_json:
        json({"why": found.why, "errors": found.errors})
    else:
        note(found.why)
        note(found.errors.rstrip())
    stop(Exit.ADAPTER)
