"""Many meshes measured, with what is needed to measure them again."""

import platform
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from math import exp, fsum, log
from os import cpu_count

from clers import __version__
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.measure.bits.costs import NAMES, PEERS, Measured, measured


@dataclass(frozen=True, slots=True)
class Refused:
    """A mesh that is none, and the rejection in one line. Clause: TOOL-BITS-8."""

    mesh: str
    why: str


@dataclass(frozen=True, slots=True)
class Report:
    """`clers bench bits --json`. Clauses: TOOL-BITS-7, TOOL-BITS-8."""

    clers: str
    python: str
    machine: str
    day: str
    packages: dict[str, str]
    meshes: tuple[Measured, ...]
    mean_ratio: float | None
    refused: tuple[Refused, ...]


Given = tuple[str, Accepted[Surface] | Rejected]
"""A mesh's name, and its surface or what is wrong with it."""

STEPS = len(NAMES)


def report(given: Iterable[Given], step: Callable[[str], None]) -> Report:
    """Measure meshes, one after another. Clause: TOOL-BITS-8."""
    rows: list[Measured] = []
    refused: list[Refused] = []
    for name, surface in given:
        match surface:
            case Accepted(value):
                rows.append(measured(name, value, _of(name, step)))
            case Rejected() as rejected:
                refused.append(Refused(name, rejected.line()))
    return Report(
        __version__,
        platform.python_version(),
        f"{platform.machine()}, {cpu_count()} cores",
        datetime.now(UTC).date().isoformat(),
        {package: _version(package) for package in sorted({p.package for p in PEERS} - {""})},
        tuple(rows),
        geometric_mean([row.ratio for row in rows if row.ratio is not None]),
        tuple(refused),
    )


def _of(mesh: str, step: Callable[[str], None]) -> Callable[[str], None]:
    return lambda word: step(f"{mesh}, {word}")


def geometric_mean(ratios: list[float]) -> float | None:
    """The mean of ratios; none of none. Clause: TOOL-BITS-7."""
    return exp(fsum(log(x) for x in ratios) / len(ratios)) if ratios else None


def _version(package: str) -> str:
    """The version that is installed, or that none is. Clause: TOOL-BITS-6."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
