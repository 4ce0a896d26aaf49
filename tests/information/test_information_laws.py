"""Every law of chapter 1, on what its domain's strategy draws."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.domains import DOMAINS
from clers.information.laws import LAWS


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@given(data=st.data())
def test_law_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()
