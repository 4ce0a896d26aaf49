"""`clers vectors`: the golden vectors made, verified, compared, listed, copied, added to."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, progress, reject, stop, table

if TYPE_CHECKING:
    from clers.oracle.suite.files import Suite
    from clers.oracle.suite.retiring import Reused, Unretired

app = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="The suite of golden vectors.")

Folder = Annotated[
    Path | None, typer.Argument(help="The suite's folder; else that of this checkout.")
]


def _folder(given: Path | None) -> Path:
    from clers.oracle.suite.files import DEFAULT

    return DEFAULT if given is None else given


def _suite(folder: Path, *, as_json: bool) -> "Suite":
    """The suite in a folder, or one line and exit 1. Clause: TOOL-OUTPUT-2."""
    from clers.conventions.result import Rejected
    from clers.oracle.suite.files import read_suite

    found = read_suite(folder)
    if isinstance(found, Rejected):
        reject(str(folder), found, as_json=as_json)
    return found.value


@app.command()
def generate(
    folder: Folder = None,
    check: Annotated[bool, typer.Option("--check", help="Only name what would change.")] = False,
    retire: Annotated[
        str, typer.Option(metavar="REASON", help="Why cases of before are gone.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Make the whole suite anew, from code and from its inputs. Clauses: ORCL-SUITE-5, -6, -12."""
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
    if isinstance(files, Unretired | Reused):
        _refuse(place, files, as_json=as_json)
    if isinstance(files, Rejected):
        reject(str(place), files, as_json=as_json)
    stale = old.value.paths if old.value else ()
    written = differing(place, files, stale) if check else write_suite(place, files, stale)
    if isinstance(written, Rejected):
        reject(str(place), written, as_json=as_json)
    changed = written if isinstance(written, tuple) else written.value
    size = sum(map(len, files.values()))
    if as_json:
        json({"folder": str(place), "files": len(files), "bytes": size, "changed": changed})
    else:
        for path in changed:
            line(f"{path}: {'differs' if check else 'written'}")
        line(f"{place}: {len(files)} files, {size} bytes, {len(changed)} changed")
    if check and changed:
        stop(Exit.NOT_CONFORMING)


def _refuse(place: Path, found: "Unretired | Reused", *, as_json: bool) -> NoReturn:
    """Name the ids for which nothing is written, and exit 1. Clause: ORCL-SUITE-6."""
    from clers.oracle.suite.retiring import Unretired

    gone = isinstance(found, Unretired)
    if as_json:
        json({"folder": str(place), "unretired" if gone else "reused": found.ids})
    else:
        for name in found.ids:
            what = "gone, and not retired: say why with --retire" if gone else "its id is retired"
            note(f"{name}: {what} [ORCL-SUITE-6]")
        note(f"{place}: {len(found.ids)} cases, nothing written")
    stop(Exit.NOT_CONFORMING)


@app.command()
def verify(folder: Folder = None, as_json: AsJson = False) -> None:
    """Find what does not hold of a suite. Clauses: ORCL-SUITE-4, ORCL-SUITE-12."""
    from clers.oracle.suite.verify import STEPS, verify

    place = _folder(folder)
    with progress("vectors", STEPS) as step:
        found = verify(place, step)
    if as_json:
        json({"folder": str(place), "problems": found})
    else:
        for problem in found:
            line(problem.line())
        line(f"{place}: {len(found) or 'no'} problem{'s' if len(found) != 1 else ''}")
    if found:
        stop(Exit.NOT_CONFORMING)


@app.command()
def diff(
    first: Annotated[Path, typer.Argument(help="The folder of a suite.")],
    second: Annotated[Path, typer.Argument(help="The folder of another.")],
    as_json: AsJson = False,
) -> None:
    """Say what became of the cases of a suite in another. Clauses: ORCL-SUITE-8, ORCL-SUITE-12."""
    from clers.oracle.suite.difference import difference

    one, other = (_suite(folder, as_json=as_json) for folder in (first, second))
    found = difference(one, other)
    if as_json:
        json({"first": str(first), "second": str(second), "difference": found})
    else:
        for name in found.added:
            line(f"added    {name}")
        for gone in (*found.retired, *found.removed):
            to = f", now {gone.successor}" if gone.successor else ""
            line(f"{'retired ' if gone.reason else 'removed '} {gone.id}: {gone.reason}{to}")
        for change in found.changed:
            line(f"changed  {change.id}: {', '.join(change.keys)}")
        line(
            f"{len(found.added)} added, {len(found.retired)} retired, "
            f"{len(found.removed)} removed, {len(found.changed)} changed"
        )
    if not found.none:
        stop(Exit.NOT_CONFORMING)


