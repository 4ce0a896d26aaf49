"""One reading of a repository: everything the checks of the specification look at."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from clers.specification.citation import Citation, Kind, in_page
from clers.specification.clause_text import ClauseText, Misshapen, chapter_number, clauses
from clers.specification.identifier import SHAPE
from clers.specification.lock import LOCK, Lock, read_lock
from clers.specification.markdown import Page, page
from clers.specification.python_sites import Module, read_module

CLAUSE_MODULE: Final = "reference/clers/conventions/clause.py"
RETIRED: Final = "spec/retired.md"
CONVENTIONS: Final = "spec/00-conventions.md"
_PREFIX_ROW: Final = re.compile(r"^\|\s*(\d+)\s*\|\s*`([A-Z]+)`\s*\|", re.MULTILINE)
_RETIRED_ITEM: Final = re.compile(rf"^- \*\*({SHAPE})\.\*\*", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Repository:
    """What was read, nothing judged yet. `prefixes` maps a prefix to its chapter's number.

    `registry` has the names of all registered laws, or says why they cannot be had; empty if the
    repository is not that of the running program, whose laws alone can be asked.
    """

    root: Path
    pages: tuple[Page, ...]
    modules: tuple[Module, ...]
    clauses: tuple[ClauseText, ...]
    misshapen: tuple[Misshapen, ...]
    citations: tuple[Citation, ...]
    prefixes: Mapping[str, int]
    retired: frozenset[str]
    lock: Lock
    clause_module: str
    registry: tuple[str, ...] | str = ()

    @property
    def ids(self) -> frozenset[str]:
        """The ids of all clauses."""
        return frozenset(clause.clause for clause in self.clauses)

    def sites(self, clause: str) -> tuple[Citation, ...]:
        """Every place that cites a clause, in order of kind, file and line."""
        return tuple(site for site in self.citations if site.clause == clause)


def find_root(start: Path) -> Path | None:
    """The nearest folder, upward from `start`, with the conventions' chapter in it."""
    around = (start.resolve(), *start.resolve().parents)
    return next((folder for folder in around if (folder / CONVENTIONS).is_file()), None)


def _text(root: Path, path: str) -> str:
    file = root / path
    return file.read_text(encoding="utf-8") if file.is_file() else ""


def _paths(root: Path, folder: str, pattern: str) -> tuple[str, ...]:
    found = (file.relative_to(root).as_posix() for file in (root / folder).rglob(pattern))
    return tuple(sorted(path for path in found if "/__pycache__/" not in path))


def _pages(root: Path) -> tuple[Page, ...]:
    paths = [*_paths(root, "spec", "*.md"), *_paths(root, "proofs_notes", "*.md")]
    readme = ["README.md"] if (root / "README.md").is_file() else []
    return tuple(page(path, _text(root, path)) for path in [*paths, *readme])


def _modules(root: Path) -> tuple[Module, ...]:
    places = ((Kind.CODE, "reference"), (Kind.TEST, "tests"))
    return tuple(
        read_module(path, _text(root, path), kind)
        for kind, folder in places
        for path in _paths(root, folder, "*.py")
        if path != CLAUSE_MODULE
    )


def _cited(
    pages: Iterable[Page], modules: Iterable[Module], stated: Iterable[ClauseText]
) -> tuple[Citation, ...]:
    """All citations; a clause does not cite itself where it is stated, nor the retired list."""
    own = {(clause.path, clause.line, clause.clause) for clause in stated}
    kinds = {kind: place for place, kind in enumerate(Kind)}
    found = [site for module in modules for site in module.citations]
    for prose in pages:
        if prose.path != RETIRED:
            kind = Kind.NOTE if prose.path.startswith("proofs_notes/") else Kind.PROSE
            found += in_page(prose, kind)
    kept = {site for site in found if (site.path, site.line, site.clause) not in own}
    return tuple(
        sorted(kept, key=lambda site: (kinds[site.kind], site.path, site.line, site.clause))
    )


def read_specification(root: Path) -> tuple[ClauseText | Misshapen, ...]:
    """The clauses of all chapters alone, in the order of the chapters; quick."""
    return _stated(page(path, _text(root, path)) for path in _paths(root, "spec", "*.md"))


def _stated(pages: Iterable[Page]) -> tuple[ClauseText | Misshapen, ...]:
    return tuple(
        item
        for page in pages
        for chapter in (chapter_number(page.path),)
        if chapter is not None and page.path.startswith("spec/")
        for item in clauses(chapter, page)
    )


def read(root: Path, registry: tuple[str, ...] | str = ()) -> Repository:
    """Read everything the checks look at; what is absent reads as empty."""
    pages, modules = _pages(root), _modules(root)
    stated = _stated(pages)
    good = tuple(item for item in stated if isinstance(item, ClauseText))
    return Repository(
        root=root,
        pages=pages,
        modules=modules,
        clauses=good,
        misshapen=tuple(item for item in stated if isinstance(item, Misshapen)),
        citations=_cited(pages, modules, good),
        prefixes={name: int(n) for n, name in _PREFIX_ROW.findall(_text(root, CONVENTIONS))},
        retired=frozenset(_RETIRED_ITEM.findall(_text(root, RETIRED))),
        lock=read_lock(_text(root, LOCK)),
        clause_module=_text(root, CLAUSE_MODULE),
        registry=registry,
    )
