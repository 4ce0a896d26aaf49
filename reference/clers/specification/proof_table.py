"""The table of all theorems, as the readme of the notes has it. Clause: TOOL-PROOF-6."""

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, assert_never

from clers.specification.identifier import number, series
from clers.specification.theorems import (
    README,
    Certificate,
    Cited,
    Coq,
    Exhaustive,
    Prose,
    Smt,
    Theorem,
    Way,
)

BEGIN: Final = "<!-- theorems: written by `clers spec proofs --write` -->"
END: Final = "<!-- end of theorems -->"
_BETWEEN: Final = re.compile(rf"{re.escape(BEGIN)}\n.*?{re.escape(END)}", re.DOTALL)


def way_in_words(way: Way) -> str:
    """How a theorem is known, in a few words."""
    match way:
        case Coq(name):
            return f"Coq `{name}`"
        case Smt(file, name):
            return f"z3 `{file}: {name}`"
        case Certificate(file):
            return f"certificate `{file}`"
        case Exhaustive(bound, judge):
            return f"exhaustive to {bound} (`{judge}`)"
        case Cited(source):
            return f"cited ({source})"
        case Prose():
            return "prose"
        case _ as never:
            assert_never(never)


@dataclass(frozen=True, slots=True)
class Row:
    """A theorem as the table shows it; `known_by` has pairs of the kind of a way and its words."""

    theorem: str
    note: str
    line: int
    known_by: tuple[tuple[str, str], ...]
    clauses: tuple[str, ...]
    laws: tuple[str, ...]
    assumes: str


def row(of: Theorem) -> Row:
    """One theorem's row. Clause: TOOL-PROOF-6."""
    ways = tuple((kind(way), way_in_words(way)) for way in of.ways)
    return Row(of.name, of.path, of.line, ways, of.clauses, of.judges, of.assumes)


def ways_in_words(ways: tuple[Way, ...]) -> str:
    """All ways in a few words; several lemmas of one file by their number."""
    lemmas = Counter(way.file for way in ways if isinstance(way, Smt))
    said = [
        f"z3 `{way.file}` ({lemmas[way.file]} lemmas)"
        if isinstance(way, Smt) and lemmas[way.file] > 1
        else way_in_words(way)
        for way in ways
    ]
    return "; ".join(dict.fromkeys(said))


def kind(way: Way) -> str:
    """The kind of a way, one word."""
    return "z3" if isinstance(way, Smt) else type(way).__name__.lower()


def only_prose(theorem: Theorem) -> bool:
    """Whether no machine has read a proof of it or gone through its cases."""
    return all(isinstance(way, Prose | Cited) for way in theorem.ways)


def ids_in_words(clauses: Iterable[str]) -> str:
    """Ids in their order, runs of three or more of one topic as ranges. Clause: CONV-CLAUSE-8."""
    runs: list[list[str]] = []
    for clause in clauses:
        last = runs[-1][-1] if runs else ""
        if series(last) == series(clause) and number(clause) == number(last) + 1:
            runs[-1].append(clause)
        else:
            runs.append([clause])
    said = [f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(run) for run in runs]
    return ", ".join(said)


def summary(theorems: tuple[Theorem, ...]) -> str:
    """One sentence of counts: theorems, notes, clauses, and the kinds of ways."""
    clauses = {clause for theorem in theorems for clause in theorem.clauses}
    kinds = Counter(way for item in theorems for way in {kind(way) for way in item.ways})
    known = ", ".join(f"{n} by {name}" for name, n in sorted(kinds.items()))
    notes = len({theorem.path for theorem in theorems})
    prose = sum(map(only_prose, theorems))
    counts = f"Theorems: {len(theorems)}, in notes: {notes}, for clauses: {len(clauses)}"
    return f"{counts}. Known: {known or 'none'}; by words alone: {prose}."


def table(theorems: tuple[Theorem, ...]) -> str:
    """The whole table in Markdown, with the sentence of counts above it."""
    rows = ["| theorem | known by | clauses | laws and tests |", "|---|---|---|---|"]
    for item in theorems:
        name = f"[`{item.name}`]({Path(item.path).name}#{item.anchor})"
        ways = ways_in_words(item.ways)
        judges = ", ".join(f"`{judge}`" for judge in item.judges) or "none"
        rows.append(f"| {name} | {ways} | {ids_in_words(item.clauses)} | {judges} |")
    return "\n".join([summary(theorems), "", *rows])


def spliced(readme: str, theorems: tuple[Theorem, ...]) -> str | None:
    """The readme with the table between its marks; None if it has not the marks, once."""
    between = f"{BEGIN}\n\n{table(theorems)}\n\n{END}"
    if len(_BETWEEN.findall(readme)) != 1:
        return None
    return _BETWEEN.sub(lambda _: between, readme)


def as_written(root: Path, theorems: tuple[Theorem, ...]) -> str | None:
    """What is wrong with the readme's table; None if nothing is. Clause: TOOL-PROOF-6."""
    file = root / README
    readme = file.read_text(encoding="utf-8") if file.is_file() else ""
    if not theorems and not readme:
        return None
    expected = spliced(readme, theorems)
    if expected is None:
        return f"has not, once, the marks {BEGIN} and {END}"
    return None if expected == readme else "its table is not of now: `clers spec proofs --write`"
