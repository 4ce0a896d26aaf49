"""A report as tables for people, and as a page of the repository."""

from collections.abc import Iterator
from dataclasses import dataclass

from clers.measure.bits.costs import BEST, NAMES, Cost, Kind, Measured, least_of_draco
from clers.measure.bits.report import Report

ABOUT = {
    Kind.CODE: "codes",
    Kind.PEER: "peers",
    Kind.MEASURE: "entropies and the limit (no codes)",
}
MISSING = "not-obtainable"


@dataclass(frozen=True, slots=True)
class Table:
    """A title, the heads of the columns, and rows of as many cells."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def tables(of: Report) -> Iterator[Table]:
    """Ratios first, then each kind of number per vertex and per triangle. Clause: TOOL-BITS-8."""
    yield _ratios(of)
    for kind, about in ABOUT.items():
        names = [name for name, whose in NAMES if whose is kind]
        for unit in ("vertex", "triangle"):
            heads = ("mesh", *names)
            rows = tuple((row.mesh, *_cells(row, names, unit)) for row in of.meshes)
            yield Table(f"bits per {unit}: {about}", heads, rows)


def _ratios(of: Report) -> Table:
    heads = ("mesh", "vertices", "faces", "components", "genus", "curves", BEST, "draco", "ratio")
    rows = [
        (
            row.mesh,
            *map(str, (row.vertices, row.faces, row.components, row.genus, row.curves)),
            _number(row.bits(BEST), 0),
            _number(least_of_draco({c.name: c.bits for c in row.costs}), 0),
            _number(row.ratio, 3),
        )
        for row in of.meshes
    ]
    return Table(f"bits of connectivity, and {BEST} divided by Draco's lesser", heads, tuple(rows))


def _cells(row: Measured, names: list[str], unit: str) -> Iterator[str]:
    costs = {cost.name: cost for cost in row.costs}
    for name in names:
        yield _cell(costs[name], unit)


def _cell(cost: Cost, unit: str) -> str:
    """A number; or – where a code refuses the mesh; or that the peer is missing. TOOL-BITS-6."""
    if cost.bits is None:
        return "not installed" if MISSING in cost.why_not else "–"
    return _number(cost.bits_per_vertex if unit == "vertex" else cost.bits_per_triangle, 3)


def _number(value: float | None, digits: int) -> str:
    return "–" if value is None else f"{value:.{digits}f}"


def mean_line(of: Report) -> str:
    """The mean of the ratios in words. Clause: TOOL-BITS-7."""
    count = sum(row.ratio is not None for row in of.meshes)
    if of.mean_ratio is None:
        return f"no mesh has both {BEST} and Draco"
    return f"geometric mean of the ratio over {count} meshes: {of.mean_ratio:.3f}"


def made_by(of: Report) -> str:
    """Versions, machine and day in words. Clause: TOOL-BITS-8."""
    packages = ", ".join(f"{name} {number}" for name, number in of.packages.items())
    return f"clers {of.clers}, Python {of.python}, {of.machine}, {of.day}; {packages}"


def page(of: Report, command: str) -> str:
    """The tables as a page, with the command that made it. Clause: TOOL-BITS-9."""
    lines = [
        "# Bits of connectivity, measured",
        "",
        "What is counted, and what the columns are, is said in "
        "[the chapter on tools](../spec/10-bits.md). This page was printed by",
        "",
        f"    {command}",
        "",
        f"{made_by(of)}.",
        "",
        f"{mean_line(of)[0].upper()}{mean_line(of)[1:]}.",
        "",
    ]
    for table in tables(of):
        lines += [f"## {table.title[0].upper()}{table.title[1:]}", ""]
        lines += [piped(table.heads), piped(("---", *["---:"] * (len(table.heads) - 1)))]
        lines += [*map(piped, table.rows), ""]
    if of.refused:
        lines += ["## Refused", ""]
        lines += [f"- {mesh.mesh}: {mesh.why}" for mesh in of.refused]
        lines.append("")
    return "\n".join(lines)


def piped(cells: tuple[str, ...]) -> str:
    """A row of a table of a page."""
    return f"| {' | '.join(cells)} |"
