"""The search, run as it stands: what it finds, and in which order."""

import json
import shutil
import subprocess
from importlib.resources import files
from typing import Final

import pytest

from clers.site.entries import Entry, Kind, entries_of, script

ENTRIES: Final = (
    Entry(Kind.CLAUSE, "TOY-WORD-1", "Chapter 5", "e#1", "A word is a string over C, L, E, R, S."),
    Entry(Kind.CLAUSE, "TOY-WORD-10", "Chapter 5", "e#10", "Café, “quoted”\u2028and more."),
    Entry(Kind.CLAUSE, "BOX-NAME-1", "Chapter 6", "c#1", "The names; see TOY-WORD-1 for a word."),
    Entry(Kind.LAW, "word-by-definition", "All laws", "l#w", "Encoding gives the string."),
    Entry(Kind.SECTION, "5.2 Words and streams", "Chapter 5", "e#s", "What a stream is."),
    Entry(Kind.SECTION, "Golden", "Chapter 6", "c#g", "Swords cost two bits; a word, too."),
)

ASK: Final = """
const fs = require("fs"), [search, entries, questions] = JSON.parse(fs.readFileSync(0, "utf8"));
const module_ = { exports: {} };
new Function("module", search)(module_);
const { find, excerpt } = module_.exports;
new Function(entries)();
console.log(JSON.stringify(questions.map((question) => find(globalThis.clersEntries, question)
  .map((entry) => [entry[1], excerpt(entry, question)[1]]))));
"""


def ask(*questions: str) -> list[list[tuple[str, str]]]:
    """Of each question the titles found, each with the word that is marked in its text."""
    node = shutil.which("node")
    assert node is not None, "the search is run with Node 20: the command `node` is not there"
    source = files("clers.site").joinpath("assets", "search.js").read_text(encoding="utf-8")
    given = json.dumps([source, script(ENTRIES).decode(), questions])
    done = subprocess.run(
        [node, "-e", ASK], input=given, capture_output=True, text=True, check=True
    )
    found: list[list[tuple[str, str]]] = json.loads(done.stdout)
    return [[(title, word) for title, word in answers] for answers in found]


QUESTIONS: Final[tuple[tuple[str, list[str]], ...]] = (
    ("TOY-WORD-1", ["TOY-WORD-1", "TOY-WORD-10", "BOX-NAME-1"]),
    ("toy-word-10", ["TOY-WORD-10"]),
    ("toy-w", ["TOY-WORD-1", "TOY-WORD-10", "BOX-NAME-1"]),
    ("  toy WORD ", ["TOY-WORD-1", "TOY-WORD-10", "BOX-NAME-1"]),
    (
        "word",
        [
            *("TOY-WORD-1", "TOY-WORD-10", "BOX-NAME-1"),
            *("word-by-definition", "5.2 Words and streams", "Golden"),
        ],
    ),
    ("golden", ["Golden"]),
    ("string", ["TOY-WORD-1", "word-by-definition"]),
    ("str wor", ["TOY-WORD-1", "word-by-definition", "5.2 Words and streams"]),
    ("tring", []),
    ("cafe", ["TOY-WORD-10"]),
    ("CAFÉ", ["TOY-WORD-10"]),
    ("quoted more", ["TOY-WORD-10"]),
    ("string golden", []),
    ("", []),
    (" – ", []),
)


def test_what_is_found_and_in_which_order() -> None:
    """Clause: TOOL-SITE-7."""
    found = ask(*(question for question, _ in QUESTIONS))
    titles = [[title for title, _ in answers] for answers in found]
    for (question, expected), got in zip(QUESTIONS, titles, strict=True):
        assert got == expected, question


@pytest.mark.parametrize(
    ("question", "word"), [("string", "string"), ("swo", "Swo"), ("wor", "wor"), ("golden", "")]
)
def test_the_word_that_is_marked(question: str, word: str) -> None:
    """Clause: TOOL-SITE-7."""
    assert ask(question)[0][-1][1] == word


def test_entries_are_a_script() -> None:
    """Clause: TOOL-SITE-7."""
    assert entries_of(script(ENTRIES)) == ENTRIES
    assert entries_of(script(())) == ()
