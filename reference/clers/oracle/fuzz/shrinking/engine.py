"""From a request that fails to the smallest that steps lead to and that fails alike. ORCL-SHRINK-4.

Greedy: the first smaller request that fails alike takes the place of the one before, and the steps
begin anew. What was tried is remembered, for steps of different requests often lead to the same.
"""

from collections.abc import Callable
from dataclasses import dataclass
from time import monotonic
from typing import Final

import msgspec

from clers.conformance.judging.judged import Status
from clers.conformance.messages import Operation
from clers.oracle.fuzz.checks import Check, Tried
from clers.oracle.fuzz.question import kind_of
from clers.oracle.fuzz.shrinking.steps import smaller


@dataclass(frozen=True, slots=True)
class Patience:
    """What shrinking may take: requests, seconds, and requests that time out. ORCL-SHRINK-4."""

    requests: int = 3000
    seconds: float = 60.0
    timeouts: int = 12


DEFAULT_PATIENCE: Final = Patience()
"""Clause: ORCL-SHRINK-4."""


@dataclass(frozen=True, slots=True)
class Least:
    """The smallest request found, what it came to, how many were asked; is no step left?"""

    operation: Operation
    tried: Tried
    asked: int
    minimal: bool


def alike(one: Tried, other: Tried) -> bool:
    """Is it the same failure, on an input of the same kind? Clause: ORCL-SHRINK-1."""
    return (
        not other.good
        and one.judged.signature == other.judged.signature
        and one.law == other.law
        and kind_of(one.case) == kind_of(other.case)
    )


Clock = Callable[[], float]


def least(
    operation: Operation,
    tried: Tried,
    check: Check,
    patience: Patience = DEFAULT_PATIENCE,
    clock: Clock = monotonic,
) -> Least:
    """Take steps as long as one leads to a smaller request that fails alike.

    `tried` is what the request came to. Clauses: ORCL-SHRINK-1 … ORCL-SHRINK-4.
    """
    until = clock() + patience.seconds
    best, found = operation, tried
    seen: set[bytes] = set()
    asked = timeouts = 0
    going = True
    while going:
        going = False
        for candidate in smaller(best):
            key = msgspec.json.encode(candidate)
            if key in seen:
                continue
            seen.add(key)
            if asked >= patience.requests or timeouts >= patience.timeouts or clock() > until:
                return Least(best, found, asked, minimal=False)
            outcome = check(candidate)
            if outcome is None:
                continue
            asked += 1
            timeouts += outcome.judged.status is Status.TIMEOUT
            if outcome.gone:
                return Least(best, found, asked, minimal=False)
            if alike(found, outcome):
                best, found, going = candidate, outcome, True
                break
    return Least(best, found, asked, minimal=True)
