"""Many items over the workers of a Dask cluster. Clauses: ORCL-POOL-1, ORCL-POOL-2, ORCL-POOL-3.

`distributed` is an optional extra (`pip install 'clers[cluster]'`), and has few types: what is
used of it stands in the protocols below.
"""

from collections import deque
from collections.abc import Callable, Generator, Iterable
from itertools import islice
from typing import Final, Protocol, TypeVar

from clers.oracle.pool.place import Lost

A = TypeVar("A")
B = TypeVar("B")
B_co = TypeVar("B_co", covariant=True)

AHEAD: Final = 64
"""Items that the cluster has at a time."""

PATIENCE: Final = 10.0
"""Seconds until a scheduler answers."""


class _Future(Protocol[B_co]):
    def result(self) -> B_co: ...
    def exception(self) -> object: ...
    def cancel(self) -> object: ...


class _Client(Protocol):
    def submit(
        self,
        whole: "Callable[[Callable[[A], Iterable[B]], A], tuple[B, ...]]",
        task: Callable[[A], Iterable[B]],
        item: A,
        *,
        pure: bool,
    ) -> _Future[tuple[B, ...]]: ...
    def close(self) -> object: ...


def on_cluster(
    task: Callable[[A], Iterable[B]], items: Iterable[A], scheduler: str
) -> Generator[B | Lost, None, None]:
    """The results in order; OSError if the scheduler does not answer. Clause: ORCL-POOL-3."""
    client = _connected(scheduler)
    rest = iter(items)
    sent: deque[tuple[A, _Future[tuple[B, ...]]]] = deque()
    try:
        while True:
            more = islice(rest, AHEAD - len(sent))
            sent.extend((item, client.submit(_whole, task, item, pure=False)) for item in more)
            if not sent:
                return
            item, future = sent.popleft()
            yield from _results(client, task, item, future, [other for _, other in sent])
    finally:
        for _, future in sent:
            future.cancel()
        client.close()


def _whole(task: Callable[[A], Iterable[B]], item: A) -> tuple[B, ...]:
    """What a worker of the cluster does."""
    return tuple(task(item))


def _results(
    client: _Client,
    task: Callable[[A], Iterable[B]],
    item: A,
    future: _Future[tuple[B, ...]],
    others: list[_Future[tuple[B, ...]]],
) -> tuple[B | Lost, ...]:
    """What came of an item. Clause: ORCL-POOL-2.

    The scheduler gives the items of a dead worker to others. Over the fourth death (its
    `allowed-failures`) it gives up all that were with that worker: the one that kills and those
    beside it. So an item that was given up is tried once more, with nothing beside it.
    """
    from distributed import KilledWorker

    try:
        return future.result()
    except KilledWorker:
        for other in others:
            other.exception()  # waits until it has come to an end
    try:
        return client.submit(_whole, task, item, pure=False).result()
    except KilledWorker as fault:
        return (Lost(" ".join(str(fault).split())),)


def cannot_reach(scheduler: str) -> str:
    """Why the scheduler cannot be asked; empty if it can. Clause: ORCL-POOL-3."""
    try:
        _connected(scheduler).close()
    except ModuleNotFoundError:
        return "a cluster needs the extra `cluster`: pip install 'clers[cluster]'"
    except (OSError, ValueError) as fault:
        return f"no scheduler answers at {scheduler}: {fault}"
    return ""


def _connected(scheduler: str) -> _Client:
    import distributed

    client: _Client = distributed.Client(scheduler, timeout=PATIENCE, set_as_default=False)
    return client