@app.command(name="list")
def list_cases(
    folder: Folder = None,
    profile: Annotated[str, typer.Option(help="Only of this profile.")] = "",
    op: Annotated[str, typer.Option(help="Only of this operation.")] = "",
    clause: Annotated[str, typer.Option(help="Only that test this clause.")] = "",
    flag: Annotated[str, typer.Option(help="Only with this flag.")] = "",
    as_json: AsJson = False,
) -> None:
    """List the cases that match all that is asked for. Clauses: ORCL-SUITE-10, ORCL-SUITE-12."""
    from clers.oracle.suite.selected import matching, unknown

    suite = _suite(_folder(folder), as_json=as_json)
    stranger = unknown(suite, profile, op, clause, flag)
    if stranger:
        raise typer.BadParameter(f"no case has {stranger!r}")
    found = tuple(matching(suite, profile, op, clause, flag))
    if as_json:
        json([{"profile": of, "case": case} for of, case in found])
        return
    table(
        ["case", "operation", "profile", "size", "clauses", "flags"],
        [
            [case.id, case.op, of, case.size, " ".join(case.clauses), " ".join(case.flags)]
            for of, case in found
        ],
    )
    line(f"{len(found)} of {len(suite.cases)} cases")


@app.command()
def copy(
    into: Annotated[Path, typer.Argument(help="A folder that is empty or not there.")],
    vectors: Annotated[
        Path | None, typer.Option(help="The suite's folder; else that of this checkout.")
    ] = None,
    profile: Annotated[list[str] | None, typer.Option(help="Only this; may be repeated.")] = None,
    as_json: AsJson = False,
) -> None:
    """Copy a suite, or some profiles of it. Clauses: ORCL-SUITE-9, ORCL-SUITE-12."""
    from clers.conformance.cases.case import PROFILES
    from clers.conventions.result import Rejected
    from clers.oracle.suite.selected import copy_suite

    strangers = [name for name in profile or () if name not in PROFILES]
    if strangers:
        raise typer.BadParameter(f"{strangers[0]!r} is none of {', '.join(PROFILES)}")
    place = _folder(vectors)
    written = copy_suite(place, _suite(place, as_json=as_json), into, profile or ())
    if isinstance(written, Rejected):
        reject(str(into), written, as_json=as_json)
    if as_json:
        json({"folder": str(into), "files": written.value})
    else:
        line(f"{into}: {len(written.value)} files written")


@app.command()
def add(
    finding: Annotated[Path, typer.Argument(help="The file of a finding.")],
    slug: Annotated[str, typer.Option(help="Words for its id, with - between.")] = "",
    vectors: Annotated[
        Path | None, typer.Option(help="The suite's folder; else that of this checkout.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Take a finding among the inputs of a suite. Clauses: ORCL-SUITE-11, ORCL-SUITE-12."""
    from clers.conventions.result import Rejected
    from clers.meshfile.atomic import write_bytes
    from clers.oracle.finding import case_of, read
    from clers.oracle.suite.adding import FILE, add, shrunk
    from clers.oracle.suite.files import read_unsealed
    from clers.oracle.suite.generated import inputs_of
    from clers.oracle.suite.retiring import slug_in

    place = _folder(vectors)
    found = read(finding)
    if isinstance(found, Rejected):
        reject(str(finding), found, as_json=as_json)
    suite, inputs = read_unsealed(place), inputs_of(place)
    if isinstance(suite, Rejected):
        reject(str(place), suite, as_json=as_json)
    before = shrunk(inputs.value) if not isinstance(inputs, Rejected) else inputs
    if isinstance(before, Rejected):
        reject(str(place), before, as_json=as_json)
    case = case_of(found.value)
    known = {known.id: known for known in suite.value.cases}
    added = add(case, slug or slug_in(case.id), known, before.value)
    if isinstance(added, Rejected):
        reject(str(finding), added, as_json=as_json)
    new, data = added.value
    (place / FILE).parent.mkdir(parents=True, exist_ok=True)
    written = write_bytes(place / FILE, data)
    if isinstance(written, Rejected):
        reject(str(place / FILE), written, as_json=as_json)
    if as_json:
        json({"folder": str(place), "case": new.id})
    else:
        line(f"{place / FILE}: {new.id} written. Then: clers vectors generate")
