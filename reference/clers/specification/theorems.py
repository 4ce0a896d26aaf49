"""Theorems as the heads of the proof notes state them. Clauses: TOOL-PROOF-1 to TOOL-PROOF-3.

A head is a list of fields, one an item, that begins with the theorem's name:

    - **Theorem.** `lids-lie`
    - **Clauses.** the ids of the clauses that it justifies
    - **Known by.** how it is known, several ways separated by semicolons
    - **Laws.** the laws and tests that exercise it
    - **Assumes.** what the proof takes for granted
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.specification.identifier import mentions
from clers.specification.markdown import Page, slug

FOLDER: Final = "proofs_notes"
README: Final = f"{FOLDER}/README.md"
OTHERS: Final = frozenset({README, f"{FOLDER}/campaigns.md"})
"""Pages that are no notes. Clause: TOOL-PROOF-1."""

FIELDS: Final = ("Theorem", "Clauses", "Known by", "Laws", "Assumes")

_FIELD: Final = re.compile(r"- \*\*([A-Z][a-z ]*)\.\*\*\s*(.*)")
_HEADING: Final = re.compile(r"#+\s+(.*?)\s*#*\s*")
_CODE: Final = re.compile(r"`([^`]*)`")
_KEBAB: Final = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*")
_NAMES: Final = r"`[^`]+`(?:,\s*(?:and\s+)?`[^`]+`)*"
_SEMICOLON: Final = re.compile(r";(?![^(]*\))")
"""A semicolon that is not in brackets."""

_WAYS: Final = re.compile(
    rf"(?i:(?P<coq>coq)\s+(?P<proofs>{_NAMES})"
    rf"|(?P<smt>z3)\s+(?P<lemmas>{_NAMES})"
    rf"|(?P<certificate>certificates?)\s+(?P<files>{_NAMES})"
    rf"|(?P<exhaustive>exhaustive\s+to)\s+(?P<bound>[^`(]+?)\s*\((?P<judges>{_NAMES})\)"
    r"|(?P<cited>cited)\s+\((?P<source>.+)\)"
    r"|(?P<prose>prose))\.?",
    re.DOTALL,
)


@dataclass(frozen=True, slots=True)
class Coq:
    """A theorem of `proofs_notes/coq`, by its full name `Clers.File.theorem`."""

    name: str


@dataclass(frozen=True, slots=True)
class Smt:
    """A lemma of a file in `proofs_notes`, which z3 settles."""

    file: str
    name: str


@dataclass(frozen=True, slots=True)
class Certificate:
    """A file of exact numbers in `proofs_notes`, which a test checks."""

    file: str


@dataclass(frozen=True, slots=True)
class Exhaustive:
    """All cases up to a bound, gone through by a law or a test file."""

    bound: str
    judge: str


@dataclass(frozen=True, slots=True)
class Cited:
    """Somebody else's proof, not given here."""

    source: str


@dataclass(frozen=True, slots=True)
class Prose:
    """The proof in the note, which people have read and no machine has."""


Way = Coq | Smt | Certificate | Exhaustive | Cited | Prose


@dataclass(frozen=True, slots=True)
class Field:
    """One item of a head: its name, the line it begins in (from 1), its words."""

    name: str
    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Theorem:
    """A head, read: `anchor` is that of the heading above it, `lines` those of its fields."""

    name: str
    path: str
    anchor: str
    lines: tuple[int, ...]
    clauses: tuple[str, ...]
    ways: tuple[Way, ...]
    judges: tuple[str, ...]
    assumes: str

    @property
    def line(self) -> int:
        """Where its head begins."""
        return self.lines[0]

    def line_of(self, field: str) -> int:
        """Where a field of its head begins."""
        return self.lines[FIELDS.index(field)]


@dataclass(frozen=True, slots=True)
class Malformed:
    """A head that cannot be read, and why."""

    path: str
    line: int
    why: str


def is_note(path: str) -> bool:
    """Whether a page is a note: it lies in the folder itself, and says what theorems it has."""
    return path.startswith(f"{FOLDER}/") and path.count("/") == 1 and path not in OTHERS


def theorems(page: Page) -> Iterator[Theorem | Malformed]:
    """Every head of a page in order, read or malformed. Clause: TOOL-PROOF-1."""
    anchor, fields, fenced = "", list[Field](), False
    for number, line in enumerate([*page.text.splitlines(), ""], 1):
        fenced ^= line.startswith("```")
        field = None if fenced else _FIELD.fullmatch(line)
        heading = None if fenced else _HEADING.fullmatch(line)
        if field and (fields or field[1] == FIELDS[0]):
            if fields and field[1] == FIELDS[0]:
                yield _read(page.path, anchor, fields)
                fields = []
            fields.append(Field(field[1], number, field[2]))
        elif fields and line.startswith("  "):
            last = fields[-1]
            fields[-1] = Field(last.name, last.line, f"{last.text} {line.strip()}")
        elif fields:
            yield _read(page.path, anchor, fields)
            fields = []
        anchor = slug(heading[1]) if heading else anchor


def _read(path: str, anchor: str, fields: list[Field]) -> Theorem | Malformed:
    names = tuple(field.name for field in fields)
    if names != FIELDS:
        stated = ", ".join(names)
        return Malformed(path, fields[0].line, f"its fields are {stated}, not {', '.join(FIELDS)}")
    name, clauses, known, laws, assumes = fields
    title = _CODE.fullmatch(name.text)
    if title is None or not _KEBAB.fullmatch(title[1]):
        return Malformed(path, name.line, f"a theorem's name is `like-this`, not {name.text}")
    found = ways(known.text)
    if found is None:
        return Malformed(path, known.line, f"is known in no way there is: {known.text}")
    ids = tuple(dict.fromkeys(mention.clause for mention in mentions(clauses.text)))
    if not ids:
        return Malformed(path, clauses.line, "justifies no clause")
    if not assumes.text:
        return Malformed(path, assumes.line, "does not say what it assumes, or that it is nothing")
    judges = _judges(laws.text)
    if judges is None:
        return Malformed(path, laws.line, f"has no laws, and no reason after `none:`: {laws.text}")
    lines = tuple(field.line for field in fields)
    return Theorem(title[1], path, anchor, lines, ids, found, judges, assumes.text)


def _judges(text: str) -> tuple[str, ...] | None:
    """Names of laws and files of tests; none with a reason; None if it is neither."""
    if re.match(r"none:\s*\S", text):
        return ()
    listed = tuple(item.strip(" .`") for item in text.split(","))
    return listed if all(listed) and listed != ("none",) else None


def _listed(text: str) -> list[str]:
    """The names in code type of a list."""
    return _CODE.findall(text)


def ways(text: str) -> tuple[Way, ...] | None:
    """The ways separated by semicolons; None if one of them is none."""
    found: list[Way] = []
    for part in _SEMICOLON.split(text):
        way = _WAYS.fullmatch(part.strip())
        if way is None:
            return None
        if way["coq"]:
            found += map(Coq, _listed(way["proofs"]))
        elif way["smt"]:
            pairs = [name.partition(":") for name in _listed(way["lemmas"])]
            found += (
                Smt(file.strip(), lemma.strip())
                for file, _, listed in pairs
                for lemma in listed.split(",")
            )
        elif way["certificate"]:
            found += map(Certificate, _listed(way["files"]))
        elif way["exhaustive"]:
            found += (Exhaustive(way["bound"], judge) for judge in _listed(way["judges"]))
        elif way["cited"]:
            found.append(Cited(way["source"]))
        else:
            found.append(Prose())
    return tuple(found)
