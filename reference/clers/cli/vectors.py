"""`clers vectors`: the golden vectors made, verified, compared, listed and copied."""

from pathlib import Path
from typing import Annotated

import typer

from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, progress, reject, stop

app = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="The suite of golden vectors.")

Folder = Annotated[
    Path | None, typer.Argument(help="The suite's folder; else that of this checkout.")
]


def _folder(given: Path | None) -> Path:
    from clers.oracle.suite.files import DEFAULT

    return DEFAULT if given is None else given


@app.command()
def generate(
    folder: Folder = None,
    check: Annotated[bool, typer.Option("--check", help="Only name what would change.")] = False,
    retire: Annotated[
        str, typer.Option(metavar="REASON", help="Why cases of before are gone.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Make the whole suite anew, from code and from its folder inputs. Clause: ORCL-SUITE-5."""
    from clers.conventions.result import Rejected
    from clers.oracle.suite.generated import STEPS, before, generate, inputs_of
    from clers.oracle.suite.retiring import Reused, Unretired
    from clers.oracle.suite.written import differing, write_suite

    place = _folder(folder)
    inputs, old = inputs_of(place), before(place)
    if isinstance(inputs, Rejected):
        reject(str(place), inputs, as_json=as_json)
    if isinstance(old, Rejected):
        reject(str(place), old, as_json=as_json)
    with progress("vectors", STEPS) as step:
        files = generate(inputs.value, old.value, retire, step)
    match files:
        case Unretired(ids) | Reused(ids):
            what = "not retired" if isinstance(files, Unretired) else "used again"
            if as_json:
                json({"folder": str(place), what.replace(" ", "_"): ids})
            else:
                for name in ids:
                    note(f"{name}: {what} [ORCL-SUITE-6]")
            stop(Exit.NOT_CONFORMING)
        case _:
            pass
    if check:
        changed = differing(place, files)
    else:
        written = write_suite(place, files)
        if isinstance(written, Rejected):
            reject(str(place), written, as_json=as_json)
        changed = written.value
    size = sum(map(len, files.values()))
    if as_json:
        json({"folder": str(place), "files": len(files), "bytes": size, "changed": changed})
    else:
        for path in changed:
            line(f"{path}: {'differs' if check else 'written'}")
        line(f"{place}: {len(files)} files, {size} bytes, {len(changed)} changed")
    if check and changed:
        stop(Exit.NOT_CONFORMING)
