"""Scripts that build balls, spheres, the solid torus and S² × S¹. Clause: OPER-SOLID-6."""

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import Final

from clers.complexes.simplicial import Complex
from clers.conventions.result import Accepted
from clers.operators.attachments.apply import NOTHING, apply
from clers.operators.attachments.attachment import Vertices, attachment, maximal
from clers.operators.attachments.operator import Attach, BoundaryAttach, Handle, Operator, Script
from clers.operators.attachments.solid import handle, prism


def build(k: Complex) -> Script:
    """The maximal simplices of a complex, one after another. Clause: OPER-ATTACH-7."""
    there = NOTHING
    script: list[Operator] = []
    for simplex in maximal(k):
        step = Attach(attachment(there, simplex))
        script.append(step)
        there = _after(step, there) or there
    return tuple(script)


def sphere(n: int) -> Script:
    """The frontier of the (n+1)-simplex: a 0-handle, n Euler attachments, an n-handle; n ≥ 1.

    Clause: OPER-SOLID-6.
    """
    return from_simplices([facet] for facet in combinations(range(n + 2), n + 1))


def from_simplices(groups: Iterable[Iterable[Vertices]]) -> Script:
    """The simplices in order as manifold Euler attachments where they are, else as handles.

    A handle is one simplex where this leaves a manifold, else all the rest of its group. Simplices
    with which none of it applies are left out. Clause: OPER-SOLID-6.
    """
    k = NOTHING
    script: list[Operator] = []
    for group in groups:
        rest = [*group]
        while rest:
            step, after, used = next(_choices(k, rest), (None, k, 1))
            script += [step] if step is not None else []
            k, rest = after, rest[used:]
    return tuple(script)


def _choices(k: Complex, rest: list[Vertices]) -> Iterator[tuple[Operator, Complex, int]]:
    glued = attachment(k, rest[0])
    ways: tuple[tuple[Operator, int], ...] = (
        (BoundaryAttach(glued), 1),
        (Handle(glued), 1),
        (handle(k, tuple(rest)), len(rest)),
    )
    for step, used in ways:
        after = _after(step, k)
        if after is not None:
            yield step, after, used


def _after(step: Operator, k: Complex) -> Complex | None:
    result = apply(step, k)
    return result.value if isinstance(result, Accepted) else None


def times_circle(triangles: Iterable[Vertices], levels: int = 3) -> Script:
    """A surface on the vertices 0 … 3 times a circle, a prism after another. Clause: OPER-SOLID-6.

    There are at least three levels.
    """
    return from_simplices(upright(face, t, levels) for face in triangles for t in range(levels))


def upright(face: Vertices, t: int, levels: int = 3) -> tuple[Vertices, ...]:
    """The prism on a triangle from level t to the next; vertex v at level t is number 4 t + v."""
    up = (t + 1) % levels
    return prism(tuple(4 * t + v for v in face), tuple(4 * up + v for v in face))


BALL: Final[Script] = from_simplices([[(0, 1, 2, 3)]])
THREE_SPHERE: Final[Script] = sphere(3)
SOLID_TORUS: Final[Script] = times_circle([(0, 1, 2)])
SPHERE_TIMES_CIRCLE: Final[Script] = times_circle(combinations(range(4), 3))
