"""`clers schema`: the JSON Schemas of what `--json` prints, made from the records it prints."""

from typing import Annotated

import typer

from clers.cli.output import json


def schemas() -> dict[str, object]:
    """A schema for each published record. Clauses: TOOL-SCHEMA-1, ORCL-LINE-3, ORCL-CASE-7."""
    import msgspec

    from clers.cli.views import InfoView, WordView
    from clers.conformance.schema import protocol_schema
    from clers.oracle.finding import finding_schema
    from clers.oracle.suite.schema import vectors_schema

    published = {"info": InfoView, "word": WordView}
    records: dict[str, object] = {
        name: {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": f"clers {name} --json",
            **msgspec.json.schema(view),
        }
        for name, view in published.items()
    }
    return {
        **records,
        "protocol": protocol_schema(),
        "finding": finding_schema(),
        "vectors": vectors_schema(),
    }


def schema(
    name: Annotated[str, typer.Argument(help="info, word, protocol, finding or vectors.")],
) -> None:
    """Print the JSON Schema of what a command prints with --json, or of the adapters' protocol."""
    known = schemas()
    if name not in known:
        raise typer.BadParameter(f"{name!r} is none of {', '.join(known)}")
    json(known[name])
