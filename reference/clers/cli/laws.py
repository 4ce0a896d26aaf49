"""`clers laws`: the registry of laws, listed and run. Clauses: CONV-LAW-3, CONV-LAW-5."""

from typing import TYPE_CHECKING, Annotated, assert_never

import typer

from clers.cli.output import Exit, json, line, note, progress, stop, table

if TYPE_CHECKING:
    from clers.conventions.law import AnyLaw
    from clers.specification.judge import Outcome

app = typer.Typer(
    name="laws", invoke_without_command=True, rich_markup_mode=None, help="List the laws."
)

Chapter = Annotated[int | None, typer.Option(help="Of this chapter only.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]


def _laws(chapter: int | None) -> "tuple[AnyLaw, ...]":
    """The laws of a chapter, or all; a registry with a name twice is no oracle."""
    from clers.laws import ALL, CHAPTERS, names_given_twice

    twice = names_given_twice(ALL)
    if twice:
        note(f"clers: two laws are named {', '.join(twice)}")
        stop(Exit.SELF_CHECK)
    if chapter is not None and chapter not in CHAPTERS:
        known = ", ".join(map(str, CHAPTERS))
        raise typer.BadParameter(f"chapter {chapter} has no laws; these have: {known}")
    return ALL if chapter is None else CHAPTERS[chapter]


@app.callback()
def list_laws(context: typer.Context, chapter: Chapter = None, as_json: AsJson = False) -> None:
    """List the laws: name, clause, statement, and what they range over."""
    if context.invoked_subcommand is not None:
        if as_json or chapter is not None:
            raise typer.BadParameter(f"options go after {context.invoked_subcommand}")
        return
    laws = _laws(chapter)
    if as_json:
        json(
            [
                {
                    "name": law.name,
                    "clause": law.clause,
                    "statement": law.statement,
                    "domain": law.domain,
                    "meaning": law.meaning,
                }
                for law in laws
            ]
        )
    else:
        rows = [[law.name, law.clause, law.domain, law.statement] for law in laws]
        table(["law", "clause", "for all", "holds"], rows)
        meanings = sorted({(law.domain, law.meaning) for law in laws})
        line("")
        table(["domain", "meaning"], meanings)


@app.command()
def run(
    law: Annotated[list[str] | None, typer.Option(help="This law only; may be repeated.")] = None,
    chapter: Chapter = None,
    examples: Annotated[int, typer.Option(min=1, help="Examples for each law.")] = 100,
    seed: Annotated[int, typer.Option(help="Another seed draws other examples.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Run the laws of the reference on generated examples."""
    from clers.generate.domains import strategy_for
    from clers.specification.judge import Held, judge

    known = _laws(chapter)
    unknown = sorted(set(law or ()) - {one.name for one in known})
    if unknown:
        raise typer.BadParameter(f"no such law: {', '.join(unknown)}")
    chosen = [one for one in known if not law or one.name in law]
    if not chosen:
        note("clers: there are no laws to run")
        stop(Exit.SELF_CHECK)
    outcomes: list[tuple[AnyLaw, Outcome]] = []
    with progress("laws", len(chosen)) as step:
        for one in chosen:
            step(one.name)
            outcomes.append((one, judge(one, strategy_for(one.domain), examples, seed)))
            if not as_json:
                _print(*outcomes[-1])
    held = sum(isinstance(outcome, Held) for _, outcome in outcomes)
    if as_json:
        json([_record(one, outcome) for one, outcome in outcomes])
    else:
        line(f"{held} of {len(outcomes)} laws held")
    stop(Exit.CONFORMING if held == len(outcomes) else Exit.NOT_CONFORMING)


def _print(law: "AnyLaw", outcome: "Outcome") -> None:
    from clers.specification.judge import Failed, Held, Unjudged

    match outcome:
        case Held(examples):
            line(f"ok      {law.name} [{law.clause}] {examples} examples")
        case Failed(example, expected, got, where):
            line(f"FAILED  {law.name} [{law.clause}] {law.statement}")
            line(f"        example:  {example}")
            line(f"        expected: {expected}")
            line(f"        got:      {got}")
            line(f"        where:    {where}")
        case Unjudged(why):
            line(f"ERROR   {law.name} [{law.clause}] {why}")
        case _:
            assert_never(outcome)


def _record(law: "AnyLaw", outcome: "Outcome") -> dict[str, str | int]:
    from clers.specification.judge import Failed, Held, Unjudged

    about: dict[str, str | int] = {"law": law.name, "clause": law.clause}
    match outcome:
        case Held(examples):
            return {**about, "outcome": "held", "examples": examples}
        case Failed(example, expected, got, where):
            verdict: dict[str, str | int] = {"expected": expected, "got": got, "where": where}
            return {**about, "outcome": "failed", "example": example, **verdict}
        case Unjudged(why):
            return {**about, "outcome": "unjudged", "why": why}
        case _:
            assert_never(outcome)
