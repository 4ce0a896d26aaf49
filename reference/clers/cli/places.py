"""`--workers` and `--scheduler`: where a campaign runs. Clauses: ORCL-POOL-1, ORCL-POOL-3."""

from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from clers.oracle.pool.place import Place


def place_of(workers: int, scheduler: str) -> "Place":
    """The cluster if one is named; wrong usage if it cannot be reached. Clause: ORCL-POOL-3."""
    from clers.oracle.pool.place import Cluster, Local
    from clers.oracle.pool.spread import obstacle

    place = Cluster(scheduler) if scheduler else Local(workers)
    why = obstacle(place)
    if why:
        raise typer.BadParameter(why, param_hint="--scheduler")
    return place
