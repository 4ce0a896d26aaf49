"""`clers bench bits` over worker processes or a cluster. Clause: TOOL-BITS-11."""

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from clers.cli.loading import mesh_in
from clers.conventions.result import Accepted, and_then
from clers.measure.bits.report import Refused, Report, Row, assembled, row
from clers.measure.bits.spheres import random_sphere
from clers.oracle.pool.place import Lost, Place
from clers.oracle.pool.spread import spread


@dataclass(frozen=True, slots=True)
class Item:
    """A mesh to be measured: its name, and its file or else the faces and seed of a sphere."""

    name: str
    file: Path | None
    faces: int = 0
    seed: int = 0


def one(item: Item) -> tuple[Row]:
    """What a worker does: it reads the file itself."""
    if item.file is None:
        return (row(item.name, Accepted(random_sphere(item.faces, item.seed)), _quiet),)
    surface = and_then(mesh_in(item.file), lambda mesh: Accepted(mesh.surface))
    return (row(item.name, surface, _quiet),)


def _quiet(_: str) -> None:
    return None


def report_of(items: Sequence[Item], place: Place, step: Callable[[str], None]) -> Report:
    """The report on the meshes, in their order, whoever has measured them. Clause: TOOL-BITS-11."""
    rows: list[Row] = []
    with closing(spread(one, items, place)) as found:
        for item, result in zip(items, found, strict=True):
            step(item.name)
            rows.append(Refused(item.name, result.why) if isinstance(result, Lost) else result)
    return assembled(rows)
