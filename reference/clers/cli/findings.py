"""`clers fuzz`, `replay`, `shrink`: failures found, asked again, and made small. ORCL-FUZZ-1."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.adapter_command import Command, nobody, words_of
from clers.cli.loading import taken
from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, stop

if TYPE_CHECKING:
    from clers.conformance.bounds import Bounds
    from clers.conformance.cases.case import Case
    from clers.conformance.messages import Operation
    from clers.oracle.finding import Finding, Party, Shrunk
    from clers.oracle.fuzz.checks import Asker
    from clers.oracle.fuzz.replay import Replayed

Against = Annotated[
    str, typer.Option("--against", help="A second adapter's command line, to compare with.")
]
Seconds = Annotated[float, typer.Option(min=0.1, help="For each request, at least.")]


def fuzz(
    adapter: Command,
    max_time: Annotated[float | None, typer.Option(min=0.1, help="Seconds.")] = None,
    examples: Annotated[
        int | None, typer.Option(min=1, help="Examples of each operation; else 300.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Which examples.")] = 0,
    op: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="This operation; repeatable.")
    ] = None,
    against: Against = "",
    out: Annotated[Path, typer.Option("-o", "--out", help="Where findings go.")] = Path(),
    workers: Annotated[int, typer.Option(min=1, help="Processes that ask.")] = 1,
    scheduler: Annotated[str, typer.Option(help="The address of a Dask scheduler.")] = "",
    seconds: Seconds = 5.0,
    as_json: AsJson = False,
) -> None:
    """Send random requests to an adapter, and shrink what fails. Clauses: ORCL-FUZZ-1 … -6."""
    from clers.cli.fuzz_run import carry_out
    from clers.conformance.results import RESULTS
    from clers.oracle.fuzz.campaign import Plan, place_of
    from clers.oracle.pool.spread import obstacle

    for name in op or []:
        if name not in RESULTS:
            raise typer.BadParameter(f"{name!r} is none of {', '.join(RESULTS)}")
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise typer.BadParameter(f"{out}: {fault.strerror}", param_hint="--out") from fault
    plan = Plan(
        tuple(words_of(adapter)),
        out,
        tuple(words_of(against)) if against else (),
        tuple(op or ()),
        seed,
        examples,
        max_time,
        workers,
        scheduler,
        _bounds(seconds),
    )
    why = obstacle(place_of(plan))
    if why:
        raise typer.BadParameter(why, param_hint="--scheduler")
    carry_out(plan, adapter, against, as_json=as_json)


def _bounds(seconds: float) -> "Bounds":
    from clers.conformance.bounds import Bounds
    from clers.oracle.fuzz.campaign import RESTARTS

    return Bounds(request=seconds, restarts=RESTARTS)


@contextmanager
def _askers(
    adapter: str, against: str, seconds: float, *, as_json: bool
) -> "Iterator[tuple[Asker, Asker | None, tuple[Party, Party | None]]]":
    """The adapters, started and ended. Clause: ORCL-RUN-9."""
    from contextlib import ExitStack

    from clers.conformance.outcome import NoProcess
    from clers.conformance.session import Session
    from clers.oracle.fuzz.checks import asker
    from clers.oracle.fuzz.found import party

    with ExitStack() as stack:
        met = []
        for command in (adapter, against):
            if command:
                words = words_of(command)
                session = stack.enter_context(Session(words, _bounds(seconds)))
                said = session.introduction()
                if isinstance(said, NoProcess):
                    nobody(NoProcess(f"{command}: {said.why}", said.errors), as_json=as_json)
                met.append((asker(session.ask, said), party(words, said)))
        (first, here), *others = met
        second, there = others[0] if others else (None, None)
        yield first, second, (here, there)


def replay(
    files: Annotated[list[Path], typer.Argument(help="Findings.")],
    adapter: Command,
    against: Against = "",
    seconds: Seconds = 5.0,
    as_json: AsJson = False,
) -> None:
    """Send the literal request of each finding again. Clauses: ORCL-REPLAY-1, ORCL-REPLAY-2."""
    from clers.oracle.finding import read
    from clers.oracle.fuzz.replay import Came
    from clers.oracle.fuzz.replay import replay as again

    findings = [(path, taken(read(path), path, as_json=as_json)) for path in files]
    with _askers(adapter, against, seconds, as_json=as_json) as (first, second, _):
        came = [(path, found, again(found, first, second)) for path, found in findings]
    if as_json:
        json([_as_record(path, found, replayed) for path, found, replayed in came])
    else:
        for path, found, replayed in came:
            line(f"{path}: {replayed.came}  {found.case.op}  {_why(replayed)}".rstrip())
    passed = all(replayed.came is Came.PASSES for _, _, replayed in came)
    stop(Exit.CONFORMING if passed else Exit.NOT_CONFORMING)


def _why(replayed: "Replayed") -> str:
    return replayed.why if replayed.tried is None else replayed.tried.judged.why


def _as_record(path: Path, found: "Finding", replayed: "Replayed") -> dict[str, object]:
    judged = None if replayed.tried is None else replayed.tried.judged
    why = _why(replayed)
    return {
        "file": str(path),
        "came": str(replayed.came),
        "op": found.case.op,
        "why": why,
        "judged": judged,
    }


def shrink(
    what: Annotated[str, typer.Argument(help="A finding, the id of a vector, or a mesh file.")],
    adapter: Command,
    out: Annotated[Path, typer.Option("-o", "--out", help="The folder for the finding.")] = Path(),
    vectors: Annotated[Path | None, typer.Option(help="The folder of a suite.")] = None,
    op: Annotated[str, typer.Option(help="What to ask about a mesh file.")] = "",
    code: Annotated[str, typer.Option(help="The code of mesh.encode.")] = "plain",
    against: Against = "",
    seconds: Seconds = 5.0,
    max_time: Annotated[float, typer.Option(min=0.1, help="Seconds for shrinking.")] = 60.0,
    as_json: AsJson = False,
) -> None:
    """Make a failing input as small as it can be. Clauses: ORCL-SHRINK-1 … ORCL-SHRINK-7."""
    from clers.oracle.finding import Finding, write
    from clers.oracle.fuzz.checks import one_against_the_other
    from clers.oracle.fuzz.families import check_of
    from clers.oracle.fuzz.shrink import smallest
    from clers.oracle.fuzz.shrinking.engine import Patience

    operation, law, before = _subject(what, vectors, op, code, as_json=as_json)
    with _askers(adapter, against, seconds, as_json=as_json) as (first, second, parties):
        check = check_of(first, _name(operation), law)
        if second is not None:
            check = one_against_the_other(first, second)
        if check is None:
            raise typer.BadParameter(f"the adapter does not do what the law {law} needs")
        found = smallest(operation, check, *parties, before, Patience(seconds=max_time))
    match found:
        case None:
            raise typer.BadParameter(f"{what}: the adapter does not declare what it requires")
        case Finding():
            out.mkdir(parents=True, exist_ok=True)
            path = taken(write(out, found), out, as_json=as_json)
            if as_json:
                json({"file": str(path), "finding": found})
            else:
                from clers.cli.fuzz_run import block

                for text in block(found, path, adapter, against):
                    line(text)
            stop(Exit.NOT_CONFORMING)
        case _:
            if found.gone:
                note(f"{adapter}: {found.gone}")
                stop(Exit.ADAPTER)
            if as_json:
                json({"file": None, "finding": None})
            else:
                line(f"{what}: passes, nothing to shrink")


def _name(operation: "Operation") -> str:
    from clers.oracle.fuzz.question import name_of

    return name_of(operation)


def _subject(
    what: str, vectors: Path | None, op: str, code: str, *, as_json: bool
) -> "tuple[Operation, str, Shrunk | None]":
    """The request, the law that it failed, and how it was shrunk before. Clause: ORCL-SHRINK-6."""
    from msgspec import UnsetType

    from clers.oracle.finding import read
    from clers.oracle.fuzz.shrink import MESH_OPERATIONS, of_case, of_mesh

    path = Path(what)
    if vectors is not None or not path.exists():
        case = _vector(what, vectors, as_json=as_json)
        return taken(of_case(case), path, as_json=as_json), "", None
    if path.suffix.lower() == ".json":
        found = taken(read(path), path, as_json=as_json)
        before = None if isinstance(found.shrunk, UnsetType) else found.shrunk
        return taken(of_case(found.case), path, as_json=as_json), found.law, before
    if op not in MESH_OPERATIONS:
        raise typer.BadParameter(f"one of {', '.join(MESH_OPERATIONS)}", param_hint="--op")
    return taken(of_mesh(path, op, code), path, as_json=as_json), "", None


def _vector(name: str, folder: Path | None, *, as_json: bool) -> "Case":
    from clers.oracle.suite.files import DEFAULT, read_suite

    place = DEFAULT if folder is None else folder
    suite = taken(read_suite(place), place, as_json=as_json)
    case = next((case for case in (*suite.cases, *suite.canaries) if case.id == name), None)
    if case is None:
        raise typer.BadParameter(f"{name}: no such file, and no vector of {place} has this id")
    return case
