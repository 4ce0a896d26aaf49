"""`clers laws`: the registry of laws, listed and run. Clause: CONV-LAW-3."""

import typer

app = typer.Typer(name="laws", no_args_is_help=True, rich_markup_mode=None, help="The laws.")


@app.command()
def run() -> None:
    """Run laws."""
