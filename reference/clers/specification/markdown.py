"""A Markdown page: its quotes, fences, headings, links and HTML comments, each with its line."""

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Final

from markdown_it import MarkdownIt
from markdown_it.token import Token

_QUOTE_MARK: Final = re.compile(r"^ {0,3}> ?")
_ANCHOR: Final = re.compile(r"""<a\s+(?:id|name)=["']([^"']+)["']""")
_NOT_IN_SLUG: Final = re.compile(r"[^\w\- ]")


@dataclass(frozen=True, slots=True)
class Page:
    """A Markdown file: its path from the repository's root (with `/`), its text, its tokens."""

    path: str
    text: str
    tokens: tuple[Token, ...]


@dataclass(frozen=True, slots=True)
class Quote:
    """A block quote at the page's top level, marks removed; `line` counts from 1."""

    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Fence:
    """A fenced block: its first content line (from 1), its language, its content."""

    line: int
    language: str
    content: str


@dataclass(frozen=True, slots=True)
class Link:
    """A link or picture to `target`, in the paragraph that begins at `line`."""

    line: int
    target: str


@dataclass(frozen=True, slots=True)
class Comment:
    """An HTML comment, and the text of its paragraph before it."""

    line: int
    content: str
    before: str


@cache
def _parser() -> MarkdownIt:
    return MarkdownIt("commonmark")


def page(path: str, text: str) -> Page:
    """Parse a page; every text is a page."""
    return Page(path, text, tuple(_parser().parse(text)))


def _line(token: Token) -> int:
    return token.map[0] + 1 if token.map else 1


def quotes(of: Page) -> Iterator[Quote]:
    """The block quotes at top level."""
    lines = of.text.splitlines()
    for token in of.tokens:
        if token.type == "blockquote_open" and token.level == 0 and token.map:
            start, stop = token.map
            body = (_QUOTE_MARK.sub("", line) for line in lines[start:stop])
            yield Quote(start + 1, "\n".join(body).rstrip())


def fences(of: Page) -> Iterator[Fence]:
    """The fenced blocks, wherever they stand."""
    for token in of.tokens:
        if token.type == "fence":
            language = token.info.split()[0] if token.info.split() else ""
            yield Fence(_line(token) + 1, language, token.content)


def _inline(of: Page) -> Iterator[tuple[int, Token]]:
    """Every inline token with its line, as far as line breaks in its paragraph tell."""
    for block in of.tokens:
        line = _line(block)
        for token in block.children or ():
            yield line, token
            line += token.type in ("softbreak", "hardbreak")


def links(of: Page) -> Iterator[Link]:
    """Every link and picture; code and fences have none."""
    for line, token in _inline(of):
        target = token.attrGet("href" if token.type == "link_open" else "src")
        if isinstance(target, str):
            yield Link(line, target)


def comments(of: Page) -> Iterator[Comment]:
    """Every HTML comment with what its paragraph says before it; code and fences have none."""
    for block in of.tokens:
        if block.type == "html_block":
            yield Comment(_line(block), block.content.strip(), "")
        before, line = "", _line(block)
        for token in block.children or ():
            if token.type == "html_inline" and token.content.startswith("<!--"):
                yield Comment(line, token.content, before)
            elif token.type in ("softbreak", "hardbreak"):
                before, line = before + " ", line + 1
            else:
                before += token.content


def slug(heading: str) -> str:
    """The anchor GitHub gives a heading: lower case, punctuation dropped, spaces to hyphens."""
    return _NOT_IN_SLUG.sub("", heading.strip().lower()).replace(" ", "-")


def anchors(of: Page) -> frozenset[str]:
    """Every anchor of the page: `<a id>`, and its headings' slugs (repeated ones get -1, -2, …)."""
    seen: Counter[str] = Counter()
    found = set(_ANCHOR.findall(of.text))
    for here, following in zip(of.tokens, of.tokens[1:], strict=False):
        if here.type == "heading_open":
            words = "".join(child.content for child in following.children or ())
            name = slug(words)
            found.add(f"{name}-{seen[name]}" if seen[name] else name)
            seen[name] += 1
    return frozenset(found)
