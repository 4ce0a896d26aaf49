"""Each law of attachments, with something broken on purpose: it must say so."""

from dataclasses import dataclass

import pytest

from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.operators.attachments import laws as general
from clers.operators.attachments import laws_curves, laws_manifolds, laws_simplex
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import Attachment, attach
from clers.operators.attachments.classes import Growth, growth
from clers.operators.attachments.curves import CurveCase
from clers.operators.attachments.examples import build
from clers.operators.attachments.expansion import expansions
from clers.operators.attachments.given import (
    AnyScript,
    CurveStep,
    Gluable,
    OperatorStep,
    SolidStep,
    Unnamed,
)
from clers.operators.attachments.gluing import Gluing
from clers.operators.attachments.operator import (
    Attach,
    EdgeBetweenEnds,
    FirstVertex,
    Handle,
    Operator,
    Undo,
)
from clers.operators.attachments.solid import SolidCase, handle, prism
from clers.operators.moves.move import Expand

REFUSED = Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_ATTACH_2)


def unchanged(k: Complex, _: object) -> Accepted[Complex]:
    """An attachment that does nothing."""
    return Accepted(k)


def with_a_point(k: Complex, glued: Attachment) -> Accepted[Complex] | Rejected:
    """An attachment that leaves a point behind."""
    after = attach(k, glued)
    if isinstance(after, Rejected):
        return after
    return Accepted(Complex(after.value.simplices | {frozenset([99])}))


def grants(_: object, k: Complex) -> Accepted[Complex]:
    """An operator that applies to everything, and does nothing."""
    return Accepted(k)


def refuses(_: object, __: object) -> Rejected:
    """An operator that never applies."""
    return REFUSED


def never_undone(operator: Operator, k: Complex) -> Accepted[Complex] | Rejected:
    """Operators without inverses."""
    return REFUSED if isinstance(operator, Undo) else apply(operator, k)


def careless(operator: Operator, k: Complex) -> Accepted[Complex] | Rejected:
    """Every operator as if it were an attachment and no more."""
    if isinstance(operator, Undo | FirstVertex | EdgeBetweenEnds):
        return apply(operator, k)
    return attach(k, operator.first) if isinstance(operator, Handle) else attach(k, _one(operator))


def _one(operator: object) -> Attachment:
    found = getattr(operator, "glued", None)
    assert isinstance(found, Attachment)
    return found


def too_much(glued: Attachment) -> Growth:
    """One vertex more."""
    right = growth(glued)
    return Growth((right.counts[0] + 1, *right.counts[1:]), right.euler)


def too_euler(glued: Attachment) -> Growth:
    """One more in χ."""
    return Growth(growth(glued).counts, growth(glued).euler + 1)


def without_the_last(found: tuple[Expand, ...] | None) -> tuple[Expand, ...] | None:
    """One expansion less."""
    return None if found is None else found[:-1]


EDGE = closure([(0, 1)])
TRIANGLE = closure([(0, 1, 2)])
EAR = Attachment((1, 2, 3), ((1, 2),))
AT_A_POINT = Attachment((2, 3, 4), ((2,),))
CHORD = Attachment((0, 1), ((0,), (1,)))
TWO_POINTS = closure([(0,), (1,)])
APART = closure([(0, 1, 2, 3), (4, 5, 6, 7)])
JOIN = SolidStep(APART, handle(APART, prism((0, 1, 2), (4, 5, 6))))
PINCH = SolidStep(APART, Handle(handle(APART, prism((0, 1, 2), (4, 5, 6))).first))


@dataclass(frozen=True)
class Broken:
    """A law, what is exchanged in its module for what, and an example that must show it."""

    law: str
    module: object
    name: str
    wrong: object
    example: object


def always(value: object) -> object:
    """A function with one answer, whatever it is asked."""
    return lambda *_: value


