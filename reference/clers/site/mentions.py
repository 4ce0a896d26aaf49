"""Ids of clauses in a page become links, wherever they stand. Clause: TOOL-SITE-3."""

import re
from collections.abc import Callable
from typing import Final

from clers.specification.identifier import SHAPE, of_member

ID: Final = re.compile(rf"(?<![\w-])(?:{SHAPE}|ERRATUM-[1-9][0-9]*)(?![\w-])")
_MEMBER: Final = re.compile(r"(?<![\w-])[A-Z]+(?:_[A-Z]+)+_[1-9][0-9]*(?![\w-])")
_PIECE: Final = re.compile(r"<[^>]*>|[^<]+")
_OPAQUE: Final = re.compile(r"<(/?)(?:a|math|svg|style|script)(?=[\s>])[^>]*?(/?)>")

Target = Callable[[str], str | None]
"""The address of an id's place, seen from the page; None for an id that is no clause."""


def linked_text(text: str, target: Target) -> str:
    """Text without tags, in which every id that has a place is a link to it."""

    def link(found: re.Match[str]) -> str:
        place = target(found[0])
        return found[0] if place is None else f'<a class="id" href="{place}">{found[0]}</a>'

    return ID.sub(link, text) if "-" in text else text


def linked_member(name: str, target: Target) -> str:
    """A member of the enumeration of clauses, as a link if it has a place."""
    clause = of_member(name)
    place = target(clause) if clause else None
    return name if place is None else f'<a class="id" href="{place}">{name}</a>'


def linked(html: str, target: Target) -> str:
    """HTML in which every id in text is a link, but where a link or a formula is around it.

    The text stays the same, letter by letter. Clause: TOOL-SITE-3.
    """
    if not ID.search(html) and not _MEMBER.search(html):
        return html
    made, within = list[str](), 0
    for piece in _PIECE.findall(html):
        if piece.startswith("<"):
            opaque = _OPAQUE.match(piece)
            if opaque and not opaque[2]:
                within += -1 if opaque[1] else 1
            made.append(piece)
        elif within > 0:
            made.append(piece)
        else:
            text = linked_text(piece, target)
            made.append(_MEMBER.sub(lambda found: linked_member(found[0], target), text))
    return "".join(made)
