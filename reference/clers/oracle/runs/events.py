"""What a run tells while it goes on. Clauses: ORCL-CHECK-1, ORCL-CHECK-9, ORCL-CHECK-11."""

from dataclasses import dataclass

from clers.conformance.judging.judged import Judged


@dataclass(frozen=True, slots=True)
class Came:
    """A selected case and what it came to: by itself, and held against the known failures.

    Later news of the same case take the place of earlier ones. Clauses: ORCL-CHECK-1, ORCL-ORDER-2.
    """

    raw: Judged
    held: Judged


@dataclass(frozen=True, slots=True)
class Sang:
    """What a canary came to: it should have failed. Clause: ORCL-CHECK-11."""

    judged: Judged


@dataclass(frozen=True, slots=True)
class Gap:
    """Cases have no result, for their piece was lost, and why. Clause: ORCL-POOL-5."""

    why: str


@dataclass(frozen=True, slots=True)
class Stopped:
    """The run ends here, and why. Clauses: ORCL-CHECK-7, ORCL-CHECK-8."""

    why: str


Event = Came | Sang | Gap | Stopped
