"""Minimax codes: bits written by hand, the page's tables, what is refused and what is promised."""

import re
from fractions import Fraction
from pathlib import Path

import pytest

from clers.arithmetic.bits import pack
from clers.codes.code import Shape
from clers.codes.factor_contexts import factor_contexts
from clers.codes.gibbs import gibbs, tables, weights
from clers.codes.minimax import (
    MINIMAX_3,
    MINIMAX_8,
    Minimax,
    bound,
    code,
    decode,
    encode,
    model,
    most_symbols,
)
from clers.complexes.surface import Face
from clers.complexes.topology import Component, components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.edgebreaker.decode import decode as decode_word
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import SYMBOLS, Stream

PAGE = Path(__file__).parents[2] / "spec/06-guarantees.md"
AFTER_C, FREE = Shape("C"), Shape("")
BOTH = pytest.mark.parametrize("of", [MINIMAX_3, MINIMAX_8], ids=["minimax-3", "minimax-8"])


def test_the_tetrahedron_by_hand() -> None:
    """CODE-MINIMAX-2, CODE-MINIMAX-4.

    In context 1 the R has 19528 to 28087 of 32768, then in context 0 the E 16570 to 25344: from
    0.7281 to 0.7979. A bit 1 is sure, two halvings go to the middle, 1000 ends: 0.75 is in it.
    """
    bits = encode(MINIMAX_3, "RE", AFTER_C)
    assert bits == Accepted(pack([1, 1, 0, 0, 0]))
    assert decode(MINIMAX_3, pack([1, 1, 0, 0, 0]), 2, AFTER_C) == Accepted("RE")


@BOTH
def test_the_page_has_the_tables(of: Minimax) -> None:
    """CODE-MINIMAX-2, CODE-MINIMAX-3: entry by entry."""
    clause = {3: "CODE-MINIMAX-2", 8: "CODE-MINIMAX-3"}[of.order]
    quote = PAGE.read_text(encoding="utf-8").split(f"**{clause}.**")[1].split("\n\n")[0]
    rows = [
        [cell.strip() for cell in line.split("|")[1:-1]]
        for line in quote.splitlines()
        if re.match(r"> \| \d", line)
    ]
    expected = [
        [str(q), word or "(none)"]
        + [f"{f} → {r}" if f else "–" for f, r in zip(row, successors, strict=True)]
        for q, (word, row, successors) in enumerate(
            zip(of.shortest, of.automaton.frequencies, of.automaton.successors, strict=True)
        )
    ]
    assert rows == expected


@BOTH
def test_where_the_model_begins(of: Minimax) -> None:
    """CODE-MINIMAX-4: in context 0, or where an implied C leads to; and each shortest word."""
    assert model(of, "").number == 0
    assert model(of, "C").number == of.shortest.index("C")
    for q, word in enumerate(of.shortest):
        found = model(of, "")
        for x in word:
            found = found.after(SYMBOLS.index(x))
        assert found.number == q
        assert found.cumulative[-1] == 32768


@BOTH
def test_what_is_refused(of: Minimax) -> None:
    """CODE-MINIMAX-4, CODE-MINIMAX-5: a stranger; the symbol that ends an impossible factor."""
    stranger = encode(of, "RXE", AFTER_C)
    assert isinstance(stranger, Rejected)
    found = (stranger.reason, stranger.clause, stranger.where)
    assert found == (Reason.NOT_IN_ALPHABET, Clause.CODE_MINIMAX_4, AtSymbol(1))
    for symbols, shape, at in (("CCRE", FREE, 3), ("CRE", AFTER_C, 2), ("L", AFTER_C, 0)):
        refused = encode(of, symbols, shape)
        assert isinstance(refused, Rejected)
        expected = (Reason.NOT_REPRESENTABLE, Clause.CODE_MINIMAX_5, AtSymbol(at))
        assert (refused.reason, refused.clause, refused.where) == expected
        assert refused.detail == "no sphere's word goes on like this"


def test_longer_contexts_refuse_more() -> None:
    """CODE-MINIMAX-1: CCSEE has five symbols, so that contexts of three do not know it."""
    assert isinstance(encode(MINIMAX_3, "CCSEE", FREE), Accepted)
    refused = encode(MINIMAX_8, "CCSEE", FREE)
    assert isinstance(refused, Rejected)
    assert refused.where == AtSymbol(4)


@BOTH
@pytest.mark.parametrize("surface", [TETRAHEDRON, CUBE])
def test_bits_are_read_strictly(of: Minimax, *, surface: object) -> None:
    """CODE-MINIMAX-4: one bit more or less, or another, is no word's code or another's."""
    assert surface in (TETRAHEDRON, CUBE)
    word = encode_surface(TETRAHEDRON if surface == TETRAHEDRON else CUBE).stream.word[1:]
    written = encode(of, word, AFTER_C)
    assert isinstance(written, Accepted)
    digits = list(written.value.values())
    longer, shorter = decode(of, pack([*digits, 0]), len(word), AFTER_C), pack(digits[:-1])
    assert isinstance(longer, Rejected)
    assert longer.reason is Reason.TRAILING_BITS
    assert isinstance(decode(of, shorter, len(word), AFTER_C), Rejected)
    for i in range(len(digits)):
        other = pack([*digits[:i], 1 - digits[i], *digits[i + 1 :]])
        found = decode(of, other, len(word), AFTER_C)
        assert not isinstance(found, Accepted) or found.value != word


