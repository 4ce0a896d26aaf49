"""Where each file of the repository stands in the site. Clauses: TOOL-SITE-1, TOOL-SITE-5."""

from pathlib import PurePosixPath
from typing import Final

from clers.specification.links import INDEX

FRONT: Final = "index.html"
LAWS: Final = "laws.html"
CLAUSES: Final = "clauses.html"
STYLE: Final = "style.css"
SCRIPT: Final = "search.js"
ENTRIES: Final = "search-index.js"
MANIFEST: Final = "site.json"


def page_at(path: str) -> str:
    """The page of a Markdown file: chapters at the top, all others as they lie."""
    if path == INDEX:
        return FRONT
    return path.removeprefix("spec/").removesuffix(".md") + ".html"


def source_at(path: str) -> str:
    """The page that shows a source file line by line. Clause: TOOL-SITE-5."""
    return f"source/{path}.html"


def picture_at(path: str) -> str:
    """A picture, copied as it is. Clause: TOOL-SITE-6."""
    return f"picture/{path.removeprefix('spec/pictures/')}"


def clause_at(clause: str) -> str:
    """The page of all that cites a clause. Clause: TOOL-SITE-4."""
    return f"clause/{clause}.html"


def up(here: str) -> str:
    """The way from a page to the site's top: empty, or `../` for each folder it is in."""
    return "../" * (len(PurePosixPath(here).parts) - 1)


def href(here: str, there: str, anchor: str = "") -> str:
    """The relative address of a place of the site, seen from one of its pages."""
    if here == there and anchor:
        return f"#{anchor}"
    return f"{up(here)}{there}" + (f"#{anchor}" if anchor else "")
