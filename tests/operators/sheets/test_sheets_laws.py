"""Every law of sheets, on random sheets, steps, scripts and surfaces."""

import pytest

from clers.conventions.law import AnyLaw
from clers.operators.sheets.laws import LAWS
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_sheet_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)
