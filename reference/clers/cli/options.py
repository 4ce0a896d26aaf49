"""Options that several commands share."""

from pathlib import Path
from typing import Annotated

import typer

Root = Annotated[
    Path | None,
    typer.Option(
        help="The repository; else the nearest folder upward that has spec/.", exists=True
    ),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]


def repository_root(given: Path | None) -> Path:
    """The repository that a command is to work on; wrong usage if there is none."""
    from clers.specification.repository import find_root

    root = find_root(given or Path.cwd())
    if root is None or (given and root != given.resolve()):
        raise typer.BadParameter(f"no spec/00-conventions.md in {given or 'any folder upward'}")
    return root
