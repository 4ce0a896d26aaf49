"""Findings among the inputs of a suite, from which they become cases. Clause: ORCL-SUITE-11."""

import re
from collections.abc import Mapping
from typing import Final

import msgspec

from clers.conformance.cases.case import Case
from clers.conformance.cases.faults import fault_in
from clers.conformance.cases.identity import named
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Status
from clers.conformance.serve import INTRODUCTION
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.answers import outcome_of
from clers.oracle.suite.files import document
from clers.oracle.suite.profiles import profile_of
from clers.oracle.suite.rendered import order, rows
from clers.oracle.suite.single import of_case

FILE: Final = "inputs/shrunk.json"
"""Where findings are kept. Clause: ORCL-SUITE-11."""

SLUG: Final = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*", re.ASCII)


class Found(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A finding's case, and the profile that it goes to. Clause: ORCL-SUITE-11."""

    profile: str
    case: Case


class Shrunk(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The file `inputs/shrunk.json`. Clause: ORCL-SUITE-11."""

    found: tuple[Found, ...]


def shrunk(inputs: Mapping[str, bytes]) -> Accepted[tuple[Found, ...]] | Rejected:
    """The findings among the inputs of a suite, none if there is no such file. ORCL-SUITE-11."""
    if FILE not in inputs:
        return Accepted(())
    read = document(FILE, inputs[FILE], Shrunk)
    return read if isinstance(read, Rejected) else Accepted(read.value.found)


def add(
    case: Case, slug: str, known: Mapping[str, Case], before: tuple[Found, ...]
) -> Accepted[tuple[Case, bytes]] | Rejected:
    """The case under its id, and the file with it; `known` are the cases of the suite by id.

    Rejects a slug that is none; a case that the suite asks already, that does not hold by itself,
    or whose expectation is not the reference's. Clause: ORCL-SUITE-11.
    """
    if not SLUG.fullmatch(slug):
        return _refused(f"{slug!r} is no slug")
    new = named(slug, msgspec.structs.replace(case, origin="shrunk"))
    asked = {(other.op, bytes(other.input)): name for name, other in known.items()}
    asked.update(((one.case.op, bytes(one.case.input)), one.case.id) for one in before)
    there = asked.get((new.op, bytes(new.input)))
    if there is not None:
        return _refused(f"{there} asks that already")
    profile = profile_of(new)
    wrong = next(of_case(FILE, profile, new.op, new), None)
    if wrong is not None:
        return _refused(wrong.what)
    judged = judge(new, outcome_of(new), INTRODUCTION)
    if judged.status is not Status.PASS:
        return _refused(f"the reference does not answer it so: {judged.why}")
    bad = fault_in(new, known)
    if bad:
        return _refused(bad)
    found = sorted((*before, Found(profile=profile, case=new)), key=lambda one: order(one.case))
    return Accepted((new, rows('{"found":', found)))


def _refused(detail: str) -> Rejected:
    return Rejected(Reason.NOT_REPRESENTABLE, Clause.ORCL_SUITE_11, detail=detail)
