"""`clers spec`: the specification's clauses and who cites them. Clause: CONV-CLAUSE-2."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.output import Exit, json, line, stop, table
from clers.cli.reading import read_with_laws

if TYPE_CHECKING:
    from clers.specification.repository import Repository

app = typer.Typer(
    name="spec", no_args_is_help=True, rich_markup_mode=None, help="The specification itself."
)

Root = Annotated[
    Path | None,
    typer.Option(
        help="The repository; else the nearest folder upward that has spec/.", exists=True
    ),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]


def _root(given: Path | None) -> Path:
    from clers.specification.repository import find_root

    root = find_root(given or Path.cwd())
    if root is None or (given and root != given.resolve()):
        raise typer.BadParameter(f"no spec/00-conventions.md in {given or 'any folder upward'}")
    return root


@app.command()
def generate(
    root: Root = None,
    check: Annotated[bool, typer.Option("--check", help="Write nothing, compare.")] = False,
) -> None:
    """Write the enumeration of clauses that the code uses."""
    from clers.specification.clause_module import clause_module, replace_file
    from clers.specification.clause_text import ClauseText
    from clers.specification.repository import CLAUSE_MODULE, read_specification

    folder = _root(root)
    stated = [item for item in read_specification(folder) if isinstance(item, ClauseText)]
    file, text = folder / CLAUSE_MODULE, clause_module(stated)
    same = file.is_file() and file.read_text(encoding="utf-8") == text
    if not same and check:
        line(f"{CLAUSE_MODULE}: is not what the chapters say")
        stop(Exit.NOT_CONFORMING)
    if not same:
        replace_file(file, text)
    line(f"{CLAUSE_MODULE}: {len(stated)} clauses, {'unchanged' if same else 'written'}")


@app.command()
def check(root: Root = None, as_json: AsJson = False) -> None:
    """Find everything wrong with the specification and its citations."""
    from clers.specification.check import check as findings_of

    repository = read_with_laws(_root(root))
    findings = findings_of(repository)
    if as_json:
        json({"clauses": len(repository.clauses), "findings": findings})
    else:
        for finding in findings:
            line(finding.sentence)
        counts = f"{len(repository.clauses)} clauses, {len(repository.citations)} citations"
        line(f"{counts}, {len(findings)} findings")
    stop(Exit.NOT_CONFORMING if findings else Exit.CONFORMING)


def _groups(repository: "Repository", clause: str) -> dict[str, list[str]]:
    groups: dict[str, list[str]] = {}
    for site in repository.sites(clause):
        groups.setdefault(str(site.kind), []).append(site.place)
    return groups


def _print_sites(groups: dict[str, list[str]]) -> None:
    for kind, places in groups.items():
        for place in places:
            line(f"  {kind:5}  {place}")
    if not groups:
        line("  no place cites it")


@app.command()
def lock(
    clauses: Annotated[list[str] | None, typer.Argument(help="Ids of clauses read again.")] = None,
    every: Annotated[bool, typer.Option("--all", help="All that changed.")] = False,
    root: Root = None,
) -> None:
    """Declare clauses read again: lock their present text and print every place that cites them."""
    from clers.specification.clause_module import replace_file
    from clers.specification.identifier import order
    from clers.specification.lock import LOCK, locked, unread, write_lock

    if bool(clauses) == every:
        raise typer.BadParameter("name clauses, or say --all")
    repository = read_with_laws(_root(root))
    wanted = frozenset(clauses or unread(repository.lock, repository.clauses))
    unknown = sorted(wanted - repository.ids - set(repository.lock))
    if unknown:
        raise typer.BadParameter(f"no such clause: {', '.join(unknown)}")
    after = locked(repository.lock, repository.clauses, wanted)
    replace_file(repository.root / LOCK, write_lock(after))
    for clause in sorted(wanted, key=order):
        line(f"{clause} {'locked; read again:' if clause in after else 'dropped'}")
        _print_sites(_groups(repository, clause))
    line(f"{LOCK}: {len(wanted)} entries changed, {len(after)} in all")


@app.command()
def show(clause: str, root: Root = None, as_json: AsJson = False) -> None:
    """Print a clause and every place that cites it."""

    repository = read_with_laws(_root(root))
    found = next((text for text in repository.clauses if text.clause == clause), None)
    if found is None:
        raise typer.BadParameter(f"no such clause: {clause}")
    groups = _groups(repository, clause)
    if as_json:
        json({"clause": found, "hash": found.hash, "sites": groups})
    else:
        line(f"{found.clause}  ({found.path}:{found.line})\n{found.text}\n")
        _print_sites(groups)


@app.command("list")
def list_clauses(
    chapter: Annotated[int | None, typer.Option(help="Of this chapter only.")] = None,
    root: Root = None,
    as_json: AsJson = False,
) -> None:
    """List the clauses with the number of places that cite each."""
    from clers.specification.citation import Kind

    repository = read_with_laws(_root(root))
    chosen = [text for text in repository.clauses if chapter in (None, text.chapter)]
    if as_json:
        json(chosen)
        return
    rows = []
    for text in chosen:
        kinds = [site.kind for site in repository.sites(text.clause)]
        opening = " ".join(text.text.split())
        cut = opening if len(opening) <= 60 else f"{opening[:59]}…"
        rows.append([text.clause, *(kinds.count(kind) for kind in Kind), cut])
    table(["clause", *map(str, Kind), "text"], rows)


@app.command()
def proofs(
    root: Root = None,
    as_json: AsJson = False,
    write: Annotated[bool, typer.Option("--write", help="Put the table into the readme.")] = False,
    check: Annotated[bool, typer.Option("--check", help="Print faults only.")] = False,
) -> None:
    """Print the theorems that clauses rest on and how each is known; find dead references."""
    from clers.specification.clause_module import replace_file
    from clers.specification.proof_table import ids_in_words, row, spliced, summary
    from clers.specification.proofs import all_theorems, findings_of
    from clers.specification.theorems import README

    if write and check:
        raise typer.BadParameter("--write or --check, not both")
    repository = read_with_laws(_root(root))
    found, readme = all_theorems(repository), repository.root / README
    if write and readme.is_file():
        text = spliced(readme.read_text(encoding="utf-8"), found)
        if text is not None:
            replace_file(readme, text)
    findings = findings_of(repository)
    if as_json:
        json({"theorems": list(map(row, found)), "findings": findings})
    else:
        if not check:
            for item in map(row, found):
                line(f"{item.theorem}  ({item.note}:{item.line})")
                line(f"  known by  {'; '.join(words for _, words in item.known_by)}")
                line(f"  clauses   {ids_in_words(item.clauses)}")
                line(f"  laws      {', '.join(item.laws) or 'none'}")
        for finding in findings:
            line(finding.sentence)
        line(f"{summary(found)} {len(findings)} findings")
    stop(Exit.NOT_CONFORMING if findings else Exit.CONFORMING)
