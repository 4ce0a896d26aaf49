"""Draw requests of one family, judge each, and shrink the first failure of each signature.

Hypothesis draws, and shrinks the choices that a failing request was drawn by; then the steps of
`shrinking` go on from there. Clauses: ORCL-FUZZ-1, ORCL-FUZZ-4, ORCL-SHRINK-5.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256
from time import monotonic
from typing import Final

import msgspec
from hypothesis import HealthCheck, Phase, Verbosity, given, seed, settings
from hypothesis.errors import Flaky

from clers.conformance.judging.judged import Status
from clers.conformance.messages import Operation
from clers.oracle.fuzz.checks import Check, Tried
from clers.oracle.fuzz.families import Family
from clers.oracle.fuzz.inputs import Drawn
from clers.oracle.fuzz.shrinking.engine import DEFAULT_PATIENCE, Least, Patience, alike, least
from clers.oracle.fuzz.shrinking.sizes import size_of

MOST: Final = {Status.TIMEOUT: 3, Status.CRASH: 50}
"""How many time-outs and crashes are borne outside of shrinking. Clause: ORCL-FUZZ-5."""

TRIES: Final = {Status.TIMEOUT: 0, Status.FLAKY: 0, Status.CRASH: 30}
"""How many requests Hypothesis may spend on shrinking a failure of this status."""

TRIES_ELSE: Final = 400
SECONDS: Final = 30.0
"""How long Hypothesis may shrink."""

ROUND: Final = 50
"""Examples between two reports."""


@dataclass(frozen=True, slots=True)
class First:
    """A failure as it was found, not yet shrunk."""

    operation: Operation
    tried: Tried


@dataclass(frozen=True, slots=True)
class Small:
    """A failure, shrunk from the request that first showed it. Clause: ORCL-FUZZ-4."""

    first: Operation
    least: Least


@dataclass(frozen=True, slots=True)
class Round:
    """So many examples more were drawn and asked; `broken` says why there will be no others."""

    drawn: int
    asked: int
    broken: str = ""


Event = First | Small | Round


class _Enough(BaseException):
    """Ends a run of Hypothesis, which lets no other kind through. Never seen outside."""


class _Found(Exception):
    """Tells Hypothesis that an example fails. Never seen outside."""


@dataclass(slots=True)
class _Search:
    """A run of Hypothesis that ends at a failure that is not known; private to this module."""

    check: Check
    examples: int
    until: float
    known: frozenset[str]
    failures: Counter[Status]
    seen: set[bytes]
    drawn: int = 0
    asked: int = 0
    broken: str = ""
    first: First | None = None

    def meet(self, operation: Operation) -> bool:
        """Ask and judge an example. Clauses: ORCL-FUZZ-3, ORCL-FUZZ-4, ORCL-FUZZ-5."""
        if self.drawn >= self.examples or monotonic() > self.until:
            raise _Enough
        self.drawn += 1
        if self._again(operation):
            return False
        tried = self.check(operation)
        if tried is None:
            return False
        self.asked += 1
        if tried.gone:
            self._break(tried.gone)
        elif not tried.good and tried.judged.signature in self.known:
            status = tried.judged.status
            self.failures[status] += 1
            if self.failures[status] >= MOST.get(status, self.failures[status] + 1):
                self._break(f"{self.failures[status]} times {status}")
        elif not tried.good:
            self.first = First(operation, tried)
            raise _Enough
        return False

    def _again(self, operation: Operation) -> bool:
        """Was it drawn before? Then it need not be asked once more."""
        key = sha256(msgspec.json.encode(operation)).digest()
        before = key in self.seen
        self.seen.add(key)
        return before

    def _break(self, why: str) -> None:
        self.broken = why
        raise _Enough


@dataclass(slots=True)
class _Shrinking:
    """The same run again, nothing asked before its failure, and that shrunk. ORCL-SHRINK-5."""

    check: Check
    before: int
    best: First
    tries: int
    stop: float
    drawn: int = 0

    def meet(self, operation: Operation) -> bool:
        """Does it fail alike? What was drawn before the failure did not."""
        self.drawn += 1
        if self.drawn < self.before:
            return False
        if self.drawn == self.before:
            if operation != self.best.operation:
                raise _Enough  # the same choices made something else: nothing to go on with
            return True
        if self.tries == 0 or monotonic() > self.stop:
            raise _Enough
        self.tries -= 1
        tried = self.check(operation)
        if tried is None or not alike(self.best.tried, tried):
            return False
        if size_of(operation) < size_of(self.best.operation):
            self.best = First(operation, tried)
        return True


def _drawing(drawn: Drawn, run: _Search | _Shrinking, examples: int, number: int) -> None:
    """One run of Hypothesis; the same for the same seed and the same answers."""

    @seed(number)
    @settings(
        max_examples=examples,
        phases=[Phase.generate, Phase.shrink],
        database=None,
        deadline=None,
        derandomize=False,
        report_multiple_bugs=False,
        print_blob=False,
        verbosity=Verbosity.quiet,
        suppress_health_check=list(HealthCheck),
    )
    @given(drawn)
    def meet(operation: Operation) -> None:
        if run.meet(operation):
            raise _Found  # from one place, or Hypothesis would take it for several failures

    try:
        meet()
    except (_Enough, _Found, Flaky):
        return


def number_of(*what: object) -> int:
    """A seed from others: the same for the same ones. Clause: ORCL-FUZZ-3."""
    return int.from_bytes(sha256(repr(what).encode()).digest()[:8], "big")


def hunt(
    family: Family,
    number: int,
    examples: int,
    until: float,
    patience: Patience = DEFAULT_PATIENCE,
) -> Iterator[Event]:
    """Events as they come, a Round after each run; it ends after so many examples, or in time.

    `number` is the seed, `until` a time of `monotonic`. Clauses: ORCL-FUZZ-3 … ORCL-FUZZ-5.
    """
    known: set[str] = set()
    failures: Counter[Status] = Counter()
    seen: set[bytes] = set()
    left, turn = examples, 0
    while left > 0 and monotonic() < until:
        count, chosen = min(left, ROUND), number_of(number, family.name, turn)
        run = _Search(family.check, count, until, frozenset(known), failures, seen)
        _drawing(family.drawn, run, count, chosen)
        turn += 1
        left -= max(run.drawn, 1)
        if run.first is not None:
            yield run.first
            known.add(run.first.tried.judged.signature)
            tries = TRIES.get(run.first.tried.judged.status, TRIES_ELSE)
            again = _Shrinking(family.check, run.drawn, run.first, tries, monotonic() + SECONDS)
            if tries:
                _drawing(family.drawn, again, count, chosen)
            best = again.best
            found = least(best.operation, best.tried, family.check, patience)
            yield Small(run.first.operation, found)
        yield Round(run.drawn, run.asked, run.broken)
        if run.broken:
            return
