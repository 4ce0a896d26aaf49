"""Every law of pictures, on random surfaces."""

from typing import Final

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
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
