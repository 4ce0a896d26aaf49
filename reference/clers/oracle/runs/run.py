"""A run, event by event: the cases, some of them in another order, and the canaries."""

from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from dataclasses import dataclass
from typing import Final

from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import GOOD, Judged
from clers.oracle.pool.place import Local, Lost, Place
from clers.oracle.pool.spread import spread
from clers.oracle.runs.events import Came, Event, Gap, Sang, Stopped
from clers.oracle.runs.order import again, leak
from clers.oracle.runs.pieces import Adapter, Result, ask_piece, pieces

HERE: Final = Local(2)
"""Where a run goes on, if nothing else is said."""


def _as_it_is(judged: Judged) -> Judged:
    return judged


@dataclass(frozen=True, slots=True)
class Plan:
    """How a run goes: whom it asks, where, what is known, and when it is stopped.

    `hold` looks at a result as one who knows the failures (ORCL-BASELINE-2); `failures` is the
    number of results at which the run is stopped, 0 for none (ORCL-CHECK-8).
    """

    adapter: Adapter
    place: Place = HERE
    hold: Callable[[Judged], Judged] = _as_it_is
    failures: int = 0


def run(
    plan: Plan, cases: Sequence[Case], canaries: Sequence[Case] = ()
) -> Generator[Event, None, None]:
    """Everything that a run comes to, as soon as it is known; close it to end all adapters.

    Clauses: ORCL-CHECK-1, ORCL-CHECK-6 … ORCL-CHECK-9, ORCL-CHECK-11, ORCL-ORDER-1, ORCL-POOL-5.
    """
    results: dict[str, Result] = {}
    with closing(_asked(plan, cases)) as news:
        for event in news:
            if isinstance(event, Result):
                results[event.judged.id] = event
                yield Came(event.judged, plan.hold(event.judged))
                continue
            yield event
            if isinstance(event, Stopped):
                return
    named = {case.id: case for case in cases}
    order = [named[name] for name in again(tuple(results.values()))]
    with closing(_alone(plan, order)) as replays:
        for found in replays:
            judged = leak(results[found.judged.id], found)
            if judged is not None:
                yield Came(judged, plan.hold(judged))
    with closing(_alone(plan, canaries)) as songs:
        yield from (Sang(found.judged) for found in songs)


def _alone(plan: Plan, cases: Sequence[Case]) -> Generator[Result, None, None]:
    """What came of a few cases, for which no worker is worth its start. Clause: ORCL-CHECK-6."""
    for piece in pieces(plan.adapter, cases):
        yield from ask_piece(piece)


def _told(plan: Plan, cases: Sequence[Case]) -> Generator[Result | Lost, None, None]:
    """What came of each case, in order. Clauses: ORCL-CHECK-6, ORCL-POOL-1."""
    return spread(ask_piece, pieces(plan.adapter, cases), plan.place)


def _asked(plan: Plan, cases: Sequence[Case]) -> Generator[Result | Gap | Stopped, None, None]:
    """The results, and why there are no more. Clauses: ORCL-CHECK-7, ORCL-CHECK-8."""
    restarts = failures = 0
    with closing(_told(plan, cases)) as news:
        for number, found in enumerate(news, 1):
            if isinstance(found, Lost):
                yield Gap(found.why)
                continue
            yield found
            restarts += found.restarts
            failures += plan.hold(found.judged).status not in GOOD
            if number == len(cases):
                return
            if restarts >= plan.adapter.bounds.restarts:
                yield Stopped(f"{restarts} processes had to be started anew")
                return
            if 0 < plan.failures <= failures:
                yield Stopped(f"{failures} failures")
                return
