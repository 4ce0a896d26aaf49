"""A report as a plot: bits per vertex, a row for each mesh, a mark for each code and peer."""

from io import BytesIO

import matplotlib as mpl
from matplotlib.figure import Figure

from clers.measure.bits.costs import BEST, NAMES, Kind
from clers.measure.bits.report import Report

LEFT_OUT = {"zlib", "zstd", "lzma", *(f"order-{k}" for k in range(6))}
"""Too far to the right, or too many, for a plot that is to be read."""

DRACO = {"draco-standard": "s", "draco-valence": "D"}


def figure(of: Report) -> Figure:
    """Meshes downward, the cheapest in bits of `best` first. Clause: TOOL-BITS-9."""
    shown = [(name, kind) for name, kind in NAMES if name not in LEFT_OUT]
    rows = sorted(of.meshes, key=lambda row: (row.bits(BEST) or 0) / row.vertices, reverse=True)
    drawn = Figure(figsize=(10, 2.2 + 0.24 * len(rows)), layout="constrained")
    axes = drawn.add_subplot()
    for k, (name, kind) in enumerate(shown):
        points = [
            (cost.bits_per_vertex, y)
            for y, row in enumerate(rows)
            for cost in row.costs
            if cost.name == name and cost.bits_per_vertex is not None
        ]
        if points:
            across, down = zip(*points, strict=True)
            marker, colour, size = _look(name, kind, k)
            axes.scatter(across, down, s=size, c=colour, marker=marker, label=name, zorder=3)
    axes.set_yticks(range(len(rows)), [row.mesh for row in rows], fontsize=7)
    axes.set_xlim(0, 8)
    axes.set_xlabel("bits of connectivity per vertex")
    axes.grid(axis="both", linewidth=0.3)
    drawn.legend(loc="outside right upper", fontsize=7, frameon=False)
    return drawn


def _look(name: str, kind: Kind, k: int) -> tuple[str, str, float]:
    """Marker, colour, size: ours are discs, `best` the largest, Draco's black."""
    if name == BEST:
        return "o", "#c1121f", 42
    if name in DRACO:
        return DRACO[name], "#000000", 20
    match kind:
        case Kind.CODE:
            return "ov"[k // 10], f"C{k % 10}", 12
        case Kind.PEER:
            return "^", "#777777", 20
        case Kind.MEASURE:
            return "|", "#1d3557" if name == "limit" else "#2a9d8f", 50


def svg(drawn: Figure) -> bytes:
    """The figure as SVG; the same bytes for the same figure."""
    with mpl.rc_context({"svg.hashsalt": "clers", "svg.fonttype": "none"}):
        stream = BytesIO()
        drawn.savefig(stream, format="svg", dpi=140, metadata={"Date": None})
        return stream.getvalue()


def png(drawn: Figure) -> bytes:
    """The figure as PNG."""
    stream = BytesIO()
    drawn.savefig(stream, format="png", dpi=140)
    return stream.getvalue()
