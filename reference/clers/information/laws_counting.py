"""Laws of enumeration, runs and codes of numbers."""

from fractions import Fraction
from itertools import groupby, permutations
from math import comb
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, AtSymbol, Where
from clers.information import canonical, enumerative, huffman, numbers, runs
from clers.information.given_counting import (
    ANY_RANK,
    ANY_RUNS,
    RANKED,
    WRITTEN,
    Ranked,
    RunsRequest,
    Unranked,
    Written,
)
from clers.information.laws_measure import along
from clers.information.measure import probability
from clers.information.model import has_ended


def _rejected(got: object, reason: Reason, where: Where) -> Verdict:
    """It is rejected for this reason, here."""
    if isinstance(got, Rejected):
        return same((reason, where), (got.reason, got.where))
    return Fails(f"{reason}", repr(got), where)


def _ranks_count_what_is_before(given: Ranked) -> Verdict:
    """Clauses: INFO-ENUM-1, INFO-ENUM-2, INFO-ENUM-4: by listing."""
    counts = tuple(given.symbols.count(symbol) for symbol in range(given.size))
    words = sorted(set(permutations(given.symbols)))
    place = words.index(given.symbols)
    digits = f"{place:b}".zfill((len(words) - 1).bit_length()) if len(words) > 1 else ""
    return every(
        same(len(words), enumerative.rearrangements(counts)),
        same(Accepted(place), enumerative.rank(given.size, given.symbols)),
        same(Accepted(given.symbols), enumerative.unrank(counts, place)),
        same(Accepted(digits), enumerative.encode(given.size, given.symbols)),
        same(Accepted(given.symbols), enumerative.decode(counts, digits)),
    )


def _binary_ranks_are_sums_of_binomials(given: Ranked) -> Verdict:
    """Clause: INFO-ENUM-3, of the word that says which symbols are odd."""
    word = [symbol % 2 for symbol in given.symbols]
    behind = [place for place, symbol in enumerate(reversed(word)) if symbol == 1]
    total = sum(comb(r, i) for i, r in enumerate(behind, 1))
    return same(Accepted(total), enumerative.rank(2, word))


def _ranks_are_read_strictly(given: Unranked) -> Verdict:
    """Clause: INFO-ENUM-4."""
    got = enumerative.decode(given.counts, given.digits)
    negative = [symbol for symbol, count in enumerate(given.counts) if count < 0]
    if negative:
        return _rejected(got, Reason.BAD_TABLE, AtSymbol(negative[0]))
    strange = [place for place, digit in enumerate(given.digits) if digit not in "01"]
    if strange:
        return _rejected(got, Reason.BAD_NUMBER, AtSymbol(strange[0]))
    words = enumerative.rearrangements(given.counts)
    long = 0
    while 2**long < words:
        long += 1
    if len(given.digits) != long:
        short = len(given.digits) < long
        return _rejected(got, Reason.TRUNCATED_BITS if short else Reason.TRAILING_BITS, WHOLE)
    if int("0" + given.digits, 2) >= words:
        return _rejected(got, Reason.NOT_CANONICAL, WHOLE)
    if isinstance(got, Rejected):
        return Fails("a word", got.line(), WHOLE)
    counts = tuple(got.value.count(symbol) for symbol in range(len(given.counts)))
    return every(
        same(given.counts, counts),
        same(Accepted(given.digits), enumerative.encode(len(given.counts), got.value)),
    )


def _rearrangements_are_near_entropy(given: Ranked) -> Verdict:
    """Clause: INFO-ENUM-5, in integers: 2^(n·H) = n^n / Π c^c."""
    counts = [given.symbols.count(symbol) for symbol in range(given.size)]
    many = [count * 7**5 for count in counts]
    verdicts: list[Verdict] = []
    for row in (counts, many if sum(counts) < 3 else counts):
        count, powers = sum(row), 1
        for each in row:
            powers *= each**each
        words = enumerative.rearrangements(row) * powers
        splits = comb(count + given.size - 1, given.size - 1)
        verdicts.append(same(True, words <= count**count <= words * splits))
    return every(*verdicts)


