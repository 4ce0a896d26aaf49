"""The laws of Euler attachments, judged by replaying their expansions and by homology."""

from typing import Final

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import dimension
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import attach
from clers.operators.attachments.classes import handles
from clers.operators.attachments.expansion import expansions, has_order
from clers.operators.attachments.given import GLUABLE, Gluable
from clers.operators.attachments.operator import EulerAttach
from clers.operators.moves.collapse import expand


def _replayed(given: Gluable) -> Verdict:
    """Its expansions, one after another, lead to where the attachment leads, ending with σ."""
    found, after = expansions(given.glued), attach(given.before, given.glued)
    if isinstance(after, Rejected) or found is None:
        return Holds()
    k = given.before
    for step in found:
        grown = expand(k, step)
        if isinstance(grown, Rejected):
            return Fails(repr(step), grown.line(), grown.where)
        k = grown.value
    return every(same(after.value, k), same(given.glued.simplex, found[-1].coface))


def _acyclic(given: Gluable) -> Verdict:
    """It applies as an Euler attachment exactly if it applies and A has a point's homology."""
    plain, result = attach(given.before, given.glued), apply(EulerAttach(given.glued), given.before)
    if isinstance(plain, Rejected):
        return same(plain, result)
    return same(not any(handles(given.glued)), isinstance(result, Accepted))


def _kept(given: Gluable) -> Verdict:
    """An Euler attachment leaves all Betti numbers as they are."""
    after = apply(EulerAttach(given.glued), given.before)
    if isinstance(after, Rejected):
        return Holds()
    higher = dimension(after.value) - dimension(given.before)
    return same((*betti(given.before, Field.Q), *[0] * higher), betti(after.value, Field.Q))


def _ordered(given: Gluable) -> Verdict:
    """A simplex attachment of order m is an Euler attachment along a facet at least."""
    glued = given.glued
    if len(glued.simplex) < 2:
        return same(False, has_order(glued))
    along_facet = any(len(face) == len(glued.simplex) - 1 for face in glued.along)
    return same(expansions(glued) is not None and along_facet, has_order(glued))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "euler-attachment-replayed",
        Clause.OPER_SIMPLEX_1,
        "Its expansions lead where the attachment leads, and end with the simplex.",
        GLUABLE,
        _replayed,
    ),
    Law(
        "euler-attachment-keeps-homology",
        Clause.OPER_SIMPLEX_1,
        "An Euler attachment leaves all Betti numbers as they are.",
        GLUABLE,
        _kept,
    ),
    Law(
        "euler-attachment-along-a-point",
        Clause.OPER_SIMPLEX_2,
        "Up to dimension 6: exactly where A has the homology of a point.",
        GLUABLE,
        _acyclic,
    ),
    Law(
        "simplex-attachment-of-order",
        Clause.OPER_SIMPLEX_3,
        "Up to dimension 4: of order m exactly if an Euler attachment along a facet at least.",
        GLUABLE,
        _ordered,
    ),
)
