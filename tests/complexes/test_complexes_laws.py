"""Every law of chapter 3; those of its inner packages are run beside their tests."""

import pytest

from clers.complexes.laws import LAWS
from clers.complexes.manifolds import laws as manifolds
from clers.complexes.polytopes import laws as polytopes
from clers.complexes.structures import laws as structures
from clers.conventions.law import AnyLaw
from laws import run

BESIDE = {law.name for law in (*manifolds.LAWS, *polytopes.LAWS, *structures.LAWS)}
HERE = tuple(law for law in LAWS if law.name not in BESIDE)


@pytest.mark.parametrize("law", HERE, ids=lambda law: law.name)
def test_law_holds(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)
