"""Every law of chapter 8, on what its domain's strategy draws."""

from typing import Final

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clers.container.laws import LAWS
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.files import DOMAINS

ON_SURFACES: Final = {"meshes-to-write", "files-to-damage"}


@pytest.mark.parametrize(
    "law", [law for law in LAWS if law.domain not in ON_SURFACES], ids=lambda law: law.name
)
@settings(max_examples=300)
@given(data=st.data())
def test_law_of_bytes_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()


@pytest.mark.parametrize(
    "law", [law for law in LAWS if law.domain in ON_SURFACES], ids=lambda law: law.name
)
@settings(max_examples=30)
@given(data=st.data())
def test_law_of_files_holds(law: AnyLaw, data: st.DataObject) -> None:
    assert law.check(data.draw(DOMAINS[law.domain])) == Holds()
