"""Small models, every number worked out by hand."""

from fractions import Fraction

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol, Whole
from clers.information.adaptive import adaptive
from clers.information.automaton import Automaton, contexts, start
from clers.information.combined import Refined, Until, joined, pieces, raw, times
from clers.information.measure import bits, content, entropy, probability
from clers.information.model import cumulative, has_ended, slots
from clers.information.static import END, Static, static, uniform

C, L, E, R, S = range(5)

AFTER_C = Automaton(((2, 0, 0, 1, 1), (1, 1, 1, 1, 1)), ((0, 1, 1, 1, 1),) * 2)
"""Two contexts, after C and not; L and E cannot follow C."""


def test_the_cube_word_by_context() -> None:
    """INFO-AUTOMATON-1. CCCRCRRCRRE: 1/5 at the start and after each R but the last E too."""
    word = [C, C, C, R, C, R, R, C, R, R, E]
    expected = (
        Fraction(1, 5) * Fraction(2, 4) * Fraction(2, 4) * Fraction(1, 4)  # CCCR
        * Fraction(1, 5) * Fraction(1, 4) * Fraction(1, 5)  # CRR
        * Fraction(1, 5) * Fraction(1, 4) * Fraction(1, 5)  # CRR
        * Fraction(1, 5)  # E
    )  # fmt: skip
    assert probability(contexts(AFTER_C)[1], word) == Accepted(expected)


def test_cl_is_not_allowed() -> None:
    """INFO-MODEL-5."""
    got = slots(contexts(AFTER_C)[1], [R, C, L, C])
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(2))


@pytest.mark.parametrize(
    ("automaton", "number", "where"),
    [
        (Automaton((), ()), 0, Whole()),
        (AFTER_C, 2, Whole()),
        (AFTER_C, -1, Whole()),
        (Automaton(((1, 1),), ()), 0, Whole()),
        (Automaton(((1, 1),), ((0,),)), 0, Whole()),
        (Automaton(((0, 0),), ((0, 0),)), 0, Whole()),
        (Automaton(((1, -1),), ((0, 0),)), 0, AtSymbol(1)),
        (Automaton(((1, 1),), ((0, 1),)), 0, AtSymbol(1)),
    ],
)
def test_bad_automata(automaton: Automaton, number: int, where: AtSymbol | Whole) -> None:
    """INFO-AUTOMATON-2."""
    got = start(automaton, number)
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (Reason.BAD_TABLE, where)


def test_successor_of_a_forbidden_symbol_is_not_looked_at() -> None:
    """INFO-AUTOMATON-2."""
    assert isinstance(start(Automaton(((1, 0),), ((0, 99),))), Accepted)


def test_totals_at_the_limit() -> None:
    """INFO-MODEL-2, INFO-STATIC-2, INFO-STATIC-3, INFO-ADAPT-3: 2^30, and one more."""
    assert isinstance(static((2**30 - 1, 1)), Accepted)
    assert isinstance(uniform(2**30), Accepted)
    assert isinstance(adaptive((1, 1), 1, 2**30), Accepted)
    for got, clause in (
        (static((2**30, 1)), Clause.INFO_STATIC_3),
        (uniform(2**30 + 1), Clause.INFO_STATIC_3),
        (uniform(0), Clause.INFO_STATIC_3),
        (adaptive((1, 1), 1, 2**30 + 1), Clause.INFO_ADAPT_3),
    ):
        assert isinstance(got, Rejected)
        assert (got.reason, got.clause) == (Reason.BAD_TABLE, clause)
    assert isinstance(adaptive((1, 1), 3, 5), Accepted)
    assert isinstance(adaptive((1, 1), 3, 4), Rejected)
    assert isinstance(adaptive((1, 1), 0, 9), Rejected)


def test_stop_symbol() -> None:
    """INFO-COMBINE-3, INFO-MODEL-3."""
    model = Until(Static(cumulative((1, 1))), stop=1)
    assert isinstance(slots(model, [0, 0, 1]), Accepted)
    got = slots(model, [0, 1, 0])
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(2))


def test_class_and_raw_bits() -> None:
    """INFO-COMBINE-6, INFO-COMBINE-7: 0, 5, 1 in classes by length cost 3 classes and 2 bits."""
    classes = Static(cumulative((1, 1, 1, 1)))
    model = Refined(times(classes, 3), (raw(0), raw(0), raw(1), raw(2)))
    symbols = (0, 3, *pieces(5 - 4, 2), 1)
    assert symbols == (0, 3, 1, 1)
    assert probability(model, symbols) == Accepted(Fraction(1, 4) ** 3 * Fraction(1, 4))
    here = model.after(0).after(3)
    assert here.cumulative == range(5)
    assert has_ended(here.after(1).after(1))


def test_pieces_by_hand() -> None:
    """INFO-COMBINE-7."""
    assert pieces(0x5ABCD, 20) == (0x5, 0xABCD)
    assert pieces(0xABCD, 16) == (0xABCD,)
    assert pieces(0, 0) == ()
    assert joined((0x5, 0xABCD)) == 0x5ABCD
    assert raw(0) == END


def test_entropy_by_hand() -> None:
    """INFO-ENTROPY-1. The tutorial's seascape: 2^-3, 2^-4, 2^-1, 2^-2, 2^-4 cost 1.875 bits."""
    assert entropy((2, 1, 8, 4, 1)) == pytest.approx(3 / 8 + 4 / 16 + 1 / 2 + 2 / 4 + 4 / 16)
    assert entropy((7,)) == 0
    assert entropy(()) == 0
    assert entropy((0, 5, 5)) == pytest.approx(1)


def test_content_of_an_unlikely_message() -> None:
    """INFO-CONTENT-2: no underflow, where floating-point probabilities would be 0."""
    model = Static(cumulative((1, 2**20 - 1)))
    got = content(model, (0,) * 500)
    assert isinstance(got, Accepted)
    assert got.value == pytest.approx(10_000)
    assert bits(Fraction(1, 2**10_000)) == pytest.approx(10_000)
    assert isinstance(content(model, (2,)), Rejected)
    assert isinstance(probability(model, (2,)), Rejected)
