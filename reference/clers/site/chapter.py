"""A Markdown page as HTML, its clauses set off. Clauses: TOOL-SITE-2, TOOL-SITE-3, TOOL-SITE-4."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from html import escape

from markdown_it import MarkdownIt
from markdown_it.token import Token

from clers.site.dossier import Dossier
from clers.site.entries import Entry, Kind
from clers.site.headings import Heading, headings, plain
from clers.site.markup import Addresses, rendered
from clers.site.mentions import linked
from clers.site.places import href, page_at
from clers.site.plan import Plan, dossier_of
from clers.specification.finding import Finding
from clers.specification.markdown import Page


@dataclass(frozen=True, slots=True)
class Parsed:
    """A page parsed with formulas: its tokens and headings."""

    page: Page
    tokens: tuple[Token, ...]
    headings: tuple[Heading, ...]

    @property
    def title(self) -> str:
        """Its first heading; else its path."""
        return self.headings[0].title if self.headings else self.page.path


def parsed(markdown: MarkdownIt, of: Page) -> Parsed:
    """Parse a page."""
    tokens = tuple(markdown.parse(of.text))
    return Parsed(of, tokens, headings(of, tokens))


@dataclass(frozen=True, slots=True)
class Made:
    """A page's body, what the search finds in it, and what could not be set."""

    body: str
    entries: tuple[Entry, ...]
    faults: tuple[Finding, ...]


def _until_close(tokens: Sequence[Token], at: int) -> int:
    """The index after the block that opens at `at`."""
    depth = 0
    for k in range(at, len(tokens)):
        depth += tokens[k].nesting
        if depth == 0:
            return k + 1
    return len(tokens)


def _without_id(tokens: Sequence[Token]) -> tuple[Token, ...]:
    """The blocks of a clause, its id (`**ID.**` at the beginning) left out."""
    first = next(k for k, token in enumerate(tokens) if token.type == "inline")
    children = list(tokens[first].children or ())
    opened = next(k for k, token in enumerate(children) if token.type == "strong_open")
    rest = children[opened + 3 :]
    if rest and rest[0].type == "text":
        rest[0] = rest[0].copy(content=rest[0].content.lstrip())
    return (*tokens[:first], tokens[first].copy(children=rest), *tokens[first + 1 :])


class Setter:
    """Sets the pages of one plan. `names` are places of names in code type: laws, files, proofs."""

    def __init__(
        self,
        markdown: MarkdownIt,
        plan: Plan,
        dossiers: Sequence[Dossier],
        names: Mapping[str, tuple[str, str]],
    ) -> None:
        self._markdown = markdown
        self._plan = plan
        self._names = names
        self._bodies: dict[str, tuple[Token, ...]] = {}
        self._of = {(known.clause.path, known.clause.line): known for known in dossiers}

    def blocks(
        self, of: Page, here: str, tokens: Sequence[Token]
    ) -> tuple[str, tuple[Finding, ...]]:
        """Some blocks of a page, as they stand in the page `here` of the site."""

        def of_name(name: str) -> str | None:
            place = self._names.get(name)
            return href(here, *place) if place else None

        addresses = Addresses(partial(self._plan.of_link, here, of), of_name)
        html, unset = rendered(self._markdown, tokens, addresses)
        line = next((token.map[0] + 1 for token in tokens if token.map), 1)
        faults = tuple(
            Finding("site", of.path, line, "", f"mathematics cannot be set: {tex}") for tex in unset
        )
        return linked(html, lambda clause: self._plan.of_id(here, clause)), faults

    def clause(self, of: Dossier, page: Page, here: str) -> str:
        """The words of a clause that a page set before has, for another place of the site."""
        return self.blocks(page, here, self._bodies[of.clause.clause])[0]

    def page(self, of: Parsed) -> Made:
        """A whole page."""
        here = page_at(of.page.path)
        made, entries, faults = list[str](), list[Entry](), list[Finding]()
        said: list[str] = []
        section = Heading(1, 1, "", of.title)
        waiting = list(of.headings)
        at = 0
        while at < len(of.tokens):
            until = _until_close(of.tokens, at)
            block = of.tokens[at:until]
            line = block[0].map[0] + 1 if block[0].map else 1
            clause = self._of.get((of.page.path, line))
            if block[0].type == "heading_open" and waiting:
                entries += _section(of, here, section, said)
                section, said = waiting.pop(0), []
                html, wrong = self.blocks(of.page, here, block[1:2])
                made.append(heading(section, html))
            elif clause and block[0].type == "blockquote_open":
                body = _without_id(block[1:-1])
                html, wrong = self.blocks(of.page, here, body)
                made.append(set_off(clause, here, html))
                id_ = clause.clause.clause
                self._bodies[id_] = body
                entries.append(Entry(Kind.CLAUSE, id_, of.title, href("", here, id_), _said(body)))
            else:
                html, wrong = self.blocks(of.page, here, block)
                made.append(html)
                said.append(_said(block))
            faults += wrong
            at = until
        entries += _section(of, here, section, said)
        return Made("".join(made), tuple(entries), tuple(faults))


def _said(tokens: Sequence[Token]) -> str:
    """The text of some blocks, for the search."""
    words = (
        plain(token.children) if token.type == "inline" else token.content
        for token in tokens
        if token.type in ("inline", "fence", "code_block")
    )
    return " ".join(" ".join(words).split())


def _section(of: Parsed, here: str, section: Heading, said: list[str]) -> list[Entry]:
    """The entry of a section: its heading and what stands there outside clauses."""
    text = " ".join(words for words in said if words)
    if not section.anchor and not text:
        return []
    return [Entry(Kind.SECTION, section.title, of.title, href("", here, section.anchor), text)]


def heading(of: Heading, html: str) -> str:
    """A heading with its anchor and a sign to copy its address from."""
    name = f"h{of.level}"
    sign = (
        f'<a class="permalink" href="#{escape(of.anchor)}" '
        f'aria-label="Link to “{escape(of.title)}”">#</a>'
    )
    return f'<{name} id="{escape(of.anchor)}">{html} {sign}</{name}>\n'


def set_off(of: Dossier, here: str, html: str) -> str:
    """A clause: its id, its words, and the line of what cites it. Clause: TOOL-SITE-4."""
    id_ = of.clause.clause
    return (
        f'<div class="clause" id="{id_}">\n'
        f'<p class="clause-id"><a href="#{id_}">{id_}</a></p>\n'
        f"{html}{evidence(of, here)}</div>\n"
    )


def evidence(of: Dossier, here: str) -> str:
    """The line beneath a clause: how many places of each kind, each a link to their list."""
    id_ = of.clause.clause
    parts = (
        f'<a href="{dossier_of(here, id_, part)}">{part} <b>{number}</b></a>'
        if number
        else f"<span>{part} 0</span>"
        for part, number in of.counts.items()
    )
    return f'<p class="evidence">{" <i>·</i> ".join(parts)}</p>\n'
