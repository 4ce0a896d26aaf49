"""The headings of a page: where each is, its anchor and its words."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from markdown_it.token import Token

from clers.site.mathematics import spoken
from clers.specification.markdown import Page, slug


@dataclass(frozen=True, slots=True)
class Heading:
    """A heading at a line (from 1), of a level from 1, with GitHub's anchor (CONV-PROSE-1)."""

    line: int
    level: int
    anchor: str
    title: str


def plain(children: Sequence[Token] | None) -> str:
    """The text of a paragraph or heading, formulas as their signs."""
    said = ""
    for token in children or ():
        match token.type:
            case "text" | "code_inline":
                said += token.content
            case "softbreak" | "hardbreak":
                said += " "
            case "math_inline" | "math_inline_double":
                said += spoken(token.content)
            case "image":
                said += plain(token.children)
            case _:
                pass
    return said


def headings(of: Page, set_: Sequence[Token]) -> tuple[Heading, ...]:
    """All headings; the anchors by the page's own tokens, the words by those with formulas."""
    anchors = list[str]()
    seen: Counter[str] = Counter()
    for here, following in zip(of.tokens, of.tokens[1:], strict=False):
        if here.type == "heading_open":
            name = slug("".join(child.content for child in following.children or ()))
            anchors.append(f"{name}-{seen[name]}" if seen[name] else name)
            seen[name] += 1
    opened = [at for at, token in enumerate(set_) if token.type == "heading_open"]
    return tuple(
        Heading(
            token.map[0] + 1 if token.map else 1,
            int(token.tag[1:]),
            anchor,
            plain(set_[at + 1].children),
        )
        for at, anchor in zip(opened, anchors, strict=True)
        for token in (set_[at],)
    )


def around(found: Sequence[Heading], line: int) -> Heading | None:
    """The last heading at or above a line."""
    above = [heading for heading in found if heading.line <= line]
    return above[-1] if above else None
