"""Mathematics between dollar signs as MathML, which browsers set themselves. TOOL-SITE-6."""

import re
from collections.abc import Mapping
from functools import cache
from html import escape, unescape
from types import MappingProxyType
from typing import Final
from xml.etree import ElementTree

from latex2mathml.converter import convert

_SIGNS: Final = str.maketrans(
    {
        "−": "-",
        "·": r"\cdot ",
        "→": r"\to ",
        "…": r"\dots ",
        "¼": r"\tfrac14 ",
        "½": r"\tfrac12 ",
        "×": r"\times ",
        "≤": r"\le ",
        "≥": r"\ge ",
        "∎": r"\blacksquare ",
    }
)
_SPACE: Final = ' xmlns="http://www.w3.org/1998/Math/MathML"'
_TAG: Final = re.compile(r"<[^>]*>")
_LETTERS: Final = re.compile(r'(?:<mi mathvariant="(italic|normal)">[^<]</mi>){2,}')
_LETTER: Final = re.compile(r">([^<])<")
_TIGHT: Final = re.compile(
    r"<m[io](?: stretchy=\"false\")?>([/|⌊⌋]|&#x0(?:002F|007C|230A|230B);)</m[io]>"
)
_FUNCTION: Final = re.compile(r"<mo>(min|max)</mo>")
_TOKEN: Final = re.compile(r"\\(?:[A-Za-z]+|.)|\{|\}|\s+|.", re.DOTALL)
_FUNCTIONS: Final = frozenset({"\\log", "\\ln", "\\exp", "\\min", "\\max"})
_OPENING: Final = frozenset(
    {"\\frac", "\\tfrac", "\\binom", "\\lfloor", "\\lceil", "\\prod", "\\sum", "\\sqrt"}
)
_PARTS: Final[Mapping[str, int]] = MappingProxyType(
    {
        **dict.fromkeys(("mfrac", "mroot", "msub", "msup", "munder", "mover"), 2),
        **dict.fromkeys(("msubsup", "munderover"), 3),
    }
)
_GREEK: Final = re.compile(r"\\(?:[a-z]*(?:eta|mma|lta|lon|mu|nu|pi|rho|gma|tau|phi|chi|psi|ega))")


class NotUnderstood(ValueError):
    """What the converter does not know; it is not thrown further than `pages`."""


def _word(letters: re.Match[str]) -> str:
    """A word in one element: letters of their own would be set like factors of a product."""
    word = "".join(_LETTER.findall(letters[0]))
    return f'<mi class="{"word" if letters[1] == "italic" else "upright"}">{word}</mi>'


def _operand(token: str, *, ends: bool) -> bool:
    """Whether a token of TeX ends (or begins) something that a function's name must not touch."""
    if token.startswith("\\"):
        return bool(_GREEK.fullmatch(token)) or (token in _OPENING and not ends)
    return token.isalnum() or (ends and token in (")", "]", "}", "'", "!"))


def spaced(tex: str) -> str:
    """TeX with thin spaces around names of functions, as TeX itself sets them; MathML does not."""
    made, tokens = list[str](), _TOKEN.findall(tex)
    at = 0
    while at < len(tokens):
        if tokens[at] not in _FUNCTIONS:
            made.append(tokens[at])
            at += 1
            continue
        before = next((token for token in reversed(made) if not token.isspace()), "")
        until = at + 1
        if until < len(tokens) and tokens[until] == "_":
            until += 2
            depth = int(tokens[until - 1 : until] == ["{"])
            while depth and until < len(tokens):
                depth += {"{": 1, "}": -1}.get(tokens[until], 0)
                until += 1
        after = next((token for token in tokens[until:] if not token.isspace()), "")
        made.append("\\," if _operand(before, ends=True) else "")
        made += tokens[at:until]
        made.append("\\," if _operand(after, ends=False) else "")
        at = until
    return "".join(made)


def _unbalanced(tex: str) -> bool:
    """Whether a brace has no other; the converter would set what it can."""
    tokens = _TOKEN.findall(tex)
    return tokens.count("{") != tokens.count("}")


def _whole(html: str) -> bool:
    """Whether each element has as many parts as it needs."""
    return all(
        len(element) == _PARTS.get(element.tag.rpartition("}")[2], len(element))
        for element in ElementTree.fromstring(html).iter()
    )


@cache
def mathml(tex: str, *, display: bool = False) -> str:
    """A formula as a `math` element. Raises `NotUnderstood` for what cannot be set."""
    try:
        found = convert(spaced(tex.translate(_SIGNS)), display="block" if display else "inline")
    except Exception as error:  # the converter's own have no class in common
        raise NotUnderstood(f"{tex}: {type(error).__name__}") from error
    if "\\" in _TAG.sub("", found) or _unbalanced(tex) or not _whole(found):
        raise NotUnderstood(tex)
    found = _LETTERS.sub(_word, found)
    found = _FUNCTION.sub(r"<mi>\1</mi>", found)
    found = _TIGHT.sub(r'<mo stretchy="false" lspace="0" rspace="0">\1</mo>', found)
    return found.replace(_SPACE, f' alttext="{escape(" ".join(tex.split()))}"', 1)


@cache
def spoken(tex: str) -> str:
    """A formula as plain text, for titles and the search: its signs without their layout."""
    try:
        return " ".join(unescape(_TAG.sub("", mathml(tex))).split())
    except NotUnderstood:
        return tex