def sphere(triangles: int) -> Component:
    """The counts of a sphere."""
    return Component(Face(0), triangles, triangles // 2 + 2, 3 * triangles // 2, 0, 0, 0, 2)


def test_what_is_promised_by_hand() -> None:
    """CODE-MINIMAX-6: 1.70696·4 − 0.98 = 5.85, 1.67613·4 − 0.30 = 6.40; for 8: 12.68, 13.11."""
    assert (MINIMAX_3.rate, MINIMAX_3.constant) == (Fraction("1.70696"), Fraction("-0.98"))
    assert (MINIMAX_8.rate, MINIMAX_8.constant) == (Fraction("1.67613"), Fraction("-0.30"))
    assert [bound(of, (sphere(4),)) for of in (MINIMAX_3, MINIMAX_8)] == [5, 6]
    assert [bound(of, (sphere(4), sphere(4))) for of in (MINIMAX_3, MINIMAX_8)] == [12, 13]
    for surface in (TORUS, ANNULUS):
        assert bound(MINIMAX_8, components(surface)) is None
        assert bound(MINIMAX_8, (sphere(4), *components(surface))) is None
    assert code(MINIMAX_3).guarantee.bits((sphere(4),)) == 5
    assert code(MINIMAX_8).guarantee.text == (
        "at most 1.67613·T − 0.3 bits for spheres of T triangles; other surfaces may be refused"
    )


@BOTH
@pytest.mark.parametrize("count", [1, 2, 25])
def test_several_spheres_together(of: Minimax, count: int) -> None:
    """CODE-MINIMAX-5, CODE-MINIMAX-6: tetrahedra and cubes, one after the other."""
    word = "CRE" * count + "CCCRCRRCRRE" * count
    assert isinstance(decode_word(Stream(word)), Accepted)
    written = encode(of, word[1:], AFTER_C)
    assert isinstance(written, Accepted)
    most = bound(of, (sphere(4), sphere(12)) * count)
    assert most is not None
    assert written.value.length <= most


@BOTH
def test_what_a_reader_believes(of: Minimax) -> None:
    """CODE-MINIMAX-7, CODE-NAME-3: each symbol costs over half a bit; Cs alone are believed."""
    assert [most_symbols(n) for n in (0, 1, 7)] == [1, 3, 15]
    assert all(2 * f * f < 32768**2 for row in of.automaton.frequencies for f in row)
    for length in (1, 2, 3000):
        written = encode(of, "C" * length, AFTER_C)
        assert isinstance(written, Accepted)
        assert length + 1 <= most_symbols(written.value.length) < 2 * length + 10


@pytest.mark.parametrize(
    ("order", "factors", "contexts", "rate"),
    [
        (0, (), ("",), 2.0),
        (1, ("CL", "CE"), ("", "C"), 1.7356047840765434),
    ],
)
def test_shorter_contexts_give_the_plain_and_golden_measures(
    order: int, factors: tuple[str, ...], contexts: tuple[str, ...], rate: float
) -> None:
    """CODE-MINIMAX-1, CODE-MINIMAX-2: 2 bits for no context, (5/2) log2 φ for one symbol.

    With no context: C 1/2 and the others 1/8 each. With one: powers of φ, as in CODE-GOLDEN-1.
    """
    del order
    found = factor_contexts(factors)
    assert found.shortest == contexts
    measure = gibbs(found.successors)
    assert abs(measure.symbol**2 / measure.creation - 2 ** (2 * rate)) < 1e-9
    rows = tables(found.successors, measure, 1000)
    expected = {
        0: ((500, 125, 125, 125, 125),),
        1: ((382, 146, 236, 146, 90), (618, 0, 0, 236, 146)),
    }[len(contexts) - 1]
    assert rows == expected


def test_the_code_as_a_value() -> None:
    """CODE-MINIMAX-4, CODE-MINIMAX-7: the tetrahedron as above."""
    of = code(MINIMAX_3)
    assert of.encode("RE", AFTER_C) == Accepted(pack([1, 1, 0, 0, 0]))
    assert of.decode(pack([1, 1, 0, 0, 0]), 2, AFTER_C) == Accepted("RE")
    assert of.most_symbols(7) == 15


def test_weights_in_the_order_of_symbols() -> None:
    """CODE-MINIMAX-2."""
    assert weights(3.0, 4.0) == (3.0, 1.0, 0.25, 1.0, 4.0)


def test_contexts_of_other_factors() -> None:
    """CODE-MINIMAX-1: by hand. After E, and after ES, L is ruled out; C forgets both."""
    found = factor_contexts(("EL", "ESL"))
    assert found.shortest == ("", "E", "ES")
    assert found.successors == ((0, 0, 1, 0, 0), (0, -1, 1, 0, 2), (0, -1, 1, 0, 0))
    # R and S before an L do the same, so that they are one context.
    both = factor_contexts(("RL", "SL"))
    assert both.shortest == ("", "R")
    assert both.successors == ((0, 0, 0, 1, 1), (0, -1, 0, 1, 1))
