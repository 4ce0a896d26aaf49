"""Source files as pages: a number and an anchor for each line. Clause: TOOL-SITE-5."""

import keyword
import re
from html import escape
from typing import Final

from clers.site.mentions import Target, linked_member, linked_text

_PYTHON: Final = re.compile(
    r"""(?P<s>(?:(?<!\w)[rbufRBUF]{1,2})?
          (?:\"{3}(?:\\.|[^\\])*?\"{3}|'{3}(?:\\.|[^\\])*?'{3}
            |"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'))
      |(?P<c>\#[^\n]*)
      |(?<=\bClause\.)(?P<m>[A-Z]+(?:_[A-Z]+)+_[1-9][0-9]*)
      |\b(?P<k>"""
    + "|".join(sorted([*keyword.kwlist, "match", "case"]))
    + r""")\b""",
    re.DOTALL | re.VERBOSE,
)
"""Strings, comments, members of the enumeration, keywords: a lexer of all the language takes ten
times as long, and the pages are there to be looked up."""


def _escaped(text: str) -> str:
    return escape(text, quote=False)


def _python(source: str, target: Target) -> str:
    """Python with its strings, comments and keywords marked; no mark goes over a line's end."""
    made, at = list[str](), 0
    for found in _PYTHON.finditer(source):
        made.append(_escaped(source[at : found.start()]))
        at = found.end()
        match found.lastgroup:
            case "m":
                made.append(linked_member(found[0], target))
            case "k":
                made.append(f"<b>{found[0]}</b>")
            case kind:
                text = linked_text(_escaped(found[0]), target)
                made.append("\n".join(f'<i class="{kind}">{line}</i>' for line in text.split("\n")))
    made.append(_escaped(source[at:]))
    return "".join(made)


def numbered(path: str, source: str, target: Target) -> str:
    """A file's lines as HTML, each in an element with the id `L` and its number from 1."""
    python = path.endswith(".py")
    html = _python(source, target) if python else linked_text(_escaped(source), target)
    lines = html.removesuffix("\n").split("\n")
    # a line's end is within its element: between blocks it would be a line of its own
    return (
        "\n</span>".join(
            f'<span id="L{n}"><a href="#L{n}">{n}</a>{line}' for n, line in enumerate(lines, 1)
        )
        + "</span>"
    )