def _urns_give_all_words_alike(given: Ranked) -> Verdict:
    """Clause: INFO-ENUM-6."""
    counts = tuple(given.symbols.count(symbol) for symbol in range(given.size))
    urn, words = enumerative.Urn(counts), enumerative.rearrangements(counts)
    low, width = Fraction(0), Fraction(1)
    trace = along(urn, given.symbols)
    for here, symbol in zip(trace, given.symbols, strict=False):
        table = here.cumulative
        low += width * Fraction(table[symbol], table[-1])
        width *= Fraction(table[symbol + 1] - table[symbol], table[-1])
    ended = [has_ended(here) for here in trace]
    return every(
        same(Accepted(Fraction(1, words)), probability(urn, given.symbols)),
        same(enumerative.rank(given.size, given.symbols), Accepted(low / width)),
        same([False] * len(given.symbols) + [True], ended),
    )


def _runs_are_maximal(given: RunsRequest) -> Verdict:
    """Clauses: INFO-RUN-1, INFO-RUN-2."""
    got = runs.joined(given.parts, given.count)
    for index, (symbol, length) in enumerate(given.parts):
        if length < 1 or (index > 0 and given.parts[index - 1].symbol == symbol):
            return _rejected(got, Reason.NOT_CANONICAL, AtSymbol(index))
    message = tuple(symbol for symbol, length in given.parts for _ in range(length))
    if len(message) != given.count:
        return _rejected(got, Reason.COUNT_MISMATCH, WHOLE)
    grouped = tuple((symbol, len(tuple(run))) for symbol, run in groupby(message))
    return every(
        same(Accepted(message), got),
        same(given.parts, runs.runs(message)),
        same(grouped, given.parts),
    )


def _numbers_come_back(given: Written) -> Verdict:
    """Clauses: INFO-NUMBER-1, INFO-NUMBER-2, INFO-NUMBER-3."""
    verdicts: list[Verdict] = []
    for number in given.numbers:
        one, other = numbers.gamma(number), numbers.golomb(given.parameter, number)
        if isinstance(one, Rejected) or isinstance(other, Rejected):
            return Fails("digits", f"{one}, {other}", WHOLE)
        before, after = given.digits[:3], given.digits[3:]
        verdicts += [
            same(2 * len(f"{number + 1:b}") - 1, len(one.value)),
            same(f"{number + 1:b}", one.value.lstrip("0")),
            same(
                Accepted(numbers.Read(number, len(before + one.value))),
                numbers.read_gamma(before + one.value + after, len(before)),
            ),
            same(
                Accepted(numbers.Read(number, len(before + other.value))),
                numbers.read_golomb(given.parameter, before + other.value + after, len(before)),
            ),
        ]
    return every(*verdicts)


def _any_digits_read_as_numbers(given: Written) -> Verdict:
    """Clause: INFO-NUMBER-3: what is read is what is written; all else ends too soon, or is odd."""
    verdicts: list[Verdict] = []
    readings = (
        (numbers.read_gamma(given.digits), numbers.gamma),
        (
            numbers.read_golomb(given.parameter, given.digits),
            lambda number: numbers.golomb(given.parameter, number),
        ),
    )
    strange = [place for place, digit in enumerate(given.digits) if digit not in "01"]
    for got, write in readings:
        if isinstance(got, Accepted):
            verdicts.append(same(Accepted(given.digits[: got.value.end]), write(got.value.value)))
        elif got.reason == Reason.BAD_NUMBER:
            verdicts.append(same([got.where], [AtSymbol(place) for place in strange[:1]]))
        else:
            last = AtSymbol(len(given.digits))
            verdicts.append(
                same((Reason.TRUNCATED_BITS, last, []), (got.reason, got.where, strange))
            )
    return every(*verdicts)


