"""Contenders on one mesh, in turn, round after round; and what comes of it."""

import gc
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from clers.conventions.result import Rejected
from clers.measure.clock import Spent, Spread, spread
from clers.measure.speed.contender import Attempt, Contender, Given, Kind, Reading, Way

Key = tuple[str, Way]


@dataclass(frozen=True, slots=True)
class Samples:
    """The readings of each name and way, one a round; and who refused the mesh, and why."""

    readings: dict[Key, list[Reading]]
    kinds: dict[str, Kind]
    refused: dict[str, str]


@dataclass(frozen=True, slots=True)
class Rate:
    """What one way of a contender took. Clause: TOOL-SPEED-2.

    Times are in seconds; `triangles_per_second` is by processor time, and so is its spread.
    """

    name: str
    kind: Kind
    way: Way
    bytes: int | None
    triangles_per_second: Spread
    cpu: Spread
    wall: Spread


def sampled(
    given: Given, contenders: Sequence[Contender], rounds: int, step: Callable[[str], None]
) -> Samples:
    """Let each contender code a mesh once a round, all in turn. Clause: TOOL-SPEED-2.

    So a slow spell of the machine hits all alike. Python looks for cyclic garbage before an
    attempt, and not within.
    """
    found = Samples({}, {}, {})
    ready: list[tuple[Contender, Attempt]] = []
    for contender in contenders:
        made = contender.ready(given)
        if isinstance(made, Rejected):
            found.refused[contender.name] = made.line()
        else:
            ready.append((contender, made.value))
    for _ in range(rounds):
        for contender, attempt in ready:
            step(f"{given.name}, {contender.name}")
            _once(found, contender, attempt)
    return found


def _once(found: Samples, contender: Contender, attempt: Attempt) -> None:
    gc.collect()
    gc.disable()
    try:
        readings = attempt()
    finally:
        gc.enable()
    if isinstance(readings, Rejected):
        found.refused[contender.name] = readings.line()
        return
    for reading in readings.value:
        found.readings.setdefault((reading.name, reading.way), []).append(reading)
        found.kinds[reading.name] = contender.kind


def rates(of: Samples, faces: int) -> tuple[Rate, ...]:
    """Medians and spreads, in the order in which names were met. Clause: TOOL-SPEED-2."""
    return tuple(
        rate(name, of.kinds[name], way, [r.spent for r in readings], faces, readings[0].bytes)
        for (name, way), readings in of.readings.items()
    )


def rate(
    name: str, kind: Kind, way: Way, spent: Sequence[Spent], faces: int, size: int | None
) -> Rate:
    """The rate of one way. Clause: TOOL-SPEED-2."""
    cpu = [each.cpu for each in spent]
    # Where a clock has not moved, a rate says nothing: it is 0.
    speeds = [faces / seconds if seconds > 0 else 0.0 for seconds in cpu]
    return Rate(name, kind, way, size, spread(speeds), spread(cpu), spread([s.wall for s in spent]))
