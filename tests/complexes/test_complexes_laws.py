"""Every law of chapter 3, on what its domain's strategy draws."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from clers.complexes.laws import LAWS
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.complexes import DOMAINS as OWN
from clers.generate.domains import DOMAINS

STRATEGIES = {**DOMAINS, **OWN}


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@given(data=st.data())
def test_law_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(STRATEGIES[law.domain])) == Holds()
