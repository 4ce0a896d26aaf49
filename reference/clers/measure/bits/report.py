"""Many meshes measured, with what is needed to measure them again."""

import platform
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from math import exp, fsum, log
from os import cpu_count
from typing import assert_never

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


Row = Measured | Refused
"""What comes of a mesh."""


def row(name: str, surface: Accepted[Surface] | Rejected, step: Callable[[str], None]) -> Row:
    """Measure one mesh. Clause: TOOL-BITS-8."""
    match surface:
        case Accepted(value):
            return measured(name, value, _of(name, step))
        case Rejected() as rejected:
            return Refused(name, rejected.line())
        case _:
            assert_never(surface)


def report(given: Iterable[Given], step: Callable[[str], None]) -> Report:
    """Measure meshes, one after another. Clause: TOOL-BITS-8."""
    return assembled([row(name, surface, step) for name, surface in given])


def assembled(found: Sequence[Row]) -> Report:
    """The report on meshes that were measured. Clauses: TOOL-BITS-7, TOOL-BITS-8."""
    rows = tuple(mesh for mesh in found if isinstance(mesh, Measured))
    return Report(
        __version__,
        platform.python_version(),
        f"{platform.machine()}, {cpu_count()} cores",
        datetime.now(UTC).date().isoformat(),
        {package: version_of(package) for package in sorted({p.package for p in PEERS} - {""})},
        rows,
        geometric_mean([mesh.ratio for mesh in rows if mesh.ratio is not None]),
        tuple(mesh for mesh in found if isinstance(mesh, Refused)),
    )


def _of(mesh: str, step: Callable[[str], None]) -> Callable[[str], None]:
    return lambda word: step(f"{mesh}, {word}")


def geometric_mean(ratios: list[float]) -> float | None:
    """The mean of ratios; none of none. Clause: TOOL-BITS-7."""
    return exp(fsum(log(x) for x in ratios) / len(ratios)) if ratios else None


def version_of(package: str) -> str:
    """The version that is installed, or that none is. Clause: TOOL-BITS-6."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
