"""Pictures as PNG, painted by matplotlib's Agg, from the same scene as the SVG."""

from collections.abc import Sequence
from io import BytesIO
from itertools import groupby
from typing import Final, assert_never

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import Collection, LineCollection, PatchCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from clers.pictures.drawing import Point
from clers.pictures.palette import PAPER
from clers.pictures.picture import Picture
from clers.pictures.scene import Disc, Item, Line, Polygon, Scene, Style, Words
from clers.pictures.sheet import scene

DPI: Final = 72
"""So that a point is a pixel."""


def to_png(picture: Picture) -> bytes:
    """The picture as a PNG image. Clause: TOOL-PICTURE-13."""
    return png_of(scene(picture))


def png_of(of: Scene) -> bytes:
    """An image as a PNG image. Clauses: TOOL-PICTURE-13, TOOL-OPERATORS-3."""
    figure = Figure(figsize=(of.width / DPI, of.height / DPI), dpi=DPI, facecolor=PAPER)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(0, of.width)
    axes.set_ylim(of.height, 0)
    _paint(axes, of)
    data = BytesIO()
    figure.savefig(data, format="png", dpi=DPI, metadata={"Software": None})
    return data.getvalue()


def _paint(axes: Axes, of: Scene) -> None:
    """Neighbours of one sort are painted together, because one by one takes minutes."""
    items = (item for group in of.groups for item in group.items)
    for height, (_, run) in enumerate(groupby(items, key=_sort)):
        together = list(run)
        drawable = [item for item in together if not isinstance(item, Words)]
        if drawable:
            collection = _collection(drawable)
            collection.set_zorder(height)
            axes.add_collection(collection, autolim=False)
        for item in together:
            if isinstance(item, Words):
                _write(axes, item, height)


def _sort(item: Item) -> str:
    """What can be painted together. A line without dashes is a polygon of two corners."""
    match item:
        case Line(style=style):
            return "dashes" if style.dash else "corners"
        case Polygon():
            return "corners"
        case Disc():
            return "discs"
        case Words():
            return "words"
        case _:
            assert_never(item)


def _collection(items: Sequence[Polygon | Disc | Line]) -> Collection:
    """Items of one sort as one object."""
    styles = [item.style for item in items]
    fills = [style.fill or "none" for style in styles]
    strokes = [style.stroke or "none" for style in styles]
    widths = [style.width for style in styles]
    if isinstance(items[0], Disc):
        circles = [Circle(item.centre, item.radius) for item in items if isinstance(item, Disc)]
        return PatchCollection(circles, facecolors=fills, edgecolors=strokes, linewidths=widths)
    paths = [_corners(item) for item in items]
    if styles[0].dash:
        dashes = list(map(_dash, styles))
        return LineCollection(paths, colors=strokes, linewidths=widths, linestyles=dashes)
    return PolyCollection(
        paths, facecolors=fills, edgecolors=strokes, linewidths=widths, joinstyle="round"
    )


def _corners(item: Polygon | Disc | Line) -> tuple[Point, ...]:
    match item:
        case Polygon():
            return item.points
        case Line():
            return item.path
        case Disc():
            return (item.centre,)
        case _:
            assert_never(item)


def _dash(style: Style) -> tuple[float, tuple[float, ...] | None]:
    """matplotlib counts dashes in widths of the line."""
    if not style.dash:
        return 0.0, None
    return 0.0, tuple(length / style.width for length in style.dash)


def _write(axes: Axes, words: Words, height: int) -> None:
    axes.text(
        *words.at,
        words.text,
        fontsize=words.size,
        color=words.colour,
        weight="bold" if words.bold else "normal",
        horizontalalignment="center" if words.centred else "left",
        verticalalignment="center_baseline",
        zorder=height,
        parse_math=False,
    )
