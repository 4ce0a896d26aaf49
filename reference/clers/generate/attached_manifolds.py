"""Manifolds of dimension 1 to 3 that grow by attachments, and what may be glued to them."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.known import KNOWN
from clers.complexes.simplicial import Complex, Simplex, boundary, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.operators.attachments.apply import NOTHING, apply, run
from clers.operators.attachments.attachment import attachment, in_order
from clers.operators.attachments.examples import SPHERE_TIMES_CIRCLE, upright
from clers.operators.attachments.given import Gluable, SolidStep
from clers.operators.attachments.operator import Handle
from clers.operators.attachments.solid import handle, prism

CHOICES: Final = st.integers(0, 10**6)
"""Every number is a choice: the candidates are taken modulo their number."""


def _starts(n: int) -> tuple[Complex, ...]:
    """A simplex, and known manifolds of few simplices; closed ones without one of them."""
    found = [closure([range(n + 1)])]
    for known in KNOWN:
        if known.manifold and known.dimension == n and len(known.facets) <= 16:
            top = of_dimension(known.complex, n)
            closed = known.boundary is not None and sum(known.boundary) == 0
            found.append(closure(top[closed:]))
    return tuple(found)


SIDES: Final = ((0, 1, 3), (0, 2, 3), (1, 2, 3))
"""The frontier of a tetrahedron without the triangle 0, 1, 2."""

SHELL: Final = closure(s for f in ((0, 1, 2), *SIDES) for t in (0, 1) for s in upright(f, t))
"""A sphere times an arc: two boundary surfaces."""

_TORUS: Final = closure(s for t in range(3) for s in upright((0, 1, 2), t))

_STARTS: Final[Mapping[int, tuple[Complex, ...]]] = {
    1: _starts(1),
    2: _starts(2),
    3: (*_starts(3), SHELL, _TORUS),
}


def manifolds(n: int, steps: int = 10) -> st.SearchStrategy[Complex]:
    """A manifold of dimension n, 1 to 3, after some steps; it may have several components."""
    starts = st.sampled_from((*[_STARTS[n][0]] * len(_STARTS[n]), *_STARTS[n]))
    return st.builds(_grown, starts, st.lists(CHOICES, max_size=steps))


def _grown(k: Complex, choices: list[int]) -> Complex:
    for choice in choices:
        result = apply(_operator(k, choice), k)
        k = result.value if isinstance(result, Accepted) else k
    return k


def _operator(k: Complex, choice: int) -> Handle:
    """A facet of the boundary with a new or an old vertex, a prism, or a new component."""
    n = dimension(k)
    kind, choice = choice % 12, choice // 12
    walls = of_dimension(boundary(k), n - 1)
    if kind == 11 or not walls:
        return Handle(attachment(k, range(_new(k), _new(k) + n + 1)))
    if kind > 7:
        near, choice = walls[choice % len(walls)], choice // len(walls)
        apart = [w for w in walls if not any(_joined(k, v, near) for v in w)] or walls
        return handle(k, prism(in_order(near), in_order(apart[choice % len(apart)])))
    return Handle(attachment(k, _beside(k, walls, choice)))


def _beside(k: Complex, walls: tuple[Simplex, ...], choice: int) -> Simplex:
    wall, choice = walls[choice % len(walls)], choice // len(walls)
    at_boundary = [min(v) for v in of_dimension(boundary(k), 0)]
    ends = [v for v in (_new(k), *at_boundary) if v not in wall]
    return wall | {ends[choice % len(ends)]}


def _joined(k: Complex, v: int, wall: Simplex) -> bool:
    return any(frozenset([v, u]) in k.simplices for u in wall)


def _new(k: Complex) -> int:
    return 1 + max(v for s in k.simplices for v in s)


@st.composite
def at_manifolds(draw: st.DrawFn) -> Gluable:
    """A manifold and a simplex glued to it: at its boundary, or anywhere."""
    n = draw(st.sampled_from((1, 2, 2, 3, 3, 3)))
    k = draw(manifolds(n))
    walls = of_dimension(boundary(k), n - 1)
    anywhere = draw(st.booleans())
    if len(walls) > 0 and not anywhere:
        return Gluable(k, attachment(k, _beside(k, walls, draw(CHOICES))))
    pool = [*(min(v) for v in of_dimension(k, 0)), *range(_new(k), _new(k) + n + 1)]
    return Gluable(k, attachment(k, [pool.pop(draw(CHOICES) % len(pool)) for _ in range(n + 1)]))


@st.composite
def handle_steps(draw: st.DrawFn, n: int) -> SolidStep:
    """A manifold and any handle that a step of its growth might be."""
    k = draw(manifolds(n))
    return SolidStep(k, _operator(k, draw(CHOICES)))


def _golden() -> tuple[SolidStep, ...]:
    """The handles of the script of S² × S¹, each with the manifold before it."""
    before = [NOTHING, *(r.value for r in run(SPHERE_TIMES_CIRCLE) if isinstance(r, Accepted))]
    return tuple(
        SolidStep(k, step)
        for k, step in zip(before, SPHERE_TIMES_CIRCLE, strict=False)
        if isinstance(step, Handle)
    )


def _through() -> SolidStep:
    """S² × S¹ on four levels without three prisms over each other, and the middle one of them.

    Without the three the boundary is a sphere; the 2-handle splits it.
    """
    tunnel = [upright((0, 1, 2), t, 4) for t in range(4)]
    others = [upright(face, t, 4) for face in SIDES for t in range(4)]
    k = closure(s for part in (tunnel[3], *others) for s in part)
    return SolidStep(k, handle(k, tunnel[1]))


def solid_steps() -> st.SearchStrategy[SolidStep]:
    """3-manifolds with handles of every index."""
    rare = st.sampled_from((*_golden(), _through()))
    return st.one_of(handle_steps(3), handle_steps(3), rare)


AT_MANIFOLDS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "attachments-to-manifolds": at_manifolds(),
    "solid-handles": solid_steps(),
}
"""The domains of this module, by name; `attachments` hands them on."""
