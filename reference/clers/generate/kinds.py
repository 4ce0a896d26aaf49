"""Tables of operators to draw from, each made of two integers, some of which need one or none."""

from collections.abc import Callable
from random import Random
from typing import Final

from clers.operators.script import (
    AddEar,
    AddHandle,
    AddTetrahedron,
    Bridge,
    CloseCurve,
    CutEdge,
    FillCorner,
    FlipEdge,
    JoinComponents,
    OpenCurve,
    Operator,
    Relabel,
    RemoveFace,
    RemoveStar,
    Script,
    SplitEdge,
    SplitFace,
)

Kind = Callable[[int, int], Operator]

GROW: Final[tuple[Kind, ...]] = (
    lambda i, _: SplitFace(i),
    lambda i, _: FlipEdge(i),
    lambda i, _: FlipEdge(i),
    lambda i, _: SplitEdge(i),
)

ACT: Final[tuple[Kind, ...]] = (
    *GROW,
    lambda i, _: AddEar(i),
    lambda i, _: FillCorner(i),
    lambda i, _: FillCorner(i),
    lambda i, _: RemoveFace(i),
    lambda i, _: RemoveStar(i),
    lambda i, _: OpenCurve(i),
    lambda i, _: CloseCurve(i),
    lambda i, _: CutEdge(i),
    lambda i, _: CutEdge(i),
    Bridge,
    Bridge,
    AddHandle,
    JoinComponents,
)

EVERY: Final[tuple[Kind, ...]] = (
    *ACT,
    lambda i, _: Relabel(i),
    lambda _, __: AddTetrahedron(),
    lambda i, _: AddEar(i),  # more of what works at borders: it seldom meets what it needs
    lambda i, _: AddEar(i),
    lambda i, _: RemoveFace(i),
    lambda i, _: OpenCurve(i),
    Bridge,
    Bridge,
)


def random_script(seed: int, size: int) -> Script:
    """A script of `size` operators, most of them refining; the same for the same seed.

    Only `Random.random` is used: its sequence is the same in every Python. Running it takes time
    proportional to size², as every step looks at the whole mesh.
    """
    draw = Random(seed).random
    tables = (GROW, GROW, EVERY)
    script: list[Operator] = []
    for _ in range(size):
        table = tables[int(draw() * len(tables))]
        kind = table[int(draw() * len(table))]
        script.append(kind(int(draw() * 10**9), int(draw() * 10**9)))
    return tuple(script)
