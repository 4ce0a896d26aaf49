"""Rules on proof notes: what a head refers to is there. Clauses: TOOL-PROOF-1 to TOOL-PROOF-6."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final, assert_never

from clers.specification.finding import Finding, Rule
from clers.specification.identifier import mentions
from clers.specification.identity import cited_exists
from clers.specification.links import inside
from clers.specification.markdown import links
from clers.specification.proof_table import as_written
from clers.specification.repository import Repository
from clers.specification.theorems import (
    FOLDER,
    Certificate,
    Cited,
    Coq,
    Exhaustive,
    Malformed,
    Prose,
    Smt,
    Theorem,
    Way,
    is_note,
    theorems,
)

RULE: Final = "proof"
_TITLE: Final = r"(?:Theorem|Lemma|Corollary|Proposition|Remark|Fact)"
_HOLE: Final = re.compile(r"\b(?:Admitted|admit|give_up|Axioms?|Conjectures?|Parameters?)\b")
_QUOTED: Final = re.compile(r"^ {0,3}>", re.MULTILINE)


def all_theorems(of: Repository) -> tuple[Theorem, ...]:
    """Every theorem of the notes that can be read, in the order of the notes."""
    read = (item for page in of.pages if is_note(page.path) for item in theorems(page))
    return tuple(item for item in read if isinstance(item, Theorem))


def headed(of: Repository) -> Iterator[Finding]:
    """Each note has a head, and each head can be read; no name twice. Clause: TOOL-PROOF-1."""
    first: dict[str, Theorem] = {}
    for page in of.pages:
        if not is_note(page.path):
            continue
        found = tuple(theorems(page))
        if not found:
            yield Finding(RULE, page.path, 1, "", "has no theorem with a head")
        for item in found:
            if isinstance(item, Malformed):
                yield Finding(RULE, item.path, item.line, "", item.why)
            elif (before := first.setdefault(item.name, item)) is not item:
                text = f"theorem {item.name} is at {before.path}:{before.line} too"
                yield Finding(RULE, item.path, item.line, "", text)


def without_comments(source: str) -> str:
    """A Coq file without its comments, which nest; line breaks stay."""
    kept, depth, at = list[str](), 0, 0
    for mark in re.finditer(r"\(\*|\*\)", source):
        text = source[at : mark.start()]
        kept.append("\n" * text.count("\n") if depth else text)
        depth = max(0, depth + (1 if mark[0] == "(*" else -1))
        at = mark.end()
    return "".join(kept) + ("" if depth else source[at:])


def _file(of: Repository, path: str) -> str | None:
    file = of.root / FOLDER / path
    return file.read_text(encoding="utf-8") if file.is_file() else None


def _coq_fault(of: Repository, full: str) -> str | None:
    library, _, rest = full.partition(".")
    file, _, path = rest.partition(".")
    name = path.rpartition(".")[2]
    if library != "Clers" or not name:
        return f"Coq's {full} is not of the form Clers.File.theorem"
    source = _file(of, f"coq/{file}.v")
    if source is None:
        return f"there is no {FOLDER}/coq/{file}.v"
    stated = rf"^\s*(?:#\[\w+\]\s*)?{_TITLE}\s+{re.escape(name)}(?![\w'])"
    if re.search(stated, without_comments(source), re.MULTILINE):
        return None
    return f"{FOLDER}/coq/{file}.v states no theorem {name}"


def _smt_fault(of: Repository, way: Smt) -> str | None:
    source = _file(of, way.file)
    if source is None:
        return f"there is no {FOLDER}/{way.file}"
    return None if way.name in lemmas(source) else f"{FOLDER}/{way.file} has no lemma {way.name}"


def lemmas(source: str, kind: str = "Lemma") -> frozenset[str]:
    """The names of the lemmas that a file for z3 writes out as `Lemma(name, …)`; or controls."""
    try:
        tree = ast.parse(source)
    except SyntaxError:
        return frozenset()
    names = (
        node.args[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == kind
        and node.args
        and isinstance(node.args[0], ast.Constant)
    )
    return frozenset(name for name in names if isinstance(name, str))


def controlled(of: Repository) -> Iterator[Finding]:
    """Each file for z3 that has a lemma has a control. Clause: TOOL-PROOF-7."""
    for file in sorted((of.root / FOLDER / "smt").glob("*.py")):
        source = file.read_text(encoding="utf-8")
        if lemmas(source) and not lemmas(source, "Control"):
            path = file.relative_to(of.root).as_posix()
            yield Finding(RULE, path, 1, "", "has lemmas and no control")


def _known_laws(of: Repository) -> frozenset[str] | None:
    """The registry's laws, or of another repository those that its files write out.

    None where the registry cannot be imported, which another rule says.
    """
    if isinstance(of.registry, str):
        return None
    written = (law.name for module in of.modules for law in module.laws)
    return frozenset((*written, *of.registry))


def _judge_fault(of: Repository, known: frozenset[str] | None, judge: str) -> str | None:
    if "/" not in judge:
        return None if known is None or judge in known else f"no law is named {judge}"
    file = judge.partition("::")[0]
    good = file.startswith("tests/") and Path(file).suffix == ".py" and (of.root / file).is_file()
    return None if good else f"there is no test {judge}"


def _way_fault(of: Repository, known: frozenset[str] | None, way: Way) -> str | None:
    match way:
        case Coq(name):
            return _coq_fault(of, name)
        case Smt():
            return _smt_fault(of, way)
        case Certificate(file):
            return None if _file(of, file) is not None else f"there is no {FOLDER}/{file}"
        case Exhaustive(_, judge):
            return _judge_fault(of, known, judge)
        case Cited() | Prose():
            return None
        case _ as never:
            assert_never(never)


def supported(of: Repository) -> Iterator[Finding]:
    """All that heads refer to is there. Clauses: TOOL-PROOF-2, TOOL-PROOF-3.

    Ids of clauses are looked up like those in any other text (CONV-CLAUSE-8).
    """
    known = _known_laws(of)
    for theorem in all_theorems(of):
        faults = [("Known by", _way_fault(of, known, way)) for way in theorem.ways]
        faults += [("Laws", _judge_fault(of, known, judge)) for judge in theorem.judges]
        for field, fault in faults:
            if fault is not None:
                text = f"{theorem.name}: {fault}"
                yield Finding(RULE, theorem.path, theorem.line_of(field), "", text)


def without_holes(of: Repository) -> Iterator[Finding]:
    """No Coq file takes a statement without proof. Clause: TOOL-PROOF-4."""
    for file in sorted((of.root / FOLDER / "coq").rglob("*.v")):
        source = without_comments(file.read_text(encoding="utf-8"))
        for hole in _HOLE.finditer(source):
            path, line = file.relative_to(of.root).as_posix(), source.count("\n", 0, hole.start())
            yield Finding(RULE, path, line + 1, "", f"takes something unproved: {hole[0]}")


def _paragraphs(text: str) -> Iterator[tuple[int, str]]:
    """The paragraphs of a page that are no quotes, each with its first line (from 1)."""
    at = 1
    for block in re.split(r"(\n\s*\n)", text):
        if block.strip() and not _QUOTED.search(block):
            yield at, block
        at += block.count("\n")


def linked(of: Repository) -> Iterator[Finding]:
    """Clauses and notes lead to each other. Clause: TOOL-PROOF-5."""
    proved = {clause: item for item in all_theorems(of) for clause in item.clauses}
    for page in of.pages:
        if not page.path.startswith("spec/"):
            continue
        for line, text in _paragraphs(page.text):
            if f"{FOLDER}/" not in text:
                continue
            for clause in dict.fromkeys(mention.clause for mention in mentions(text)):
                if clause not in proved:
                    said = "a note is to have its proof, and no theorem justifies it"
                    yield Finding(RULE, page.path, line, clause, said)
    yield from _to_notes(of)


def _to_notes(of: Repository) -> Iterator[Finding]:
    """Each page that states a clause of a theorem links to the theorem's note."""
    pages = {page.path: page for page in of.pages}
    targets = {
        path: {inside(page, link.target.partition("#")[0]) for link in links(page)}
        for path, page in pages.items()
        if path.startswith("spec/")
    }
    stated = {clause.clause: clause for clause in of.clauses}
    missing = {
        (clause.path, theorem.path): (clause, theorem)
        for theorem in reversed(all_theorems(of))
        for id_ in reversed(theorem.clauses)
        if (clause := stated.get(id_)) and theorem.path not in targets.get(clause.path, set())
    }
    for clause, theorem in reversed(missing.values()):
        text = f"theorem {theorem.name} justifies it, and its page does not link to {theorem.path}"
        yield Finding(RULE, clause.path, clause.line, clause.clause, text)


def tabled(of: Repository) -> Iterator[Finding]:
    """The readme of the notes has the table of all theorems as it is. Clause: TOOL-PROOF-6."""
    fault = as_written(of.root, all_theorems(of))
    if fault is not None:
        yield Finding(RULE, f"{FOLDER}/README.md", 1, "", fault)


RULES: Final[tuple[Rule, ...]] = (headed, supported, without_holes, controlled, linked, tabled)


def findings_of(of: Repository) -> tuple[Finding, ...]:
    """Every fault of the notes and their table, ids of no clause included."""
    dangling = (finding for finding in cited_exists(of) if finding.path.startswith(f"{FOLDER}/"))
    return (*dangling, *(finding for rule in RULES for finding in rule(of)))
