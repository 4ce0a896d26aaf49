"""The whole site of a repository, in memory. Clauses: TOOL-SITE-1, TOOL-SITE-11."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.resources import files as packaged
from typing import Final

from clers.conventions.law import AnyLaw
from clers.site.chapter import Setter, parsed
from clers.site.dossier import Told, Vectors, dossiers, told
from clers.site.entries import Entry, script
from clers.site.headings import Heading
from clers.site.layout import laid_out
from clers.site.listing import clauses_page, dossier_pages, laws_page
from clers.site.markup import parser
from clers.site.navigation import Group, groups, neighbours, shown
from clers.site.places import CLAUSES, ENTRIES, LAWS, SCRIPT, STYLE, page_at, picture_at, source_at
from clers.site.plan import Plan, plan
from clers.site.sound import Site, faults
from clers.site.sources import numbered
from clers.specification.finding import Finding
from clers.specification.repository import Repository

STEPS: Final = 5
_COQ: Final = re.compile(
    r"^[ \t]*(?:Theorem|Lemma|Corollary|Proposition|Remark|Fact|Definition|Fixpoint|Inductive)"
    r"\s+(\w+)",
    re.MULTILINE,
)


@dataclass(frozen=True, slots=True)
class Material:
    """What a site is made of: the repository, the registry of laws, the vectors by clause.

    The last two are empty for a repository that is not the running program's.
    """

    repository: Repository
    laws: Sequence[AnyLaw]
    vectors: Mapping[str, tuple[Vectors, ...]]


def site(of: Material, step: Callable[[str], None]) -> tuple[Site, tuple[Finding, ...]]:
    """The files of the site, and everything wrong with it. Clauses: TOOL-SITE-1, TOOL-SITE-8."""
    step("pages")
    plan_, markdown = plan(of.repository), parser()
    pages = {path: parsed(markdown, page) for path, page in sorted(plan_.pages.items())}
    laws = told(of.repository, of.laws)
    cited = {law.path for law in laws if law.path}
    assert cited <= plan_.sources.keys(), "laws cite clauses, and so their files have pages"
    found = dossiers(
        of.repository, laws, of.vectors, {path: page.headings for path, page in pages.items()}
    )
    names = _names(plan_, laws)
    setter = Setter(markdown, plan_, found, names)
    titles = {path: page.title for path, page in pages.items()}
    all_ = groups(plan_, titles)
    files: dict[str, bytes] = {}
    entries: list[Entry] = []
    wrong: list[Finding] = []
    for path, page in pages.items():
        made = setter.page(page)
        entries += made.entries
        wrong += made.faults
        files[page_at(path)] = _framed(all_, page_at(path), page.title, made.body, page.headings)
    step("lists")
    chapters = [(clause.chapter, clause.clause) for clause in of.repository.clauses]
    body, sections, of_laws = laws_page(plan_, laws, chapters)
    files[LAWS] = _framed(all_, LAWS, "All laws", body, sections)
    body, sections = clauses_page(plan_, found, {entry.title: entry.text for entry in entries})
    files[CLAUSES] = _framed(all_, CLAUSES, "All clauses", body, sections)
    files.update(dossier_pages(plan_, setter, found, titles, names))
    step("sources")
    files.update(_sources(plan_))
    files.update((picture_at(path), data) for path, data in plan_.pictures.items())
    files[ENTRIES] = script(_in_order(entries, of_laws))
    for name in (STYLE, SCRIPT):
        files[name] = packaged("clers.site").joinpath("assets", name).read_bytes()
    step("check")
    clauses = {clause.clause: page_at(clause.path) for clause in of.repository.clauses}
    whole = Site(dict(sorted(files.items())), clauses)
    return whole, (*wrong, *faults(whole))


def _in_order(entries: Sequence[Entry], laws: Sequence[Entry]) -> tuple[Entry, ...]:
    """Clauses, laws, sections; of each kind in the order of the pages. Clause: TOOL-SITE-7."""
    kinds = ("clause", "law", "section")
    return tuple(sorted((*entries, *laws), key=lambda entry: kinds.index(entry.kind)))


def _framed(
    all_: tuple[Group, ...], here: str, title: str, body: str, sections: Sequence[Heading]
) -> bytes:
    before, after = neighbours(all_, here)
    values = {
        "body": body,
        "groups": shown(all_, here),
        "sections": tuple(section for section in sections if section.level in (2, 3)),
        "wide": here == CLAUSES,
        "before": before,
        "after": after,
    }
    return laid_out("page.html.jinja", here, title, values)


def _sources(of: Plan) -> Iterator[tuple[str, bytes]]:
    """A page for each source file. Clause: TOOL-SITE-5."""
    for path, text in of.sources.items():
        here = source_at(path)
        lines = numbered(path, text, partial(of.of_id, here))
        yield here, laid_out("source.html.jinja", here, path, {"lines": lines})


def _names(of: Plan, laws: Sequence[Told]) -> dict[str, tuple[str, str]]:
    """What stands in code type and has a place: laws, files and Coq's theorems by full name."""
    found: dict[str, tuple[str, str]] = {law.name: (LAWS, law.name) for law in laws}
    for path, text in of.sources.items():
        found[path] = (source_at(path), "")
        if path.endswith(".v"):
            module = path.rpartition("/")[2].removesuffix(".v")
            for theorem in _COQ.finditer(text):
                line = text.count("\n", 0, theorem.start(1)) + 1
                found[f"Clers.{module}.{theorem[1]}"] = (source_at(path), f"L{line}")
    return found
