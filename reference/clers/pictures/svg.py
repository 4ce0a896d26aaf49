"""Pictures as SVG 1.1: one document, nothing loaded, the same text for the same picture."""

from collections.abc import Iterator
from typing import assert_never

from clers.pictures.element import Element, document
from clers.pictures.picture import Picture
from clers.pictures.scene import FONT, Disc, Group, Item, Line, Polygon, Scene, Style, Words
from clers.pictures.sheet import scene


def to_svg(picture: Picture) -> str:
    """The picture as an SVG document. Clause: TOOL-PICTURE-12."""
    return svg_of(scene(picture))


def svg_of(of: Scene) -> str:
    """An image as an SVG document. Clauses: TOOL-PICTURE-12, TOOL-OPERATORS-3."""
    return document(_root(of))


def number(value: float) -> str:
    """With two digits after the point, and none that say nothing."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _root(of: Scene) -> Element:
    width, height = number(of.width), number(of.height)
    styles = {
        item.style.name: item.style
        for group in of.groups
        for item in group.items
        if not isinstance(item, Words)
    }
    return Element(
        "svg",
        (
            ("xmlns", "http://www.w3.org/2000/svg"),
            ("version", "1.1"),
            ("width", width),
            ("height", height),
            ("viewBox", f"0 0 {width} {height}"),
            ("role", "img"),
        ),
        (
            Element("title", (), (of.title,)),
            Element("style", (), ("\n" + "".join(_rules(styles)),)),
            Element("rect", (("width", "100%"), ("height", "100%"), ("fill", "#ffffff"))),
            *(_group(group) for group in of.groups),
        ),
    )


def _rules(styles: dict[str, Style]) -> Iterator[str]:
    """A rule of CSS for each style; class names are the styles' with `_` for other characters."""
    yield f"text{{font-family:{FONT}}}\n.m{{text-anchor:middle}}\n.b{{font-weight:bold}}\n"
    yield "line{stroke-linecap:round}\npolygon{stroke-linejoin:round}\n"
    for name in sorted(styles):
        style = styles[name]
        stroke = f"stroke:{style.stroke};stroke-width:{number(style.width)}" if style.stroke else ""
        dash = "stroke-dasharray:" + ",".join(map(number, style.dash)) if style.dash else ""
        butt = "stroke-linecap:butt" if style.dash else ""
        parts = (f"fill:{style.fill or 'none'}", stroke, dash, butt)
        yield f".{_class(name)}{{{';'.join(part for part in parts if part)}}}\n"


def _class(name: str) -> str:
    return "s-" + name.replace(".", "_")


def _group(group: Group) -> Element:
    return Element("g", (("id", group.name),), tuple(map(_element, group.items)))


def _element(item: Item) -> Element:
    match item:
        case Polygon(points, style, kind, title):
            at = " ".join(f"{number(x)},{number(y)}" for x, y in points)
            return Element("polygon", (_classes(kind, style), ("points", at)), _title(title))
        case Disc((x, y), radius, style, kind, title):
            circle = ("cx", number(x)), ("cy", number(y)), ("r", number(radius))
            return Element("circle", (_classes(kind, style), *circle), _title(title))
        case Line(((x1, y1), (x2, y2)), style, kind):
            ends = zip(("x1", "y1", "x2", "y2"), map(number, (x1, y1, x2, y2)), strict=True)
            return Element("line", (_classes(kind, style), *ends))
        case Words((x, y), text, size, colour, centred, bold):
            kinds = " ".join([*(["m"] if centred else []), *(["b"] if bold else [])])
            return Element(
                "text",
                (
                    *((("class", kinds),) if kinds else ()),
                    ("x", number(x)),
                    ("y", number(y + 0.36 * size)),
                    ("font-size", number(size)),
                    ("fill", colour),
                ),
                (text,),
            )
        case _:
            assert_never(item)


def _classes(kind: str, style: Style) -> tuple[str, str]:
    return "class", f"{kind} {_class(style.name)}"


def _title(title: str) -> tuple[Element, ...]:
    return (Element("title", (), (title,)),) if title else ()
