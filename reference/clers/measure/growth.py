"""How time and memory grow with the number of triangles: a claim of linearity, put to the test."""

import gc
import platform
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from clers.generate.flat_families import shuffled, sphere_of
from clers.measure.path import timed_path

SEED: Final = 2007


@dataclass(frozen=True, slots=True)
class StepGrowth:
    """Seconds per triangle of one step at each size, and the last divided by the first."""

    step: str
    seconds_per_triangle: tuple[float, ...]
    ratio: float


@dataclass(frozen=True, slots=True)
class Growth:
    """`clers bench growth --json`."""

    python: str
    machine: str
    family: str
    faces: tuple[int, ...]
    steps: tuple[StepGrowth, ...]
    peak_bytes_per_triangle: tuple[float, ...]


def measure(
    sizes: Sequence[int], rounds: int, shuffle: bool, step: Callable[[str], None]
) -> Growth:
    """Time the path at each size, sizes taken in turn so that a slow spell hits all alike."""
    meshes = [sphere_of(size) for size in sizes]
    if shuffle:
        meshes = [shuffled(mesh, SEED) for mesh in meshes]
    best: list[dict[str, float]] = [{} for _ in sizes]
    gc.disable()
    for _ in range(rounds):
        for mesh, found in zip(meshes, best, strict=True):
            step(f"{mesh.faces} faces")
            gc.collect()
            for timed in timed_path(mesh):
                wall = timed.spent.wall
                found[timed.step] = min(wall, found.get(timed.step, wall))
    gc.enable()
    faces = tuple(mesh.faces for mesh in meshes)
    for found in best:
        found["encode (surface, walk, code)"] = sum(found[x] for x in ("surface", "walk", "code"))
        found["decode (code, walk)"] = found["decode code"] + found["decode walk"]
    return Growth(
        platform.python_version(),
        platform.machine(),
        f"grid sphere, {f'shuffled with seed {SEED}' if shuffle else 'rows in order'}",
        faces,
        tuple(_row(name, best, faces) for name in best[0]),
        tuple(_peak(n) for n in sizes),
    )


def _row(name: str, best: list[dict[str, float]], faces: tuple[int, ...]) -> StepGrowth:
    each = tuple(found[name] / n for found, n in zip(best, faces, strict=True))
    return StepGrowth(name, each, each[-1] / each[0])


def _peak(faces: int) -> float:
    """Peak memory of the whole path, the mesh included, in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-m", "clers.measure.peak", str(faces)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return float(done.stdout)
