"""Laws run on toy domains, with examples that are known beforehand."""

from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from clers.conventions.clause import Clause
from clers.conventions.law import Given, Law, at_most, same
from clers.conventions.verdict import Holds, Verdict
from clers.conventions.where import AtFace
from clers.specification.judge import Failed, Held, Outcome, Unjudged, judge

NUMBERS = Given("numbers", "whole numbers", int)
WHOLE_NUMBERS = st.integers()


def below_a_hundred(number: int) -> Verdict:
    return same(True, number < 100, AtFace(7))


def divides(number: int) -> Verdict:
    return at_most(1.0, number / number)


def run(law: Law[int], strategy: SearchStrategy[object] | None, seed: int = 0) -> Outcome:
    return judge(law, strategy, 200, seed)


TOO_SMALL = Law("small", Clause.CONV_LAW_5, "they are small", NUMBERS, below_a_hundred)
RAISES = Law("raises", Clause.CONV_LAW_5, "they divide themselves", NUMBERS, divides)
TRUE = Law("true", Clause.CONV_LAW_5, "nothing is said", NUMBERS, lambda _: Holds())


def test_the_smallest_example_is_shown() -> None:
    """Clause: CONV-LAW-5."""
    assert run(TOO_SMALL, WHOLE_NUMBERS) == Failed("100", "True", "False", "at face 7")


def test_seed_decides() -> None:
    """Clause: CONV-LAW-5."""
    drawn: list[list[int]] = []

    def remember(number: int) -> Verdict:
        drawn[-1].append(number)
        return Holds()

    spy = Law("spy", Clause.CONV_LAW_5, "nothing is said", NUMBERS, remember)
    for seed in (1, 1, 2):
        drawn.append([])
        assert run(spy, WHOLE_NUMBERS, seed) == Held(200)
    assert drawn[0] == drawn[1] != drawn[2]


def test_a_small_domain_is_exhausted() -> None:
    """Clause: CONV-LAW-5."""
    assert run(TRUE, st.sampled_from((1, 2, 3))) == Held(3)


def test_no_generator_is_an_error() -> None:
    """Clause: CONV-LAW-5."""
    assert run(TRUE, None) == Unjudged("no generator for the domain numbers")


def test_an_empty_generator_is_an_error() -> None:
    """Clause: CONV-LAW-5."""
    nothing = Unjudged("the generator of numbers draws nothing")
    assert run(TRUE, st.nothing()) == nothing
    assert run(TRUE, WHOLE_NUMBERS.filter(lambda _: False)) == nothing


def test_a_broken_generator_is_an_error() -> None:
    """Clause: CONV-LAW-5."""
    broken = WHOLE_NUMBERS.map(lambda number: 1 // (number - number))
    text = "the generator of numbers raised ZeroDivisionError: integer division or modulo by zero"
    assert run(TRUE, broken) == Unjudged(text)


def test_a_generator_of_another_type_fails() -> None:
    """Clause: CONV-LAW-5."""
    assert run(TRUE, st.just("x")) == Failed("'x'", "int", "str", "of the whole input")


def test_a_law_that_raises_has_failed() -> None:
    """Clause: CONV-LAW-5."""
    raised = "raised ZeroDivisionError: division by zero"
    assert run(RAISES, WHOLE_NUMBERS) == Failed("0", "a verdict", raised, "of the whole input")


def test_a_law_with_a_memory_is_an_error() -> None:
    """Clause: CONV-LAW-5."""
    asked: list[int] = []

    def once(number: int) -> Verdict:
        asked.append(number)
        return same(True, len(asked) != 10)

    moody = Law("moody", Clause.CONV_LAW_5, "it holds but once", NUMBERS, once)
    text = "two verdicts on one example: the law or its generator is not pure"
    assert run(moody, WHOLE_NUMBERS) == Unjudged(text)