BROKEN: tuple[Broken, ...] = (
    Broken("attachment-adds-a-closure", general, "attach", unchanged, Gluable(TRIANGLE, EAR)),
    Broken("attachment-adds-a-closure", general, "attach", refuses, Gluable(TRIANGLE, EAR)),
    Broken("attachment-adds-a-closure", general, "attach", unchanged, Gluable(EDGE, CHORD)),
    Broken(
        "attachment-led-back",
        general,
        "inverse",
        lambda operator: operator,
        OperatorStep(TRIANGLE, Attach(EAR)),
    ),
    Broken(
        "attachment-undone-exactly",
        general,
        "apply",
        never_undone,
        OperatorStep(closure([(0, 1, 2), (1, 2, 3)]), Attach(EAR)),
    ),
    Broken(
        "attachment-undone-exactly",
        general,
        "apply",
        grants,
        OperatorStep(TRIANGLE, FirstVertex(-1)),
    ),
    Broken("attachment-growth", general, "growth", too_much, Gluable(TRIANGLE, EAR)),
    Broken("attachment-growth", general, "growth", too_euler, Gluable(TRIANGLE, EAR)),
    Broken(
        "attachment-relative-homology",
        general,
        "handles",
        always((0, 1, 0)),
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "attachment-handles-act", general, "handles", always((0, 0)), Gluable(TWO_POINTS, CHORD)
    ),
    Broken("attachment-handles-act", general, "handles", always((0, 0, 1)), Gluable(TRIANGLE, EAR)),
    Broken("complex-built-by-attachments", general, "build", lambda k: build(k)[:-1], TRIANGLE),
    Broken("complex-built-by-attachments", general, "inverse", lambda operator: operator, TRIANGLE),
    Broken("attachment-script-steps", general, "run", always(()), AnyScript((FirstVertex(0),))),
    Broken(
        "attachment-script-steps",
        general,
        "run",
        always((Accepted(TRIANGLE),)),
        AnyScript((FirstVertex(0),)),
    ),
    Broken("attachment-script-as-text", general, "write", always(""), AnyScript((FirstVertex(0),))),
    Broken(
        "gluing-named",
        general,
        "quotient_is_complex",
        always(True),
        Unnamed(EDGE, Gluing((0, 1), frozenset({frozenset({0}), frozenset({1})}))),
    ),
    Broken(
        "gluing-named",
        general,
        "quotient_is_complex",
        always(False),
        Unnamed(EDGE, Gluing((0, -1), frozenset({frozenset({0})}))),
    ),
    Broken(
        "gluing-named",
        general,
        "fits",
        always(REFUSED),
        Unnamed(EDGE, Gluing((0, -1), frozenset({frozenset({0})}))),
    ),
    Broken(
        "gluing-named",
        general,
        "named",
        always(Accepted(Attachment((1, 2), ((1,), (2,))))),
        Unnamed(EDGE, Gluing((1, -1), frozenset({frozenset({0})}))),
    ),
    Broken("attachment-keeps-purity", general, "attach", with_a_point, Gluable(TRIANGLE, EAR)),
    Broken(
        "euler-attachment-replayed",
        laws_simplex,
        "expansions",
        lambda glued: without_the_last(expansions(glued)),
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "euler-attachment-replayed",
        laws_simplex,
        "expand",
        lambda *_: REFUSED,
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "euler-attachment-keeps-homology",
        laws_simplex,
        "apply",
        careless,
        Gluable(TWO_POINTS, CHORD),
    ),
    Broken(
        "euler-attachment-along-a-point",
        laws_simplex,
        "apply",
        careless,
        Gluable(TWO_POINTS, CHORD),
    ),
    Broken(
        "euler-attachment-along-a-point", laws_simplex, "apply", refuses, Gluable(TRIANGLE, EAR)
    ),
    Broken("euler-attachment-along-a-point", laws_simplex, "apply", grants, Gluable(EDGE, CHORD)),
    Broken(
        "simplex-attachment-of-order",
        laws_simplex,
        "has_order",
        always(True),
        Gluable(TRIANGLE, AT_A_POINT),
    ),
    Broken(
        "simplex-attachment-of-order",
        laws_simplex,
        "has_order",
        always(False),
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "simplex-attachment-of-order",
        laws_simplex,
        "has_order",
        always(True),
        Gluable(TRIANGLE, Attachment((3,))),
    ),
    Broken(
        "boundary-attachment-is-manifold-and-euler",
        laws_manifolds,
        "apply",
        careless,
        Gluable(TRIANGLE, AT_A_POINT),
    ),
    Broken(
        "boundary-attachment-is-manifold-and-euler",
        laws_manifolds,
        "apply",
        refuses,
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "manifold-stays-along-boundary-facets",
        laws_manifolds,
        "attach",
        with_a_point,
        Gluable(TRIANGLE, EAR),
    ),
    Broken(
        "handle-of-one-attachment",
        laws_manifolds,
        "apply",
        careless,
        Gluable(TRIANGLE, AT_A_POINT),
    ),
    Broken("handle-leaves-a-manifold", laws_manifolds, "apply", careless, PINCH),
    Broken("solid-effect-in-table", laws_manifolds, "solid_case", always(SolidCase.ONE_AT), JOIN),
    Broken("solid-effect-in-table", laws_manifolds, "solid_case", always(None), JOIN),
    Broken(
        "curve-operator-applies",
        laws_curves,
        "apply",
        grants,
        CurveStep(closure([(0, 1), (1, 2)]), EdgeBetweenEnds(1, 3)),
    ),
    Broken(
        "curve-operator-applies", laws_curves, "apply", refuses, CurveStep(EDGE, FirstVertex(2))
    ),
    Broken(
        "curve-effect-in-table",
        laws_curves,
        "curve_case",
        always(CurveCase.MEV_AT_END),
        CurveStep(EDGE, FirstVertex(2)),
    ),
    Broken(
        "curve-stays-a-curve",
        laws_curves,
        "curve_case",
        always(CurveCase.MEV_INSIDE),
        CurveStep(EDGE, FirstVertex(2)),
    ),
)


@pytest.mark.parametrize("case", BROKEN, ids=lambda case: f"{case.law}-{case.name}")
def test_law_fails(case: Broken, monkeypatch: pytest.MonkeyPatch) -> None:
    (law,) = [law for law in general.LAWS if law.name == case.law]
    assert law.check(case.example) == Holds()
    monkeypatch.setattr(case.module, case.name, case.wrong)
    assert isinstance(law.check(case.example), Fails)


def test_every_law_was_seen_to_fail() -> None:
    assert {case.law for case in BROKEN} == {law.name for law in general.LAWS}
