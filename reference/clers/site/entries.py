"""What the search knows: an entry for each clause, law and section. Clause: TOOL-SITE-7."""

from collections.abc import Iterable
from enum import StrEnum

import msgspec

HEAD = "globalThis.clersEntries = "
"""The entries are a script and not data, for pages opened as files may not fetch data."""


class Kind(StrEnum):
    """What an entry is; the search shows the kinds in this order."""

    CLAUSE = "clause"
    LAW = "law"
    SECTION = "section"


class Entry(msgspec.Struct, frozen=True, array_like=True):
    """Something to find: its kind, its id or title, its page's title, its address, its text."""

    kind: Kind
    title: str
    page: str
    href: str
    text: str


def script(entries: Iterable[Entry]) -> bytes:
    """The entries as a script that says them, one on a line."""
    lines = ",\n".join(msgspec.json.encode(entry).decode() for entry in entries)
    return f"{HEAD}[\n{lines}\n];\n".encode()


def entries_of(said: bytes) -> tuple[Entry, ...]:
    """What `script` wrote."""
    data = said.removeprefix(HEAD.encode()).removesuffix(b";\n")
    return msgspec.json.decode(data, type=tuple[Entry, ...])
