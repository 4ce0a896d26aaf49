"""Markdown as HTML that is well-formed XML too. Clauses: TOOL-SITE-2, TOOL-SITE-6."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from types import MappingProxyType
from typing import Final

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from markdown_it.utils import EnvType, OptionsDict
from mdit_py_plugins.dollarmath import dollarmath_plugin
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name
from pygments.util import ClassNotFound

from clers.site.mathematics import NotUnderstood, mathml

_COMMENT: Final = re.compile(r"<!--.*?-->", re.DOTALL)


@dataclass(frozen=True, slots=True)
class Addresses:
    """Seen from a page: the address of a link's target, and of a name in code type, if any."""

    link: Callable[[str], str]
    name: Callable[[str], str | None]


_Rule = Callable[[RendererHTML, Sequence[Token], int, OptionsDict, EnvType], str]


def _link_open(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A link, with the address it has in the site."""
    target = str(tokens[idx].attrGet("href") or "")
    return f'<a href="{escape(env["addresses"].link(target))}">'


def _image(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A picture, with the address of its copy."""
    target = str(tokens[idx].attrGet("src") or "")
    source = escape(env["addresses"].link(target))
    said = escape(self.renderInlineAsText(tokens[idx].children, options, env))
    return f'<img src="{source}" alt="{said}" />'


def _code_inline(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """Code type; the name of a law, file or Coq theorem is a link."""
    code = f"<code>{escape(tokens[idx].content, quote=False)}</code>"
    depth = sum(
        (token.type == "link_open") - (token.type == "link_close") for token in tokens[:idx]
    )
    place = None if depth else env["addresses"].name(tokens[idx].content)
    return f'<a href="{escape(place)}">{code}</a>' if place else code


def _fence(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A block of code, its signs marked by kind."""
    words = tokens[idx].info.split()
    return highlighted(tokens[idx].content, words[0] if words else "")


def _code_block(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A block of code that is only indented."""
    return highlighted(tokens[idx].content, "")


def _table_open(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A table in a frame of its own, which scrolls where the page is narrow."""
    return '<div class="table" role="region" aria-label="Table" tabindex="0"><table>\n'


def _table_close(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """The end of a table and its frame."""
    return "</table></div>\n"


def _html(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """HTML as written, without comments."""
    return _COMMENT.sub("", tokens[idx].content)


def _in_line(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A formula in a line."""
    return _formula(tokens[idx].content, env, display=False)


def _displayed(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A formula on a line of its own, with text around it."""
    return _formula(tokens[idx].content, env, display=True)


def _block(
    self: RendererHTML, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
) -> str:
    """A formula on a line of its own; it scrolls where the page is narrow."""
    return f'<div class="formula">{_formula(tokens[idx].content, env, display=True)}</div>\n'


def _formula(tex: str, env: EnvType, *, display: bool) -> str:
    try:
        return mathml(tex.strip(), display=display)
    except NotUnderstood as error:
        env["faults"].append(str(error))
        return f"<code>{escape(tex, quote=False)}</code>"


_RULES: Final[Mapping[str, _Rule]] = MappingProxyType(
    {
        "link_open": _link_open,
        "image": _image,
        "code_inline": _code_inline,
        "fence": _fence,
        "code_block": _code_block,
        "table_open": _table_open,
        "table_close": _table_close,
        "html_block": _html,
        "html_inline": _html,
        "math_inline": _in_line,
        "math_inline_double": _displayed,
        "math_block": _block,
    }
)
"""What is rendered otherwise than by the library."""


def parser() -> MarkdownIt:
    """The parser of pages: as the checks read them, with tables and formulas."""
    made = MarkdownIt("commonmark", {"xhtmlOut": True}).enable("table")
    made.use(dollarmath_plugin, allow_labels=False, allow_space=True, double_inline=True)
    for name, rule in _RULES.items():
        made.add_render_rule(name, rule)
    return made


def highlighted(code: str, language: str) -> str:
    """A block of code; without a known language its signs are not marked."""
    try:
        lexer = get_lexer_by_name(language or "text", stripnl=False)
    except ClassNotFound:
        lexer = get_lexer_by_name("text", stripnl=False)
    marked = highlight(code, lexer, HtmlFormatter(nowrap=True))
    return f'<pre tabindex="0"><code>{marked}</code></pre>\n'


def rendered(
    markdown: MarkdownIt,
    tokens: Sequence[Token],
    addresses: Addresses,
) -> tuple[str, tuple[str, ...]]:
    """Tokens as HTML, and the formulas that could not be set."""
    faults: list[str] = []
    env: EnvType = {"addresses": addresses, "faults": faults}
    return markdown.renderer.render(tokens, markdown.options, env), tuple(faults)
