"""Every law of the data structures, on what its domain's strategy draws."""

import pytest

from clers.complexes.structures.laws import LAWS
from clers.conventions.law import AnyLaw
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)
