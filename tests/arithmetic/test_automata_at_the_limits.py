"""Automata that flat tables can just hold, or cannot, are coded as any model is."""

import pytest

from clers.arithmetic.bits import pack
from clers.arithmetic.coder import encode
from clers.arithmetic.given import ByAutomaton
from clers.arithmetic.laws_automaton import LAWS_OF_AUTOMATA
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds
from clers.information.automaton import Automaton, contexts
from clers.information.model import MAXIMUM_TOTAL

(LAW,) = LAWS_OF_AUTOMATA


@pytest.mark.parametrize(
    ("automaton", "symbols"),
    [
        # As many symbols as a byte has values, and one fewer.
        (Automaton(((1,) * 256,), ((0,) * 256,)), (255, 0, 254)),
        (Automaton(((1,) * 255,), ((0,) * 255,)), (254, 0)),
        # A table longer, and one shorter, than that of the first context.
        (Automaton(((1, 1), (1, 1, 1)), ((1, 1), (0, 0, 0))), (1, 2, 0, 1)),
        (Automaton(((1, 1, 1), (1, 1)), ((1, 1, 1), (0, 0))), (2, 1, 0, 0)),
        # The greatest total, in the first context and in the second.
        (Automaton(((1, MAXIMUM_TOTAL - 1),), ((0, 0),)), (1, 0, 1)),
        (Automaton(((1, 1), (1, MAXIMUM_TOTAL - 1)), ((1, 1), (0, 0))), (0, 0, 0, 1)),
    ],
)
def test_a_message_comes_back(automaton: Automaton, symbols: tuple[int, ...]) -> None:
    """Clauses: INFO-AUTOMATON-1, ARITH-ENCODE-1, ARITH-DECODE-1."""
    start = contexts(automaton)[0]
    bits = encode(start, symbols)
    assert isinstance(bits, Accepted)
    assert LAW.check(ByAutomaton(start, symbols, bits.value)) == Holds()
    assert LAW.check(ByAutomaton(start, symbols[:-1], bits.value)) == Holds()


@pytest.mark.parametrize(
    ("frequencies", "symbols"),
    [
        (((1, MAXIMUM_TOTAL),), (1,)),
        (((1, 1), (1, MAXIMUM_TOTAL)), (0, 1)),
        (((0, 0),), (0,)),
        (((1, 1), (0, 0)), (0, 0)),
    ],
)
def test_a_total_that_is_none(
    frequencies: tuple[tuple[int, ...], ...], symbols: tuple[int, ...]
) -> None:
    """INFO-MODEL-5, INFO-MODEL-6: such an automaton `start` refuses; made all the same, it ends
    or is rejected as any model of these tables."""
    there = tuple((min(1, len(frequencies) - 1),) * 2 for _ in frequencies)
    start = contexts(Automaton(frequencies, there))[0]
    bits = encode(contexts(Automaton(((1, 1),), ((0, 0),)))[0], (0, 1, 0, 0))
    assert isinstance(bits, Accepted)
    assert LAW.check(ByAutomaton(start, symbols, bits.value)) == Holds()


@pytest.mark.parametrize("digits", [(), (0,), (1,), (0, 1), (1, 1)])
@pytest.mark.parametrize("symbols", [(), (0,)])
def test_fewer_bits_than_any_message_has(digits: tuple[int, ...], symbols: tuple[int, ...]) -> None:
    """Clauses: ARITH-END-1, ARITH-STRICT-2."""
    start = contexts(Automaton(((1, 1),), ((0, 0),)))[0]
    assert LAW.check(ByAutomaton(start, symbols, pack(digits))) == Holds()
