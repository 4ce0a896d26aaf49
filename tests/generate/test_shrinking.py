"""What examples shrink to: small meshes, with bounds on how small."""

from collections.abc import Callable
from random import Random

import pytest
from hypothesis import HealthCheck, find, settings
from hypothesis import strategies as st

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.generate.distribution import look
from clers.generate.solids import solid_surfaces
from clers.generate.surfaces import surfaces

FINDING = settings(
    max_examples=1000, database=None, deadline=None, suppress_health_check=list(HealthCheck)
)


def smallest(of: st.SearchStrategy[Surface], wanted: Callable[[Surface], bool]) -> Surface:
    """The example that Hypothesis shrinks to."""
    return find(of, wanted, settings=FINDING, random=Random(0))


# The least possible: 4; 14 (seven vertices, all joined); 8; 6 (an annulus of two triangles).
FROM_SCRIPTS: list[tuple[str, Callable[[Surface], bool], int]] = [
    ("closed", lambda s: look(s).curves == 0, 4),
    ("closed, with a handle", lambda s: look(s).curves == 0 and look(s).genus > 0, 16),
    ("genus 2", lambda s: look(s).genus >= 2, 28),
    ("two components", lambda s: look(s).components >= 2, 8),
    ("two curves", lambda s: look(s).curves >= 2, 10),
    ("two curves of one component", lambda s: any(c.curves > 1 for c in components(s)), 6),
    ("twenty faces", lambda s: s.faces >= 20, 36),
]


@pytest.mark.parametrize(("name", "wanted", "bound"), FROM_SCRIPTS)
def test_scripts(name: str, wanted: Callable[[Surface], bool], bound: int) -> None:
    found = smallest(surfaces(), wanted)
    assert wanted(found)
    assert found.faces <= bound, name


FROM_SOLIDS: list[tuple[str, Callable[[Surface], bool], int]] = [
    ("closed, with a handle", lambda s: look(s).curves == 0 and look(s).genus > 0, 84),
]


@pytest.mark.parametrize(("name", "wanted", "bound"), FROM_SOLIDS)
def test_solids(name: str, wanted: Callable[[Surface], bool], bound: int) -> None:
    found = smallest(solid_surfaces(), wanted)
    assert wanted(found)
    assert found.faces <= bound, name
