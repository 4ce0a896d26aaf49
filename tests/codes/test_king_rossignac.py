"""King and Rossignac's code: bits written by hand, and every fault that bits can have."""

from itertools import pairwise, product

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes import king_rossignac as code
from clers.codes.code import Shape
from clers.codes.counts import Counts, counts_of, counts_of_word
from clers.complexes.surface import Face
from clers.complexes.topology import Component, components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSymbol, Where
from clers.edgebreaker.decode import decode as decode_word
from clers.edgebreaker.examples import ANNULUS, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import SYMBOLS, Stream

AFTER_C, FREE = Shape("C"), Shape("")


def bits(digits: str) -> Bits:
    """Bits as printed."""
    return pack(map(int, digits))


@pytest.mark.parametrize(
    ("symbols", "shape", "digits"),
    [
        ("RE", AFTER_C, "011101"),  # I takes 5, II and III 4
        ("RC", FREE, "001010"),  # I and II take 4, III 5
        ("LE", FREE, "101011"),  # 6, 5, 4
        ("CC", AFTER_C, "0000"),
        ("CS", FREE, "00010"),
        ("SRC", AFTER_C, "00101010"),  # I takes 2 + 3 + 1, II 2 + 2 + 2, III 2 + 3 + 2
        ("", AFTER_C, "00"),
    ],
)
def test_bits_by_hand(symbols: str, shape: Shape, digits: str) -> None:
    """CODE-KR-1, CODE-KR-2: the shortest, and of equal ones the first."""
    assert code.encode(symbols, shape) == Accepted(bits(digits))
    assert code.decode(bits(digits), len(symbols), shape) == Accepted(symbols)


@pytest.mark.parametrize(
    ("symbols", "shape", "at"),
    [("X", FREE, 0), ("L", AFTER_C, 0), ("RCE", FREE, 2), ("CL", AFTER_C, 1), ("CCRX", FREE, 3)],
)
def test_symbols_without_codeword(symbols: str, shape: Shape, at: int) -> None:
    """CODE-KR-1."""
    refused = code.encode(symbols, shape)
    assert isinstance(refused, Rejected)
    found = (refused.reason, refused.clause, refused.where)
    assert found == (Reason.NOT_IN_ALPHABET, Clause.CODE_KR_1, AtSymbol(at))


@pytest.mark.parametrize(
    ("digits", "count", "reason", "where", "detail"),
    [
        ("", 0, Reason.TRUNCATED_BITS, AtSymbol(0), "0 bits for 0 symbols"),
        ("1", 3, Reason.TRUNCATED_BITS, AtSymbol(0), "1 bits for 3 symbols"),
        ("11", 0, Reason.NOT_CANONICAL, WHOLE, "there is no code 3"),
        ("011101", 3, Reason.TRUNCATED_BITS, AtSymbol(2), "6 bits for 3 symbols"),
        ("01110", 2, Reason.TRUNCATED_BITS, AtSymbol(1), "5 bits for 2 symbols"),
        ("01110100", 2, Reason.TRAILING_BITS, WHOLE, "2 bits more than 2 symbols need"),
        ("0011111", 2, Reason.NOT_CANONICAL, WHOLE, "code 1 is shorter or comes first, 0 is used"),
        ("101111", 2, Reason.NOT_CANONICAL, WHOLE, "code 1 is shorter or comes first, 2 is used"),
    ],
)
def test_bits_that_no_encoder_writes(
    digits: str, count: int, reason: Reason, where: Where, detail: str
) -> None:
    """CODE-KR-3: after an implied C; 11 01 is RE in code II."""
    refused = code.decode(bits(digits), count, AFTER_C)
    expected = Rejected(reason, Clause.CODE_KR_3, where, detail)
    assert refused == expected


@pytest.mark.parametrize("shape", [FREE, AFTER_C])
@pytest.mark.parametrize("count", range(4))
def test_as_many_bits_as_words(count: int, shape: Shape) -> None:
    """CODE-KR-3: of all strings of bits those of the words without CL and CE, one each."""
    read: set[str] = set()
    for length in range(3 * count + 4):
        for digits in product("01", repeat=length):
            given = bits("".join(digits))
            found = code.decode(given, count, shape)
            if isinstance(found, Accepted):
                assert code.encode(found.value, shape) == Accepted(given)
                read.add(found.value)
    words = {"".join(w) for w in product(SYMBOLS, repeat=count)}
    allowed = {w for w in words if not {("C", "L"), ("C", "E")} & set(pairwise(shape.head + w))}
    assert read == allowed


