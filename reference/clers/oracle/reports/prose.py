"""The text of a clause as HTML. Clauses: ORCL-HTML-2, ORCL-HTML-3."""

import re
from collections.abc import Sequence
from functools import cache

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from markdown_it.utils import EnvType, OptionsDict
from markupsafe import Markup


def prose(text: str) -> Markup:
    """Markdown as markup: paragraphs and tables; formulas as code; links without their targets.

    What looks like markup in the text is shown as it is.
    """
    return Markup(_writer().render(re.sub(r"\$([^$\n]+)\$", r"`\1`", text)))


@cache
def _writer() -> MarkdownIt:
    """A page of the specification is not beside the report, so that its links lead nowhere."""
    writer = MarkdownIt("commonmark", {"html": False}).enable("table")
    for rule in ("link_open", "link_close", "image"):
        writer.add_render_rule(rule, _nothing)
    return writer


def _nothing(
    _: RendererHTML, __: Sequence[Token], ___: int, ____: OptionsDict, _____: EnvType
) -> str:
    return ""
