"""Complexes and attachments that may apply to them; scripts of attachments from nothing."""

from collections.abc import Callable, Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.simplicial import Complex, Simplex, closure, star
from clers.conventions.result import Accepted
from clers.generate.attached_manifolds import AT_MANIFOLDS, handle_steps
from clers.operators.attachments.apply import NOTHING, apply
from clers.operators.attachments.attachment import Attachment, attachment, in_order, maximal
from clers.operators.attachments.given import (
    AnyScript,
    CurveStep,
    Gluable,
    OperatorStep,
    Unnamed,
)
from clers.operators.attachments.gluing import Gluing
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    Constructive,
    CurveOperator,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    EulerAttach,
    FirstVertex,
    Handle,
    Operator,
    Script,
    Undo,
)

NUMBERS: Final = st.integers(0, 7)
"""Few vertices, so that simplices meet."""

ON_ONE: Final[tuple[Callable[[Attachment], Constructive], ...]] = (
    Attach,
    EulerAttach,
    BoundaryAttach,
    Handle,
)
"""The operators that may be one attachment."""


def simplices(size: int = 5) -> st.SearchStrategy[tuple[int, ...]]:
    """A simplex on few vertices, in increasing order."""
    return st.sets(NUMBERS, min_size=1, max_size=size).map(in_order)


def complexes(size: int = 5, count: int = 6) -> st.SearchStrategy[Complex]:
    """A complex of few simplices, each of at most `size` vertices; it may be empty."""
    return st.lists(simplices(size), max_size=count).map(closure)


@st.composite
def gluable(draw: st.DrawFn) -> Gluable:
    """A complex and an attachment; most apply, some have a face too many or too few."""
    simplex = draw(simplices())
    faces = st.sets(st.sampled_from(simplex), min_size=1)
    k = closure([*draw(st.lists(simplices(), max_size=4)), *draw(st.lists(faces, max_size=5))])
    if draw(st.integers(0, 9)) < 9:
        k = Complex(k.simplices - star(k, frozenset(simplex)))
    glued = attachment(k, simplex)
    match draw(st.integers(0, 5)):
        case 4:
            glued = _along(glued, closure([*glued.along, draw(faces)]).simplices)
        case 5 if glued.along:
            gone = frozenset(draw(st.sampled_from(glued.along)))
            glued = _along(glued, closure(glued.along).simplices - {gone})
        case _:
            pass
    return Gluable(k, glued)


def _along(glued: Attachment, faces: frozenset[Simplex]) -> Attachment:
    frontier = Complex(faces - {frozenset(glued.simplex)})
    return Attachment(glued.simplex, maximal(frontier))


@st.composite
def gluings(draw: st.DrawFn) -> Unnamed:
    """A complex of dimension 2 at most and a gluing of a simplex of dimension 3 at most.

    One in a few is not well formed.
    """
    k = draw(complexes(3))
    corners = range(draw(st.integers(1, 4)))
    place = tuple(draw(st.sampled_from((-1, 0, 1, 2, 3))) for _ in corners)
    if draw(st.integers(0, 4)) > 0:
        place = tuple(v if frozenset([v]) in k.simplices else -1 for v in place)
    kept: set[Simplex] = {frozenset([i]) for i in corners if place[i] >= 0 and len(corners) > 1}
    for face in sorted(closure([corners]).simplices, key=lambda s: (len(s), in_order(s))):
        image = frozenset(place[i] for i in face)
        sound = len(image) == len(face) > 1 and image in k.simplices
        whole = len(face) < len(corners) and all(face - {i} in kept for i in face)
        if sound and whole and draw(st.booleans()):
            kept.add(face)
    if draw(st.integers(0, 9)) == 9:
        kept ^= {draw(st.sets(st.integers(0, 3), min_size=1).map(frozenset))}
    return Unnamed(k, Gluing(place, frozenset(kept)))


CURVE_OPERATORS: Final[st.SearchStrategy[CurveOperator]] = st.one_of(
    st.builds(FirstVertex, NUMBERS),
    st.builds(EdgeAndVertex, NUMBERS, NUMBERS),
    st.builds(EdgeBetweenEnds, NUMBERS, NUMBERS),
    st.builds(EdgeAtInterior, NUMBERS, NUMBERS),
)


