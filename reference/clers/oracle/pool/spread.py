"""One task over many items, wherever: the results come in the order of the items. ORCL-POOL-1."""

from collections.abc import Callable, Generator, Iterable
from typing import TypeVar, assert_never

from clers.oracle.pool.cluster import cannot_reach, on_cluster
from clers.oracle.pool.local import by_processes
from clers.oracle.pool.place import Cluster, Local, Lost, Place

A = TypeVar("A")
B = TypeVar("B")


def spread(
    task: Callable[[A], Iterable[B]], items: Iterable[A], place: Place
) -> Generator[B | Lost, None, None]:
    """The results of each item, in order, as they are known; close it to end what still runs.

    `task` is a function of a module, and its item and results can be pickled. What it raises is
    raised when its turn has come. A cluster that cannot be reached is an OSError: see `obstacle`.
    Clauses: ORCL-POOL-1, ORCL-POOL-2, ORCL-POOL-3.
    """
    match place:
        case Local(workers) if workers <= 1:
            for item in items:
                yield from task(item)
        case Local(workers):
            yield from by_processes(task, items, workers)
        case Cluster(scheduler):
            yield from on_cluster(task, items, scheduler)
        case _:
            assert_never(place)


def obstacle(place: Place) -> str:
    """Why nothing can be done there; empty if something can. Clause: ORCL-POOL-3."""
    return cannot_reach(place.scheduler) if isinstance(place, Cluster) else ""
