"""The option that names an adapter, for all commands that ask one."""

import shlex
from typing import Annotated

import typer

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