def test_the_bound_by_hand() -> None:
    """CODE-KR-5, CODE-KR-6.

    Tetrahedron: 22 − 4 = 18, less 5 is 13, a third of it 4, and 2. The word CRE has no CS. Torus
    of 18 triangles: 99 − 4 + 12 = 107, less 5 is 102, a third 34. Annulus of 6 triangles, two
    curves of 3 edges: 33 + 15 − 12 + 12 = 48, a third 16.
    """
    assert code.bound(components(TETRAHEDRON)) == 6
    assert code.bound(components(TETRAHEDRON), 3) == 5
    assert code.sum_of_three(components(TORUS), 0) == 107
    assert code.bound(components(TORUS)) == 36
    assert code.bound(components(TORUS), 3) == 35
    assert code.bound(components(ANNULUS)) == 18
    assert code.CODE.guarantee.bits(components(TORUS)) == 36
    assert code.CODE.guarantee.text == "at most 11T/6 − 1 bits for a sphere of T triangles"


def test_what_a_reader_believes() -> None:
    """CODE-KR-7: reached by nothing but Cs in code I."""
    assert [code.most_symbols(n) for n in (0, 1, 2, 3, 9)] == [1, 1, 1, 2, 8]
    written = code.encode("C" * 7, AFTER_C)
    assert isinstance(written, Accepted)
    assert code.most_symbols(written.value.length) == 8


@pytest.mark.parametrize("m", [1, 84, 2000])
def test_the_family_that_comes_close(m: int) -> None:
    """CODE-KR-6: (CCCRLR)^m E takes 11m + 2 bits for 6m + 2 triangles, the bound less a bit.

    In six symbols CCCRLR: code I takes 1+1+1+2+3+3 but for the first C of all, II and III as much.
    """
    word = "CCCRLR" * m + "E"
    assert isinstance(decode_word(Stream(word)), Accepted)
    written = code.encode(word[1:], AFTER_C)
    assert isinstance(written, Accepted)
    assert written.value.length == 11 * m + 2
    assert (11 * (6 * m + 2) - 6) // 6 == 11 * m + 2


def part(triangles: int, genus: int = 0, curves: int = 0, edges: int = 0) -> Component:
    """A component by the counts that matter here."""
    return Component(Face(0), triangles, 0, 0, edges, curves, genus, 0)


def test_counts_by_hand() -> None:
    """CODE-COUNT-1, CODE-COUNT-2.

    Closed, T = 20, g = 2: n 19, #C 10 − 1 − 4, #S − #E 3. With boundary, T = 20, g = 2, b = 3,
    B = 10: n 20, #C 5 + 2 − 4 − 3, #S − #E 4 + 3 − 2. Both together are the sums.
    """
    assert counts_of((part(20, genus=2),)) == Counts(19, 5, 3)
    assert counts_of((part(20, 2, 3, 10),)) == Counts(20, 0, 5)
    assert counts_of((part(20, genus=2), part(20, 2, 3, 10))) == Counts(39, 5, 8)
    assert counts_of_word("CCSREE") == Counts(6, 2, -1)


def test_the_bound_is_tight_in_its_parts() -> None:
    """CODE-KR-6: T = 8 has 35 / 3, and with a CS 34 / 3; with boundary no C is implied.

    Sphere of 4 and disc of a triangle (11/2 + 15/2 − 12 + 6 = 7): 18 + 7 = 25, a third is 8.
    """
    assert [code.bound((part(8),), cs) for cs in (0, 2, 3)] == [13, 13, 12]
    assert code.bound((part(8),)) == 13
    assert code.bound((part(1, 0, 1, 3), part(4))) == 10
    assert code.bound((part(4), part(4))) == (18 + 18 - 5) // 3 + 2


def test_the_code_as_a_value() -> None:
    """CODE-KR-1, CODE-KR-7."""
    assert code.CODE.encode("RE", AFTER_C) == Accepted(bits("011101"))
    assert code.CODE.decode(bits("011101"), 2, AFTER_C) == Accepted("RE")
    assert code.CODE.most_symbols(9) == 8
