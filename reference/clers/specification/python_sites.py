"""Citations in Python source: comments, docstrings, other strings, and `Clause.X` attributes."""

import ast
import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from clers.specification.citation import Citation, Kind
from clers.specification.identifier import mentions, of_member

_DEFINITIONS: Final = (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
_LINE_END: Final = re.compile(r"\n")
_SAID: Final = re.compile(
    r"""(?:(?<!\w)[rbuf]{1,2})?
        (?:\"{3}(?:\\.|[^\\])*?\"{3}|'{3}(?:\\.|[^\\])*?'{3}
          |"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
      |\#[^\n]*""",
    re.DOTALL | re.IGNORECASE | re.VERBOSE,
)
"""Strings and comments of a source that parses; the library's lexer takes ten times as long, and
from Python 3.12 on it takes strings with expressions in them apart."""


@dataclass(frozen=True, slots=True)
class Span:
    """The lines (from 1, both included) of a definition or of a law in a tuple of laws."""

    first: int
    last: int
    name: str


@dataclass(frozen=True, slots=True)
class Rejection:
    """A call `Rejected(Reason.X, Clause.Y, …)`, with both as pages write them. CONV-RESULT-6."""

    reason: str
    clause: str
    line: int


@dataclass(frozen=True, slots=True)
class Module:
    """What one Python file says: whom it cites, the laws it writes out, why it does not parse.

    `imports` has each name that it imports, dotted, with its line, wherever in the file;
    `rejections` what code rejects, where reason and clause are both written out.
    """

    path: str
    citations: tuple[Citation, ...] = ()
    laws: tuple[Span, ...] = ()
    fault: tuple[int, str] | None = None
    imports: tuple[tuple[str, int], ...] = ()
    rejections: tuple[Rejection, ...] = ()


def read_module(path: str, source: str, kind: Kind) -> Module:
    """Read one file; `kind` is `CODE` or `TEST`. Clauses: CONV-CLAUSE-2, CONV-CLAUSE-8.

    Docstrings, comments and attributes `Clause.X` cite as the file does; other strings are prose.
    Where code writes laws out, the attributes are the laws', and all words are prose, for a law's
    words are no implementation. A string over several lines cites at the line where the id
    stands. A file that does not parse cites nothing, and says so in `fault`.
    """
    try:
        tree = ast.parse(source)
    except SyntaxError as error:
        return Module(path, fault=(error.lineno or 1, error.msg))
    nodes = tuple(_nodes(tree))
    calls = tuple(_law_calls(nodes)) if kind is Kind.CODE else ()
    said, named = (Kind.PROSE, Kind.LAW) if calls else (kind, kind)
    laws = tuple(call for call in calls if call.name)
    spans = (*laws, *_definitions(nodes))
    found = [
        *(
            (clause, said if documents else Kind.PROSE, line)
            for clause, line, documents in _said(source, _documents(nodes))
        ),
        *((clause, named, line) for clause, line in _named(nodes)),
    ]
    found.sort(key=lambda site: site[2])
    sites = (Citation(id_, as_, path, line, _innermost(spans, line)) for id_, as_, line in found)
    rejected = tuple(_rejections(nodes)) if kind is Kind.CODE else ()
    return Module(path, tuple(sites), laws, imports=tuple(_imports(nodes)), rejections=rejected)


def _nodes(tree: ast.AST) -> Iterator[tuple[ast.AST, str]]:
    """All nodes in the source's order, each with the dotted name of its definitions, own included.

    They are walked once, for the walk takes longer than all that is asked of the nodes.
    """
    waiting = [(tree, "")]
    while waiting:
        node, name = waiting.pop()
        if isinstance(node, _DEFINITIONS):
            name = f"{name}.{node.name}" if name else node.name
        yield node, name
        waiting += [(child, name) for child in ast.iter_child_nodes(node)][::-1]


def _imports(nodes: Iterable[tuple[ast.AST, str]]) -> Iterator[tuple[str, int]]:
    """What is imported, with lines; of `from a import b` it is `a.b`. None is relative."""
    for node, _ in nodes:
        if isinstance(node, ast.Import):
            yield from ((name.name, node.lineno) for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((f"{node.module}.{name.name}", node.lineno) for name in node.names)


def _rejections(nodes: Iterable[tuple[ast.AST, str]]) -> Iterator[Rejection]:
    """The calls that reject with a reason and a clause that are written out."""
    for node, _ in nodes:
        match node:
            case ast.Call(
                func=ast.Name("Rejected"),
                args=[
                    ast.Attribute(value=ast.Name("Reason"), attr=reason),
                    ast.Attribute(value=ast.Name("Clause"), attr=member),
                    *_,
                ],
            ):
                clause = of_member(member)
                if clause is not None:
                    yield Rejection(reason.lower().replace("_", "-"), clause, node.lineno)
            case _:
                pass


def _law_calls(nodes: Iterable[tuple[ast.AST, str]]) -> Iterator[Span]:
    """The calls `Law(name, …)`; the name is empty where it is computed."""
    for node, _ in nodes:
        match node:
            case ast.Call(func=ast.Name("Law"), args=[name, *_], end_lineno=int(last)):
                known = name.value if isinstance(name, ast.Constant) else ""
                yield Span(node.lineno, last, known if isinstance(known, str) else "")
            case _:
                pass


def _definitions(nodes: Iterable[tuple[ast.AST, str]]) -> Iterator[Span]:
    """Classes and functions with their dotted names."""
    for node, name in nodes:
        if isinstance(node, _DEFINITIONS):
            first = min([node.lineno, *(mark.lineno for mark in node.decorator_list)])
            yield Span(first, node.end_lineno or node.lineno, name)


def _innermost(spans: tuple[Span, ...], line: int) -> str:
    """The name of the shortest span around a line; empty outside all."""
    around = [span for span in spans if span.first <= line <= span.last]
    return min(around, key=lambda span: span.last - span.first).name if around else ""


def _documents(nodes: Iterable[tuple[ast.AST, str]]) -> frozenset[tuple[int, int]]:
    """Where docstrings begin (line, column): those of modules, definitions and constants."""
    return frozenset(
        (node.lineno, node.col_offset)
        for node, _ in nodes
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    )


def _said(source: str, documents: frozenset[tuple[int, int]]) -> Iterator[tuple[str, int, bool]]:
    """Ids in strings and comments, with their lines, and whether that is documentation."""
    starts = [0, *(end.end() for end in _LINE_END.finditer(source))]
    for found in _SAID.finditer(source):
        for mention in mentions(found[0]):
            begin = bisect_right(starts, found.start())
            documents_it = (
                found[0].startswith("#") or (begin, found.start() - starts[begin - 1]) in documents
            )
            line = bisect_right(starts, found.start() + mention.offset)
            yield mention.clause, line, documents_it


def _named(nodes: Iterable[tuple[ast.AST, str]]) -> Iterator[tuple[str, int]]:
    """Attributes `Clause.X` that have the form of an id, with their lines."""
    for node, _ in nodes:
        match node:
            case ast.Attribute(value=ast.Name("Clause"), attr=name, end_lineno=int(line)):
                clause = of_member(name)
                if clause is not None:
                    yield clause, line
            case _:
                pass
