"""Each breakage on the tetrahedron gives the fault it is named for, and draws reach all faults."""

import pytest
from hypothesis import HealthCheck, Phase, given, settings

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.generate.face_lists import BREAKAGES, face_lists
from clers.operators.script import START


def reason_of(mesh: FaceList) -> Reason | None:
    match surface(mesh):
        case Accepted():
            return None
        case Rejected(reason):
            return reason


EXPECTED: dict[str, Reason | None] = {
    "none": None,
    "face-removed": None,
    "index-too-high": Reason.INDEX_OUT_OF_RANGE,
    "index-negative": Reason.INDEX_OUT_OF_RANGE,
    "index-changed": Reason.REPEATED_INDEX,  # corner 0 of (0, 1, 2) names 1
    "count-too-low": Reason.INDEX_OUT_OF_RANGE,
    "face-twice": Reason.DUPLICATE_FACE,
    "face-twice-flipped": Reason.DUPLICATE_FACE,
    "face-flipped": Reason.EDGE_TWICE_IN_ONE_DIRECTION,
    "edge-with-a-face-more": Reason.EDGE_WITH_THREE_FACES,
    "vertices-identified": Reason.REPEATED_INDEX,
    "pinched": Reason.PINCHED_VERTEX,
    "vertex-isolated": Reason.ISOLATED_VERTEX,
    "strip-one-sided": Reason.EDGE_TWICE_IN_ONE_DIRECTION,
    "empty": Reason.EMPTY_MESH,
}


def test_all_are_expected() -> None:
    assert EXPECTED.keys() == BREAKAGES.keys()


@pytest.mark.parametrize("name", BREAKAGES)
def test_breakage(name: str) -> None:
    """CPLX-REJECT-1, -3 … -9."""
    assert reason_of(BREAKAGES[name](START, 0, 1)) == EXPECTED[name]


@pytest.mark.parametrize("name", BREAKAGES)
@pytest.mark.parametrize("mesh", [FaceList((), 0), FaceList((), 2), FaceList(((0, 0, 9),), 1)])
def test_breakages_are_total(name: str, mesh: FaceList) -> None:
    """A breakage may meet what another one left."""
    for i, j in ((0, 0), (1, 2), (7, 999)):
        assert BREAKAGES[name](mesh, i, j).vertices >= 0


def test_draws_reach_every_fault() -> None:
    """CPLX-REJECT-1, -3 … -9, and a third at least that is good."""
    found: list[Reason | None] = []

    @settings(max_examples=1200, phases=[Phase.generate], suppress_health_check=list(HealthCheck))
    @given(face_lists())
    def record(mesh: FaceList) -> None:
        found.append(reason_of(mesh))

    record()
    assert set(found) == set(EXPECTED.values())
    assert 3 * found.count(None) >= len(found)
