"""Laws of bits and of the exact coder."""

from fractions import Fraction
from itertools import pairwise, product
from typing import Final

from clers.arithmetic import exact
from clers.arithmetic.bits import Bits, pack, packed
from clers.arithmetic.given import BITS, DECLARED, JOINED, Declared, Joined
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.information.given import MESSAGE, SMALL, TABLE, Message, Small, Table
from clers.information.laws_measure import all_messages
from clers.information.measure import probability
from clers.information.model import Slot, cumulative


def _bits_are_a_string(given: Bits) -> Verdict:
    """Clauses: ARITH-BITS-1, ARITH-BITS-2."""
    digits = given.digits()
    by_hand = bytes(
        sum(1 << (7 - place) for place, digit in enumerate(digits[at : at + 8]) if digit == "1")
        for at in range(0, len(digits), 8)
    )
    twice = given.followed_by(given)
    return every(
        same((given.length, by_hand), (len(digits), given.data)),
        same([int(digit) for digit in digits], list(given.values())),
        same(given, pack(given.values())),
        same(digits + digits, twice.digits()),
    )


def _declared_bits_are_checked(given: Declared) -> Verdict:
    """Clause: ARITH-BITS-3."""
    got = packed(given.data, given.length)
    fits = given.length >= 0 and len(given.data) == -(-given.length // 8)
    digits = "".join(f"{byte:08b}" for byte in given.data)
    good = fits and "1" not in digits[given.length :]
    if isinstance(got, Rejected):
        short = given.length < 0 or 8 * len(given.data) < given.length
        reason = "truncated-bits" if short else "trailing-bits"
        return same((False, reason), (good, got.reason))
    return same((True, digits[: given.length]), (good, got.value.digits()))


def _subdivision_is_a_partition(given: Table) -> Verdict:
    """Clauses: ARITH-EXACT-1, ARITH-EXACT-4."""
    whole = exact.Interval(Fraction(2, 7), Fraction(3, 11))
    table = cumulative(given.frequencies)
    parts = [whole.part(Slot(below, upto, table[-1])) for below, upto in pairwise(table)]
    shares = [Fraction(f, sum(given.frequencies)) for f in given.frequencies]
    return every(
        same(whole.low, parts[0].low),
        same([part.high for part in parts], [part.low for part in parts[1:]] + [whole.high]),
        same(shares, [part.width / whole.width for part in parts]),
    )


def _width_is_the_probability(given: Message) -> Verdict:
    """Clauses: ARITH-EXACT-1, ARITH-EXACT-4."""
    trace = exact.intervals(given.model, given.symbols)
    if isinstance(trace, Rejected):
        return Fails("intervals", trace.line(), WHOLE)
    nested = all(a.low <= b.low and b.high <= a.high for a, b in pairwise(trace.value))
    return every(
        same(True, nested),
        same(probability(given.model, given.symbols), Accepted(trace.value[-1].width)),
    )


def _exact_bits_are_shortest(given: Small) -> Verdict:
    """Clause: ARITH-EXACT-2. All strings of up to 8 bits are tried."""
    for symbols in all_messages(given):
        target, got = exact.interval(given.model, symbols), exact.encode(given.model, symbols)
        if isinstance(target, Rejected) or isinstance(got, Rejected):
            return Fails("bits", f"{target}, {got}", WHOLE)
        low, high = target.value.low, target.value.high
        if target.value.width < Fraction(1, 64):
            continue  # the shortest may have more than 8 bits
        inside = (
            "".join(word)
            for length in range(9)
            for word in product("01", repeat=length)
            if low <= _number(word) and _number(word) + Fraction(1, 2**length) <= high
        )
        verdict = same(next(inside), got.value.digits())
        if isinstance(verdict, Fails):
            return verdict
    return Holds()


def _number(word: tuple[str, ...]) -> Fraction:
    """0.b1b2b3… as a sum."""
    return sum((Fraction(1, 2**k) for k, b in enumerate(word, 1) if b == "1"), Fraction(0))


def _exact_round_trip(given: Joined) -> Verdict:
    """Clause: ARITH-EXACT-3."""
    coded = exact.encode(given.model, given.symbols)
    if isinstance(coded, Rejected):
        return Fails("bits", coded.line(), WHOLE)
    count = len(given.symbols)
    return every(
        same(Accepted(given.symbols), exact.decode(given.model, coded.value, count)),
        same(
            Accepted(given.symbols),
            exact.decode(given.model, coded.value.followed_by(given.tail), count),
        ),
    )


def _exact_length(given: Message) -> Verdict:
    """Clause: ARITH-EXACT-5."""
    coded = exact.encode(given.model, given.symbols)
    chance = probability(given.model, given.symbols)
    if isinstance(coded, Rejected) or isinstance(chance, Rejected):
        return Fails("bits", f"{coded}, {chance}", WHOLE)
    share = Fraction(1, 2**coded.value.length)
    return same((True, True), (share <= chance.value, chance.value < 4 * share))


LAWS_OF_EXACT: Final[tuple[AnyLaw, ...]] = (
    Law(
        "bits-are-a-string",
        Clause.ARITH_BITS_2,
        "bits are packed from the most significant on, filled with zeros, and come back",
        BITS,
        _bits_are_a_string,
    ),
    Law(
        "declared-bits-are-checked",
        Clause.ARITH_BITS_3,
        "bytes are accepted as L bits exactly if their number fits and the filling is zero",
        DECLARED,
        _declared_bits_are_checked,
    ),
    Law(
        "exact-subdivision-is-a-partition",
        Clause.ARITH_EXACT_4,
        "the parts of an interval follow each other, fill it, and have their shares",
        TABLE,
        _subdivision_is_a_partition,
    ),
    Law(
        "exact-width-is-the-probability",
        Clause.ARITH_EXACT_4,
        "the intervals are nested, and the last is as wide as the message is probable",
        MESSAGE,
        _width_is_the_probability,
    ),
    Law(
        "exact-bits-are-shortest",
        Clause.ARITH_EXACT_2,
        "the exact code is the first of all strings, by length and then by value, that fits",
        SMALL,
        _exact_bits_are_shortest,
    ),
    Law(
        "exact-round-trip",
        Clause.ARITH_EXACT_3,
        "the exact code, with or without bits after it, decodes to the message",
        JOINED,
        _exact_round_trip,
    ),
    Law(
        "exact-length-within-two-bits",
        Clause.ARITH_EXACT_5,
        "I ≤ L < I + 2 for the exact code",
        MESSAGE,
        _exact_length,
    ),
)
