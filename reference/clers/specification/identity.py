"""Rules on ids: each stated once, numbered without gap, in its chapter, and never dangling."""

import re
from collections.abc import Iterator
from itertools import groupby
from typing import Final

from clers.specification.clause_module import clause_module
from clers.specification.clause_text import ClauseText
from clers.specification.finding import Finding
from clers.specification.identifier import number, order, prefix, series
from clers.specification.repository import CLAUSE_MODULE, RETIRED, Repository

_KEBAB: Final = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


def stated_once(of: Repository) -> Iterator[Finding]:
    """No id is stated twice, nor stated and retired. Clause: CONV-CLAUSE-1."""
    first: dict[str, ClauseText] = {}
    for clause in of.clauses:
        before = first.setdefault(clause.clause, clause)
        at = (clause.path, clause.line, clause.clause)
        if before is not clause:
            yield Finding("id-twice", *at, f"stated already at {before.path}:{before.line}")
        if clause.clause in of.retired:
            yield Finding("id-retired", *at, f"an id that {RETIRED} has retired")


def well_formed(of: Repository) -> Iterator[Finding]:
    """Nothing only looks like a clause. Clause: CONV-CLAUSE-1."""
    for item in of.misshapen:
        text = f"{item.opening} opens no clause: want `> **CHAPTER-TOPIC-N.**` first in a quote"
        yield Finding("misshapen", item.path, item.line, "", text)


def numbered(of: Repository) -> Iterator[Finding]:
    """The numbers of a series run from 1 without gap, retired ones aside. Clause: CONV-CLAUSE-7."""
    ordered = sorted(of.clauses, key=lambda clause: order(clause.clause))
    for name, members in groupby(ordered, key=lambda clause: series(clause.clause)):
        expected = 1
        for clause in members:
            for missing in range(expected, number(clause.clause)):
                gone = f"{name}-{missing}"
                if gone not in of.retired:
                    text = f"missing before {clause.clause}, and {RETIRED} does not list it"
                    yield Finding("gap", clause.path, clause.line, gone, text)
            expected = number(clause.clause) + 1


def in_its_chapter(of: Repository) -> Iterator[Finding]:
    """A clause stands in the chapter of its prefix. Clause: CONV-CLAUSE-6."""
    for clause in of.clauses:
        chapter = of.prefixes.get(prefix(clause.clause))
        if chapter != clause.chapter:
            text = "chapter 0 gives its prefix to " + ("none" if chapter is None else f"{chapter}")
            yield Finding("prefix", clause.path, clause.line, clause.clause, text)


def cited_exists(of: Repository) -> Iterator[Finding]:
    """Whatever has the form of an id is the id of a clause. Clause: CONV-CLAUSE-8.

    In tests an id of a prefix that no chapter has is free, for examples of wrong repositories.
    """
    ids = of.ids
    for site in of.citations:
        free = site.path.startswith("tests/") and prefix(site.clause) not in of.prefixes
        if site.clause not in ids and not free:
            text = "retired" if site.clause in of.retired else "no such clause"
            yield Finding("dangling", site.path, site.line, site.clause, text)


def generated(of: Repository) -> Iterator[Finding]:
    """The enumeration is what the chapters say. Clause: CONV-CLAUSE-9."""
    if of.clause_module != clause_module(of.clauses):
        text = "is not what the chapters say: run `clers spec generate`"
        yield Finding("generated", CLAUSE_MODULE, 1, "", text)


def laws_written_once(of: Repository) -> Iterator[Finding]:
    """No two laws have one name, and each is in kebab-case. Clause: CONV-LAW-3."""
    first: dict[str, str] = {}
    for path, law in ((module.path, law) for module in of.modules for law in module.laws):
        here = f"{path}:{law.first}"
        before = first.setdefault(law.name, here)
        if before != here:
            yield Finding("law-twice", path, law.first, "", f"{law.name} is also at {before}")
        if not _KEBAB.fullmatch(law.name):
            yield Finding("law-name", path, law.first, "", f"{law.name!r} is not in kebab-case")
