"""Several images in one, from left to right, each under its heading."""

from dataclasses import replace
from itertools import accumulate
from typing import Final

from clers.pictures.palette import INK
from clers.pictures.scene import Disc, Group, Item, Line, Polygon, Scene, Style, Words

HEADING: Final = 20.0
"""The height of a heading's letters."""


def beside(title: str, scenes: tuple[tuple[str, Scene], ...]) -> Scene:
    """The scenes side by side with their headings above; one of none is empty.

    Clause: TOOL-PICTURE-15.
    """
    high = 2.4 * HEADING
    starts = [0.0, *accumulate(scene.width for _, scene in scenes)]
    groups: list[Group] = []
    for k, ((heading, scene), left) in enumerate(zip(scenes, starts, strict=False)):
        words = Words((left + scene.width / 2, 1.4 * HEADING), heading, HEADING, INK, bold=True)
        groups.append(Group(f"heading-{k}", (words,)))
        for group in scene.groups:
            items = tuple(_moved(item, left, high, f"{k}-") for item in group.items)
            groups.append(Group(f"{k}-{group.name}", items))
    tallest = max((scene.height for _, scene in scenes), default=0.0)
    return Scene(starts[-1], high + tallest, title, tuple(groups))


def renamed(of: Scene, prefix: str, title: str) -> Scene:
    """The same image under another title, with a prefix to the names of styles and groups.

    Clause: TOOL-PICTURE-15.
    """
    return replace(
        of,
        title=title,
        groups=tuple(
            Group(
                f"{prefix}{group.name}",
                tuple(_moved(item, 0.0, 0.0, prefix) for item in group.items),
            )
            for group in of.groups
        ),
    )


def _moved(item: Item, right: float, down: float, prefix: str) -> Item:
    """The item elsewhere; names of styles are unique in a scene, so they get a prefix."""
    match item:
        case Polygon():
            points = tuple((x + right, y + down) for x, y in item.points)
            return replace(item, points=points, style=_named(item.style, prefix))
        case Disc(centre=(x, y)):
            return replace(item, centre=(x + right, y + down), style=_named(item.style, prefix))
        case Line(path=((a, b), (c, d))):
            path = (a + right, b + down), (c + right, d + down)
            return replace(item, path=path, style=_named(item.style, prefix))
        case Words(at=(x, y)):
            return replace(item, at=(x + right, y + down))


def _named(style: Style, prefix: str) -> Style:
    return replace(style, name=f"{prefix}{style.name}")
