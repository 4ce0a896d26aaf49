"""Both builds give the same bits: how that is compared, and some meshes."""

import ast
import os
import subprocess
import sys
from random import Random

import pytest

from clers.complexes.corner_table import face_list
from clers.complexes.topology import components
from clers.edgebreaker.encode import encode
from clers.kernels import COMPILED, HERE
from clers.oracle.builds import damaged, first_difference, of_meshes, random_mesh, spoilt


def run(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "clers", "bench", "builds", *words],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
    )


def test_the_builds_agree() -> None:
    """TOOL-BUILD-6: where there is machine code, it gives what the sources give."""
    ended = run("--count", "12", "--seed", "7", "--meshes")
    if COMPILED:
        assert ended.stdout == "12 alike: 12 random meshes, seed 7, and 0 vectors\n", ended.stderr
        assert ended.returncode == 0
    else:
        assert (ended.returncode, ended.stdout) == (4, "")


def test_nothing_is_compared_with_itself() -> None:
    """Clause: TOOL-BUILD-6."""
    ended = run("--meshes", CLERS_KERNELS="interpreted")
    assert (ended.returncode, ended.stdout) == (4, "")
    assert "nothing to compare" in ended.stderr


def test_a_build_says_the_same_again() -> None:
    """TOOL-BUILD-6: in another process, whose kernels are interpreted."""
    ended = run("--count", "3", "--seed", "5", "--meshes", "--say", CLERS_KERNELS="interpreted")
    here = [f"{name} {said}" for name, said in of_meshes(3, 5)]
    assert ended.stdout.splitlines() == here
    assert [row.split()[0] for row in here] == ["mesh-5-0", "mesh-5-1", "mesh-5-2"]
    assert len({row.split()[1] for row in here}) == 3


@pytest.mark.parametrize(
    ("theirs", "found"),
    [
        ([("a", "1"), ("b", "2")], (2, "")),
        ([("a", "1"), ("b", "3")], (1, "b")),
        ([("a", "1"), ("c", "2")], (1, "b")),
        ([("a", "1")], (1, "b")),
        ([], (0, "a")),
        ([("a", "1"), ("b", "2"), ("c", "3")], (2, "c")),
    ],
)
def test_the_first_difference_is_named(
    theirs: list[tuple[str, str]], found: tuple[int, str]
) -> None:
    """Clause: TOOL-BUILD-6."""
    assert first_difference([("a", "1"), ("b", "2")], theirs) == found


def test_the_meshes_are_of_every_kind() -> None:
    """TOOL-BUILD-6: any genus, with and without curves, one component and several."""
    parts = [components(random_mesh(Random(k))) for k in range(60)]
    kinds = {
        (len(of) > 1, any(part.genus for part in of), any(part.curves for part in of))
        for of in parts
    }
    assert len(kinds) == 8


def test_what_is_damaged_is_another() -> None:
    """TOOL-BUILD-6: streams and face lists that are mostly refused."""
    mesh = random_mesh(Random(1))
    stream, faces = encode(mesh).stream, face_list(mesh)
    first, *others = damaged(stream, Random(2))
    assert first == stream
    assert len(others) == 3
    spoiled = list(spoilt(faces, Random(2)))
    assert [len(of.faces) - len(faces.faces) for of in spoiled] == [-1, 0, 0]
    assert all(of != faces for of in spoiled)


def shifted_literals(source: str) -> list[str]:
    """Literals below 2^31 that a source shifts by a variable, named or not."""
    tree = ast.parse(source)
    named = {
        node.target.id: int(ast.literal_eval(node.value))
        for node in tree.body
        if isinstance(node, ast.AnnAssign)
        and isinstance(node.target, ast.Name)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, int)
    }

    def literal(node: ast.expr) -> int | None:
        match node:
            case ast.Constant(value=int() as value):
                return value
            case ast.Name(id=name):
                return named.get(name)
            case _:
                return None

    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.LShift | ast.RShift):
            shifted = literal(node.left)
            if shifted is not None and shifted < 1 << 31 and literal(node.right) is None:
                found.append(ast.unparse(node))
    return found


def test_no_literal_is_shifted_by_a_variable() -> None:
    """TOOL-BUILD-6: machine code would do that in 32 bits."""
    source = "ONE: F = 1\nALL: F = 0xFFFF_FFFF\na = 1 << n\nb = n << 1\nc = 1 << ONE\nd = ONE >> n"
    assert shifted_literals(f"{source}\ne = ALL >> n") == ["1 << n", "ONE >> n"]
    for path in HERE.glob("*.py"):
        assert shifted_literals(path.read_text("utf-8")) == [], path.name
