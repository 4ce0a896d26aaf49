"""Formulas as MathML: what is set, how functions are spaced, what cannot be set."""

import pytest

from clers.site.mathematics import NotUnderstood, mathml, spaced, spoken


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        (r"T \log n", r"T \,\log\, n"),
        (r"\log_2 φ", r"\log_2\, φ"),
        (r"\log_{10} n", r"\log_{10}\, n"),
        (r"n\ln 2 + \ln 3", r"n\,\ln\, 2 + \ln\, 3"),
        (r"\min(p, q)", r"\min(p, q)"),
        (r"= \min \left( p \right)", r"= \min \left( p \right)"),
        (r"\sigma \log \frac12", r"\sigma \,\log\, \frac12"),
        (r"\le \log x", r"\le \log\, x"),
        (r"\log", r"\log"),
        (r"\log_", r"\log_"),
        (r"\log_{2", r"\log_{2"),
    ],
)
def test_thin_spaces_are_where_tex_sets_them(tex: str, expected: str) -> None:
    """TOOL-SITE-6."""
    assert spaced(tex) == expected


def test_words_are_one_element_each() -> None:
    """TOOL-SITE-6: letters of their own would be factors."""
    html = mathml(r"\mathit{low} + \mathrm{lk}\,A")
    assert '<mi class="word">low</mi>' in html
    assert '<mi class="upright">lk</mi>' in html


def test_signs_are_operators() -> None:
    """TOOL-SITE-6: a minus sign written as such has the space of one, as a hyphen has."""
    assert mathml("a − b").replace("a − b", "a - b") == mathml("a - b")
    assert "<mo>" in mathml("A → B")


def test_the_formula_as_written_goes_along() -> None:
    """TOOL-SITE-6."""
    assert 'alttext="a &lt; b"' in mathml("a < b")
    assert 'display="block"' in mathml("a", display=True)


@pytest.mark.parametrize("tex", [r"\nosuchcommand x", r"a_{b", r"\frac{1}", "a^b^c", r"\left( x"])
def test_what_cannot_be_set_is_said(tex: str) -> None:
    """TOOL-SITE-8: it is never shown as something else."""
    with pytest.raises(NotUnderstood):
        mathml(tex)


def test_a_formula_in_a_title() -> None:
    assert spoken(r"T/2 - \chi") == "T/2−χ"
    assert spoken(r"\nosuchcommand") == r"\nosuchcommand"
