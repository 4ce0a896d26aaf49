"""All cases with a fault and their parents, made once for the tests that look at them."""

from functools import cache

from msgspec import UnsetType

from clers.conformance.cases.case import Case
from clers.oracle.negatives import negatives


@cache
def made() -> tuple[tuple[str, str, Case], ...]:
    """Profile, words of the id, and case."""
    return negatives({})


@cache
def suite() -> dict[str, Case]:
    """The cases by id."""
    return {case.id: case for _, _, case in made()}


@cache
def rejected() -> tuple[Case, ...]:
    """Those with a rejection."""
    return tuple(case for case in suite().values() if not isinstance(case.reject, UnsetType))


@cache
def accepted() -> tuple[Case, ...]:
    """Those with a result."""
    return tuple(case for case in suite().values() if isinstance(case.reject, UnsetType))
