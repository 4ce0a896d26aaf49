"""`clers explain`: what a case asks, how its answer comes about, where an adapter goes astray."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.adapter_command import words_of
from clers.cli.options import AsJson
from clers.cli.output import Exit, json, note, progress, reject, stop

if TYPE_CHECKING:
    from clers.conformance.bounds import Bounds
    from clers.conformance.cases.case import Case
    from clers.conformance.outcome import Outcome
    from clers.oracle.explaining.explanation import Explanation, Heard
    from clers.oracle.suite.files import Suite

SUFFIXES = (".svg", ".png", ".html")


def explain(
    case: Annotated[str, typer.Argument(help="An id, the beginning of one, or a finding's file.")],
    adapter: Annotated[
        str, typer.Option("--adapter", "-a", help="Ask this adapter: a command line.")
    ] = "",
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="A picture (.svg, .png) or a page (.html).")
    ] = None,
    vectors: Annotated[Path | None, typer.Option(help="The folder of a suite.")] = None,
    strict_reasons: Annotated[
        bool, typer.Option("--strict-reasons", help="Judge reasons, not only classes.")
    ] = False,
    seconds: Annotated[float, typer.Option(min=0.1, help="For the request, at least.")] = 5.0,
    start: Annotated[float, typer.Option(min=0.1, help="Seconds until hello is answered.")] = 30.0,
    memory: Annotated[int, typer.Option(min=1, help="MiB of address space.")] = 8192,
    as_json: AsJson = False,
) -> None:
    """Say what a case asks, by which clauses, and how its answer comes about.

    With -a also where an adapter's answer diverges. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-5.
    """
    import msgspec

    from clers.cli.explain_text import print_explanation
    from clers.conformance.bounds import Bounds
    from clers.conformance.judging.judged import GOOD
    from clers.oracle.explaining.explain import explanation
    from clers.oracle.reports.texts import clause_texts

    if out is not None and out.suffix.lower() not in SUFFIXES:
        raise typer.BadParameter(f"{out} is none of {', '.join(SUFFIXES)}", param_hint="--out")
    command = words_of(adapter) if adapter else None
    with progress("explain", 3) as step:
        step("reading")
        chosen, suite, parent = _chosen(case, vectors)
        found = explanation(chosen, clause_texts(), _flags(suite))
        outcome: Outcome | None = None
        if command is not None:
            step("asking")
            bounds = Bounds(start=start, request=seconds, memory=memory << 20)
            heard, outcome = _heard(chosen, tuple(command), bounds, strict=strict_reasons)
            found = msgspec.structs.replace(found, heard=heard)
        if out is not None:
            step("drawing")
            _draw(out, found, chosen, outcome, parent)
    if as_json:
        json(found)
    else:
        print_explanation(found)
    good = isinstance(found.heard, msgspec.UnsetType) or found.heard.judged.status in GOOD
    stop(Exit.CONFORMING if good else Exit.NOT_CONFORMING)


def _chosen(name: str, folder: Path | None) -> "tuple[Case, Suite | None, Case | None]":
    """The case, its suite, and the parent of its fault. Clause: ORCL-EXPLAIN-1."""
    from msgspec import UnsetType

    from clers.conventions.result import Rejected
    from clers.oracle.explaining.found import NoCase, case_named
    from clers.oracle.finding import read
    from clers.oracle.suite.files import DEFAULT, read_suite

    if Path(name).suffix == ".json":
        finding = read(Path(name))
        if isinstance(finding, Rejected):
            reject(name, finding)
        return finding.value.case, None, None
    suite = read_suite(folder or DEFAULT)
    if isinstance(suite, Rejected):
        note(f"{folder or DEFAULT}: {suite.line()}")
        stop(Exit.SELF_CHECK)
    cases = (*suite.value.cases, *suite.value.canaries)
    found = case_named(name, cases)
    if isinstance(found, NoCase):
        raise typer.BadParameter(found.why, param_hint="CASE")
    wanted = "" if isinstance(found.fault, UnsetType) else found.fault.parent
    return found, suite.value, next((case for case in cases if case.id == wanted), None)


def _flags(suite: "Suite | None") -> dict[str, str]:
    """What each flag means. Clause: ORCL-CASE-5."""
    return {flag.name: f"{flag.mistake}; {flag.matters}" for flag in (suite.flags if suite else ())}


def _heard(
    case: "Case", command: tuple[str, ...], bounds: "Bounds", *, strict: bool
) -> "tuple[Heard, Outcome]":
    """What the adapter says; without a process the command ends. Clause: ORCL-EXPLAIN-4."""
    from clers.conformance.outcome import NoProcess
    from clers.oracle.explaining.asking import hear

    found = hear(case, command, bounds, strict_reasons=strict)
    if isinstance(found, NoProcess):
        note(f"{' '.join(command)}: {found.why}")
        stop(Exit.ADAPTER)
    return found


def _draw(
    out: Path,
    found: "Explanation",
    case: "Case",
    outcome: "Outcome | None",
    parent: "Case | None",
) -> None:
    """Write the picture, or the page with the picture in it. Clause: ORCL-EXPLAIN-5."""
    from msgspec import UnsetType

    from clers.cli.loading import taken
    from clers.conventions.result import Rejected
    from clers.meshfile.atomic import write_bytes
    from clers.oracle.explaining.pictured import picture
    from clers.oracle.reports.page import page
    from clers.pictures.png import png_of
    from clers.pictures.svg import svg_of

    parted = None if isinstance(found.heard, UnsetType) else found.heard.judged.divergence
    divergence = None if parted is None or isinstance(parted, UnsetType) else parted
    drawn = picture(case, divergence, outcome, parent=parent)
    if out.suffix.lower() == ".html":
        data = page(found, None if isinstance(drawn, Rejected) else drawn.value).encode()
    else:
        scene = taken(drawn, Path(case.id))
        data = svg_of(scene).encode() if out.suffix.lower() == ".svg" else png_of(scene)
    taken(write_bytes(out, data), out)
