"""Triangles a second against bytes a vertex: each coder a point, each way a panel."""

from collections.abc import Iterator, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from clers.measure.speed.contender import Kind, Way
from clers.measure.speed.report import OnMesh, Speed

OURS = "#c1121f"
THEIRS = "#1d3557"
INK = "#222222"
PAPER = "#ffffff"
"""The paper is painted, so that the plot is the same on a light page and on a dark one."""

Point = tuple[str, Kind, float, float]


def largest(of: Speed) -> OnMesh:
    """The mesh with most triangles; it is the one that is drawn. Clause: TOOL-SPEED-8."""
    return max(of.meshes, key=lambda mesh: mesh.faces)


def points(of: OnMesh, way: Way) -> Iterator[Point]:
    """Of each coder that was timed its name, kind, bytes a vertex, million triangles a second."""
    for rate in of.rates:
        size = of.bytes_per_vertex(rate.name)
        if rate.way is way and size is not None and rate.triangles_per_second.median > 0:
            yield rate.name, rate.kind, size, rate.triangles_per_second.median / 1e6


def figure(of: Speed) -> Figure:
    """Two panels with logarithmic axes, for the largest mesh. Clause: TOOL-SPEED-8."""
    mesh = largest(of)
    drawn = Figure(figsize=(11, 5.2), layout="constrained", facecolor=PAPER)
    for k, way in enumerate(Way):
        _panel(drawn.add_subplot(1, 2, k + 1), way, list(points(mesh, way)))
    drawn.suptitle(
        f"{mesh.mesh}: {mesh.faces} triangles, kernels {of.machine.kernels}, "
        "processor time; upward is faster, to the left is smaller",
        fontsize=10, color=INK,
    )  # fmt: skip
    return drawn


def _panel(axes: Axes, way: Way, shown: list[Point]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(way, color=INK)
    axes.set_xlabel("bytes of connectivity per vertex", color=INK)
    axes.set_ylabel("million triangles per second", color=INK)
    axes.grid(which="both", linewidth=0.3)
    if not shown:
        return
    heights = apart([upward for _, _, _, upward in shown])
    for (name, kind, across, upward), height in zip(shown, heights, strict=True):
        ours = kind is Kind.CODE
        colour = OURS if ours else THEIRS
        axes.scatter([across], [upward], c=colour, marker="o" if ours else "^", s=45, zorder=3)
        axes.annotate(
            name, (across, upward), xytext=(across * 1.2, height),
            fontsize=8, color=colour, va="center",
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.4},
        )  # fmt: skip
    axes.set_xlim(min(p[2] for p in shown) / 1.3, max(p[2] for p in shown) * 4)
    axes.set_ylim(min(p[3] for p in shown) / 1.5, max(p[3] for p in shown) * 1.7)


def apart(heights: Sequence[float]) -> list[float]:
    """Where names stand on a logarithmic axis: at their points, or a line above the one below."""
    line = (max(heights) / min(heights) * 2.5) ** 0.032
    stand: dict[int, float] = {}
    last = 0.0
    for k in sorted(range(len(heights)), key=lambda k: heights[k]):
        last = stand[k] = max(heights[k], last * line)
    return [stand[k] for k in range(len(heights))]
