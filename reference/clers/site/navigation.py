"""The pages in their order, and the list of chapters beside each of them. Clause: TOOL-SITE-10."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby

from clers.site.headings import plain
from clers.site.places import CLAUSES, LAWS, href, page_at
from clers.site.plan import Plan
from clers.specification.clause_text import chapter_number
from clers.specification.links import INDEX, inside
from clers.specification.markdown import Page


@dataclass(frozen=True, slots=True)
class Stop:
    """A page in the list: its words and its place in the site; `depth` is 1 below a chapter."""

    label: str
    place: str
    depth: int


@dataclass(frozen=True, slots=True)
class Group:
    """A part of the list under its own head; the chapters' has none."""

    head: str
    stops: tuple[Stop, ...]


def _named(index: Page) -> Iterator[tuple[str, str]]:
    """Each page that the index links to, with the words of its first link."""
    seen: set[str] = set()
    for block in index.tokens:
        children = block.children or []
        for at, token in enumerate(children):
            if token.type != "link_open":
                continue
            path = inside(index, str(token.attrGet("href")).partition("#")[0])
            until = next(k for k in range(at, len(children)) if children[k].type == "link_close")
            if path and path not in seen:
                seen.add(path)
                yield path, plain(children[at + 1 : until])


def _chapter(path: str) -> str:
    """What pages have in common that stand under one head: a chapter's number, or a first word."""
    number = chapter_number(path)
    return str(number) if number is not None else path.partition("-")[0].removesuffix(".md")


def groups(of: Plan, titles: Mapping[str, str]) -> tuple[Group, ...]:
    """All pages: the specification in the index's order, lists, proofs, the other pages.

    `titles` are the pages' own, by path.
    """
    index = of.pages.get(INDEX)
    named = [
        (path, words)
        for path, words in (_named(index) if index else ())
        if path in of.pages and path.startswith("spec/")
    ]
    chapters = [Stop("The specification", page_at(INDEX), 0)]
    for _, group in groupby(named, lambda item: _chapter(item[0])):
        chapters += (
            Stop(words[0].upper() + words[1:], page_at(path), int(place > 0))
            for place, (path, words) in enumerate(group)
        )
    rest = [path for path in sorted(of.pages) if not path.startswith("spec/")]
    proofs = [path for path in rest if path.startswith("proofs_notes/")]
    others = [path for path in rest if path not in proofs]
    lists = (Stop("All clauses", CLAUSES, 0), Stop("All laws", LAWS, 0))
    return tuple(
        group
        for group in (
            Group("", tuple(chapters)),
            Group("Lists", lists),
            Group("Proofs", tuple(Stop(titles[path], page_at(path), 0) for path in proofs)),
            Group("Beside it", tuple(Stop(titles[path], page_at(path), 0) for path in others)),
        )
        if group.stops
    )


@dataclass(frozen=True, slots=True)
class Item:
    """A line of the list as one page shows it."""

    label: str
    href: str
    depth: int
    here: bool


def shown(all_: tuple[Group, ...], here: str) -> tuple[tuple[str, tuple[Item, ...]], ...]:
    """The list as seen from a page."""
    return tuple(
        (
            group.head,
            tuple(
                Item(stop.label, href(here, stop.place), stop.depth, stop.place == here)
                for stop in group.stops
            ),
        )
        for group in all_
    )


def neighbours(all_: tuple[Group, ...], here: str) -> tuple[Item | None, Item | None]:
    """The pages before and after a page; None at an end."""
    order = [stop for group in all_ for stop in group.stops]
    at = next((k for k, stop in enumerate(order) if stop.place == here), None)
    if at is None:
        return None, None

    def item(k: int) -> Item | None:
        if not 0 <= k < len(order):
            return None
        return Item(order[k].label, href(here, order[k].place), 0, here=False)

    return item(at - 1), item(at + 1)
