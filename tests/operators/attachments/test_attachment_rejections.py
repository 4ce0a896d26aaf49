"""What is rejected, why, by which clause and where."""

import pytest

from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex
from clers.operators.attachments.apply import NOTHING, apply, run
from clers.operators.attachments.attachment import Attachment, malformed
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    EulerAttach,
    FirstVertex,
    Handle,
    Operator,
    Undo,
)

TRIANGLE = closure([(0, 1, 2)])
SQUARE = closure([(0, 1, 2), (0, 2, 3)])
PATH = closure([(0, 1), (1, 2), (3,)])


def refused(k: Complex, operator: Operator) -> tuple[Reason, Clause, tuple[int, ...]]:
    """Reason, clause and simplex of a rejection, which says something besides."""
    result = apply(operator, k)
    assert isinstance(result, Rejected), result
    assert isinstance(result.where, AtSimplex)
    return result.reason, result.clause, result.where.vertices


@pytest.mark.parametrize(
    ("glued", "at"),
    [
        (Attachment(()), ()),
        (Attachment((1, 0)), (0, 1)),
        (Attachment((0, 0)), (0,)),
        (Attachment((-1, 0)), (-1, 0)),
        (Attachment((0, 1), ((),)), ()),
        (Attachment((0, 1), ((0, 1),)), (0, 1)),
        (Attachment((0, 1, 2), ((1, 0),)), (0, 1)),
        (Attachment((0, 1, 2), ((0, 3),)), (0, 3)),
        (Attachment((0, 1, 2), ((0, 1), (0,))), (0, 1, 2)),
        (Attachment((0, 1, 2), ((1,), (0,))), (0, 1, 2)),
        (Attachment((0, 1, 2), ((0,), (0,))), (0, 1, 2)),
    ],
)
def test_malformed(glued: Attachment, at: tuple[int, ...]) -> None:
    """Clause: OPER-ATTACH-1."""
    expected = (Reason.BAD_OPERAND, Clause.OPER_ATTACH_1, at)
    assert refused(TRIANGLE, Attach(glued)) == expected
    assert refused(TRIANGLE, Undo(Attach(glued))) == expected


def test_ten_vertices_and_no_more() -> None:
    """Clause: OPER-ATTACH-1."""
    assert malformed(Attachment(tuple(range(10)))) is None
    eleven = tuple(range(11))
    expected = (Reason.TOO_MANY_VERTICES, Clause.OPER_ATTACH_1, eleven)
    assert refused(NOTHING, Attach(Attachment(eleven))) == expected
    assert refused(NOTHING, Attach(Attachment(eleven[::-1]))) == expected


