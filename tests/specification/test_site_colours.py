"""The colours of the site can be told apart, by the rule of WCAG 2.2, 1.4.3."""

import re
from importlib.resources import files
from typing import Final

import pytest

STYLE: Final = files("clers.site").joinpath("assets", "style.css").read_text(encoding="utf-8")
COLOUR: Final = re.compile(r"--([a-z]+): (#[0-9a-f]{6});")
INKS: Final = ("ink", "soft", "link", "keyword", "string", "comment", "number", "name")
PAPERS: Final = ("paper", "raised", "clause")


def schemes() -> dict[str, dict[str, str]]:
    """The colours by name, light and dark."""
    light, dark = re.findall(r":root \{(.*?)\}", STYLE, re.DOTALL)[:2]
    return {"light": dict(COLOUR.findall(light)), "dark": dict(COLOUR.findall(dark))}


def luminance(colour: str) -> float:
    """Relative luminance of `#rrggbb`."""
    parts = (int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5))
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_the_rule_itself() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("paper", PAPERS)
@pytest.mark.parametrize("ink", INKS)
def test_contrast(scheme: str, paper: str, ink: str) -> None:
    """Clause: TOOL-SITE-9."""
    colours = schemes()[scheme]
    assert contrast(colours[ink], colours[paper]) >= 4.5


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_what_the_search_marks(scheme: str) -> None:
    """Clause: TOOL-SITE-9."""
    assert "mark { background: var(--mark); color: var(--ink);" in STYLE
    colours = schemes()[scheme]
    assert contrast(colours["ink"], colours["mark"]) >= 4.5


def test_both_schemes_follow_the_reader() -> None:
    """Clause: TOOL-SITE-10."""
    found = schemes()
    assert found["light"].keys() == found["dark"].keys()
    assert "@media (prefers-color-scheme: dark)" in STYLE
