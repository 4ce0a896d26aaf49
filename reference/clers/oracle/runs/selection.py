"""Which cases of a suite are asked, and how many those must be. ORCL-CHECK-2, ORCL-CHECK-5.

That no profile can be passed blindly (ORCL-CHECK-13) is a property of the suite.
"""

from collections.abc import Collection
from dataclasses import dataclass
from fnmatch import fnmatchcase

from clers.conformance.cases.case import Case
from clers.oracle.suite.files import Suite


@dataclass(frozen=True, slots=True)
class Selection:
    """What is named by each of the four ways; nothing selects everything. Clause: ORCL-CHECK-2.

    `only` are patterns for whole ids.
    """

    profiles: tuple[str, ...] = ()
    ops: tuple[str, ...] = ()
    clauses: tuple[str, ...] = ()
    only: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Chosen:
    """A case and its profile."""

    profile: str
    case: Case


@dataclass(frozen=True, slots=True)
class Selected:
    """The cases to be asked, in the manifest's order, and how many the manifest makes them."""

    chosen: tuple[Chosen, ...]
    counted: int


@dataclass(frozen=True, slots=True)
class NotThere:
    """A selection that the suite cannot satisfy, and why. Clause: ORCL-CHECK-2."""

    why: str


def select(suite: Suite, selection: Selection) -> Selected | NotThere:
    """The selected cases, in order. Clauses: ORCL-CHECK-2, ORCL-CHECK-5."""
    files = suite.manifest.files
    for named, known, what in (
        (selection.profiles, {entry.profile for entry in files}, "profile"),
        (selection.ops, {entry.op for entry in files}, "operation"),
    ):
        unknown = sorted({*named} - known)
        if unknown:
            there = ", ".join(sorted(known))
            return NotThere(f"the suite has no {what} {', '.join(unknown)}; it has {there}")
    chosen: list[Chosen] = []
    counted = 0
    for entry, part in zip(files, suite.parts, strict=True):
        if not (_named(entry.profile, selection.profiles) and _named(entry.op, selection.ops)):
            continue
        found = [case for case in part.cases if _wanted(case, selection)]
        counted += entry.cases - (len(part.cases) - len(found))
        chosen.extend(Chosen(part.profile, case) for case in found)
    if not chosen:
        return NotThere("no case of the suite is selected")
    return Selected(tuple(chosen), counted)


def _named(name: str, names: Collection[str]) -> bool:
    return not names or name in names


def _wanted(case: Case, selection: Selection) -> bool:
    cited = not selection.clauses or any(name in case.clauses for name in selection.clauses)
    matched = not selection.only or any(fnmatchcase(case.id, glob) for glob in selection.only)
    return cited and matched
