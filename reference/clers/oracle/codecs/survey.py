"""All meshes through all codecs, and for each kind of finding one smallest mesh. ORCL-CODEC-14."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from typing import Final

from clers import __version__
from clers.conformance import payloads as form
from clers.conformance.bounds import Bounds
from clers.conformance.session import Session
from clers.oracle.codecs.asking import Ask, Became, asking
from clers.oracle.codecs.settings import Setting
from clers.oracle.codecs.smallest import smallest

BOUNDS: Final = Bounds(request=30.0, restarts=100_000)
"""A codec may break as often as it is asked."""

Named = tuple[str, form.MeshForm]


@dataclass(frozen=True, slots=True)
class Row:
    """A mesh, and what became of it in each setting, in the order of the settings."""

    mesh: str
    vertices: int
    faces: int
    became: tuple[Became, ...]


@dataclass(frozen=True, slots=True)
class Shown:
    """A kind of finding in one setting: the meshes that show it, and one as small as can be.

    `became` is what became of that one.
    """

    setting: str
    finding: str
    meshes: tuple[str, ...]
    smallest: form.MeshForm
    became: Became


@dataclass(frozen=True, slots=True)
class Survey:
    """Versions, settings, meshes, findings, and what was left out and why. ORCL-CODEC-14."""

    clers: str
    packages: dict[str, str]
    settings: tuple[str, ...]
    commands: tuple[str, ...]
    missing: tuple[str, ...]
    rows: tuple[Row, ...]
    shown: tuple[Shown, ...]
    left_out: tuple[tuple[str, str], ...]


def installed(settings: Iterable[Setting]) -> dict[str, str]:
    """The versions of the packages that are there."""
    found: dict[str, str] = {}
    for package in sorted({setting.package for setting in settings}):
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            continue
    return found


def steps_of(meshes: Sequence[Named], settings: Sequence[Setting]) -> int:
    """How many steps a survey announces at least: a mesh in each setting that is installed."""
    packages = installed(settings)
    return len(meshes) * sum(setting.package in packages for setting in settings)


def survey(
    meshes: Sequence[Named],
    left_out: Sequence[tuple[str, str]],
    settings: Sequence[Setting],
    step: Callable[[str], None],
) -> Survey:
    """Ask every codec that is installed about every mesh. Clause: ORCL-CODEC-14."""
    packages = installed(settings)
    there = [setting for setting in settings if setting.package in packages]
    columns: list[tuple[Became, ...]] = []
    shown: list[Shown] = []
    for setting in there:
        with Session(setting.command, BOUNDS) as session:
            ask = asking(session, setting)
            column: list[Became] = []
            for name, mesh in meshes:
                step(f"{setting.name}, {name}")
                column.append(ask(mesh))
            columns.append(tuple(column))
            shown += _shown(setting, meshes, column, ask)
    return Survey(
        __version__,
        packages,
        tuple(setting.name for setting in there),
        tuple(f"clers adapter {' '.join(setting.words)}" for setting in there),
        tuple(setting.name for setting in settings if setting not in there),
        tuple(
            Row(name, int(mesh.vertices), len(mesh.faces), tuple(column[k] for column in columns))
            for k, (name, mesh) in enumerate(meshes)
        ),
        tuple(shown),
        tuple(left_out),
    )


def _shown(
    setting: Setting,
    meshes: Sequence[Named],
    column: Sequence[Became],
    ask: Ask,
) -> Iterable[Shown]:
    """Each finding of a codec, from the smallest mesh that shows it made smaller."""
    by_kind: dict[str, list[int]] = {}
    for k, one in enumerate(column):
        for finding in one.findings:
            by_kind.setdefault(finding, []).append(k)
    for finding in sorted(by_kind):
        where = by_kind[finding]
        least = min(where, key=lambda k: _weight(meshes[k][1], column[k]))
        kinds = column[least].findings
        small = smallest(meshes[least][1], _showing(ask, kinds))
        yield Shown(setting.name, finding, tuple(meshes[k][0] for k in where), small, ask(small))


def _showing(ask: Ask, kinds: frozenset[str]) -> Callable[[form.MeshForm], bool]:
    return lambda mesh: ask(mesh).findings == kinds


def _weight(mesh: form.MeshForm, became: Became) -> tuple[int, int, int]:
    """Meshes that show little beside are best to begin with, then small ones."""
    return len(became.findings), len(mesh.faces), int(mesh.vertices)