def _remainders_are_huffman(given: Written) -> Verdict:
    """Clause: INFO-NUMBER-2."""
    size = min(given.parameter, 40)
    words = [numbers.golomb(size, rest) for rest in range(size)]
    tails = tuple(word.value[1:] for word in words if isinstance(word, Accepted))
    lengths = [len(tail) for tail in tails]
    even = huffman.huffman_lengths((1,) * size)
    code = canonical.canonical(lengths)
    if isinstance(even, Rejected) or isinstance(code, Rejected):
        return Fails("codes", f"{even}, {code}", WHOLE)
    heads = [numbers.golomb(size, size * ones) for ones in range(4)]
    return every(
        same(tails, code.value.words),
        same(lengths, sorted(length for length in even.value if length is not None)),
        same(
            ["1" * ones + "0" + tails[0] for ones in range(4)],
            [head.value for head in heads if isinstance(head, Accepted)],
        ),
    )


def _unwritable_numbers_are_rejected(given: Written) -> Verdict:
    """Clause: INFO-NUMBER-3."""
    below = -1 - (given.numbers[0] if given.numbers else 0)
    over = given.parameter << 20
    return every(
        _rejected(numbers.gamma(below), Reason.NOT_IN_ALPHABET, WHOLE),
        _rejected(numbers.golomb(given.parameter, below), Reason.NOT_IN_ALPHABET, WHOLE),
        _rejected(numbers.golomb(given.parameter, over), Reason.NOT_IN_ALPHABET, WHOLE),
        _rejected(numbers.golomb(below + 1, 0), Reason.BAD_TABLE, WHOLE),
        _rejected(numbers.read_golomb(below + 1, given.digits), Reason.BAD_TABLE, WHOLE),
    )


LAWS_OF_COUNTING: Final[tuple[AnyLaw, ...]] = (
    Law(
        "ranks-count-what-is-before",
        Clause.INFO_ENUM_1,
        "the rank of a word is its place in the sorted list of its rearrangements, and back",
        RANKED,
        _ranks_count_what_is_before,
    ),
    Law(
        "binary-ranks-are-sums-of-binomials",
        Clause.INFO_ENUM_3,
        "the rank of a word of zeros and ones is the sum of C(r_i, i)",
        RANKED,
        _binary_ranks_are_sums_of_binomials,
    ),
    Law(
        "ranks-are-read-strictly",
        Clause.INFO_ENUM_4,
        "digits are the code of one word with the counts, or the first fault is named",
        ANY_RANK,
        _ranks_are_read_strictly,
    ),
    Law(
        "rearrangements-are-near-entropy",
        Clause.INFO_ENUM_5,
        "N ≤ 2^(n·H) ≤ N·C(n + k - 1, k - 1), as inequalities of integers",
        RANKED,
        _rearrangements_are_near_entropy,
    ),
    Law(
        "urns-give-all-words-alike",
        Clause.INFO_ENUM_6,
        "under the urn a word has the probability 1/N, its rank over N as lower end, and an end",
        RANKED,
        _urns_give_all_words_alike,
    ),
    Law(
        "runs-are-maximal",
        Clause.INFO_RUN_1,
        "pairs are joined exactly if they are the runs of so many symbols, and come back",
        ANY_RUNS,
        _runs_are_maximal,
    ),
    Law(
        "numbers-come-back",
        Clause.INFO_NUMBER_1,
        "gamma and Golomb codes are read back from amid other digits, with the place behind",
        WRITTEN,
        _numbers_come_back,
    ),
    Law(
        "any-digits-read-as-numbers",
        Clause.INFO_NUMBER_3,
        "digits read as the number whose code they begin with, or end too soon, or are none",
        WRITTEN,
        _any_digits_read_as_numbers,
    ),
    Law(
        "golomb-remainders-are-huffman",
        Clause.INFO_NUMBER_2,
        "remainders have the canonical code of Huffman's lengths of equal frequencies",
        WRITTEN,
        _remainders_are_huffman,
    ),
    Law(
        "unwritable-numbers-are-rejected",
        Clause.INFO_NUMBER_3,
        "negative numbers, quotients of 2^20 and parameters below 1 are rejected",
        WRITTEN,
        _unwritable_numbers_are_rejected,
    ),
)
