"""The HTML report. Clauses: ORCL-HTML-1 … ORCL-HTML-5."""

import re
from html.parser import HTMLParser
from itertools import pairwise
from typing import Final

import msgspec
import pytest
from reported import BAD, DECODE, HOSTILE, RULINGS, classified, mirrored, numbered, report, ruled
from typing_extensions import override

from clers.conformance.cases.case import FaultForm
from clers.conformance.messages import Rejection
from clers.conformance.outcome import Answered, Declined
from clers.conformance.payloads import Faces
from clers.conventions.reason import Fault
from clers.oracle.reports.grouped import grouped
from clers.oracle.reports.html import OF_A_KIND, PICTURES, figures, html
from clers.oracle.reports.prose import prose

VOID: Final = frozenset(("meta",))
APART: Final = frozenset(("dt", "dd", "th", "td"))
"""Elements that a reader sees apart from each other."""


class Outline(HTMLParser):
    """A page as a tree is walked: tags with attributes, what is closed wrongly, and the text."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.wrong: list[str] = []
        self.tags: list[tuple[str, dict[str, str]]] = []
        self.text: list[str] = []
        self.within: list[tuple[str, str]] = []
        self.feed(page)
        self.close()

    @override
    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, {name: value or "" for name, value in attrs}))
        if tag not in VOID:
            self.open.append(tag)

    @override
    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, {name: value or "" for name, value in attrs}))

    @override
    def handle_endtag(self, tag: str) -> None:
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)
        if tag in APART:
            self.text.append(" ")

    @override
    def handle_data(self, data: str) -> None:
        if "style" not in self.open:
            self.text.append(data)
        if self.open:
            self.within.append((self.open[-1], data))


PAGE: Final = html(report())
SEEN: Final = Outline(PAGE)


def test_equal_runs_have_equal_reports() -> None:
    """Clause: ORCL-HTML-1."""
    assert html(report()) == PAGE


def test_every_element_is_closed_where_it_was_opened() -> None:
    """Clause: ORCL-HTML-3."""
    assert PAGE.startswith("<!DOCTYPE html>\n")
    assert (SEEN.open, SEEN.wrong) == ([], [])


def test_ids_are_there_once_and_what_refers_to_them_finds_them() -> None:
    """Clause: ORCL-HTML-3."""
    ids = [attributes["id"] for _, attributes in SEEN.tags if "id" in attributes]
    assert len(ids) == len(set(ids))
    named = [a["aria-labelledby"] for _, a in SEEN.tags if "aria-labelledby" in a]
    linked = [a["href"] for _, a in SEEN.tags if "href" in a]
    assert named
    assert len(linked) == 3
    assert set(named) <= set(ids)
    assert {link.removeprefix("#") for link in linked} <= set(ids)


def test_nothing_is_loaded_and_nothing_runs() -> None:
    """Clause: ORCL-HTML-3."""
    tags = {tag for tag, _ in SEEN.tags}
    assert not tags & {"script", "link", "img", "iframe", "object", "embed", "base", "form"}
    attributes = [name for _, found in SEEN.tags for name in found]
    assert not [name for name in attributes if name.startswith("on") or name in ("src", "style")]
    places = re.findall(r"https?://[^\s\"']+", PAGE)
    assert set(places) == {"http://www.w3.org/2000/svg"}
    assert "url(" not in PAGE
    assert "@import" not in PAGE


def test_light_dark_narrow_and_paper() -> None:
    """Clause: ORCL-HTML-3."""
    for medium in ("prefers-color-scheme: dark", "max-width: 34rem", "@media print"):
        assert medium in PAGE
    assert ("meta", {"name": "viewport", "content": "width=device-width, initial-scale=1"}) in (
        SEEN.tags
    )


def test_headings_are_in_order() -> None:
    """Clause: ORCL-HTML-3."""
    levels = [int(tag[1]) for tag, _ in SEEN.tags if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_tables_have_heads() -> None:
    """Clause: ORCL-HTML-3."""
    tags = [tag for tag, _ in SEEN.tags]
    assert tags.count("table") == tags.count("caption") == tags.count("thead") == 4
    assert all("scope" in attributes for tag, attributes in SEEN.tags if tag == "th")


def test_pictures_have_texts_in_their_place() -> None:
    """Clauses: ORCL-HTML-3, ORCL-HTML-4."""
    drawn = [attributes for tag, attributes in SEEN.tags if tag == "svg"]
    assert len(drawn) == OF_A_KIND
    assert all(attributes["role"] == "img" for attributes in drawn)
    titles = [text for tag, text in SEEN.within if tag == "title" and text.startswith("The surf")]
    assert titles[0] == "The surface of turned-0-aaaaaaaa at face 2, made by symbol 1 (R)"
    assert len(titles) == OF_A_KIND
    captions = [text for tag, text in SEEN.within if tag == "figcaption"]
    assert captions == titles


def test_no_class_of_one_picture_is_one_of_another() -> None:
    """Clause: ORCL-HTML-3."""
    styles = re.findall(r"<svg.*?</svg>", PAGE, re.DOTALL)
    classes = [set(re.findall(r"^\.(s-[^{]+)\{", style, re.MULTILINE)) for style in styles]
    assert all(classes)
    for k, one in enumerate(classes):
        for other in classes[k + 1 :]:
            assert not one & other


def _said(page: str) -> str:
    return " ".join("".join(Outline(page).text).split())


@pytest.mark.parametrize(
    "text",
    [
        f"{HOSTILE} against the suite abcdefgh",
        "24 of 26 cases failed, 1 of 26 skipped.",
        "handles yes, boundaries one, components no, at most 10 faces and 20 symbols",
        "policy: ties <b>",
        "components is not declared 1",
        "word.decode fail face fail 22",
        "word.decode fail face (22)",
        "turned-0-aaaaaaaa operation word.decode, profile core, fail first divergence face 2, "
        "made by symbol 1 (R) expected (0, 3, 1) got (0, 1, 3) EB-ORDER-1 Vertices v are "
        "numbered so, by <i>order</i>, see there. EB-WORD-1 the text is not at hand "
        "flag mirrored: right for left <b>; it matters flag deaf more clers explain "
        "turned-0-aaaaaaaa -a",
        "2 more of this signature",
        "turned-21-aaaaaaaa core face 2",
        "why crash: exit code -11",
    ],
)
def test_what_is_said(text: str) -> None:
    """Clauses: ORCL-HTML-2, ORCL-HTML-5."""
    assert text in _said(PAGE)


def test_profiles_and_statuses() -> None:
    """Clause: ORCL-HTML-2."""
    assert '<tr><th scope="row">handles</th><td class="zero">0</td>' not in PAGE
    assert (
        '<tr><th scope="row">handles</th><td>3</td><td class="zero">0</td><td>1</td><td>1</td>'
        "<td>1</td></tr>"
    ) in PAGE


def test_a_run_without_failures() -> None:
    """Clause: ORCL-HTML-2."""
    page = html(report(RULINGS[:1]))
    assert '<p class="verdict good">' in page
    assert "Failures" not in page
    assert "Skipped" not in page
    assert '<p class="verdict bad">' in html(report(RULINGS[:1], "interrupted"))
    assert '<p class="verdict bad">' in PAGE


def test_pictures_are_few() -> None:
    """Clause: ORCL-HTML-4."""
    kinds = (*mirrored("turned", 9), *classified(9))
    found = report(kinds)
    ids = [f"turned-{k}-aaaaaaaa" for k in range(5)] + [f"counted-{k}-aaaaaaaa" for k in range(5)]
    assert list(figures(found, grouped(found))) == ids


def test_pictures_are_fifty_at_most() -> None:
    """Clause: ORCL-HTML-4."""
    rulings = []
    for k, ruling in enumerate(mirrored("turned", 60)):
        judged = msgspec.structs.replace(ruling.judged, signature=f"kind {'x' * (k // 3)}")
        rulings.append(type(ruling)(ruling.profile, ruling.case, judged))
    found = report(tuple(rulings))
    assert len(figures(found, grouped(found))) == PICTURES


def test_a_large_surface_has_no_picture() -> None:
    """Clause: ORCL-HTML-4: a fan of 201 faces, and one of 200."""

    def fan(faces: int) -> int:
        word = "C" * (faces // 2 - 1) + "R" * (faces // 2 - 1) + "E"
        given = msgspec.Raw(
            b'{"word":"%b","handles":[],"components_with_boundary":0}' % word.encode()
        )
        case = msgspec.structs.replace(
            numbered(DECODE, "fan"),
            input=given,
            ok=msgspec.Raw(msgspec.json.encode(Faces(faces=((0, 1, 2),) * faces, vertices=9))),
        )
        found = report((ruled(case, Answered(Faces(faces=((1, 2, 0),), vertices=9))),))
        return len(figures(found, grouped(found)))

    assert (fan(200), fan(202)) == (1, 0)


def test_a_fault_is_pictured_at_its_parent() -> None:
    """Clauses: ORCL-HTML-4, ORCL-EXPLAIN-5: if the parent was asked too."""
    parent = numbered(DECODE, "parent")
    case = msgspec.structs.replace(
        numbered(BAD, "fault"), fault=FaultForm(kind="k", parent=parent.id, undo=())
    )
    wrong = ruled(case, Declined(Rejection(Fault.MALFORMED)))
    with_parent = report((ruled(parent, Answered(Faces(faces=(), vertices=0))), wrong))
    assert case.id in figures(with_parent, grouped(with_parent))
    alone = report((wrong,))
    assert figures(alone, grouped(alone)) == {}


@pytest.mark.parametrize(
    ("text", "markup"),
    [
        ("plain $x_1$ text", "<p>plain <code>x_1</code> text</p>\n"),
        ("a [link](b.md#c) and `code`", "<p>a link and <code>code</code></p>\n"),
        ("<script>x</script>", "<p>&lt;script&gt;x&lt;/script&gt;</p>\n"),
        ("![seen](there.png)", "<p></p>\n"),
        ("*so* $5\n6$", "<p><em>so</em> $5\n6$</p>\n"),
    ],
)
def test_clauses_as_markup(text: str, markup: str) -> None:
    """Clauses: ORCL-HTML-2, ORCL-HTML-3."""
    assert prose(text) == markup


def test_tables_of_clauses() -> None:
    """Clause: ORCL-HTML-2."""
    assert "<table>" in prose("| a | b |\n|---|---|\n| 1 | 2 |")
