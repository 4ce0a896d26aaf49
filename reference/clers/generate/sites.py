"""Small sites with one thing broken, texts with ids, source files. Clause: CONV-LAW-2."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from hypothesis import strategies as st

from clers.site.entries import Entry, Kind, script
from clers.site.laws import BREAKS, MENTIONING, SOURCES, Break, Mentioning, Source
from clers.site.places import ENTRIES
from clers.site.sound import Site

_IDS: Final = ("EB-WORD-1", "EB-WORD-2", "CODE-NAME-4", "CONV-LAW-3")
_PLAIN: Final = ("word ", "EB-WORD", "-EB-WORD-1", "EB-WORD-1-", " &lt; ", "\n", "1 ", "EB_WORD")
_OPAQUE: Final = (
    '<a href="x">{}</a>',
    '<math><mi alttext="{}">{}</mi></math>',
    "<svg><text>{}</text></svg>",
    '<a href="x"><code>{}</code> and {}</a>',
)
_OPEN: Final = ("{}", "<code>{}</code>", "<abbr>{}</abbr>", "<td>{}</td>", "Clause.{}")


@st.composite
def _mentioning(draw: st.DrawFn) -> Mentioning:
    """Pieces with a space between: text, an id that counts, or one within a link or a formula."""
    known = draw(st.frozensets(st.sampled_from(_IDS)))
    pieces, mentions = list[str](), 0
    for _ in range(draw(st.integers(0, 6))):
        id_ = draw(st.sampled_from(_IDS))
        match draw(st.integers(0, 2)):
            case 0:
                pieces.append(draw(st.sampled_from(_PLAIN)))
            case 1:
                pieces.append(draw(st.sampled_from(_OPAQUE)).replace("{}", id_))
            case _:
                frame = draw(st.sampled_from(_OPEN))
                of_code = frame.startswith("Clause")
                pieces.append(frame.format(id_.replace("-", "_") if of_code else id_))
                mentions += id_ in known
    return Mentioning(" ".join(pieces), known, mentions)


_SCRAPS: Final = (
    *('"', "'", '"""', "'''", "#", "\\", "\n", " ", "x", "é", "<", "&", "1"),
    *("def", "if ", "r'", 'f"', "EB-WORD-1", "Clause.EB_WORD_1", "# EB-WORD-1", '"EB-WORD-1"'),
)
_SOURCE: Final = st.builds(
    Source,
    st.sampled_from(("reference/x.py", "proofs/x.v", "x.json")),
    st.lists(st.sampled_from(_SCRAPS), max_size=12).map("".join),
)

_PAGE: Final = """<!DOCTYPE html>
<html lang="en">
<head><title>{name}</title></head>
<body>
<header>top</header>
<main>
<h1>{name}</h1>
<img src="dot.png" alt="a dot" />
<div id="{clause}">words</div>
<p id="end">See <a href="{other}#{far}">it</a>, <a href="#end">here</a>.</p>
</main>
</body>
</html>
"""


def _sound(count: int) -> Site:
    """So many pages, each with a clause, and each with a link to the next one's."""
    names = [f"page-{k}.html" for k in range(count)]
    ids = [f"TOY-RULE-{k + 1}" for k in range(count)]
    files = {
        name: _PAGE.format(
            name=name, clause=ids[k], other=names[(k + 1) % count], far=ids[(k + 1) % count]
        ).encode()
        for k, name in enumerate(names)
    }
    found = (
        Entry(Kind.CLAUSE, id_, "Toys", f"{name}#{id_}", "words")
        for id_, name in zip(ids, names, strict=True)
    )
    known = {**files, "dot.png": b"dot", ENTRIES: script(found)}
    return Site(known, dict(zip(ids, names, strict=True)))


_EDITS: Final[Mapping[str, tuple[str, str]]] = MappingProxyType(
    {
        "a link to no anchor": ('href="#end"', 'href="#nowhere"'),
        "a link to no file": ('href="#end"', 'href="gone.html"'),
        "a link out of the site": ('href="#end"', 'href="../x.html"'),
        "a picture that is not there": ("dot.png", "gone.png"),
        "a picture from elsewhere": ("dot.png", "https://x.test/d.png"),
        "a picture without words": (' alt="a dot"', ""),
        "an element that does not end": ("</div>", ""),
        "an element closed by itself": (">words</div>", " />"),
        "ends in the wrong order": ("</a>, <a", "</p><p></a>, <a"),
        "a bare ampersand": ("See", "See & hear"),
        "an attribute twice": ('<p id="end"', '<p id="a" id="end"'),
        "an id twice": ("<h1>", '<h1 id="end">'),
        "a link within a link": ("here<", '<b><a href="#end">x</a></b><'),
        "no language": (' lang="en"', ""),
        "no title": ("title>", "style>"),
        "two first headings": ("<h1>", "<h1>x</h1><h1>"),
        "no main part": ("main>", "div>"),
        "a field without a name": ("top", '<input type="search" />'),
    }
)


@st.composite
def _broken(draw: st.DrawFn) -> Break:
    """One edit of one page, or the anchor of its clause on another page too, or gone."""
    sound = _sound(draw(st.integers(2, 4)))
    clause, page = draw(st.sampled_from(sorted(sound.clauses.items())))
    what = draw(st.sampled_from((*sorted(_EDITS), "a clause gone", "a clause on two pages")))
    where, (old, new) = page, _EDITS.get(what, (f'<div id="{clause}"', "<div"))
    if what == "a clause on two pages":
        where = draw(st.sampled_from(sorted(set(sound.clauses.values()) - {page})))
        old, new = "<h1>", f'<h1 id="{clause}">'
    edited = sound.files[where].decode().replace(old, new)
    broken = {**sound.files, where: edited.encode()}
    return Break(sound, Site(broken, sound.clauses), what, page)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    MENTIONING.name: _mentioning(),
    SOURCES.name: _SOURCE,
    BREAKS.name: _broken(),
}
