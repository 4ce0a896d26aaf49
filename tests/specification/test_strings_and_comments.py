"""Ids in strings and comments are found where the library's own lexer has them."""

import io
import tokenize
from pathlib import Path
from typing import Final

import pytest

from clers.specification.citation import Kind
from clers.specification.identifier import mentions
from clers.specification.python_sites import read_module

ROOT: Final = Path(__file__).parents[2]

SOURCES: Final = {
    "quotes within quotes": "a = 'x # TOY-RULE-1' # TOY-RULE-2\nb = \"it's TOY-RULE-3\"\n",
    "escapes": "a = 'x\\' # TOY-RULE-1'\nb = 'x\\\\' # TOY-RULE-2\n",
    "an escaped line end": "a = 'x\\\n TOY-RULE-1' # TOY-RULE-2\n",
    "three quotes": "a = '''x ' '' # TOY-RULE-1\nTOY-RULE-2\\'''' # TOY-RULE-3\n",
    "empty strings": 'a = \'\'  # TOY-RULE-1\nb = "" \'TOY-RULE-2\'\nc = """""" # TOY-RULE-3\n',
    "prefixes": "a = rb'TOY-RULE-1', Rb'\\' # TOY-RULE-2', f'{1}TOY-RULE-3'\n",
    "names before quotes": "a = 1 if'TOY-RULE-1'else'TOY-RULE-2' # TOY-RULE-3\n",
    "a comment with quotes": "# it's TOY-RULE-1\na = 1 # \"TOY-RULE-2\nb = 'TOY-RULE-3'\n",
    "neither": "TOY-RULE-1 # TOY-RULE-2\n",
}


def by_library(source: str) -> list[tuple[str, int]]:
    """Ids and lines by `tokenize`; strings with expressions in them are several tokens of it."""
    found, inside = list[tuple[str, int]](), {"STRING", "COMMENT", "FSTRING_MIDDLE"}
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if tokenize.tok_name[token.type] in inside:
            for mention in mentions(token.string):
                line = token.start[0] + token.string.count("\n", 0, mention.offset)
                found.append((mention.clause, line))
    return found


def said(path: str, source: str) -> list[tuple[str, int]]:
    """Ids and lines as the checks read them, but for members of the enumeration."""
    sites = read_module(path, source, Kind.TEST).citations
    members = "Clause." in source
    return [(site.clause, site.line) for site in sites if not members]


@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
def test_where_ids_stand(source: str) -> None:
    """Clause: CONV-CLAUSE-8."""
    assert by_library(source) != []
    assert said("x.py", source) == by_library(source)


def test_the_files_of_this_package() -> None:
    """Clause: CONV-CLAUSE-8."""
    files = sorted((ROOT / "reference" / "clers" / "specification").rglob("*.py"))
    texts = [(path, path.read_text(encoding="utf-8")) for path in files]
    plain = [(path, text) for path, text in texts if "Clause." not in text]
    assert len(plain) > 15
    for path, text in plain:
        assert said(str(path), text) == by_library(text), path


def test_docstrings_are_told_from_other_strings() -> None:
    """Clause: CONV-CLAUSE-2."""
    source = (
        '"""TOY-RULE-1."""\nX = "TOY-RULE-2"\n"""TOY-RULE-3,\nTOY-RULE-4."""\nf(\n  "TOY-RULE-5")\n'
    )
    found = read_module("x.py", source, Kind.CODE).citations
    assert [(site.clause, site.kind, site.line) for site in found] == [
        ("TOY-RULE-1", Kind.CODE, 1),
        ("TOY-RULE-2", Kind.PROSE, 2),
        ("TOY-RULE-3", Kind.CODE, 3),
        ("TOY-RULE-4", Kind.CODE, 4),
        ("TOY-RULE-5", Kind.PROSE, 6),
    ]
