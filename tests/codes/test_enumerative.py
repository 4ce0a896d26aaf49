"""Spheres at the limit: bits by hand, the bound on all small spheres, what is refused."""

from fractions import Fraction
from math import comb, log2

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes.closings import closings
from clers.codes.code import Shape
from clers.codes.enumerative import BACK, CODE, FRONT, decode, encode, most_bits, most_symbols
from clers.codes.laws_enumerative import CLOSED, LAWS, damaged
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSymbol
from clers.edgebreaker.encode import encode as stream_of
from clers.edgebreaker.examples import ANNULUS, TETRAHEDRON, TORUS
from clers.edgebreaker.grammar import sphere_words
from clers.generate.uniform import uniform_sphere
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)


def bits(digits: str) -> Bits:
    return pack(map(int, digits))


def written(word: str) -> Bits:
    done = encode(word[1:], CLOSED)
    assert isinstance(done, Accepted)
    return done.value


def test_the_tetrahedron_is_the_end_of_a_message_of_no_bits() -> None:
    """CODE-ENUM-2: of 1000 nothing is coded; the coder ends with 01."""
    assert list(FRONT + BACK) == [1, 0, 0, 0]
    assert written("CRE") == bits("01")
    assert decode(bits("01"), 2, CLOSED) == Accepted("RE")


def test_five_vertices_by_hand() -> None:
    """CODE-ENUM-2: the tree words are 10 and 0100, 0010 or 1000, and 00.

    The urn has three zeros and a one. In quarters of the interval: 1000 is the last, 0100 the
    third, 0010 the second, 0001 (no tree word) the first. A quarter is two bits, after which the
    interval is whole and the end is 01.
    """
    assert {written(word).digits() for word in sphere_words(5)} == {"1101", "1001", "0101"}
    refused = decode(bits("0001"), 4, CLOSED)
    expected = "the root has its two leaves already"
    assert refused == Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, AtSymbol(4), expected)


@pytest.mark.parametrize("vertices", [4, 5, 6, 7, 8])
def test_all_small_spheres(vertices: int) -> None:
    """CODE-ENUM-2 … CODE-ENUM-5: each has its own bits, within both bounds, and they come back."""
    k, t = vertices - 4, 2 * vertices - 4
    seen: set[Bits] = set()
    for word in sphere_words(vertices):
        found = written(word)
        assert decode(found, t - 2, CLOSED) == Accepted(word[1:])
        assert found.length <= log2(comb(4 * k, k)) + 2 + k / 10**6
        assert found.length <= Fraction("1.622557") * t - Fraction("4.49")
        assert found.length <= (CODE.guarantee.bits(components(uniform_sphere(vertices, 0))) or 0)
        assert t - 1 <= most_symbols(found.length)
        seen.add(found)
    assert len(seen) == len(list(sphere_words(vertices)))


def test_the_two_bounds_of_every_size() -> None:
    """CODE-ENUM-4: log2 C(4k, k) + 2 + k/10^6 is at most 1.622557·T − 4.49, in whole numbers.

    C(4k, k) ≤ (256/27)^k, so the difference is at least 2.000228 − 2 + k (3.245114 − 10^-6 −
    log2 256/27), and the last is positive if 2^3.245113 > 256/27.
    """
    assert 2 ** Fraction(3245113, 10**6) > 256 / 27 * (1 + 1e-7)
    for k in range(60):
        assert 27**k * comb(4 * k, k) <= 256**k
        t = 2 * k + 4
        room = Fraction("1.622557") * t - Fraction("4.49") - 2 - Fraction(k, 10**6)
        assert log2(comb(4 * k, k)) <= room


def test_what_is_promised_to_a_sphere_and_to_nothing_else() -> None:
    """CODE-ENUM-4: 1.622557 · 4 − 4.49 = 2.0002; of 1996 faces 3234.13."""
    assert most_bits(components(TETRAHEDRON)) == 2
    assert most_bits(components(uniform_sphere(1000, 1))) == 3234
    for other in (TORUS, ANNULUS):
        assert most_bits(components(other)) is None
    assert most_bits(components(TETRAHEDRON) * 2) is None
    assert CODE.guarantee.bits is most_bits


def test_a_large_sphere_costs_what_its_urn_costs() -> None:
    """CODE-ENUM-4: no more than two bits and a millionth over, and not two less."""
    word = stream_of(uniform_sphere(3000, 7)).stream.word
    found = written(word)
    ideal = log2(comb(4 * 2996, 2996))
    assert ideal - 1 < found.length <= ideal + 2 + 2996 / 10**6
    assert decode(found, len(word) - 1, CLOSED) == Accepted(word[1:])


def test_a_long_string_of_bits_is_believed() -> None:
    """CODE-ENUM-5."""
    assert [most_symbols(n) for n in (2, 3, 10)] == [5, 6, 13]
    assert CODE.most_symbols is most_symbols


def test_other_surfaces_are_refused() -> None:
    """CODE-ENUM-1."""
    curved = stream_of(ANNULUS).stream
    seen = closings(curved)
    assert isinstance(seen, Accepted)
    no_sphere = Rejected(
        Reason.NOT_REPRESENTABLE, Clause.CODE_ENUM_1, WHOLE, "no sphere: it has boundary or handles"
    )
    assert encode(curved.word, Shape("", seen.value)) == no_sphere
    assert decode(bits("01"), 2, Shape("", ())) == no_sphere
    torus = stream_of(TORUS).stream
    handles = closings(torus)
    assert isinstance(handles, Accepted)
    assert encode(torus.word[1:], Shape("C", handles.value)) == no_sphere
    assert decode(bits("01"), 2, Shape("C", handles.value)) == no_sphere
    two = encode("RECRE", CLOSED)
    assert two == Rejected(
        Reason.NOT_REPRESENTABLE, Clause.CODE_ENUM_1, WHOLE, "no sphere: it has several components"
    )


@pytest.mark.parametrize("count", [0, 1, 3, 5])
def test_numbers_of_symbols_that_no_sphere_has(count: int) -> None:
    """CODE-ENUM-1."""
    expected = f"no sphere: no sphere has {count + 2} faces"
    refused = decode(bits("01"), count, CLOSED)
    assert refused == Rejected(Reason.NOT_REPRESENTABLE, Clause.CODE_ENUM_1, WHOLE, expected)


def test_the_urn_has_2_to_the_30_at_most() -> None:
    """CODE-ENUM-2, INFO-MODEL-6: of n symbols it has 2n - 4."""
    refused = decode(bits("01"), 2**29 + 4, CLOSED)
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.clause) == (Reason.BAD_TABLE, Clause.INFO_MODEL_6)
    assert refused.where == AtSymbol(0)
    refused = decode(bits("01"), 2**29 + 2, CLOSED)
    assert isinstance(refused, Rejected)
    assert refused.clause is Clause.ARITH_STRICT_2


def test_words_of_no_surface_are_refused_by_the_grammar() -> None:
    """CODE-ENUM-1: a reversed C needs a loop of four at least."""
    refused = encode("E", CLOSED)
    assert isinstance(refused, Rejected)
    assert refused.clause is Clause.EB_GRAMMAR_5


def test_bits_too_many_and_too_few() -> None:
    """CODE-ENUM-3."""
    found = written("CCRRE")
    reasons = [
        result.reason if isinstance(result, Rejected) else None
        for result in (decode(other, 4, CLOSED) for other in damaged(found)[-3:])
    ]
    assert reasons == [Reason.TRAILING_BITS, Reason.TRAILING_BITS, Reason.TRUNCATED_BITS]
    assert len(damaged(found)) == found.length + 3
