"""How much a foreign process may take of everything."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Bounds:
    """Seconds, bytes and numbers of processes. Clauses: ORCL-RUN-2, ORCL-RUN-6, ORCL-RUN-7.

    `start`, `request`: seconds until hello and until any other reply; `bytes_a_second`: how much
    of a request's line is worth one second more; `farewell`: seconds to end after bye; `restarts`:
    processes after the first; `memory`: bytes of address space; `output`: bytes of standard output
    for a request; `errors`: bytes of standard error that are kept.
    """

    start: float = 30.0
    request: float = 5.0
    bytes_a_second: int = 50_000
    farewell: float = 2.0
    restarts: int = 20
    memory: int = 8 << 30
    output: int = 64 << 20
    errors: int = 64 << 10

    def seconds_for(self, line: bytes) -> float:
        """The time that a request has. Clause: ORCL-RUN-2."""
        return self.request + len(line) / self.bytes_a_second


DEFAULT_BOUNDS: Final = Bounds()
"""Clauses: ORCL-RUN-2, ORCL-RUN-6, ORCL-RUN-7."""
