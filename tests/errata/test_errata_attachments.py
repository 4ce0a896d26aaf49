"""ERRATUM-36, ERRATUM-37: what the words of section 6 about attachments let through."""

from itertools import combinations

from clers.complexes.manifolds.kind import Flaw, NotManifold
from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import Complex, boundary, closure, link, of_dimension, pieces
from clers.conventions.result import Accepted, Rejected
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import Attachment, attach, attachment
from clers.operators.attachments.expansion import has_order
from clers.operators.attachments.gluing import Gluing, fits, named, quotient_is_complex
from clers.operators.attachments.operator import BoundaryAttach


def both_ends(one: int, other: int) -> Gluing:
    """An edge with its two ends identified, and not the edge itself."""
    return Gluing((one, other), frozenset({frozenset({0}), frozenset({1})}))


def test_identified_faces_may_leave_no_complex() -> None:
    """ERRATUM-36: a loop at a point, and a second edge between two vertices.

    OPER-ATTACH-4 is what is printed, OPER-ATTACH-9 what is needed.
    """
    point, edge = closure([(0,)]), closure([(0, 1)])
    for k, gluing in ((point, both_ends(0, 0)), (edge, both_ends(0, 1))):
        assert fits(k, gluing) is None  # the ends have no faces: one to one they are
        assert not quotient_is_complex(k, gluing)
        assert isinstance(named(k, gluing), Rejected)


def as_printed(k: Complex, glued: Attachment) -> bool:
    """6(a): a simplex attachment of the dimension of the manifold, of bounding simplices only."""
    rim = boundary(k).simplices
    return (
        isinstance(attach(k, glued), Accepted)
        and has_order(glued)
        and all(frozenset(face) in rim for face in glued.along)
    )


def test_bounding_simplices_are_not_enough_for_tetrahedra() -> None:
    """ERRATUM-37: a triangle and the edge from one of its vertices to the opposite one.

    OPER-SIMPLEX-5, OPER-SIMPLEX-6.
    """
    k = closure([(0, 1, 2, 4), (0, 1, 4, 5), (0, 3, 4, 5)])
    assert isinstance(manifold(k), Manifold)
    glued = Attachment((0, 1, 2, 3), ((0, 1, 2), (0, 3)))
    assert glued == attachment(k, (0, 1, 2, 3))
    assert as_printed(k, glued)
    after = attach(k, glued)
    assert isinstance(after, Accepted)
    assert manifold(after.value) == NotManifold(frozenset({0}), Flaw.BAD_LINK)
    assert len(pieces(link(after.value, frozenset({0, 3})))) == 2
    assert isinstance(apply(BoundaryAttach(glued), k), Rejected)


def test_two_tetrahedra_are_too_few() -> None:
    """ERRATUM-37: on one tetrahedron, and on two at a triangle, what is printed is right.

    A simplex attachment is connected, so that two tetrahedra apart have nothing more.
    """
    for k in (closure([(0, 1, 2, 3)]), closure([(0, 1, 2, 3), (0, 1, 2, 4)])):
        old = [min(v) for v in of_dimension(k, 0)]
        for count in range(5):
            for chosen in combinations(old, count):
                glued = attachment(k, (*chosen, *range(9, 13 - count)))
                if as_printed(k, glued):
                    after = attach(k, glued)
                    assert isinstance(after, Accepted)
                    assert isinstance(manifold(after.value), Manifold)
