"""Every law of scripts and of operators at a gate; those of packages are run beside their tests."""

from typing import Final

import pytest

from clers.conventions.law import AnyLaw
from clers.operators import laws_handles, laws_scripts
from laws import run

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_scripts.LAWS, *laws_handles.LAWS)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)
