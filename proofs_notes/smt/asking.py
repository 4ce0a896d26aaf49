"""Lemmas and controls as data, and the question to z3. Clause: TOOL-PROOF-7.

A lemma holds if z3 finds its negation unsatisfiable; a control must have a counterexample.
Numbers are integers without bound unless a lemma bounds them.
"""

import json
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from time import perf_counter

from z3 import And, BoolRef, Solver, sat, unsat

PATIENCE = 20_000
"""Milliseconds for one question; all are settled in a small part of it."""


@dataclass(frozen=True, slots=True)
class Lemma:
    """For all numbers, `given` implies `then`."""

    name: str
    statement: str
    given: tuple[BoolRef, ...]
    then: BoolRef


@dataclass(frozen=True, slots=True)
class Control:
    """The same with less given or more claimed: not for all numbers."""

    name: str
    statement: str
    given: tuple[BoolRef, ...]
    then: BoolRef


def within(least: int, greatest: int, *terms: object) -> BoolRef:
    """Every term lies between two numbers, both included."""
    return And(*(And(least <= term, term <= greatest) for term in terms))


def signed64(*terms: object) -> BoolRef:
    """Every term is an integer of 64 bits with sign."""
    return within(-(1 << 63), (1 << 63) - 1, *terms)


def unsigned64(*terms: object) -> BoolRef:
    """Every term is an integer of 64 bits without sign."""
    return within(0, (1 << 64) - 1, *terms)


def found(asked: Lemma | Control) -> tuple[str, str]:
    """`holds`, `fails` or `unknown`, and the counterexample if there is one."""
    solver = Solver()
    solver.set("timeout", PATIENCE)
    # The negation of `given implies then`.
    solver.add(*asked.given, And(asked.then) == False)  # noqa: E712
    answer = solver.check()
    if answer == unsat:
        return "holds", ""
    if answer == sat:
        return "fails", " ".join(str(solver.model()).split())
    return "unknown", solver.reason_unknown()


def main(asked: Iterable[Lemma | Control]) -> int:
    """Ask all; print a line each, or JSON with `--json`. 0 if all is as it must be, otherwise 1."""
    rows = []
    for one in asked:
        begun = perf_counter()
        answer, example = found(one)
        wanted = "holds" if isinstance(one, Lemma) else "fails"
        rows.append(
            {
                "kind": type(one).__name__.lower(),
                "name": one.name,
                "statement": one.statement,
                "answer": answer,
                "as_wanted": answer == wanted,
                "example": example,
                "seconds": round(perf_counter() - begun, 3),
            }
        )
    good = all(row["as_wanted"] for row in rows)
    if "--json" in sys.argv[1:]:
        print(json.dumps(rows))
    else:
        for row in rows:
            mark = "  " if row["as_wanted"] else "! "
            print(f"{mark}{row['answer']:7} {row['kind']:7} {row['name']}: {row['statement']}")
            if row["example"]:
                print(f"          {row['example']}")
    return 0 if good else 1
