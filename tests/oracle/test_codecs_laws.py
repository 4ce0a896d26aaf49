"""The laws of comparing meshes."""

import pytest

from clers.conformance.judging.laws_meshes import LAWS
from clers.conventions.law import AnyLaw
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law_of_meshes(law: AnyLaw) -> None:
    """Clauses: ORCL-CODEC-3, ORCL-CODEC-4, ORCL-CODEC-5, ORCL-CODEC-6, ORCL-CODEC-7."""
    run(law)
