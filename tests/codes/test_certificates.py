"""The certificates beside the notes, checked from the files; and that a wrong one is found out."""

import json
from dataclasses import replace
from decimal import Decimal, localcontext
from fractions import Fraction
from pathlib import Path

import pytest

from clers.codes import charges, golden, king_rossignac, minimax
from clers.codes.certificates import (
    Breach,
    Certificate,
    breaches,
    constant,
    log2_above,
    rate,
    weight,
)
from clers.codes.charges import Charges, mischarged
from clers.codes.factor_contexts import factor_contexts
from clers.codes.factors import impossible
from clers.codes.gibbs import gibbs, tables
from clers.codes.minimax import MINIMAX_3, MINIMAX_8, Minimax
from clers.edgebreaker.grammar import sphere_words
from clers.edgebreaker.stream import SYMBOLS

DIRECTORY = Path(__file__).parents[2] / "proofs_notes/certificates"
BOTH = pytest.mark.parametrize("of", [MINIMAX_3, MINIMAX_8], ids=["minimax-3", "minimax-8"])
SUM = 32768


def content(name: str) -> dict[str, object]:
    """A certificate's file."""
    found = json.loads((DIRECTORY / f"{name}.json").read_text(encoding="utf-8"))
    assert isinstance(found, dict)
    assert found["code"] == name
    return found


def texts(of: object) -> tuple[str, ...]:
    """A list of texts."""
    assert isinstance(of, list)
    return tuple(map(str, of))


def factors(of: Minimax) -> tuple[str, ...]:
    """The impossible factors that the contexts of a code rest on."""
    return texts(content(f"minimax-{of.order}")["factors"])


def certificate(of: Minimax) -> Certificate:
    """The certificate of a code, from its file."""
    found = content(f"minimax-{of.order}")
    names = ("symbol", "creation", "split")
    symbol, creation, split = (Fraction(str(found[name])) for name in names)
    return Certificate(symbol, creation, split, tuple(map(Fraction, texts(found["potential"]))))


@BOTH
def test_the_factors_are_impossible(of: Minimax) -> None:
    """CODE-FACTOR-2, CODE-FACTOR-3, CODE-CERTIFICATE-4: each, and none within another."""
    given = factors(of)
    assert all(map(impossible, given))
    assert all(not impossible(factor[1:]) and not impossible(factor[:-1]) for factor in given)
    lengths = [len(factor) for factor in given]
    counts = {2: 2, 4: 1} if of.order == 3 else {2: 2, 4: 1, 5: 1, 6: 5, 7: 9, 8: 38, 9: 97}
    assert {n: lengths.count(n) for n in set(lengths)} == counts


@BOTH
def test_the_contexts_are_those_of_the_factors(of: Minimax) -> None:
    """CODE-MINIMAX-1: the smallest automaton; 4 contexts and 37."""
    found = factor_contexts(factors(of))
    assert found.shortest == of.shortest
    assert found.successors == of.automaton.successors
    assert len(of.shortest) == {3: 4, 8: 37}[of.order]


@BOTH
def test_the_tables_are_the_rounded_measure(of: Minimax) -> None:
    """CODE-MINIMAX-2, CODE-MINIMAX-3: found anew; the sums are exact."""
    successors = of.automaton.successors
    assert tables(successors, gibbs(successors), SUM) == of.automaton.frequencies
    assert all(sum(row) == SUM for row in of.automaton.frequencies)
    for row, after in zip(of.automaton.frequencies, successors, strict=True):
        assert [f > 0 for f in row] == [q >= 0 for q in after]


@BOTH
def test_the_certificates_hold(of: Minimax) -> None:
    """CODE-CERTIFICATE-1, CODE-CERTIFICATE-2, CODE-CERTIFICATE-4, CODE-MINIMAX-6.

    The coder loses at most log2 (2^30 / (2^30 − 32768)) bits a symbol (ARITH-LENGTH-1), of which
    there are less than T, and two at the end.
    """
    found, automaton = certificate(of), of.automaton
    assert tuple(breaches(found, automaton)) == ()
    assert min(found.symbol, found.creation, found.split, *found.potential) > 0
    assert found.symbol >= found.creation * found.split
    start = automaton.successors[0][SYMBOLS.index("C")]
    loss = log2_above(Fraction(2**30, 2**30 - SUM))
    assert rate(found) + loss < of.rate < rate(found) + loss + Fraction(1, 100_000)
    left = constant(found, automaton, start) + 2
    assert left < of.constant < left + Fraction(2, 100)
    recorded = content(f"minimax-{of.order}")
    assert Fraction(str(recorded["rate"])) == rate(found)
    assert Fraction(str(recorded["constant"])) == constant(found, automaton, start)


@BOTH
def test_a_better_certificate_is_a_wrong_one(of: Minimax) -> None:
    """CODE-CERTIFICATE-1: less for a symbol, or a context's potential, breaks an inequality."""
    found = certificate(of)
    less = Fraction(9999, 10000)
    assert any(breaches(replace(found, symbol=found.symbol * less), of.automaton))
    for q in range(len(found.potential)):
        lower = tuple(x * less if r == q else x for r, x in enumerate(found.potential))
        blamed = {b.context for b in breaches(replace(found, potential=lower), of.automaton)}
        assert q in blamed
    for name in ("creation", "split"):
        more = {name: getattr(found, name) / less**20}
        assert any(breaches(replace(found, **more), of.automaton))


