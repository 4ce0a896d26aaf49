"""Which nodes of a module are changed at all, and what surrounds each. Clause: TOOL-MUTATION-2."""

import ast
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

Function = ast.FunctionDef | ast.AsyncFunctionDef

TYPES: Final = frozenset(
    {"tuple", "list", "dict", "set", "frozenset", "type", "Callable", "Final", "Iterator"}
)
"""What stands before the brackets of a type, where it stands in an expression."""

UNREAD: Final = frozenset({"cast", "TypeVar", "NewType", "ParamSpec", "assert_never"})
"""Calls for the type checker."""

DECLARATIONS: Final = frozenset({"Law", "Given"})
"""Calls that say what something is called and of which clause it is."""

SPECIAL: Final = ("TYPE_CHECKING", "__name__")
"""Conditions that say how a module is used."""

NAMES: Final = frozenset({"__all__", "__slots__"})


@dataclass(frozen=True, slots=True)
class Around:
    """What surrounds a node: the lines of its statement, its function, its class."""

    first: int = 1
    last: int = 1
    function: Function | None = None
    within: ast.ClassDef | None = None


def walk(tree: ast.Module) -> Iterator[tuple[ast.AST, Around]]:
    """Each node that may be changed, with what surrounds it; outer nodes before inner ones."""
    waiting: list[tuple[ast.AST, Around]] = [(node, Around()) for node in tree.body]
    while waiting:
        node, around = waiting.pop()
        if isinstance(node, ast.If) and ast.unparse(node.test).startswith(SPECIAL):
            continue
        if isinstance(node, ast.stmt):
            around = replace(around, first=node.lineno, last=_last(node))
        yield node, around
        match node:
            case ast.FunctionDef() | ast.AsyncFunctionDef():
                around = replace(around, function=node, within=None)
            case ast.ClassDef():
                around = replace(around, within=node)
            case ast.Lambda():
                around = replace(around, function=None)
            case _:
                pass
        waiting.extend((part, around) for part in _parts(node, around))


def _last(node: ast.stmt) -> int:
    """The last line of a statement, or of its head."""
    match node:
        case ast.Match(subject=subject):
            return subject.end_lineno or subject.lineno
        case (
            ast.FunctionDef(body=body)
            | ast.AsyncFunctionDef(body=body)
            | ast.ClassDef(body=body)
            | ast.If(body=body)
            | ast.For(body=body)
            | ast.While(body=body)
            | ast.With(body=body)
            | ast.Try(body=body)
        ):
            return max(node.lineno, body[0].lineno - 1)
        case _:
            return node.end_lineno or node.lineno


def _parts(node: ast.AST, around: Around) -> Sequence[ast.AST]:
    """The parts of a node that may be changed: no annotations, aliases, decorators, claims."""
    match node:
        case ast.FunctionDef(args=args, body=body) | ast.AsyncFunctionDef(args=args, body=body):
            return [*_defaults(args), *body]
        case ast.ClassDef(body=body):
            return body
        case ast.Lambda(args=args, body=inner):
            return [*_defaults(args), inner]
        case ast.AnnAssign(target=target, annotation=annotation, value=value):
            alias = ast.unparse(annotation).endswith("TypeAlias")
            return [] if value is None or alias or _named(target) else [value]
        case ast.Assign(targets=targets, value=value):
            outer = around.function is None and around.within is None
            if any(map(_named, targets)) or (outer and _is_type(value)):
                return []
            return [*targets, value]
        case ast.Assert() | ast.Raise() | ast.JoinedStr() | ast.Import() | ast.ImportFrom():
            return []
        case ast.Subscript(value=ast.Name(id=name)) if name in TYPES:
            return []
        case ast.Call():
            return _call(node)
        case ast.MatchClass(patterns=patterns, kwd_patterns=by_name):
            return [*patterns, *by_name]
        case _:
            return list(ast.iter_child_nodes(node))


def _call(node: ast.Call) -> Sequence[ast.AST]:
    keywords = [keyword.value for keyword in node.keywords if keyword.arg != "strict"]
    match node.func:
        case ast.Name(id=name) if name in UNREAD:
            return []
        case ast.Name(id=name) if name in DECLARATIONS:
            return [arg for arg in node.args if isinstance(arg, ast.Lambda | ast.Call)]
        case ast.Name(id="isinstance" | "issubclass"):
            return node.args[:1]
        case _:
            return [node.func, *node.args, *keywords]


def _defaults(args: ast.arguments) -> list[ast.AST]:
    return [*args.defaults, *(default for default in args.kw_defaults if default is not None)]


def _named(target: ast.expr) -> bool:
    return isinstance(target, ast.Name) and target.id in NAMES


def _is_type(value: ast.expr) -> bool:
    """Does a value at the outermost level look like a type? `A | B`, `tuple[int, ...]`, `A`."""
    match value:
        case ast.BinOp(op=ast.BitOr()):
            return True
        case ast.Subscript(value=ast.Name(id=name)):
            return name in TYPES
        case _:
            return False
