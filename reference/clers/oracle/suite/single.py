"""What must hold of a case by itself. Clauses: ORCL-SUITE-4, ORCL-CASE-1 … ORCL-CASE-8."""

from collections.abc import Iterator
from typing import Final, get_args

from msgspec import UnsetType

from clers.codes.registry import CodeName
from clers.conformance.cases.case import PROFILES, Case, operation_of, right_result
from clers.conformance.cases.identity import named
from clers.conformance.lines import NoMessage
from clers.conformance.payloads import CoderName
from clers.conformance.results import RESULTS
from clers.conventions.clause import Clause
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.profiles import LIMITS, profile_of
from clers.oracle.suite.retiring import slug_in

CAPABILITIES: Final = frozenset(
    (
        "handles",
        "boundaries.one",
        "boundaries.many",
        "components",
        *(f"code.{code}" for code in CodeName),
        *(f"coder.{coder}" for coder in get_args(CoderName)),
    )
)
"""What a case may require. Clause: ORCL-CASE-4."""

CLAUSES: Final = frozenset(map(str, Clause))


def of_case(file: str, profile: str, op: str, case: Case) -> Iterator[Problem]:
    """What does not hold of a case in the file of a profile and an operation. ORCL-SUITE-4."""
    if case.op not in RESULTS:
        yield Problem(file, f"no operation is named {case.op}", Clause.ORCL_CASE_1, case.id)
        return
    if case.op != op:
        yield Problem(file, f"it is of {case.op}", Clause.ORCL_SUITE_1, case.id)
    if named(slug_in(case.id), case) != case:
        what = "its id or its text is not that of what it asks and expects"
        yield Problem(file, what, Clause.ORCL_CASE_2, case.id)
    yield from _forms(file, case)
    unknown = [name for name in case.clauses if name not in CLAUSES]
    if unknown or not case.clauses:
        what = f"no clause is named {unknown[0]}" if unknown else "it names no clause"
        yield Problem(file, what, Clause.ORCL_CASE_1, case.id)
    for name in case.requires:
        if name not in CAPABILITIES:
            yield Problem(file, f"no capability is named {name}", Clause.ORCL_CASE_4, case.id)
    if profile not in PROFILES or (profile != LIMITS and profile_of(case) != profile):
        what = f"its profile is {profile_of(case)}, not {profile}"
        yield Problem(file, what, Clause.ORCL_SUITE_3, case.id)


def _forms(file: str, case: Case) -> Iterator[Problem]:
    """Input and result are of the operation's form, and there is one answer. ORCL-CASE-1."""
    asked = operation_of(case)
    if isinstance(asked, NoMessage):
        yield Problem(file, f"its input: {asked.why}", Clause.ORCL_CASE_1, case.id)
    if isinstance(case.ok, UnsetType) == isinstance(case.reject, UnsetType):
        what = "it has both a result and a rejection, or none"
        yield Problem(file, what, Clause.ORCL_CASE_1, case.id)
    elif not isinstance(case.ok, UnsetType):
        right = right_result(case)
        if isinstance(right, NoMessage):
            yield Problem(file, f"its result: {right.why}", Clause.ORCL_CASE_1, case.id)
