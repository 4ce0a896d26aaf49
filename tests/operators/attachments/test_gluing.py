"""Gluings without names: what fits, what becomes a complex, and how it is named."""

from itertools import product

import pytest

from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds
from clers.conventions.where import AtSimplex
from clers.operators.attachments.attachment import Attachment
from clers.operators.attachments.classes import subcomplexes
from clers.operators.attachments.given import Unnamed
from clers.operators.attachments.gluing import Gluing, fits, named, quotient_is_complex
from clers.operators.attachments.laws import LAWS

(LAW,) = [law for law in LAWS if law.name == "gluing-named"]
PATH = closure([(0, 1), (1, 2)])


def gluing(place: tuple[int, ...], *faces: tuple[int, ...]) -> Gluing:
    """The corners at their places, and the faces identified."""
    return Gluing(place, frozenset(map(frozenset, faces)))


@pytest.mark.parametrize(
    ("given", "at"),
    [
        (gluing((0,), (0,)), (0,)),
        (gluing((0, 1, -1), (0, 1)), (0, 1)),
        (gluing((0, 0, -1), (0,), (1,), (0, 1)), (0, 1)),
        (gluing((0, 2, -1), (0,), (1,), (0, 2)), (0, 2)),
        (gluing((0, 2, -1), (0,), (1,), (0, 1)), (0, 1)),
        (gluing((0, 7), (0,), (1,)), (1,)),
        (gluing((0, -1), (0,), (5,)), (5,)),
        (gluing((0, -1), (0,), ()), ()),
        (gluing((0, 1), (0,)), (1,)),
        (gluing((-1, 0), (0,), (1,)), (0,)),
        (gluing((-1, 0)), (1,)),
    ],
)
def test_gluings_that_do_not_fit(given: Gluing, at: tuple[int, ...]) -> None:
    """Clause: OPER-ATTACH-4."""
    bad = fits(PATH, given)
    assert isinstance(bad, Rejected)
    assert (bad.reason, bad.clause) == (Reason.BAD_OPERAND, Clause.OPER_ATTACH_4)
    assert bad.where == AtSimplex(at)
    assert "identified" in bad.detail
    assert named(PATH, given) == bad


@pytest.mark.parametrize(
    ("given", "at", "word"),
    [
        (gluing((0, 0), (0,), (1,)), (0, 1), "twice"),
        (gluing((1, 2, 2), (0,), (1,), (2,), (0, 1), (0, 2)), (1, 2), "twice"),
        (gluing((0, 1), (0,), (1,)), (0, 1), "span"),
        (gluing((0, 1, 2), (0,), (1,), (2,), (0, 1)), (1, 2), "span"),
        (gluing((0, 1, 2), (0,), (1,), (2,)), (0, 1), "span"),
    ],
)
def test_gluings_that_leave_no_complex(given: Gluing, at: tuple[int, ...], word: str) -> None:
    """Clause: OPER-ATTACH-9."""
    assert fits(PATH, given) is None
    assert not quotient_is_complex(PATH, given)
    result = named(PATH, given)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause) == (
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_ATTACH_9,
    )
    assert result.where == AtSimplex(at)
    assert word in result.detail


def test_names() -> None:
    """New corners take the next numbers. Clause: OPER-ATTACH-9."""
    assert named(PATH, gluing((-1, 2, -1), (1,))) == Accepted(Attachment((2, 3, 4), ((2,),)))
    assert named(PATH, gluing((2, -1, 1), (0,), (2,), (0, 2))) == Accepted(
        Attachment((1, 2, 3), ((1, 2),))
    )
    assert named(PATH, gluing((0, 2), (0,), (1,))) == Accepted(Attachment((0, 2), ((0,), (2,))))
    assert named(Complex(frozenset()), gluing((-1, -1))) == Accepted(Attachment((0, 1)))


def test_every_gluing_of_an_edge_and_a_triangle_to_small_complexes() -> None:
    """All places and all parts of the frontier, well formed or not. Clause: OPER-ATTACH-9."""
    complexes = (
        closure([(0,)]),
        closure([(0, 1)]),
        PATH,
        closure([(0, 1), (1, 2), (0, 2)]),
        closure([(0, 1, 2)]),
    )
    results: list[bool] = []
    for k, m in product(complexes, (1, 2)):
        for place in product((-1, 0, 1, 2), repeat=m + 1):
            for part in subcomplexes(m):
                given = Gluing(place, part.simplices)
                assert LAW.check(Unnamed(k, given)) == Holds(), (k, given)
                if fits(k, given) is None:
                    results.append(quotient_is_complex(k, given))
    assert True in results
    assert False in results
