"""Rules on links: each leads somewhere, and the index to every page of the specification."""

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath
from typing import Final
from urllib.parse import unquote

from clers.specification.finding import Finding
from clers.specification.markdown import Page, anchors, links
from clers.specification.repository import Repository

INDEX: Final = "spec/README.md"
_ELSEWHERE: Final = re.compile(r"[a-z][a-z0-9+.-]*:|//", re.IGNORECASE)


def inside(page: Page, target: str) -> str | None:
    """The path from the root that a relative target means; None if it leaves the repository."""
    if target.startswith("/"):
        return None
    steps: list[str] = list(PurePosixPath(page.path).parent.parts)
    for step in target.split("/"):
        if step == "..":
            if not steps:
                return None
            steps.pop()
        elif step not in ("", "."):
            steps.append(step)
    return "/".join(steps)


def _fault(of: Repository, pages: Mapping[str, Page], page: Page, target: str) -> str | None:
    file, _, anchor = target.partition("#")
    path = inside(page, unquote(file)) if file else page.path
    if path is None:
        return "leaves the repository"
    if not (of.root / path).exists():
        return "no such file"
    if not anchor:
        return None
    if path not in pages:
        return None if not path.endswith(".md") else "anchor in a page that is not checked"
    return None if unquote(anchor) in anchors(pages[path]) else "no such heading"


def resolved(of: Repository) -> Iterator[Finding]:
    """Every relative link leads to a file, and its anchor to a heading. Clause: CONV-PROSE-1."""
    pages = {page.path: page for page in of.pages}
    for page in of.pages:
        for link in links(page):
            if not _ELSEWHERE.match(link.target):
                fault = _fault(of, pages, page, link.target)
                if fault:
                    text = f"link to {link.target}: {fault}"
                    yield Finding("link", page.path, link.line, "", text)


def indexed(of: Repository) -> Iterator[Finding]:
    """The readme of the specification links to all its other pages. Clause: CONV-PROSE-4."""
    index = next((page for page in of.pages if page.path == INDEX), None)
    linked = (
        {inside(index, link.target.partition("#")[0]) for link in links(index)} if index else set()
    )
    for page in of.pages:
        if page.path.startswith("spec/") and page.path not in (INDEX, *linked):
            yield Finding("index", page.path, 1, "", f"{INDEX} does not link to it")
