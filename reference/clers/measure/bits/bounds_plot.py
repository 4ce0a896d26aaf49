"""Random spheres and real meshes beside what codes guarantee, as a plot."""

from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from clers.measure.bits.bounds import GUARANTEED, Bounds, OnMesh
from clers.measure.bits.costs import BEST

COLOURS: Final = {
    "plain": "#6c757d",
    "king-rossignac": "#e76f51",
    "golden": "#e9a800",
    "enumerative": "#1d3557",
    BEST: "#c1121f",
}

TITLES: Final = {
    "plain": "2",
    "king-rossignac": "11/6",
    "golden": "1.7356",
    "enumerative": "1.6226",
}


def drawn(of: Bounds) -> Figure:
    """Spheres to the left, meshes to the right, the bounds across. Clause: TOOL-BITS-10."""
    figure = Figure(figsize=(11, 5.2), layout="constrained")
    if of.meshes:
        left, right = figure.subplots(1, 2, width_ratios=(1, 1.15))
        _draw_meshes(right, of.meshes)
    else:
        left = figure.add_subplot()
    _draw_spheres(left, of)
    return figure


def _draw_spheres(axes: Axes, of: Bounds) -> None:
    for row in of.spheres:
        colour = COLOURS[row.code]
        axes.scatter(
            row.faces, row.bits_per_triangle, s=4, c=colour, linewidths=0, label=row.code,
            rasterized=True,
        )  # fmt: skip
    _draw_bounds(axes)
    for name, value in GUARANTEED.items():
        axes.annotate(
            TITLES[name], (1, value), xycoords=("axes fraction", "data"), xytext=(-3, 2),
            textcoords="offset points", ha="right", fontsize=7, color=COLOURS[name],
        )  # fmt: skip
    axes.set_xscale("log")
    axes.set_ylim(1.5, 2.03)
    axes.set_xlabel("triangles")
    axes.set_ylabel("bits per triangle")
    count = len(of.spheres[0].faces)
    axes.set_title(f"{count} random spheres: the word; lines: what is guaranteed", fontsize=9)
    axes.legend(
        loc="upper right", bbox_to_anchor=(1, 0.92), ncols=2, fontsize=8, markerscale=3,
        frameon=False,
    )  # fmt: skip


def _draw_bounds(axes: Axes) -> None:
    for name, value in GUARANTEED.items():
        axes.axhline(value, color=COLOURS[name], linewidth=0.8, zorder=1)


def _draw_meshes(axes: Axes, meshes: tuple[OnMesh, ...]) -> None:
    across = range(len(meshes))
    _draw_bounds(axes)
    axes.scatter(across, [m.golden for m in meshes], s=14, c=COLOURS["golden"], label="golden")
    drawn_by = [(x, m.draco) for x, m in zip(across, meshes, strict=True) if m.draco is not None]
    if drawn_by:
        places, values = zip(*drawn_by, strict=True)
        axes.scatter(places, values, s=18, c="#000000", marker="D", label="Draco's lesser")
    axes.scatter(across, [m.best for m in meshes], s=26, c=COLOURS[BEST], label=BEST)
    axes.set_ylim(bottom=0)
    axes.set_xticks(list(across), [m.mesh for m in meshes], rotation=90, fontsize=6)
    axes.set_title("meshes: all connectivity, handles and counts included", fontsize=9)
    axes.legend(loc="lower left", fontsize=8, frameon=False)
