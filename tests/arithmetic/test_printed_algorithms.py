"""Why Algorithms 1 and 2 are not taken as printed: the smallest messages that show it.

Intervals are pairs of fractions; the steps are those of the print, each alone.
"""

from fractions import Fraction
from typing import Final

from clers.arithmetic import coder, exact
from clers.arithmetic.bits import pack
from clers.conventions.result import Accepted
from clers.information.model import cumulative
from clers.information.static import Static

HALF: Final = Fraction(1, 2)

Ends = tuple[Fraction, Fraction]


def printed_search(chances: tuple[Fraction, ...], number: Fraction) -> int:
    """Algorithm 1, lines 5 to 11: the index that the loop leaves behind."""
    count, found = chances[0], 0
    for found in range(1, len(chances)):
        if number < count:
            break
        count += chances[found]
    return found


def test_the_search_finds_the_symbol_after() -> None:
    """ARITH-EXACT-3. Two symbols of 1/2: 0 lies in the part of the first; printed, the second."""
    assert printed_search((HALF, HALF), Fraction(0)) == 1
    assert exact.decode(Static((0, 1, 2)), pack([0]), 1) == Accepted((0,))


def test_the_part_is_not_scaled() -> None:
    """ARITH-EXACT-1. With 1/3, 2/3 the second symbol and then the first must lie in [1/3, 1)."""
    model = Static(cumulative((1, 2)))
    assert exact.interval(model, (1, 0)) == Accepted(exact.Interval(Fraction(1, 3), Fraction(2, 9)))
    printed = (Fraction(0), Fraction(1, 3))  # Σ p up to the symbol, whatever came before
    assert not (Fraction(1, 3) <= printed[0] and printed[1] <= 1)


def test_the_loop_doubles_what_no_case_fits() -> None:
    """ARITH-SHIFT-1. [1/5, 11/20) holds 1/2 and is shorter than it: printed, it is doubled."""
    low, high = Fraction(1, 5), Fraction(11, 20)
    enters = not low <= HALF < high or high - low < HALF
    lower, upper = high <= HALF, low >= HALF
    central = low >= Fraction(1, 4) and high <= Fraction(3, 4)
    assert enters
    assert (lower, upper, central) == (False, False, False)
    assert 2 * high > 1


def test_a_central_half_scaled_by_four_leaves_the_unit_interval() -> None:
    """ARITH-SHIFT-1. The text scales by four, Algorithm 2 by two: the text is wrong."""
    low, high = Fraction(1, 4), Fraction(3, 4)
    assert 4 * (high - low) > 1
    assert 2 * (low - Fraction(1, 4)) == 0
    assert 2 * (high - Fraction(1, 4)) == 1


def test_pending_bits_are_opposite() -> None:
    """ARITH-SHIFT-2. [1/4, 3/4) and then its lower half is [1/4, 1/2): 01, and not 00."""
    model = Static(cumulative((1, 2, 1)))
    target = exact.interval(model, (1, 0))
    assert target == Accepted(exact.Interval(Fraction(1, 4), Fraction(1, 8)))
    coded = coder.encode(model, (1, 0))
    assert isinstance(coded, Accepted)
    assert coded.value.digits().startswith("010")  # [1/4, 3/8)
    repeated = exact.number_of(pack([0, 0, *[1] * 50]))  # the most that 00… can name
    assert repeated < Fraction(1, 4)


def test_nothing_sent_at_the_end_is_not_enough() -> None:
    """ARITH-END-1. With 1/4, 3/4 the second symbol leaves [1/4, 1) and sends nothing: 0."""
    model = Static(cumulative((1, 3)))
    read = coder.read(model, pack([]), 1)
    assert isinstance(read, Accepted)
    assert read.value.symbols == (0,)
    assert coder.encode(model, (1,)) == Accepted(pack([1, 0]))
