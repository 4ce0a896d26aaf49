"""What is put in the place of a statement, or of one of its parts. Clause: TOOL-MUTATION-1."""

import ast
from collections.abc import Iterator, Mapping
from typing import Final

from clers.measure.mutation.expressions import ARITHMETIC, Change, always, condition
from clers.measure.mutation.text import Text, whole
from clers.measure.mutation.walk import Around

EMPTY: Final[Mapping[str, tuple[str, ...]]] = {
    "bool": ("True", "False"),
    "int": ("0",),
    "str": ('""',),
    "bytes": ('b""',),
    "tuple": ("()",),
    "Sequence": ("()",),
    "list": ("[]",),
    "dict": ("{}",),
    "set": ("set()",),
    "frozenset": ("frozenset()",),
    "None": ("None",),
}
"""By the head of a type the values put in place of one that is returned."""


def statement(node: ast.AST, text: Text, around: Around) -> Iterator[Change]:  # noqa: C901  (one case a form)
    """The changes of one statement, clause of a comprehension or case, not of what is within."""
    match node:
        case ast.If(test=test):
            yield from condition(test, text)
        case ast.While(test=test):
            yield from condition(test, text)
        case ast.comprehension(ifs=tests):
            for test in tests:
                yield from condition(test, text)
                yield from always(test)
        case ast.match_case(guard=ast.expr() as guard):
            yield from condition(guard, text)
            yield from always(guard)
        case ast.For(iter=over):
            yield whole(over), "loop", "()"
        case ast.Break():
            yield whole(node), "jump", "continue"
        case ast.Continue():
            yield whole(node), "jump", "break"
        case ast.Return(value=ast.expr() as value):
            yield from _return(value, text, around)
        case ast.AugAssign(target=target, op=operator, value=value):
            sign, other = ARITHMETIC.get(type(operator), ("@", "@"))
            place = text.token(whole(target), whole(value), f"{sign}=")
            if place is not None:
                yield place, "arithmetic", f"{other}="
            yield whole(node), "deletion", "pass"
        case ast.Expr(value=ast.Call() | ast.Yield() | ast.YieldFrom()):
            if not text.of(node).startswith("assert_never("):
                yield whole(node), "deletion", "pass"
        case ast.Delete():
            yield whole(node), "deletion", "pass"
        case ast.Assign(targets=[target]) if _again(target, node, around):
            yield whole(node), "deletion", "pass"
        case _:
            pass


def _return(value: ast.expr, text: Text, around: Around) -> Iterator[Change]:
    """Another value of the declared type, where its name tells one."""
    if around.function is None or around.function.returns is None:
        return
    heads = [t.strip().split("[")[0] for t in ast.unparse(around.function.returns).split("|")]
    for head in heads:
        for instead in EMPTY.get(head, ()):
            if text.of(value) != instead:
                yield whole(value), "return", instead


def _again(target: ast.expr, node: ast.Assign, around: Around) -> bool:
    """Does an assignment change what was there? Else its deletion leaves a name unbound."""
    match target:
        case ast.Subscript() | ast.Attribute():
            return True
        case ast.Name(id=name) if around.function is not None:
            return any(
                (isinstance(n, ast.arg) and n.arg == name)
                or (
                    isinstance(n, ast.Name)
                    and isinstance(n.ctx, ast.Store)
                    and n.id == name
                    and n.lineno < node.lineno
                )
                for n in ast.walk(around.function)
            )
        case _:
            return False
