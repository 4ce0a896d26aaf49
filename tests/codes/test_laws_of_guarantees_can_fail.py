"""Each law of the codes with guarantees finds a planted fault."""

from dataclasses import replace
from fractions import Fraction

import pytest

from clers.arithmetic.bits import pack
from clers.codes import king_rossignac, laws_guarantees, minimax
from clers.codes.code import Shape
from clers.codes.counts import Counts, counts_of
from clers.codes.laws_guarantees import LAWS
from clers.complexes.surface import Surface
from clers.complexes.topology import Component
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Fails, Holds
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import Stream

LAW = {law.name: law for law in LAWS}
EXAMPLES = (TETRAHEDRON, CUBE, TORUS, ANNULUS)
BY_NAME = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)


@BY_NAME
def test_all_hold_on_the_examples(law: AnyLaw) -> None:
    """CODE-COUNT-1, CODE-KR-5, CODE-MINIMAX-5: unless a fault is planted."""
    spheres = EXAMPLES[:2] if law.domain == "spheres" else EXAMPLES
    assert all(isinstance(law.check(surface), Holds) for surface in spheres)


@pytest.mark.parametrize("surface", [CUBE, TORUS, ANNULUS])
@pytest.mark.parametrize("field", ["symbols", "created", "split"])
def test_wrong_counts(monkeypatch: pytest.MonkeyPatch, surface: Surface, field: str) -> None:
    """CODE-COUNT-1: each count of each kind of surface."""

    def wrong(parts: tuple[Component, ...]) -> Counts:
        counts = counts_of(parts)
        return replace(counts, **{field: getattr(counts, field) + 1})

    monkeypatch.setattr(laws_guarantees, "counts_of", wrong)
    assert isinstance(LAW["counts-from-surface"].check(surface), Fails)


@pytest.mark.parametrize("word", ["CLE", "CE", "RC"])
def test_a_c_that_is_followed_by_something_else(monkeypatch: pytest.MonkeyPatch, word: str) -> None:
    """CODE-COUNT-2: by L, by E, by nothing."""

    def wrong(surface: Surface) -> object:
        found = encode_surface(surface)
        return replace(found, stream=Stream(word))

    monkeypatch.setattr(laws_guarantees, "encode_surface", wrong)
    assert isinstance(LAW["pairs-after-c"].check(CUBE), Fails)


@pytest.mark.parametrize("name", ["king-rossignac-sum-of-word", "king-rossignac-sum-of-surface"])
@pytest.mark.parametrize("surface", [CUBE, TORUS, ANNULUS])
def test_a_codeword_too_long(monkeypatch: pytest.MonkeyPatch, name: str, surface: Surface) -> None:
    """CODE-KR-4, CODE-KR-5: a codeword of one code with a bit more."""
    longer = ({**king_rossignac.OTHERWISE[0], "R": "1010"}, *king_rossignac.OTHERWISE[1:])
    monkeypatch.setattr(king_rossignac, "OTHERWISE", longer)
    assert isinstance(LAW[name].check(surface), Fails)


def test_not_the_shortest(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-KR-2: code I for the tetrahedron, which costs a bit more; and a bound too low."""
    law = LAW["king-rossignac-shortest"]
    with monkeypatch.context() as planted:
        planted.setattr(king_rossignac, "chosen", lambda symbols, head: 0)
        assert isinstance(law.check(TETRAHEDRON), Fails)
    monkeypatch.setattr(king_rossignac, "bound", lambda parts, cs: 5)
    assert isinstance(law.check(TETRAHEDRON), Fails)


def test_a_refusal_by_the_three_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-KR-1: R is missing from the table after C."""
    monkeypatch.setattr(king_rossignac, "AFTER_C", {"C": "0", "S": "10"})
    with pytest.raises(KeyError):
        king_rossignac.lengths("R", "C")
    found = LAW["king-rossignac-shortest"].check(TETRAHEDRON)
    assert isinstance(found, Fails)
    assert found.expected == "bits"


def test_a_sphere_that_costs_too_much(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-KR-6: the tetrahedron may take 6 bits, 4 besides the selector, and not 5."""
    law = LAW["king-rossignac-on-spheres"]
    monkeypatch.setattr(king_rossignac, "lengths", lambda symbols, head: (5, 5, 5))
    assert isinstance(law.check(TETRAHEDRON), Fails)
    monkeypatch.setattr(king_rossignac, "lengths", lambda symbols, head: (5, 4, 5))
    assert isinstance(law.check(TETRAHEDRON), Holds)


@pytest.mark.parametrize("which", [0, 1])
def test_a_minimax_code_that_promises_too_much(monkeypatch: pytest.MonkeyPatch, which: int) -> None:
    """CODE-MINIMAX-6: with half a bit a triangle less, each of them alone."""
    of = minimax.ALL[which]
    less = replace(of, rate=of.rate - Fraction(1, 2))
    planted = (less, *minimax.ALL[1:]) if which == 0 else (*minimax.ALL[:1], less)
    monkeypatch.setattr(minimax, "ALL", planted)
    assert isinstance(LAW["minimax-on-spheres"].check(CUBE), Fails)


def test_a_minimax_code_that_refuses_a_sphere(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-MINIMAX-5, CODE-MINIMAX-6: begun in the context after CCR, no E can come."""
    refused = minimax.encode(minimax.MINIMAX_3, "CCRE", Shape(""))
    monkeypatch.setattr(minimax, "encode", lambda of, symbols, shape: refused)
    assert isinstance(LAW["minimax-on-spheres"].check(CUBE), Fails)
    assert isinstance(LAW["minimax-refusals"].check(CUBE), Fails)
    assert isinstance(LAW["minimax-refusals"].check(TORUS), Holds)
    stranger = minimax.decode(minimax.MINIMAX_3, pack([]), 1, Shape(""))
    monkeypatch.setattr(minimax, "encode", lambda of, symbols, shape: stranger)
    assert isinstance(LAW["minimax-refusals"].check(TORUS), Fails)
