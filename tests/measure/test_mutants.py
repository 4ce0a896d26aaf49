"""Mutants of small sources, each list written by hand."""

import ast
import warnings
from pathlib import Path

import pytest

import clers
from clers.conventions.clause import Clause
from clers.measure.mutation.mutant import Mutant, difference, mutated
from clers.measure.mutation.mutants import mutants
from clers.measure.mutation.vocabulary import next_member, vocabulary

WORDS = {"Colour": ("RED_DARK", "RED_LIGHT", "BLUE"), "One": ("ONLY",)}


def sources(source: str) -> set[str]:
    found = [mutated(source, mutant) for mutant in mutants(source, WORDS)]
    assert len(set(found)) == len(found), "none twice"
    return set(found)


CHANGES = [
    ("a < b", {"a <= b", "a >= b"}),
    ("a <= b", {"a < b", "a > b"}),
    ("a > b", {"a >= b", "a <= b"}),
    ("a >= b", {"a > b", "a < b"}),
    ("a == b", {"a != b"}),
    ("a != b", {"a == b"}),
    ("a in b", {"a not in b"}),
    ("a not  in b", {"a in b"}),
    ("a is b", {"a is not b"}),
    ("a is not b", {"a is b"}),
    ("a < b < c", {"a <= b < c", "a >= b < c", "a < b <= c", "a < b >= c"}),
    ("(a) < (\n b)", {"(a) <= (\n b)", "(a) >= (\n b)"}),
    ("(a\n < b)", {"(a\n <= b)", "(a\n >= b)"}),
    ("(a\n\n   < b)", {"(a\n\n   <= b)", "(a\n\n   >= b)"}),
    ("φ < b", {"φ <= b", "φ >= b"}),
    ("(a\nin b)", {"(a\nnot in b)"}),
    ("a + b", {"a - b"}),
    ("a - b", {"a + b"}),
    ("a * b", {"a + b"}),
    ("a / b", {"a * b"}),
    ("a // b", {"a * b"}),
    ("a % b", {"a // b"}),
    ("a ** b", {"a * b"}),
    ("a << b", {"a >> b"}),
    ("a >> b", {"a << b"}),
    ("a & b", {"a | b"}),
    ("f(a | b)", {"f(a & b)"}),
    ("a ^ b", {"a | b"}),
    ("'x' + b", set()),
    ("a @ b", set()),
    ("a and b", {"a or b", "(b)", "(a)"}),
    ("a or (b and c)", {
        "a and (b and c)", "((b and c))", "(a)", "a or (b or c)", "a or ((c))", "a or ((b))",
    }),
    ("a or b or c", {
        "a and b or c", "a or b and c", "(b or c)", "(a or c)", "(a or b)",
    }),
    ("not a", {"a"}),
    ("not (a, b)", {"((a, b))"}),
    ("-a", {"a"}),
    ("~a", {"a"}),
    ("f(5)", {"f(6)", "f(4)"}),
    ("f(0)", {"f(1)", "f((-1))"}),
    ("f(0.5)", {"f(1.5)", "f((-0.5))"}),
    ("f(True)", {"f(False)"}),
    ("f('text', None)", {"f((None), ('text'))"}),
    ("Colour.RED_DARK", {"Colour.RED_LIGHT"}),
    ("Colour.RED_LIGHT", {"Colour.RED_DARK"}),
    ("Colour.BLUE", {"Colour.RED_DARK"}),
    ("One.ONLY", set()),
    ("Colour.NONE", set()),
    ("f(a, b, c)", {"f(b, a, c)", "f(a, c, b)"}),
    ("f(a, a)", set()),
    ("f(*a, b)", set()),
    ("f(a, b, *c)", {"f(b, a, *c)"}),
    ("f((a for a in b), c)", {"f(c, ((a for a in b)))"}),
    ("isinstance(f(True), B)", {"isinstance(f(False), B)"}),
    ("max(a, b)", {"min(a, b)"}),
    ("min(a, b)", {"max(a, b)"}),
    ("any(a)", {"all(a)"}),
    ("all(a)", {"any(a)"}),
    ("sorted(a)", {"list(a)"}),
    ("sorted(a, key=b)", set()),
    ("reversed(a)", {"list(a)"}),
    ("a.union(b)", {"a.intersection(b)"}),
    ("a.popleft()", {"a.pop()"}),
    ("a if b else c", {"a if (not b) else c"}),
    ("a if b < c else d", {"a if b <= c else d", "a if b >= c else d"}),
    ("a[b:]", {"a[:]", "a[b + 1:]", "a[b - 1:]"}),
    ("a[:2]", {"a[:]", "a[:3]", "a[:1]"}),
    ("[a for a in b if c(a)]", {
        "[a for a in b if (not c(a))]", "[a for a in b if True]",
    }),
    ("[a for a in b if a < c]", {
        "[a for a in b if a <= c]", "[a for a in b if a >= c]", "[a for a in b if True]",
    }),
    ("lambda a=2: a", {"lambda a=3: a", "lambda a=1: a"}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), CHANGES)