def test_the_breach_is_named() -> None:
    """CODE-CERTIFICATE-1: with all numbers 1, f/M ≥ 1 fails for each symbol that is not certain."""
    ones = Certificate(*(Fraction(1),) * 3, (Fraction(1),) * 4)
    found = list(breaches(ones, MINIMAX_3.automaton))
    assert found[:5] == [Breach(0, x) for x in "CLERS"]
    assert found[5:8] == [Breach(1, x) for x in "CRS"]
    assert len(found) == 5 + 3 + 3 + 4


@BOTH
@pytest.mark.parametrize("vertices", range(4, 9))
def test_the_potentials_telescope(of: Minimax, vertices: int) -> None:
    """CODE-CERTIFICATE-2: the probability of each word, in fractions, against its counts."""
    found = certificate(of)
    for word in sphere_words(vertices):
        q, chance = 0, Fraction(1)
        for x in word:
            s = SYMBOLS.index(x)
            chance *= Fraction(of.automaton.frequencies[q][s], SUM)
            q = of.automaton.successors[q][s]
        split = word.count("S") - word.count("E")
        due = found.creation ** word.count("C") * found.split**split / found.symbol ** len(word)
        assert chance >= due * found.potential[q] / found.potential[0]


def test_weights_of_symbols() -> None:
    """CODE-CERTIFICATE-1."""
    of = Certificate(Fraction(7), Fraction(3), Fraction(2), ())
    assert [weight(of, x) for x in "CLERS"] == [3, 1, Fraction(1, 2), 1, 2]


def test_rate_and_constant_by_hand() -> None:
    """CODE-CERTIFICATE-2: Λ = 8, x = 4, y = 1, ψ = 1: 3 − 1 = 2 bits, and log2 (16/64) = −2."""
    of = Certificate(Fraction(8), Fraction(4), Fraction(1), (Fraction(1),) * 4)
    near = Fraction(1, 2**38)
    assert 2 <= rate(of) <= 2 + near
    assert -2 <= constant(of, MINIMAX_3.automaton, 1) <= -2 + near
    split = replace(of, split=Fraction(2))
    assert -1 <= constant(split, MINIMAX_3.automaton, 1) <= -1 + near
    start = replace(of, potential=(Fraction(1), Fraction(2), Fraction(1), Fraction(1)))
    assert -1 <= constant(start, MINIMAX_3.automaton, 1) <= -1 + near
    # an E leads to context 0 only, so that a low potential elsewhere changes nothing
    end = replace(of, potential=(Fraction(2), Fraction(1), Fraction(1, 8), Fraction(1, 8)))
    assert -3 <= constant(end, MINIMAX_3.automaton, 1) <= -3 + near


@pytest.mark.parametrize(
    "x", [Fraction(n, d) for n in (1, 2, 3, 5, 8, 255, 256, 257, 10**30) for d in (1, 3, 7, 64)]
)
def test_logarithms_from_above(x: Fraction) -> None:
    """CODE-CERTIFICATE-3: against fifty decimal places."""
    with localcontext() as context:
        context.prec = 50
        exact = (Decimal(x.numerator) / Decimal(x.denominator)).ln() / Decimal(2).ln()
        found = log2_above(x)
        above = Decimal(found.numerator) / Decimal(found.denominator) - exact
        assert Decimal(0) <= above + Decimal(10) ** -45
        assert above <= Decimal(2) ** -40 + Decimal(2) ** -50


def charged(name: str) -> Charges:
    """The certificate of a code with whole costs, from its file."""
    found = content(name)
    names = ("each", "creation", "pair", "potential")
    return Charges(*(int(str(found[key])) for key in names))


@pytest.mark.parametrize(
    ("name", "costs"),
    [
        ("golden", charges.golden_costs()),
        ("king-rossignac", charges.king_rossignac_costs()),
    ],
)
def test_each_symbol_costs_what_it_is_charged(
    name: str, costs: tuple[charges.Costs, charges.Costs]
) -> None:
    """CODE-CERTIFICATE-5; any other number is found out."""
    of = charged(name)
    assert list(mischarged(of, *costs)) == []
    for key in ("each", "creation", "pair", "potential"):
        other = replace(of, **{key: getattr(of, key) + 1})
        assert list(mischarged(other, *costs))
    assert ("", "E") in list(mischarged(replace(of, each=0), *costs))


def test_the_charges_by_hand() -> None:
    """CODE-CERTIFICATE-5, CODE-KR-4, CODE-GOLDEN-4: CRE, of 3 symbols, a C and an E: 18 and 8."""
    assert charged("king-rossignac") == Charges(8, -5, 1, 2)
    assert charged("golden") == Charges(4, -3, 0, 1)
    assert (
        charged("king-rossignac").total(3, 1, -1, 0) == 18 == sum(king_rossignac.lengths("CRE", ""))
    )
    assert charged("golden").total(3, 1, -1, 0) == 8 == golden.units("CRE")
    assert Charges(8, -5, 1, 2).total(0, 0, 0, 2) == -2
    assert charges.king_rossignac_costs() == (
        {"C": 3, "S": 6, "R": 6},
        {"C": 5, "S": 9, "R": 8, "L": 8, "E": 7},
    )


def test_the_golden_tables_have_a_certificate_too() -> None:
    """CODE-CERTIFICATE-2, CODE-GOLDEN-7: with Λ = 1.0000001 φ^4, x = φ^3, y = 1/φ, ψ = 1, 1/φ."""
    phi = Fraction(golden.fibonacci(40), golden.fibonacci(39))
    of = Certificate(phi**4 * Fraction(10**7 + 1, 10**7), phi**3, 1 / phi, (Fraction(1), 1 / phi))
    assert list(breaches(of, golden.AUTOMATON)) == []
    assert Fraction("1.735604") < rate(of) < Fraction("1.735606")
    assert minimax.MINIMAX_3.rate < rate(of)
