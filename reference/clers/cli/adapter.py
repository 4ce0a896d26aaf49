"""`clers adapter`: the reference as an adapter, a doctor for others, and sources to start from."""

import sys

import typer

app = typer.Typer(
    no_args_is_help=True, rich_markup_mode=None, help="Programs that stand for an implementation."
)


@app.command()
def reference() -> None:
    """Serve the reference on standard input and output. Clause: ORCL-SERVE-1."""
    from clers.conformance.adapter import loop

    loop(sys.stdin.buffer, sys.stdout.buffer)
