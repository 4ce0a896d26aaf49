"""What is put in the place of an expression. Clause: TOOL-MUTATION-1."""

import ast
from collections.abc import Iterator, Mapping
from typing import Final

from clers.measure.mutation.text import Place, Text, whole
from clers.measure.mutation.vocabulary import Vocabulary, next_member
from clers.measure.mutation.walk import DECLARATIONS, UNREAD

Change = tuple[Place, str, str]
"""Where, the kind, what is put there."""

COMPARISONS: Final[Mapping[type[ast.cmpop], tuple[str, tuple[str, ...]]]] = {
    ast.Lt: ("<", ("<=", ">=")),
    ast.LtE: ("<=", ("<", ">")),
    ast.Gt: (">", (">=", "<=")),
    ast.GtE: (">=", (">", "<")),
    ast.Eq: ("==", ("!=",)),
    ast.NotEq: ("!=", ("==",)),
    ast.In: ("in", ("not in",)),
    ast.NotIn: ("not in", ("in",)),
    ast.Is: ("is", ("is not",)),
    ast.IsNot: ("is not", ("is",)),
}
ARITHMETIC: Final[Mapping[type[ast.operator], tuple[str, str]]] = {
    ast.Add: ("+", "-"),
    ast.Sub: ("-", "+"),
    ast.Mult: ("*", "+"),
    ast.Div: ("/", "*"),
    ast.FloorDiv: ("//", "*"),
    ast.Mod: ("%", "//"),
    ast.Pow: ("**", "*"),
    ast.LShift: ("<<", ">>"),
    ast.RShift: (">>", "<<"),
    ast.BitAnd: ("&", "|"),
    ast.BitOr: ("|", "&"),
    ast.BitXor: ("^", "|"),
}
CALLS: Final[Mapping[str, str]] = {
    "min": "max",
    "max": "min",
    "any": "all",
    "all": "any",
    "sorted": "list",
    "reversed": "list",
    "union": "intersection",
    "intersection": "union",
    "difference": "intersection",
    "symmetric_difference": "union",
    "add": "discard",
    "discard": "add",
    "popleft": "pop",
    "appendleft": "append",
    "startswith": "endswith",
    "endswith": "startswith",
}
SYMMETRIC: Final = frozenset({"min", "max", "gcd", "isinstance", "issubclass"})
"""Calls whose arguments can be swapped without effect, or never are."""


def expression(node: ast.expr, text: Text, words: Vocabulary) -> Iterator[Change]:
    """The changes of one expression, not of the expressions within it."""
    match node:
        case ast.Compare(left=left, ops=ops, comparators=others):
            for a, op, b in zip((left, *others), ops, others, strict=False):
                sign, instead = COMPARISONS[type(op)]
                place = text.token(whole(a), whole(b), sign)
                yield from () if place is None else ((place, "comparison", x) for x in instead)
        case ast.BinOp(left=left, op=operator, right=right):
            sign, other = ARITHMETIC.get(type(operator), ("@", "@"))
            place = text.token(whole(left), whole(right), sign)
            if place is not None and not _is_texts(left, right):
                yield place, "arithmetic", other
        case ast.BoolOp():
            yield from _boolean(node, text)
        case ast.UnaryOp(op=ast.Not() | ast.USub() | ast.Invert(), operand=operand):
            yield whole(node), "sign", text.within(operand)
        case ast.Constant(value=bool() as flag):
            yield whole(node), "constant", str(not flag)
        case ast.Constant(value=int() | float() as number):
            yield whole(node), "constant", f"{number + 1}"
            yield whole(node), "constant", f"{number - 1}" if number >= 1 else f"({number - 1})"
        case ast.Attribute(value=ast.Name(id=name), attr=member) if name in words:
            other_member = next_member(words[name], member)
            if other_member is not None:
                yield whole(node), "member", f"{name}.{other_member}"
        case ast.Call():
            yield from _call(node, text)
        case ast.IfExp(test=test):
            yield from condition(test, text)
        case ast.Subscript(slice=ast.Slice() as cut):
            yield from _slice(cut, text)
        case _:
            pass


def condition(test: ast.expr, text: Text) -> Iterator[Change]:
    """A condition negated. One comparison alone is negated as a comparison is changed."""
    if not (isinstance(test, ast.Compare) and len(test.ops) == 1):
        yield whole(test), "condition", f"(not {text.within(test)})"


def always(test: ast.expr) -> Iterator[Change]:
    """A condition left out."""
    yield whole(test), "condition", "True"


def _boolean(node: ast.BoolOp, text: Text) -> Iterator[Change]:
    sign, other = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
    for a, b in zip(node.values, node.values[1:], strict=False):
        place = text.token(whole(a), whole(b), sign)
        if place is not None:
            yield place, "boolean", other
    for left_out in range(len(node.values)):
        rest = [text.within(v) for i, v in enumerate(node.values) if i != left_out]
        yield whole(node), "operand", f"({f' {sign} '.join(rest)})"


def _call(node: ast.Call, text: Text) -> Iterator[Change]:
    match node.func:
        case ast.Name(id=name) as func if name in CALLS:
            if not (name in {"sorted", "reversed"} and node.keywords):
                yield whole(func), "call", CALLS[name]
        case ast.Attribute(attr=name, value=owner) as func if name in CALLS:
            yield whole(func), "call", f"{text.within(owner)}.{CALLS[name]}"
        case _:
            pass
    if isinstance(node.func, ast.Name) and node.func.id in SYMMETRIC | UNREAD | DECLARATIONS:
        return
    for a, b in zip(node.args, node.args[1:], strict=False):
        (line, column, _, _), (_, _, end_line, end_column) = whole(a), whole(b)
        swapped = f"{text.within(b)}, {text.within(a)}"
        if text.of(a) != text.of(b):
            yield (line, column, end_line, end_column), "arguments", swapped


def _slice(cut: ast.Slice, text: Text) -> Iterator[Change]:
    for bound in (cut.lower, cut.upper):
        if bound is None:
            continue
        yield whole(bound), "slice", ""
        if not isinstance(bound, ast.Constant | ast.UnaryOp):
            yield whole(bound), "slice", f"{text.within(bound)} + 1"
            yield whole(bound), "slice", f"{text.within(bound)} - 1"


def _is_texts(*nodes: ast.expr) -> bool:
    """Is one of these a text? Then `+` joins, and nothing else can stand there."""
    return any(
        isinstance(node, ast.JoinedStr)
        or (isinstance(node, ast.Constant) and isinstance(node.value, str | bytes))
        for node in nodes
    )
