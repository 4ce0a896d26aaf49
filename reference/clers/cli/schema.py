"""`clers schema`: the JSON Schemas of what `--json` prints, made from the records it prints."""

from typing import Annotated

import typer

from clers.cli.output import json


def schemas() -> dict[str, object]:
    """A schema for each published record, by name. Clause: TOOL-SCHEMA-1."""
    import msgspec

    from clers.cli.views import InfoView, WordView

    published = {"info": InfoView, "word": WordView}
    return {
        name: {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": f"clers {name} --json",
            **msgspec.json.schema(view),
        }
        for name, view in published.items()
    }


def schema(name: Annotated[str, typer.Argument(help="info or word.")]) -> None:
    """Print the JSON Schema of what a command prints with --json."""
    known = schemas()
    if name not in known:
        raise typer.BadParameter(f"{name!r} is none of {', '.join(known)}")
    json(known[name])
