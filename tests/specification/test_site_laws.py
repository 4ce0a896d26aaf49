"""Every law of the site."""

import pytest

from clers.conventions.law import AnyLaw
from clers.site.laws import LAWS
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)
