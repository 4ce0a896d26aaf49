"""The program `clers`: its commands, each in a module of its own. Clause: TOOL-EXIT-1.

Start-up is quick because a command's module imports what it needs inside the command.
Clause: TOOL-START-1.
"""

import sys
from typing import Annotated

import typer

from clers import SPEC_VERSION, __version__
from clers.cli import (
    adapter,
    bench,
    check,
    complexes,
    corpus,
    explain,
    findings,
    generate,
    laws,
    meshes,
    mutants,
    operators,
    repairs,
    roundtrip,
    schema,
    site,
    spec,
    vectors,
    walks,
)
from clers.cli.output import Exit, line, note

app = typer.Typer(
    name="clers",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

# Here a command joins: one line.
app.command()(meshes.encode)
app.command()(meshes.decode)
app.command()(meshes.info)
app.command()(roundtrip.roundtrip)
app.command()(repairs.repair)
app.command()(walks.word)
app.command()(walks.trace)
app.command()(check.check)
app.command()(explain.explain)
app.command()(findings.fuzz)
app.command()(findings.replay)
app.command()(findings.shrink)
app.command()(mutants.mutants)
app.command()(schema.schema)
app.command(name="complex")(complexes.complex_of)
app.add_typer(adapter.app, name="adapter")
app.add_typer(bench.app, name="bench")
app.add_typer(corpus.app, name="corpus")
app.add_typer(generate.app, name="generate")
app.add_typer(laws.app, name="laws")
app.add_typer(operators.app, name="operators")
spec.app.command()(site.site)
app.add_typer(spec.app, name="spec")
app.add_typer(vectors.app, name="vectors")
app.add_typer(complexes.structure_app, name="structure")


def _version(wanted: bool) -> None:
    """Clause: TOOL-BUILD-5."""
    if wanted:
        from clers.kernels import COMPILED

        build = "compiled" if COMPILED else "interpreted"
        line(f"clers {__version__}, specification {SPEC_VERSION}, kernels {build}")
        raise typer.Exit


@app.callback()
def _clers(
    version: Annotated[
        bool, typer.Option("--version", help="Print versions.", callback=_version, is_eager=True)
    ] = False,
) -> None:
    """The conformance oracle of Edgebreaker mesh compression."""


def main() -> None:
    """Run the program; an interrupt ends it with one line and code 130. Clause: TOOL-EXIT-2."""
    try:
        app()
    except SystemExit as ended:
        if ended.code == Exit.INTERRUPTED:
            note("clers: interrupted")
        raise
    except KeyboardInterrupt:
        note("clers: interrupted")
        sys.exit(Exit.INTERRUPTED)
