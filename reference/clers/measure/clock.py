"""Two clocks read together: the wall's, and that of the processor's time of this process."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter, process_time


@dataclass(frozen=True, slots=True)
class Spent:
    """Seconds by the wall and of the processor. Clause: TOOL-SPEED-2."""

    wall: float
    cpu: float

    def __sub__(self, other: "Spent") -> "Spent":
        return Spent(self.wall - other.wall, self.cpu - other.cpu)


def now() -> Spent:
    """What both clocks say; the difference of two readings is what was spent between."""
    return Spent(perf_counter(), process_time())


@dataclass(frozen=True, slots=True)
class Spread:
    """The median of measurements, the least and the greatest. Clause: TOOL-SPEED-2."""

    median: float
    least: float
    most: float


def spread(values: Sequence[float]) -> Spread:
    """The spread of one measurement or more. Clause: TOOL-SPEED-2."""
    return Spread(median(values), min(values), max(values))