REJECTED: tuple[tuple[Complex, Operator, Reason, Clause, tuple[int, ...]], ...] = (
    # the first missing simplex, by dimension
    (
        TRIANGLE,
        Attach(Attachment((0, 1, 3, 4), ((0, 1, 3), (4,)))),
        Reason.MISSING_SIMPLEX,
        Clause.OPER_ATTACH_2,
        (3,),
    ),
    # the first that is there, by dimension
    (
        TRIANGLE,
        Attach(Attachment((0, 1, 2, 3))),
        Reason.PRESENT_SIMPLEX,
        Clause.OPER_ATTACH_2,
        (0,),
    ),
    # along two edges, though the third is there
    (
        closure([(0, 1), (1, 2), (0, 2)]),
        Attach(Attachment((0, 1, 2), ((0, 1), (1, 2)))),
        Reason.PRESENT_SIMPLEX,
        Clause.OPER_ATTACH_2,
        (0, 2),
    ),
    # the simplex itself
    (
        TRIANGLE,
        Attach(Attachment((0, 1, 2), ((0, 1), (0, 2), (1, 2)))),
        Reason.PRESENT_SIMPLEX,
        Clause.OPER_ATTACH_2,
        (0, 1, 2),
    ),
    (
        TRIANGLE,
        Undo(Attach(Attachment((0, 1, 3), ((0, 1),)))),
        Reason.MISSING_SIMPLEX,
        Clause.OPER_ATTACH_3,
        (3,),
    ),
    (
        SQUARE,
        Undo(Attach(Attachment((0, 1, 2), ((0, 1),)))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_ATTACH_3,
        (2, 3),
    ),
    (
        SQUARE,
        Undo(EulerAttach(Attachment((0, 1, 2), ((0, 1), (0, 2), (1, 2))))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_1,
        (0, 1, 2),
    ),
    (
        closure([(0,), (1,)]),
        EulerAttach(Attachment((0, 1), ((0,), (1,)))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_1,
        (0, 1),
    ),
    # another dimension than the complex, higher and lower
    (
        TRIANGLE,
        BoundaryAttach(Attachment((0, 1, 2, 3), ((0, 1, 2),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (0, 1, 2, 3),
    ),
    (
        TRIANGLE,
        BoundaryAttach(Attachment((0, 3), ((0,),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (0, 3),
    ),
    # along nothing, along everything, along a vertex, inside
    (
        TRIANGLE,
        BoundaryAttach(Attachment((3, 4, 5))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (3, 4, 5),
    ),
    (
        closure([(0, 1, 2), (0, 1, 3), (0, 2, 3)]),
        BoundaryAttach(Attachment((1, 2, 3), ((1, 2), (1, 3), (2, 3)))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (1, 2, 3),
    ),
    (
        TRIANGLE,
        BoundaryAttach(Attachment((2, 3, 4), ((2,),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (2,),
    ),
    (
        SQUARE,
        BoundaryAttach(Attachment((0, 2, 4), ((0, 2),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_5,
        (0, 2),
    ),
    # curves
    (
        SQUARE,
        FirstVertex(9),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_CURVE_1,
        (0, 1, 2),
    ),
    (
        SQUARE,
        EdgeAndVertex(3, 4),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_CURVE_1,
        (0, 1, 2),
    ),
    (
        SQUARE,
        EdgeBetweenEnds(1, 3),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_CURVE_1,
        (0, 1, 2),
    ),
    (
        SQUARE,
        EdgeAtInterior(1, 3),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_CURVE_1,
        (0, 1, 2),
    ),
    (PATH, FirstVertex(1), Reason.PRESENT_SIMPLEX, Clause.OPER_ATTACH_2, (1,)),
    (PATH, FirstVertex(-1), Reason.BAD_OPERAND, Clause.OPER_ATTACH_1, (-1,)),
    (PATH, EdgeAndVertex(4, 5), Reason.MISSING_SIMPLEX, Clause.OPER_ATTACH_2, (4,)),
    (PATH, EdgeAndVertex(0, 3), Reason.PRESENT_SIMPLEX, Clause.OPER_ATTACH_2, (3,)),
    (PATH, EdgeAndVertex(0, 0), Reason.BAD_OPERAND, Clause.OPER_ATTACH_1, (0,)),
    (PATH, EdgeBetweenEnds(3, 1), Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_CURVE_4, (1,)),
    (PATH, EdgeBetweenEnds(1, 3), Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_CURVE_4, (1,)),
    (PATH, EdgeBetweenEnds(3, 3), Reason.BAD_OPERAND, Clause.OPER_ATTACH_1, (3,)),
    (PATH, EdgeBetweenEnds(0, 1), Reason.PRESENT_SIMPLEX, Clause.OPER_ATTACH_2, (0, 1)),
    (PATH, EdgeAtInterior(0, 3), Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_CURVE_5, (0,)),
    (PATH, EdgeAtInterior(1, 4), Reason.MISSING_SIMPLEX, Clause.OPER_ATTACH_2, (4,)),
    # handles
    (
        TRIANGLE,
        Handle(Attachment((0, 3), ((0,),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_1,
        (0, 3),
    ),
    (
        TRIANGLE,
        Handle(
            Attachment((2, 3, 4), ((2,),)),
            (Attachment((1, 2, 3), ((1, 2), (2, 3))), Attachment((0, 2, 4), ((0, 2), (2, 4)))),
        ),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_1,
        (2, 3, 4),
    ),
    (
        closure([(0, 1, 2), (0, 2, 3), (0, 3, 4)]),
        Handle(Attachment((0, 2, 5), ((0, 2),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_1,
        (0, 2),
    ),
    (
        TRIANGLE,
        Handle(Attachment((3, 4, 5)), (Attachment((0, 6), ((0,),)),)),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_1,
        (0, 6),
    ),
    (
        TRIANGLE,
        Handle(Attachment((3, 4, 5)), (Attachment((2, 3, 6), ((2,), (3,))),)),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SIMPLEX_1,
        (2, 3, 6),
    ),
    (
        TRIANGLE,
        Handle(Attachment((2, 3, 4), ((2,),))),
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_2,
        (2,),
    ),
)


@pytest.mark.parametrize(("k", "operator", "reason", "clause", "at"), REJECTED)
def test_rejected(
    k: Complex, operator: Operator, reason: Reason, clause: Clause, at: tuple[int, ...]
) -> None:
    """Each condition of the operators, where it is not met."""
    assert refused(k, operator) == (reason, clause, at)


def test_every_rejection_says_something() -> None:
    for k, operator, *_ in REJECTED:
        result = apply(operator, k)
        assert isinstance(result, Rejected)
        assert len(result.detail.split()) > 2 or result.detail == "is to be there"


def test_a_detached_simplex_leaves_what_it_was_glued_to() -> None:
    """Clause: OPER-ATTACH-3."""
    glued = Attachment((1, 2, 3), ((1, 2), (3,)))
    k = closure([(0, 1, 2), (3, 4)])
    assert apply(Attach(glued), k) == Accepted(closure([(0, 1, 2), (1, 2, 3), (3, 4)]))
    assert apply(Undo(Attach(glued)), closure([(0, 1, 2), (1, 2, 3), (3, 4)])) == Accepted(k)


def test_a_script_stops_at_the_first_rejection() -> None:
    """Clause: OPER-ATTACH-7."""
    steps = run((FirstVertex(0), EdgeAndVertex(2, 1), FirstVertex(3)))
    assert steps[0] == Accepted(closure([(0,)]))
    assert len(steps) == 2
    assert isinstance(steps[1], Rejected)
    assert run((FirstVertex(3),), PATH) == (
        Rejected(Reason.PRESENT_SIMPLEX, Clause.OPER_ATTACH_2, AtSimplex((3,)), "is to be new"),
    )
    assert run(()) == ()
