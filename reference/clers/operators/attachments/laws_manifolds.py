"""The laws of attachments to manifolds: what stays a manifold, and what handles do to solids."""

from typing import Final

from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import boundary, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import attach
from clers.operators.attachments.classes import handles
from clers.operators.attachments.given import AT_MANIFOLDS, SOLID_STEPS, Gluable, SolidStep
from clers.operators.attachments.operator import BoundaryAttach, Handle
from clers.operators.attachments.solid import TABLE, solid_case, solid_change


def _stays(given: Gluable) -> Verdict:
    """K' is a manifold exactly if A is made of facets at the boundary."""
    k, glued = given.before, given.glued
    after = attach(k, glued)
    if isinstance(after, Rejected):
        return Holds()
    walls = of_dimension(boundary(k), dimension(k) - 1)
    good = all(frozenset(face) in walls for face in glued.along)
    return same(good, isinstance(manifold(after.value), Manifold))


def _manifold_euler(given: Gluable) -> Verdict:
    """`boundary-attach` applies exactly if K' is a manifold and no handle was attached."""
    k, glued = given.before, given.glued
    after = attach(k, glued)
    good = (
        isinstance(after, Accepted)
        and not any(handles(glued))
        and isinstance(manifold(after.value), Manifold)
    )
    return same(good, isinstance(apply(BoundaryAttach(glued), k), Accepted))


def _handle_stays(step: SolidStep) -> Verdict:
    """What a handle leaves of a manifold is one."""
    after = apply(step.operator, step.before)
    if isinstance(after, Rejected):
        return Holds()
    return same(True, isinstance(manifold(after.value), Manifold))


def _one_attachment(given: Gluable) -> Verdict:
    """A handle of one attachment applies exactly if the attachment leaves a manifold."""
    after = attach(given.before, given.glued)
    good = isinstance(after, Accepted) and isinstance(manifold(after.value), Manifold)
    return same(good, isinstance(apply(Handle(given.glued), given.before), Accepted))


def _effect(step: SolidStep) -> Verdict:
    """A handle changes a 3-manifold as the table says."""
    after = apply(step.operator, step.before)
    if isinstance(after, Rejected):
        return Holds()
    case = solid_case(step.before, step.operator)
    if case is None:
        return Fails("one handle", repr(handles(step.operator.first)), WHOLE)
    return same(TABLE[case], solid_change(step.before, after.value))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "boundary-attachment-is-manifold-and-euler",
        Clause.OPER_SIMPLEX_5,
        "It applies to a manifold exactly if the result is a manifold and no handle is attached.",
        AT_MANIFOLDS,
        _manifold_euler,
    ),
    Law(
        "manifold-stays-along-boundary-facets",
        Clause.OPER_SIMPLEX_6,
        "A manifold stays one exactly if the simplex is glued along facets at the boundary.",
        AT_MANIFOLDS,
        _stays,
    ),
    Law(
        "handle-of-one-attachment",
        Clause.OPER_SOLID_1,
        "A handle of one attachment applies to a manifold exactly if a manifold results.",
        AT_MANIFOLDS,
        _one_attachment,
    ),
    Law(
        "handle-leaves-a-manifold",
        Clause.OPER_SOLID_2,
        "What a handle leaves of a 3-manifold is one.",
        SOLID_STEPS,
        _handle_stays,
    ),
    Law(
        "solid-effect-in-table",
        Clause.OPER_SOLID_5,
        "A handle changes χ, components and boundary of a 3-manifold as the table says.",
        SOLID_STEPS,
        _effect,
    ),
)
