"""XML as a tree of elements and text, and its one way to be written."""

from collections.abc import Iterator
from dataclasses import dataclass
from re import compile as pattern
from typing import Final
from xml.sax.saxutils import escape

_ILLEGAL: Final = pattern("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True, slots=True)
class Element:
    """An element: its name, its attributes in the order given, and what is inside."""

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    inside: tuple["Element | str", ...] = ()


def document(root: Element) -> str:
    """A well-formed XML document, ended by a newline. Clause: TOOL-PICTURE-12.

    Characters that XML 1.0 cannot have become U+FFFD. An element that has elements inside has each
    on a line of its own; text is written as it is.
    """
    return "".join(['<?xml version="1.0" encoding="UTF-8"?>\n', *_written(root)])


def _written(root: Element) -> Iterator[str]:
    """Depth first, without recursion: a stack of what is still to be written."""
    rest: list[Element | str] = [root]
    while rest:
        match rest.pop():
            case str(text):
                yield text
            case Element(name, attributes, inside):
                yield f"<{name}"
                for key, value in attributes:
                    yield f' {key}="{escape(legal(value), {chr(34): "&quot;"})}"'
                if not inside:
                    yield "/>\n"
                    continue
                lines = any(isinstance(child, Element) for child in inside)
                yield ">\n" if lines else ">"
                rest.append(f"</{name}>\n")
                rest += [
                    escape(legal(child)) if isinstance(child, str) else child
                    for child in reversed(inside)
                ]


def legal(text: str) -> str:
    """The text with U+FFFD for what XML 1.0 has no way to say (its production Char)."""
    return _ILLEGAL.sub("\ufffd", text)
