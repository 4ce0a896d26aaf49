"""All that `clers bench speed` finds out, with the machine it was found out on."""

import os
import platform
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from clers import __version__
from clers.generate.irregular import flat_irregular_sphere
from clers.kernels import COMPILED
from clers.measure.bits.report import version_of
from clers.measure.speed.contender import Contender, Given, Kind, Way, listed
from clers.measure.speed.memory import Memory, memory
from clers.measure.speed.ours import CODES, OURS, step_name, whole
from clers.measure.speed.peers import PEERS
from clers.measure.speed.rates import Rate, Samples, rate, rates, sampled
from clers.measure.speed.slopes import (
    FAMILIES,
    LEAST,
    SEED,
    Slope,
    rounds_at,
    sizes,
    slopes,
)

PACKAGES: Final = ("DracoPy", "librt", "meshoptimizer", "numpy", "zstandard")
CONTENDERS: Final = (*OURS, *PEERS)
REST: Final = "container"
"""The step that is what the others leave of the whole. Clause: TOOL-SPEED-3."""


@dataclass(frozen=True, slots=True)
class Machine:
    """Where and with what. Clause: TOOL-SPEED-7.

    `load` is the mean number of processes that wanted a core in the minute before, at the begin
    and at the end; none where the system does not say.
    """

    clers: str
    python: str
    kernels: str
    processor: str
    cores: int
    system: str
    day: str
    packages: dict[str, str]
    load: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Ratio:
    """A peer's time divided by ours, one way: above 1 we are faster. Clause: TOOL-SPEED-4."""

    code: str
    peer: str
    way: Way
    ratio: float


@dataclass(frozen=True, slots=True)
class OnMesh:
    """What was found on one mesh."""

    mesh: str
    vertices: int
    faces: int
    rates: tuple[Rate, ...]
    ratios: tuple[Ratio, ...]
    refused: dict[str, str]
    memory: tuple[Memory, ...]

    def find(self, name: str, way: Way) -> Rate | None:
        """The rate of a name, if it has one."""
        return next((r for r in self.rates if (r.name, r.way) == (name, way)), None)

    def bytes_per_vertex(self, name: str) -> float | None:
        """What is written for a vertex, where something is."""
        found = self.find(name, Way.ENCODE)
        if found is None or found.bytes is None:
            return None
        return found.bytes / self.vertices


@dataclass(frozen=True, slots=True)
class Speed:
    """`clers bench speed --json`. Clause: TOOL-SPEED-7."""

    machine: Machine
    rounds: int
    meshes: tuple[OnMesh, ...]
    slopes: tuple[Slope, ...]


def spheres(faces: int) -> Iterable[Given]:
    """The two larger sizes of irregular spheres. Clause: TOOL-SPEED-1."""
    for size in (max(faces // 10, LEAST), faces):
        mesh = flat_irregular_sphere(size - size % 2, SEED)
        yield listed(f"sphere-{mesh.faces}", mesh)


def steps_of(meshes: int, faces: int, rounds: int) -> int:
    """How often `measure` calls its `step`."""
    coded = len(CONTENDERS) * rounds + len(CODES)
    grown = sum(rounds_at(size, faces, rounds) for size in sizes(faces))
    return meshes * coded + grown * len(FAMILIES) * len(CODES)


def measure(meshes: Iterable[Given], faces: int, rounds: int, step: Callable[[str], None]) -> Speed:
    """Time all contenders on all meshes, then our codes on all families. TOOL-SPEED-1 … -7."""
    begin = load()
    found = tuple(on_mesh(each, CONTENDERS, rounds, step) for each in meshes)
    grown = slopes(sizes(faces), [whole(code) for code in CODES], rounds, step)
    return Speed(machine((*begin, *load())), rounds, found, grown)


def on_mesh(
    mesh: Given, contenders: Sequence[Contender], rounds: int, step: Callable[[str], None]
) -> OnMesh:
    """One mesh. Clauses: TOOL-SPEED-1 … TOOL-SPEED-4, TOOL-SPEED-6."""
    samples = sampled(mesh, contenders, rounds, step)
    faces = mesh.surface.faces
    timed = (*rates(samples, faces), *_rests(samples, faces))
    most: list[Memory] = []
    for code in CODES:
        step(f"{mesh.name}, memory of {code}")
        most.append(memory(mesh, code))
    return OnMesh(
        mesh.name,
        mesh.surface.vertices,
        faces,
        timed,
        tuple(ratios(timed)),
        samples.refused,
        tuple(most),
    )


def _rests(samples: Samples, faces: int) -> Iterable[Rate]:
    """What a whole way takes beyond its steps, round by round. Clause: TOOL-SPEED-3."""
    for (name, way), readings in samples.readings.items():
        if samples.kinds[name] is Kind.CODE:
            left = [reading.spent for reading in readings]
            for (step, same), parts in samples.readings.items():
                if same is way and step.startswith(step_name(name, "")):
                    left = [a - b.spent for a, b in zip(left, parts, strict=True)]
            called = step_name(name, REST if way is Way.ENCODE else f"decode {REST}")
            yield rate(called, Kind.STEP, way, left, faces, None)


def ratios(of: Sequence[Rate]) -> Iterable[Ratio]:
    """Each code against each peer, by the medians of processor time. Clause: TOOL-SPEED-4."""
    for ours in of:
        for theirs in of:
            if (
                ours.kind is Kind.CODE
                and theirs.kind is Kind.PEER
                and ours.way is theirs.way
                and ours.cpu.median > 0
            ):
                ratio = theirs.cpu.median / ours.cpu.median
                yield Ratio(ours.name, theirs.name, ours.way, ratio)


def load() -> tuple[float, ...]:
    """The load of the minute before, where the system says it."""
    return (os.getloadavg()[0],) if hasattr(os, "getloadavg") else ()


def machine(loads: tuple[float, ...]) -> Machine:
    """What this is run on and with. Clause: TOOL-SPEED-7."""
    return Machine(
        __version__,
        platform.python_version(),
        "compiled" if COMPILED else "interpreted",
        processor(Path("/proc/cpuinfo")),
        os.cpu_count() or 1,
        f"{platform.system()} {platform.machine()}",
        datetime.now(UTC).date().isoformat(),
        {package: version_of(package) for package in PACKAGES},
        loads,
    )


def processor(information: Path) -> str:
    """The processor's name as the system has it in a file, or else as Python knows it."""
    if information.exists():
        for line in information.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
