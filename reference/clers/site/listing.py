"""The pages that are lists: all laws, all clauses, all that cites one clause. TOOL-SITE-4."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby, pairwise
from typing import assert_never

from clers.site.chapter import Setter, heading
from clers.site.dossier import PARTS, Dossier, Told
from clers.site.entries import Entry, Kind
from clers.site.headings import Heading
from clers.site.layout import laid_out, part_of
from clers.site.mentions import linked
from clers.site.places import CLAUSES, LAWS, clause_at, href, page_at, source_at
from clers.site.plan import Plan, dossier_of
from clers.specification.markdown import Page
from clers.specification.theorems import (
    FOLDER,
    Certificate,
    Cited,
    Coq,
    Exhaustive,
    Prose,
    Smt,
    Way,
)


def _source(here: str, path: str, line: int) -> str:
    return href(here, source_at(path), f"L{line}")


def _linked(plan: Plan, here: str, html: str) -> str:
    return linked(html, lambda clause: plan.of_id(here, clause))


def laws_page(
    plan: Plan, laws: Sequence[Told], chapters: Sequence[tuple[int, str]]
) -> tuple[str, tuple[Heading, ...], tuple[Entry, ...]]:
    """The body of the page of laws, by the chapter of their clause, with its sections."""
    of = {clause: number for number, clause in chapters}
    ordered = sorted(laws, key=lambda law: of.get(law.clause, 0))
    made, sections = ["<h1>All laws</h1>\n"], list[Heading]()
    for chapter, group in groupby(ordered, lambda law: of.get(law.clause, 0)):
        section = Heading(1, 2, f"chapter-{chapter}", f"Chapter {chapter}")
        sections.append(section)
        made.append(heading(section, section.title))
        values = {"laws": tuple(group), "source": lambda path, line: _source(LAWS, path, line)}
        made.append(part_of("laws.html.jinja", values))
    entries = (
        Entry(Kind.LAW, law.name, "All laws", f"{LAWS}#{law.name}", law.statement)
        for law in ordered
    )
    return _linked(plan, LAWS, "".join(made)), tuple(sections), tuple(entries)


def clauses_page(
    plan: Plan, dossiers: Sequence[Dossier], texts: Mapping[str, str]
) -> tuple[str, tuple[Heading, ...]]:
    """The body of the page of clauses, a table for each chapter, with its sections.

    `texts` are the clauses' words by id, without marks.
    """
    made, sections = ["<h1>All clauses</h1>\n"], list[Heading]()
    for chapter, group in groupby(dossiers, lambda of: of.clause.chapter):
        section = Heading(1, 2, f"chapter-{chapter}", f"Chapter {chapter}")
        sections.append(section)
        values = {
            "parts": PARTS,
            "dossiers": tuple(group),
            "dossier": lambda clause, part: dossier_of(CLAUSES, clause, part),
            "opening": lambda of: _opening(texts[of.clause.clause]),
        }
        made.append(heading(section, section.title))
        made.append(part_of("clauses.html.jinja", values))
    return _linked(plan, CLAUSES, "".join(made)), tuple(sections)


def _opening(text: str) -> str:
    return text if len(text) <= 90 else f"{text[:89].rstrip()}…"


def _way(of: Way, here: str, names: Mapping[str, tuple[str, str]]) -> tuple[str, str, str]:
    """How a theorem is known: in words, by what name, and the address of that, if it has one."""
    match of:
        case Coq(name):
            said, name, key = "Coq", name, name
        case Smt(file, lemma):
            said, name, key = "z3", f"{file}: {lemma}", f"{FOLDER}/{file}"
        case Certificate(file):
            said, name, key = "a certificate", file, f"{FOLDER}/{file}"
        case Exhaustive(bound, judge):
            said, name, key = f"all cases to {bound}", judge, judge
        case Cited(source):
            said, name, key = f"cited: {source}", "", ""
        case Prose():
            said, name, key = "the proof in the note", "", ""
        case _:
            assert_never(of)
    place = names.get(key)
    return said, name, href(here, *place) if place else ""


def dossier_pages(
    plan: Plan,
    setter: Setter,
    dossiers: Sequence[Dossier],
    titles: Mapping[str, str],
    names: Mapping[str, tuple[str, str]],
) -> Iterator[tuple[str, bytes]]:
    """The page of each clause: all that cites it."""
    around = [None, *(of.clause.clause for of in dossiers), None]
    for of, (before, _), (_, after) in zip(
        dossiers, pairwise(around), list(pairwise(around))[1:], strict=False
    ):
        here = clause_at(of.clause.clause)
        page: Page = plan.pages[of.clause.path]
        values = {
            "of": of,
            "stated": href(here, page_at(of.clause.path), of.clause.clause),
            "chapter": titles[of.clause.path],
            "before": before,
            "after": after,
            "body": setter.clause(of, page, here),
            "source": lambda path, line, here=here: _source(here, path, line),
            "ways": lambda theorem, here=here: [_way(way, here, names) for way in theorem.ways],
            "page": lambda path, anchor, here=here: href(here, page_at(path), anchor),
        }
        yield here, laid_out("clause.html.jinja", here, of.clause.clause, values)