def test_each_change_of_an_expression(text: str, expected: set[str]) -> None:
    """Clause: TOOL-MUTATION-1."""
    assert sources(f"x = y({text})") == {f"x = y({new})" for new in expected}


STATEMENTS = [
    ("if a:\n    b = c", {"if (not a):\n    b = c"}),
    ("while a:\n    break", {"while (not a):\n    break", "while a:\n    continue"}),
    ("for a in b:\n    continue", {"for a in ():\n    continue", "for a in b:\n    break"}),
    ("a += b", {"a -= b", "pass"}),
    ("a //= b", {"a *= b", "pass"}),
    ("a[b] = c", {"pass"}),
    ("a.b = c", {"pass"}),
    ("a = b", set()),
    ("a()", {"pass"}),
    ("del a", {"pass"}),
    ("match a:\n    case b if c:\n        d = e", {
        "match a:\n    case b if (not c):\n        d = e",
        "match a:\n    case b if True:\n        d = e",
    }),
    ("match a:\n    case 2:\n        b = c", {
        "match a:\n    case 3:\n        b = c", "match a:\n    case 1:\n        b = c",
    }),
    ("match a:\n    case Colour.BLUE:\n        b = c", {
        "match a:\n    case Colour.RED_DARK:\n        b = c",
    }),
    ("match a:\n    case A(Colour.BLUE, b=Colour.RED_DARK):\n        b = c", {
        "match a:\n    case A(Colour.RED_DARK, b=Colour.RED_DARK):\n        b = c",
        "match a:\n    case A(Colour.BLUE, b=Colour.RED_LIGHT):\n        b = c",
    }),
    ("class A:\n    b = c | d", {"class A:\n    b = c & d"}),
    ("def f():\n    b = c | d", {"def f():\n    b = c & d"}),
    ("def f(a=True): b = a", {"def f(a=False): b = a"}),
    ("def f(*, a=True): b = a", {"def f(*, a=False): b = a"}),
    ("def f(a):\n    b = a\n    b = c", {"def f(a):\n    b = a\n    pass"}),
    ("def f(a):\n    a = c", {"def f(a):\n    pass"}),
    ("def f():\n    yield a", {"def f():\n    pass"}),
    ("class A:\n    b: int = 2", {"class A:\n    b: int = 3", "class A:\n    b: int = 1"}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), STATEMENTS)
def test_each_change_of_a_statement(text: str, expected: set[str]) -> None:
    """Clause: TOOL-MUTATION-1."""
    assert sources(text) == expected


RETURNS = [
    ("bool", {"True", "False"}),
    ("int", {"0"}),
    ("str", {'""'}),
    ("bytes", {'b""'}),
    ("A | None", {"None"}),
    ("tuple[int, ...]", {"()"}),
    ("Sequence[A]", {"()"}),
    ("list[A]", {"[]"}),
    ("dict[A, B]", {"{}"}),
    ("set[A] | None", {"set()", "None"}),
    ("frozenset[A]", {"frozenset()"}),
    ("A", set()),
]


@pytest.mark.parametrize(("kind", "expected"), RETURNS)
def test_another_value_of_the_declared_type(kind: str, expected: set[str]) -> None:
    """Clause: TOOL-MUTATION-1."""
    head = f"def f() -> {kind}:\n    return "
    assert sources(f"{head}a") == {head + new for new in expected}
    for same in expected:
        assert sources(head + same) >= {head + other for other in expected - {same}}


