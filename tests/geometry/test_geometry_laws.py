"""Every law of chapter 7, on what its domain's strategy draws."""

from typing import Final

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.meshes import DOMAINS
from clers.geometry.laws import LAWS

ON_SURFACES: Final = {"meshes", "lattice-meshes", "position-codings"}


@pytest.mark.parametrize(
    "law", [law for law in LAWS if law.domain not in ON_SURFACES], ids=lambda law: law.name
)
@settings(max_examples=200)
@given(data=st.data())
def test_law_of_numbers_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()


@pytest.mark.parametrize(
    "law", [law for law in LAWS if law.domain in ON_SURFACES], ids=lambda law: law.name
)
@settings(max_examples=20)
@given(data=st.data())
def test_law_of_surfaces_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()
