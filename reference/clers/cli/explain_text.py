"""An explanation in lines and tables, for people. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-4."""

from shlex import join
from textwrap import wrap
from typing import TYPE_CHECKING, Final

from clers.cli.output import line, table

if TYPE_CHECKING:
    from clers.oracle.explaining.explanation import Explanation, Heard, Table, Told

ROWS: Final = 60
"""Rows of a table that are printed. Clause: ORCL-EXPLAIN-2."""

WIDE: Final = 96
LONGEST: Final = 2000
"""Characters of a request's line that are printed."""


def print_explanation(found: "Explanation") -> None:
    """Print it all, what an adapter said last. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-4."""
    from msgspec import UnsetType

    from clers.oracle.explaining.explain import undoing

    line(f"{found.id}  {found.op}  ({found.origin}, size {found.size})")
    if found.comment:
        _wrapped(found.comment, "")
    if found.requires:
        line(f"requires: {', '.join(found.requires)}")
    line(f"asks:   {found.asks}")
    how = " (labels and orders are free)" if found.compare == "isomorphic" else ""
    line(f"right:  {found.answer}{how}")
    _told("clauses", found.clauses)
    _told("flags", found.flags)
    if not isinstance(found.fault, UnsetType):
        line("")
        line(f"fault: {found.fault.kind}; to blame: {found.blamed}")
        line(f"  without it: {found.fault.parent}")
        for undo in undoing(found.fault):
            line(f"  to undo it: {undo}")
    for each in found.tables:
        _table(each)
    if not isinstance(found.heard, UnsetType):
        _heard(found.heard)


def _told(title: str, items: "tuple[Told, ...]") -> None:
    if items:
        line("")
        line(f"{title}:")
    for item in items:
        _wrapped(f"{item.name}  {' '.join(item.text.split())}", "  ")


def _wrapped(text: str, indent: str) -> None:
    for part in wrap(text, WIDE, initial_indent=indent, subsequent_indent=indent + "  "):
        line(part)


def _table(each: "Table") -> None:
    line("")
    line(f"{each.title}:")
    table(each.heads, each.rows[:ROWS])
    if len(each.rows) > ROWS:
        line(f"… and {len(each.rows) - ROWS} more rows; --json has them all")


def _heard(heard: "Heard") -> None:
    """The verdict, and what a person can send to see the same. Clause: ORCL-EXPLAIN-4."""
    from msgspec import UnsetType

    judged, divergence = heard.judged, heard.judged.divergence
    line("")
    line(f"{heard.adapter} {heard.version}: {str(judged.status).upper()}")
    if isinstance(divergence, UnsetType):
        if judged.why:
            line(f"  {judged.why}")
    else:
        line(f"  first divergence: {divergence.place}")
        line(f"    expected  {divergence.expected}")
        line(f"    got       {divergence.got}")
    line(f"  {heard.outcome}")
    shown = heard.request[:LONGEST]
    line(f"  the request, for {join(heard.command)}:")
    line(f"  {shown}{'…' if len(heard.request) > LONGEST else ''}")
