"""Every law of pictures, on random surfaces."""

from typing import Final

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pictured import built

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.generate.domains import strategy_for
from clers.pictures.laws import LAWS

EXAMPLES: Final = 25


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@settings(max_examples=EXAMPLES)
@given(data=st.data())
def test_law(law: AnyLaw, data: st.DataObject) -> None:
    """Clauses are in the laws."""
    strategy = strategy_for(law.domain)
    assert strategy is not None
    assert law.check(data.draw(strategy)) == Holds()


TWO_HOLES: Final = built(
    [
        (8, 3, 2), (1, 7, 0), (0, 3, 1), (5, 0, 7), (3, 6, 4), (9, 3, 8), (2, 6, 8),
        (8, 5, 7), (0, 6, 3), (8, 1, 9), (1, 8, 7), (8, 6, 0), (3, 4, 2),
    ],
    10,
)  # fmt: skip
"""The first E meets the left edge of the last S, whose gate is then popped with the one below."""

KNOWN: Final = {
    "CCCRCRRCRRE": CUBE,
    "CCCCRCSCRSSRLSEEE": TORUS,
    "CRE": TETRAHEDRON,
    "E": TRIANGLE,
    "SCSRRSLLRRERE": TWO_HOLES,
    "SLRRLE": ANNULUS,
}


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("word", KNOWN)
def test_law_on_known_surfaces(law: AnyLaw, word: str) -> None:
    """What random surfaces seldom have. Clauses are in the laws."""
    assert encode(KNOWN[word]).stream.word == word
    assert law.check(KNOWN[word]) == Holds()
