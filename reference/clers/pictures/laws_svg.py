"""Laws of what is written."""

from collections import Counter
from typing import Final
from xml.etree import ElementTree

from clers.complexes.given import SMALL_SURFACES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Fails, Verdict
from clers.pictures.options import Options
from clers.pictures.palette import Letter
from clers.pictures.picture import State
from clers.pictures.shown import flat_picture, shapes_of
from clers.pictures.svg import to_svg

SVG: Final = "{http://www.w3.org/2000/svg}"

KINDS: Final = {*Letter, State.BLANK}


def svg_has_the_faces(surface: Surface) -> Verdict:
    """Read by another hand, the document has a group for each panel, with its faces and titles.

    Drawn anew, the picture has the same text.
    """
    options = Options(steps=(0, surface.faces // 2, surface.faces), tree=True)
    picture, again = flat_picture(surface, options), flat_picture(surface, options)
    if isinstance(picture, Fails):
        return picture
    if isinstance(again, Fails):
        return again
    text = to_svg(picture)
    root = ElementTree.fromstring(text)
    groups = {group.get("id"): group for group in root.iter(f"{SVG}g")}
    verdicts: list[Verdict] = [same(f"{SVG}svg", root.tag), same(text, to_svg(again))]
    for panel in picture.panels:
        expected = Counter(
            (
                "blank" if shape.state is State.BLANK else shape.visit.letter.value,
                f"step {shape.visit.step}: {shape.visit.letter}",
            )
            for shape in shapes_of(panel)
        )
        got = Counter(
            (kind, element.findtext(f"{SVG}title", "").split(",")[0])
            for element in groups[f"step-{panel.step}"]
            if (kind := element.get("class", "").split(" ")[0]) in KINDS
        )
        verdicts.append(same(expected, got))
    return every(*verdicts)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "svg-has-the-faces",
        Clause.TOOL_PICTURE_12,
        "the document is well formed, always the same, and has each face once with its title",
        SMALL_SURFACES,
        svg_has_the_faces,
    ),
)
