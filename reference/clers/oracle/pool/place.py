"""Where a campaign runs, and what comes of an item that nobody could finish. ORCL-POOL-1."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Local:
    """So many processes of this machine; with one, this very process. Clause: ORCL-POOL-1."""

    workers: int


@dataclass(frozen=True, slots=True)
class Cluster:
    """The workers of the Dask scheduler at an address. Clause: ORCL-POOL-3."""

    scheduler: str


Place = Local | Cluster
"""Clauses: ORCL-POOL-1, ORCL-POOL-3."""


@dataclass(frozen=True, slots=True)
class Lost:
    """An item without a result, and why: each worker that had it ended. Clause: ORCL-POOL-2."""

    why: str
