"""SVG and PNG: well formed, complete, and the same every time."""

from collections import Counter
from io import BytesIO
from struct import unpack
from xml.etree import ElementTree

from matplotlib.image import imread
from pictured import globe, picture

from clers.edgebreaker.examples import ANNULUS, CUBE, TORUS
from clers.pictures.element import Element, document
from clers.pictures.options import Layout, Options
from clers.pictures.palette import COLOURS, channels
from clers.pictures.png import to_png
from clers.pictures.sheet import scene
from clers.pictures.svg import number, to_svg

SVG = "{http://www.w3.org/2000/svg}"


def test_text_is_escaped() -> None:
    """Read by another hand it is what was meant, as far as XML goes. Clause: TOOL-PICTURE-12."""
    meant = "a<b & \"c\" 'd' > \u2192 \U0001d54a ]]>"
    written = document(Element("x", (("y", meant),), (meant, Element("z"), "\x00\ud800\ufffe")))
    root = ElementTree.fromstring(written)
    assert root.get("y") == meant
    assert (root.text or "").strip() == meant
    assert (root[0].tail or "").strip() == "\ufffd" * 3


def test_numbers_are_short() -> None:
    """Clause: TOOL-PICTURE-12."""
    assert [number(x) for x in (0, -0.001, 1.5, 100, 2 / 3, -1e3)] == [
        "0", "0", "1.5", "100", "0.67", "-1000",
    ]  # fmt: skip


def test_titles_tell_the_step() -> None:
    """Clause: TOOL-PICTURE-12."""
    root = ElementTree.fromstring(to_svg(picture(CUBE)))
    titles = [title.text for title in root.iter(f"{SVG}title")]
    assert "step 3: C, face 2 = 143, gate 3 to 1" in titles
    assert "step 1: P, face 0 = 012" in titles


def test_captions_are_lettered() -> None:
    """As in Figure 14; where steps are left out, they are said. Clause: TOOL-PICTURE-2."""

    def words(options: Options) -> str:
        root = ElementTree.fromstring(to_svg(picture(CUBE, options)))
        return " ".join(text.text or "" for text in root.iter(f"{SVG}text"))

    assert "(d) 143 is created, 4 is marked: C" in words(Options())
    assert "(m) 567 is attached, the end: E" in words(Options())
    assert "(b) after 12: 567 is attached, the end: E" in words(Options(steps=(3, 12)))
    assert "after 3: 143 is created" in words(Options(steps=(3,)))
    assert "567 is attached" not in words(Options(steps=(12,)))


def test_legend_names_the_lines() -> None:
    """Those that are drawn and no others. Clause: TOOL-PICTURE-3."""

    def legend(shown: str) -> set[str]:
        root = ElementTree.fromstring(shown)
        (group,) = (g for g in root.iter(f"{SVG}g") if g.get("id") == "legend")
        return {text.text or "" for text in group.iter(f"{SVG}text")}

    letters = {"P 1", "C 6", "L 1", "E 3", "R 3", "S 2", "Sh 2"}
    cut = "cut: sides of one letter are one"
    assert legend(to_svg(picture(TORUS, Options(steps=(18,))))) == letters | {cut, "Morse edge"}
    tree = legend(to_svg(picture(ANNULUS, Options(steps=(1,), tree=True))))
    assert tree == {
        "L 2", "E 1", "R 2", "Sb 1", "next gate", "gate on the stack", "boundary curve, reached",
        "primal remainder",
    }  # fmt: skip


def test_nothing_is_loaded() -> None:
    """No address but the name of SVG. Clause: TOOL-PICTURE-12."""
    text = to_svg(picture(TORUS))
    assert text.count("http") == 1
    assert not {"script", "image", "use", "link"} & {
        element.tag.removeprefix(SVG) for element in ElementTree.fromstring(text).iter()
    }


def test_png_has_the_sides_of_the_scene() -> None:
    """And the same bytes twice. Clause: TOOL-PICTURE-13."""
    shown = picture(TORUS, Options(steps=(4, 18), tree=True))
    data = to_png(shown)
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = unpack(">II", data[16:24])
    of = scene(shown)
    assert abs(width - of.width) <= 1
    assert abs(height - of.height) <= 1
    assert to_png(shown) == data


def test_png_has_the_colours() -> None:
    """Each letter of the torus colours some hundred pixels; no face is black: TOOL-PICTURE-13."""
    shown = picture(TORUS, Options(steps=(18,), size=300))
    pixels = imread(BytesIO(to_png(shown)), format="png")
    found = Counter(
        map(tuple, (pixels[:, :, :3] * 255).round().astype(int).reshape(-1, 3).tolist())
    )
    for letter, _ in shown.counts:
        assert found[channels(COLOURS[letter])] > 300
    assert found[0, 0, 0] < 300


def test_every_kind_of_line_is_painted() -> None:
    """Clause: TOOL-PICTURE-13."""
    plain = to_png(picture(ANNULUS, Options(steps=(1, 6), size=60)))
    tree = to_png(picture(ANNULUS, Options(steps=(1, 6), size=60, tree=True)))
    ribbon = to_png(picture(ANNULUS, Options(steps=(1, 6), size=60, layout=Layout.RIBBON)))
    assert len({plain, tree, ribbon}) == 3


def test_large_mesh() -> None:
    """Fifty thousand faces: each once, no titles. Clause: TOOL-PICTURE-12."""
    of, at = globe(126, 200)
    assert of.faces == 50_000
    text = to_svg(picture(of, at=at))
    panel, _ = text.split('<g id="legend">')
    assert panel.count('<polygon class="') == of.faces
    assert text.count("<title>") == 1
    assert panel.count('class="P ') == 1
    assert panel.count('class="blank') == 0