UNCHANGED = [
    '"""A docstring with 1."""',
    "def f():\n    'text 1'",
    "class A:\n    'text 1'",
    "from a import b",
    "__all__ = [a + b]",
    "class A:\n    __slots__ = (a + b,)",
    "A: TypeAlias = B | C",
    "A = B | C",
    "A = tuple[1, 2]",
    "A: Final[Literal[1]] = b",
    "A: typing.TypeAlias = B | C",
    "class A:\n    __slots__: Final = (a + b,)",
    "A = NewType('A', int)",
    "x = tuple[1, 2]()",
    "@f(1, slots=True)\nclass A(B[1]):\n    b: C[1]",
    "def f(a: A[1]) -> B[1]:\n    b: C[1] = a",
    "assert a < b",
    "raise A(1)",
    "x = f'{a + 1}'",
    "x = zip(a, strict=True)",
    "def f():\n    assert_never(a)",
    "x = isinstance(a, B | C)",
    "x = gcd(a, b)",
    "x = Law('name', Colour.BLUE, 'statement', a, b)",
    "if TYPE_CHECKING:\n    a = 1",
    "if __name__ == '__main__':\n    main()",
]


@pytest.mark.parametrize("text", UNCHANGED)
def test_what_is_left_as_it_is(text: str) -> None:
    """Clause: TOOL-MUTATION-2."""
    assert mutants(text, WORDS) == ()


def test_the_function_within_a_law_is_changed() -> None:
    """Clause: TOOL-MUTATION-2."""
    law = "x = Law('a', Colour.BLUE, 'b', c, lambda d: d < e)"
    assert sources(law) == {law.replace("<", "<="), law.replace("<", ">=")}


def test_place_lines_and_difference_of_one() -> None:
    """Clause: TOOL-MUTATION-5."""
    source = "def f(a):\n    if (a\n            < b):  # φ\n        return 1\n"
    found = next(m for m in mutants(source) if m.after == "<=")
    assert found == Mutant(3, 12, 3, 13, "comparison", "<", "<=", 2, 3)
    assert found.place == "3:13"
    assert difference(source, found) == "-             < b):  # φ\n+             <= b):  # φ"
    gone = "a[0] = (\n    b\n)\nc = d\n"
    change = next(m for m in mutants(gone) if m.kind == "deletion")
    assert mutated(gone, change) == "pass\nc = d\n"
    assert difference(gone, change) == "- a[0] = (\n-     b\n- )\n+ pass"
    assert (change.first, change.last) == (1, 3)


def test_heads_end_where_bodies_begin() -> None:
    """Clause: TOOL-MUTATION-3."""
    match = "match f(\n    1\n):\n    case 2:\n"
    source = f"{match}        if (\n            a < 3\n        ):\n            b()\n"
    lines = {(m.line, m.first, m.last) for m in mutants(source)}
    assert lines == {(2, 1, 3), (4, 1, 3), (6, 5, 7), (8, 8, 8)}


def test_every_mutant_of_a_module_compiles_and_differs() -> None:
    """By place, none twice, and none the source itself. Clause: TOOL-MUTATION-1."""
    folder = Path(clers.__file__).parent
    words = vocabulary(folder)
    for name in ("complexes/matching.py", "arithmetic/coder.py"):
        source = (folder / name).read_text(encoding="utf-8")
        found = mutants(source, words)
        new = [mutated(source, mutant) for mutant in found]
        assert len(set(new) | {source}) == len(new) + 1
        assert list(found) == sorted(found)
        assert all(isinstance(ast.parse(text), ast.Module) for text in new)
        assert {m.kind for m in found} >= {"comparison", "arithmetic", "constant"}


def test_what_compiles_with_a_warning_compiles(recwarn: pytest.WarningsRecorder) -> None:
    """Clause: TOOL-MUTATION-1."""
    warnings.simplefilter("error")
    assert sources("x = a is 'b'") == {"x = a is not 'b'"}
    assert not recwarn.list


def test_members_are_read_from_sources(tmp_path: Path) -> None:
    """Clause: TOOL-MUTATION-1."""
    (tmp_path / "within").mkdir()
    (tmp_path / "within" / "colours.py").write_text(
        "class A(str, enum.Enum):\n    _x = 1\n    B = 2\n    C = D = 3\n    e.f = 4\n\n"
        "class G:\n    H = 1\n\nclass I(IntFlag):\n    J = 1\n"
    )
    assert vocabulary(tmp_path) == {"A": ("B", "C", "D"), "I": ("J",)}


def test_clauses_become_clauses_of_their_chapter() -> None:
    """Clause: TOOL-MUTATION-1."""
    words = vocabulary(Path(clers.__file__).parent)
    assert words["Clause"] == tuple(clause.name for clause in Clause)
    assert next_member(words["Clause"], "CONV_CLAUSE_1") == "CONV_CLAUSE_2"
    last = [clause.name for clause in Clause if clause.name.startswith("CONV_")][-1]
    assert next_member(words["Clause"], last) == "CONV_CLAUSE_1"
