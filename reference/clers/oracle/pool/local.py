"""Many items over worker processes of this machine. Clauses: ORCL-POOL-1, ORCL-POOL-2."""

from collections import defaultdict, deque
from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass
from multiprocessing.connection import wait
from typing import Final, Generic, TypeVar, assert_never

from clers.oracle.pool.place import Lost
from clers.oracle.pool.worker import PATIENCE, Died, Done, Part, Raised, Worker

A = TypeVar("A")
B = TypeVar("B")

TRIES: Final = 3
"""Workers that an item is given to, one after the other. Clause: ORCL-POOL-2."""

DEATHS: Final = 20
"""Deaths of workers in a campaign after which nothing is tried any more. Clause: ORCL-POOL-2."""

AHEAD: Final = 16
"""Items a worker that may be done before the oldest is: their results wait in memory."""


@dataclass(slots=True)
class _Job(Generic[A]):
    """An item, its place in the order, its results so far, and the workers that ended over it."""

    index: int
    item: A
    results: int = 0
    deaths: int = 0


@dataclass(slots=True)
class _Held(Generic[A, B]):
    """A worker with its job, and how many results of it this worker has given."""

    worker: Worker[A, B]
    job: _Job[A]
    results: int = 0


class _Campaign(Generic[A, B]):
    """What is still to be done, who does what, and what is known. Private and mutable."""

    def __init__(self, task: Callable[[A], Iterable[B]], items: Iterable[A], workers: int) -> None:
        self._task = task
        self._fresh = (_Job(index, item) for index, item in enumerate(items))
        self._again: deque[_Job[A]] = deque()
        self._workers = workers
        self._idle: list[Worker[A, B]] = []
        self._busy: list[_Held[A, B]] = []
        self._given = 0
        self._deaths = 0
        self._known: defaultdict[int, deque[Part[B] | Raised | Lost]] = defaultdict(deque)
        self._done: set[int] = set()
        self._told = 0

    def next(self) -> Part[B] | Raised | Lost | None:
        """What comes next, as soon as it is known; None at the end. Clause: ORCL-POOL-1."""
        while True:
            self._hand_out()
            known = self._known[self._told]
            if known:
                return known.popleft()
            if self._told in self._done:
                del self._known[self._told]
                self._told += 1
            elif self._busy:
                self._gather()
            else:
                return None

    def _hand_out(self) -> None:
        """Give each free worker something to do, but nothing too far ahead."""
        while len(self._busy) < self._workers:
            job = self._next_job()
            if job is None:
                return
            if self._deaths >= DEATHS:
                self._give_up(job, f"not tried: {DEATHS} workers have ended")
                continue
            worker = self._idle.pop() if self._idle else Worker[A, B](self._task)
            self._busy.append(_Held(worker, job))
            worker.give(job.item)

    def _next_job(self) -> _Job[A] | None:
        if self._again:
            return self._again.popleft()
        if self._given >= self._told + AHEAD * self._workers:
            return None
        self._given += 1
        return next(self._fresh, None)

    def _give_up(self, job: _Job[A], why: str) -> None:
        self._known[job.index].append(Lost(why))
        self._done.add(job.index)

    def _gather(self) -> None:
        """Wait until somebody says something, and take what all who have something say."""
        ready = set(wait([held.worker.pipe for held in self._busy]))
        working, self._busy = self._busy, []
        for held in working:
            if held.worker.pipe not in ready or self._heard(held):
                self._busy.append(held)

    def _heard(self, held: _Held[A, B]) -> bool:
        """Take what a worker says; whether it goes on. Clause: ORCL-POOL-2."""
        job, found = held.job, held.worker.taken()
        match found:
            case Part():
                held.results += 1
                if held.results > job.results:  # else one who ended has given it before
                    job.results += 1
                    self._known[job.index].append(found)
                return True
            case Died(code):
                self._deaths += 1
                job.deaths += 1
                if job.deaths < TRIES:
                    self._again.append(job)
                else:
                    why = f"{TRIES} workers ended over it, the last with code {code}"
                    self._give_up(job, why)
                return False
            case Raised():
                self._known[job.index].append(found)
            case Done():
                self._done.add(job.index)
            case _:
                assert_never(found)
        self._idle.append(held.worker)
        return False

    def end(self) -> None:
        """No worker is left. Clause: ORCL-POOL-4."""
        for held in self._busy:
            held.worker.end()
        for worker in self._idle:
            worker.end(PATIENCE)


def by_processes(
    task: Callable[[A], Iterable[B]], items: Iterable[A], workers: int
) -> Generator[B | Lost, None, None]:
    """The results in order. Clauses: ORCL-POOL-1, ORCL-POOL-2, ORCL-POOL-4."""
    campaign = _Campaign(task, items, workers)
    try:
        while (found := campaign.next()) is not None:
            match found:
                case Part(result):
                    yield result
                case Raised(fault):
                    raise fault
                case Lost():
                    yield found
                case _:
                    assert_never(found)
    finally:
        campaign.end()
