"""Which cases are asked again in another order, and what their replies say. ORCL-ORDER-1, -2."""

from collections.abc import Sequence
from hashlib import sha256
from typing import Final

import msgspec
from msgspec import UNSET

from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.judging.signature import signature
from clers.oracle.runs.pieces import Result
from clers.oracle.runs.said import NOTHING

SHARE: Final = 50
"""One of so many cases is asked again. Clause: ORCL-ORDER-1."""

LEAST: Final = 20
"""Cases that are asked again in any case. Clause: ORCL-ORDER-1."""

FAILURES: Final = 20
"""Failures that are asked again. Clause: ORCL-ORDER-1."""

LEAKS: Final = "state leaks"


def rank(name: str) -> str:
    """Where a case stands in the other order. Clause: ORCL-ORDER-1."""
    return sha256(name.encode()).hexdigest()


def again(results: Sequence[Result]) -> tuple[str, ...]:
    """The ids of the cases that are asked again, in the order in which they are. ORCL-ORDER-1."""
    replied = [result.judged for result in results if result.said != NOTHING]
    share = max(LEAST, -(-len(replied) // SHARE))
    few = sorted((judged.id for judged in replied), key=rank)[:share]
    failed = [judged.id for judged in replied if judged.status not in GOOD][:FAILURES]
    return tuple(sorted({*few, *failed}, key=rank, reverse=True))


def leak(before: Result, now: Result) -> Judged | None:
    """The case as flaky, if it is not answered as before. Clause: ORCL-ORDER-2."""
    if before.said == now.said:
        return None
    first, then = _short(before.judged), _short(now.judged)
    return msgspec.structs.replace(
        before.judged,
        status=Status.FLAKY,
        why=f"{LEAKS}: first {first}; in another order, of a new process, {then}",
        signature=signature(before.judged.op, Status.FLAKY, LEAKS),
        divergence=UNSET,
    )


def _short(judged: Judged) -> str:
    return f"{judged.status} ({judged.why})" if judged.why else str(judged.status)
