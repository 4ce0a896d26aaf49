"""Every subcomplex of the frontier of a simplex, up to dimension 4: nothing is left to chance."""

import pytest

from clers.complexes.homology import Field, betti
from clers.complexes.known import DUNCE
from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.operators.attachments.attachment import Attachment, attachment, common, maximal
from clers.operators.attachments.classes import handles, pinches, subcomplexes, ways
from clers.operators.attachments.expansion import expansions, has_order
from clers.operators.attachments.given import GLUABLE, Gluable
from clers.operators.attachments.laws import LAWS

ON_WAYS = [law for law in LAWS if law.domain == GLUABLE.name]


def alone(glued: Attachment) -> Gluable:
    """The attachment to nothing but the simplices that it asks for."""
    return Gluable(common(glued), glued)


def in_more(glued: Attachment) -> Gluable:
    """The attachment to a cone over what it asks for, with two more simplices beside it."""
    apex = 1 + max(glued.simplex)
    cone = [(*face, apex) for face in glued.along]
    return Gluable(closure([*cone, (apex, apex + 1), (apex + 2,)]), glued)


@pytest.mark.parametrize(("m", "labelled", "classes"), [(1, 4, 3), (2, 18, 8), (3, 166, 28)])
def test_numbers_of_dedekind(m: int, labelled: int, classes: int) -> None:
    """Two less than 6, 20, 168 monotone functions, and than 5, 10, 30 classes of them.

    These are OEIS A000372 and A003182; left out are the whole simplex and the complex that lacks
    even the empty simplex. Clause: OPER-SIMPLEX-2.
    """
    assert len(set(subcomplexes(m))) == len(subcomplexes(m)) == labelled
    assert len(ways(m)) == classes


def test_numbers_of_dedekind_in_dimension_four() -> None:
    """7581 and 210, less two. Clause: OPER-SIMPLEX-2."""
    assert len(subcomplexes(4)) == 7579
    assert len(ways(4)) == 208


@pytest.mark.parametrize("law", ON_WAYS, ids=lambda law: law.name)
def test_law_on_every_way(law: AnyLaw) -> None:
    """All 248 classes with their laws; those up to dimension 3 in two complexes each."""
    for m in range(5):
        for glued in ways(m):
            assert law.check(alone(glued)) == Holds(), glued
            if m < 4:
                assert law.check(in_more(glued)) == Holds(), glued


def test_euler_attachments_and_orders_counted() -> None:
    """How many classes are Euler attachments, and how many have the tutorial's order.

    By hand, m = 2: a vertex, an edge, two edges; the last two have order 2. m = 3: a vertex, the
    four trees with edges (01, 01 02, star, path), one, two, three triangles, a triangle with an
    edge; the last four have order 3. Clauses: OPER-SIMPLEX-2, OPER-SIMPLEX-3.
    """
    euler = [[w for w in ways(m) if expansions(w) is not None] for m in range(1, 4)]
    order = [[w.along for w in ways(m) if has_order(w)] for m in range(1, 4)]
    assert [len(found) for found in euler] == [1, 3, 9]
    assert order[1] == [((0, 1),), ((0, 1), (0, 2))]
    assert order[2] == [
        ((0, 1, 2),),
        ((0, 1), (0, 2, 3)),
        ((0, 1, 2), (0, 1, 3)),
        ((0, 1, 2), (0, 1, 3), (0, 2, 3)),
    ]


def test_the_dunce_hat_is_beyond_the_bound() -> None:
    """On eight vertices there is a part with the homology of a point and no expansions.

    The dunce hat has no free face, so that no expansion of its dual ends with it; its complement
    is glued along by a 7-simplex. Clause: OPER-SIMPLEX-2.
    """
    hat = DUNCE.complex
    everything = frozenset(min(v) for v in hat.simplices if len(v) == 1)
    assert len(everything) == 8
    frontier = closure([everything]).simplices - {everything}
    dual = Complex(frozenset(s for s in frontier if everything - s not in hat.simplices))
    glued = Attachment(tuple(sorted(everything)), maximal(dual))
    assert not any(handles(glued))
    assert betti(dual, Field.Q)[0] == 1
    assert expansions(glued) is None


def test_expansions_of_a_triangle_in_order() -> None:
    """A triangle on one edge: the vertex with an edge first, then the triangle with the other."""
    found = expansions(Attachment((0, 1, 2), ((0, 1),)))
    assert found is not None
    assert [(step.free, step.coface) for step in found] == [((2,), (0, 2)), ((1, 2), (0, 1, 2))]
    assert expansions(Attachment((0, 1, 2), ((0,), (1,)))) is None
    assert expansions(Attachment((3,))) is None


def test_no_order_below_one() -> None:
    """Clause: OPER-SIMPLEX-3."""
    assert not has_order(Attachment((0,)))
    assert not has_order(Attachment((0, 1)))
    assert not has_order(Attachment((0, 1), ((0,), (1,))))
    assert has_order(Attachment((0, 1), ((1,),)))


def test_handles_and_pinches_of_some() -> None:
    """By hand. Clauses: OPER-ATTACH-6, OPER-SIMPLEX-6."""
    assert handles(Attachment((5,))) == (1,)
    assert handles(Attachment((4, 5), ((4,), (5,)))) == (0, 1)
    assert handles(Attachment((0, 1, 2, 3), ((0,), (1, 2), (1, 3), (2, 3)))) == (0, 1, 1, 0)
    assert pinches(Attachment((0, 1, 2, 3), ((0, 1), (0, 2, 3)))) == ((0, 1),)
    assert pinches(Attachment((0, 1), ((0,), (1,)))) == ()


def test_the_only_attachment_that_fits() -> None:
    """Clause: OPER-ATTACH-2."""
    k = closure([(0, 1, 2), (2, 3), (5,)])
    assert attachment(k, (3, 1, 2)) == Attachment((1, 2, 3), ((1, 2), (2, 3)))
    assert attachment(k, (2, 1, 0)) == Attachment((0, 1, 2), ((0, 1), (0, 2), (1, 2)))
    assert attachment(k, (7, 8)) == Attachment((7, 8))


def test_clauses_have_their_laws() -> None:
    """The laws that every way is held against."""
    clauses = {law.clause for law in ON_WAYS}
    assert {Clause.OPER_ATTACH_2, Clause.OPER_SIMPLEX_1, Clause.OPER_SIMPLEX_3} <= clauses
