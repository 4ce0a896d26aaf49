"""Every law of mesh files, on what its domain's strategy draws."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.mesh_files import DOMAINS
from clers.meshfile.laws import LAWS


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@settings(max_examples=150)
@given(data=st.data())
def test_law_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()
