"""Citations in Python source: comments, docstrings, other strings, and `Clause.X` attributes."""

import ast
import io
import tokenize
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from clers.specification.citation import Citation, Kind
from clers.specification.identifier import mentions, of_member

_DEFINITIONS: Final = (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


@dataclass(frozen=True, slots=True)
class Span:
    """The lines (from 1, both included) of a definition or of a law in a tuple of laws."""

    first: int
    last: int
    name: str


def _definitions(body: ast.AST, outer: str = "") -> Iterator[Span]:
    """Classes and functions with their dotted names; outer before inner."""
    waiting = [(body, outer)]
    while waiting:
        node, around = waiting.pop()
        name = around
        if isinstance(node, _DEFINITIONS):
            name = f"{around}.{node.name}" if around else node.name
            first = min([node.lineno, *(d.lineno for d in node.decorator_list)])
            yield Span(first, node.end_lineno or node.lineno, name)
        waiting += [(child, name) for child in ast.iter_child_nodes(node)]


def _laws(tree: ast.AST) -> Iterator[Span]:
    """The calls `Law("name", …)`, by the name of the law."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(
                func=ast.Name("Law"), args=[ast.Constant(str(name)), *_], end_lineno=int(last)
            ):
                yield Span(node.lineno, last, name)
            case _:
                pass


def _innermost(spans: tuple[Span, ...], line: int) -> str:
    around = [span for span in spans if span.first <= line <= span.last]
    return min(around, key=lambda span: span.last - span.first).name if around else ""


def citations(path: str, source: str, kind: Kind) -> tuple[Citation, ...]:
    """Every citation in one Python file; a file that does not parse has none.

    In files named `laws.py`, an attribute `Clause.X` is a law's; what the strings and comments
    there say is prose, for a law's words are no implementation. A string that goes over several
    lines cites at the line where the id stands. Clause: CONV-CLAUSE-2.
    """
    try:
        tree = ast.parse(source)
        tokens = tuple(tokenize.generate_tokens(io.StringIO(source).readline))
    except (SyntaxError, tokenize.TokenError):
        return ()
    laws_file = kind is Kind.CODE and path.endswith("laws.py")
    law_spans, spans = tuple(_laws(tree)), tuple(_definitions(tree))
    found: list[Citation] = []
    for token in tokens:
        if token.type in (tokenize.COMMENT, tokenize.STRING):
            for mention in mentions(token.string):
                line = token.start[0] + token.string.count("\n", 0, mention.offset)
                inside = _innermost(law_spans, line) or _innermost(spans, line)
                said = Kind.PROSE if laws_file else kind
                found.append(Citation(mention.clause, said, path, line, inside))
    for clause, line in _attributes(tokens):
        inside = _innermost(law_spans, line) or _innermost(spans, line)
        found.append(Citation(clause, Kind.LAW if laws_file else kind, path, line, inside))
    return tuple(sorted(found, key=lambda site: site.line))


def _attributes(tokens: tuple[tokenize.TokenInfo, ...]) -> Iterator[tuple[str, int]]:
    """`Clause.EB_WORD_1` as id and line."""
    dotted = tuple(token for token in tokens if token.type in (tokenize.NAME, tokenize.OP))
    for (before, dot), (_, name) in pairwise(pairwise(dotted)):
        if before.string == "Clause" and dot.string == ".":
            clause = of_member(name.string)
            if clause is not None:
                yield clause, name.start[0]


def law_names(source: str) -> tuple[tuple[str, int], ...]:
    """The laws a file writes out, each with its line."""
    try:
        return tuple((span.name, span.first) for span in _laws(ast.parse(source)))
    except SyntaxError:
        return ()