@st.composite
def curve_steps(draw: st.DrawFn) -> CurveStep:
    """Vertices and edges, or a triangle in some, and an operator; most of them apply."""
    k = draw(complexes(2, 8))
    if draw(st.integers(0, 19)) == 19:
        k = draw(complexes(3))
    there = sorted(min(s) for s in k.simplices if len(s) == 1) or [0]
    one = draw(st.sampled_from(there))
    other = draw(st.sampled_from([v for v in there if v != one] or [8]))
    likely: tuple[CurveOperator, ...] = (
        EdgeBetweenEnds(one, other),
        EdgeAtInterior(one, other),
        EdgeAndVertex(one, 8),
    )
    return CurveStep(k, draw(st.one_of(*[st.sampled_from(likely)] * 3, CURVE_OPERATORS)))


_ANY_SIMPLEX: Final = st.lists(st.integers(-1, 12), max_size=12).map(tuple)
_ANY_ATTACHMENT: Final = st.builds(
    Attachment, _ANY_SIMPLEX, st.lists(_ANY_SIMPLEX, max_size=3).map(tuple)
)
_BUILDS: Final[st.SearchStrategy[Constructive]] = st.one_of(
    st.builds(Attach, _ANY_ATTACHMENT),
    st.builds(EulerAttach, _ANY_ATTACHMENT),
    st.builds(BoundaryAttach, _ANY_ATTACHMENT),
    st.builds(Handle, _ANY_ATTACHMENT, st.lists(_ANY_ATTACHMENT, max_size=2).map(tuple)),
    CURVE_OPERATORS,
)
OPERATORS: Final[st.SearchStrategy[Operator]] = st.one_of(_BUILDS, st.builds(Undo, _BUILDS))
"""Any operator with any numbers; hardly ever does one apply."""


@st.composite
def operator_steps(draw: st.DrawFn) -> OperatorStep:
    """A complex and an operator that may apply, or the undoing of one, there or further on."""
    step = draw(
        st.one_of(
            gluable().flatmap(_on_one),
            gluable().flatmap(_on_one),
            curve_steps().map(lambda s: OperatorStep(s.before, s.operator)),
            handle_steps(2).map(lambda s: OperatorStep(s.before, s.operator)),
            st.builds(OperatorStep, complexes(), OPERATORS),
        )
    )
    if isinstance(step.operator, Undo) or draw(st.booleans()):
        return step
    after = _after(step.operator, step.before)
    if draw(st.integers(0, 2)) == 0:
        after = closure([*after.simplices, draw(simplices())])
    return OperatorStep(after, Undo(step.operator))


def _on_one(given: Gluable) -> st.SearchStrategy[OperatorStep]:
    return st.sampled_from(ON_ONE).map(lambda of: OperatorStep(given.before, of(given.glued)))


def _after(operator: Operator, k: Complex) -> Complex:
    result = apply(operator, k)
    return result.value if isinstance(result, Accepted) else k


def attachment_scripts(size: int = 5, count: int = 10) -> st.SearchStrategy[Script]:
    """Scripts that run to their end from nothing, of simplices of at most `size` vertices.

    Drawn as a list of simplices, each with what to do, so that they shrink to few and small ones.
    """
    return st.lists(st.tuples(st.integers(0, 5), simplices(size)), max_size=count).map(_script)


def _script(wanted: list[tuple[int, tuple[int, ...]]]) -> Script:
    """The operators among those wanted that apply: kind 4 and 5 undo the last, if it is there."""
    k = NOTHING
    script: list[Operator] = []
    done: list[tuple[Constructive, Complex]] = []
    for kind, simplex in wanted:
        if kind >= len(ON_ONE):
            if done:
                operator, k = done.pop()
                script.append(Undo(operator))
            continue
        step = ON_ONE[kind](attachment(k, simplex))
        result = apply(step, k)
        if isinstance(result, Accepted):
            script.append(step)
            done.append((step, k))
            k = result.value
    return tuple(script)


def any_scripts() -> st.SearchStrategy[AnyScript]:
    """Scripts that run, and after them perhaps operators that do not apply."""
    return st.builds(
        lambda start, more: AnyScript((*start, *more)),
        attachment_scripts(),
        st.lists(OPERATORS, max_size=2),
    )


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "complexes-to-build": complexes(),
    "attachments": gluable(),
    "gluings": gluings(),
    "attachment-steps": operator_steps(),
    "curve-steps": curve_steps(),
    "attachment-scripts": any_scripts(),
    **AT_MANIFOLDS,
}
"""The domains of this module, by name."""
