"""The picture of a walk over a surface, or why there is none."""

from collections import Counter
from dataclasses import replace
from math import ceil, isfinite, sqrt
from typing import Final

from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.encode import encode
from clers.edgebreaker.outline import outline
from clers.edgebreaker.stream import Encoding
from clers.geometry.positions import Positions
from clers.pictures.compose import panel
from clers.pictures.drawing import Drawing, fitted
from clers.pictures.flat import flat
from clers.pictures.options import DEFAULT, SIZES, Layout, Options
from clers.pictures.palette import Letter
from clers.pictures.picture import Picture
from clers.pictures.pointing import pointed
from clers.pictures.ribbon import ribbon
from clers.pictures.story import Story, moments, story
from clers.pictures.view import view

SHEET: Final = 60
"""Up to so many faces every step is shown, with labels. Clause: TOOL-PICTURE-10."""

PLANE: Final = 10_000
"""Up to so many faces in each component there is a flat drawing. Clause: TOOL-PICTURE-6."""

SHAPES: Final = 1 << 22
"""How many faces all panels of a picture may have together. Clause: TOOL-PICTURE-11."""

COLUMNS: Final = 5


def draw(
    surface: Surface,
    encoding: Encoding,
    positions: Positions | None = None,
    options: Options = DEFAULT,
) -> Accepted[Picture] | Rejected:
    """The picture of the walk that wrote an encoding of a surface; `encoding` is encode(surface).

    Linear in the faces of all panels; a flat drawing takes a few hundred times as long as any other
    for each face. Clauses: TOOL-PICTURE-1 to TOOL-PICTURE-11, TOOL-PICTURE-14.
    """
    outlined = outline(encoding.stream)
    if isinstance(outlined, Rejected):
        return outlined
    if encoding != encode(surface):
        return _refused("the encoding is not this surface's own")
    told = story(surface, encoding, outlined.value)
    layout = _layout(told, positions, options)
    fault = _fault(told, positions, options, layout)
    if fault is not None:
        return fault
    steps = _steps(surface, options)
    labels = surface.faces <= SHEET if options.labels is None else options.labels
    drawing, width, height = fitted(_drawing(told, positions, options, layout))
    return Accepted(
        Picture(
            panels=tuple(
                replace(
                    panel(told, drawing, now, options.tree, labels),
                    pointed=pointed(surface, drawing, options.pointer),
                )
                for now in moments(told, steps)
            ),
            columns=min(COLUMNS, ceil(sqrt(len(steps)))),
            width=width,
            height=height,
            pixels=options.size or (1000 if len(steps) == 1 else 250),
            labels=labels,
            counts=_counts(told),
            turned=drawing.turned,
        )
    )


def _layout(told: Story, positions: Positions | None, options: Options) -> Layout:
    """What AUTO means for this mesh. Clause: TOOL-PICTURE-5."""
    if options.layout is not Layout.AUTO:
        return options.layout
    if positions is not None and (told.surface.faces > SHEET or options.view is not None):
        return Layout.VIEW
    return Layout.FLAT if _longest(told) <= PLANE else Layout.RIBBON


def _longest(told: Story) -> int:
    """The faces of the greatest component."""
    return max(map(len, told.components))


def _steps(surface: Surface, options: Options) -> tuple[int, ...]:
    """Those asked for; or all of a small mesh, or the last one. Clause: TOOL-PICTURE-10."""
    if options.steps:
        return tuple(sorted(set(options.steps)))
    return tuple(range(surface.faces + 1)) if surface.faces <= SHEET else (surface.faces,)


def _fault(
    told: Story, positions: Positions | None, options: Options, layout: Layout
) -> Rejected | None:
    """The first thing that cannot be drawn. Clause: TOOL-PICTURE-11."""
    surface = told.surface
    if positions is not None and positions.vertices != surface.vertices:
        detail = f"{positions.vertices} positions for {surface.vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.TOOL_PICTURE_11, detail=detail)
    if layout is Layout.VIEW and positions is None:
        return _refused("a view needs positions")
    if layout is Layout.FLAT and _longest(told) > PLANE:
        return _refused(f"flat drawings are of at most {PLANE} faces a component")
    direction = options.view
    if direction is not None and not (any(direction) and all(map(isfinite, direction))):
        return _refused(f"no direction: {direction}")
    if options.size is not None and options.size not in SIZES:
        return _refused(f"a panel of {options.size} pixels, not {SIZES.start} to {SIZES.stop - 1}")
    for step in options.steps:
        if not 0 <= step <= surface.faces:
            detail = f"step {step} of {surface.faces}"
            return Rejected(Reason.NO_SUCH_STEP, Clause.TOOL_PICTURE_11, detail=detail)
    panels = len(_steps(surface, options))
    if panels * surface.faces > SHAPES and panels > 1:
        detail = f"{panels} panels of {surface.faces} faces, together at most {SHAPES}"
        return Rejected(Reason.TOO_MANY_FACES, Clause.TOOL_PICTURE_11, detail=detail)
    return None


def _refused(detail: str) -> Rejected:
    return Rejected(Reason.NOT_DRAWABLE, Clause.TOOL_PICTURE_11, detail=detail)


def _drawing(told: Story, positions: Positions | None, options: Options, layout: Layout) -> Drawing:
    """Where everything is. Clause: TOOL-PICTURE-5."""
    if layout is Layout.VIEW and positions is not None:
        return view(told.surface, positions, options.view)
    if layout is Layout.RIBBON:
        return ribbon(told.surface, [visit.tip for visit in told.visits])
    return flat(told.surface, told.components)


def _counts(told: Story) -> tuple[tuple[Letter, int], ...]:
    """How often each letter occurs, of those that do. Clause: TOOL-PICTURE-3."""
    found = Counter(visit.letter for visit in told.visits)
    return tuple((letter, found[letter]) for letter in Letter if found[letter])
