"""Answers whose labels and orders are free. Clauses: ORCL-JUDGE-3, ORCL-DIVERGE-12."""

import msgspec
import pytest
from judged_by_hand import case_of

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Divergence, Judged, Status
from clers.conformance.messages import Operation
from clers.conformance.outcome import Answered
from clers.conformance.samples import FACES, SAMPLES
from clers.conformance.serve import INTRODUCTION

RENAMED = ((1, 2, 3), (1, 3, 0), (0, 2, 1), (3, 2, 0))
"""The tetrahedron with 0, 1, 2, 3 renamed 3, 1, 2, 0, faces turned and in another order."""

MIRRORED = tuple((a, c, b) for a, b, c in FACES)


def _judged(request: Operation, result: form.Faces) -> Judged:
    case = msgspec.structs.replace(case_of(request), compare="isomorphic")
    return judge(case, Answered(result), INTRODUCTION)


def _mesh(x: float, error: float | None = None) -> form.ThroughForm:
    """The tetrahedron, its vertices along the first axis, vertex 3 at x."""
    return form.ThroughForm.of(
        form.MeshForm(
            faces=FACES,
            vertices=4,
            positions=form.Places(
                precision="f64",
                coordinates=(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, x, 0.0, 0.0),
            ),
        ),
        msgspec.UNSET if error is None else (error, 0.0, 0.0),
    )


def _through(x: float, error: float | None = None) -> Operation:
    return message.Roundtrip(id=0, input=_mesh(x, error))


def _back(x: float) -> form.MeshForm:
    given = _mesh(x)
    return form.MeshForm(faces=given.faces, vertices=4, positions=given.positions)


def test_names_and_orders_are_free() -> None:
    """Clause: ORCL-JUDGE-3."""
    renamed = form.Faces(faces=RENAMED, vertices=4)
    assert _judged(SAMPLES["word.decode"], renamed).status is Status.PASS
    exact = judge(case_of(SAMPLES["word.decode"]), Answered(renamed), INTRODUCTION)
    assert exact.status is Status.FAIL


def test_orientation_is_not() -> None:
    """Clauses: ORCL-JUDGE-3, ORCL-DIVERGE-12."""
    mirrored = form.MeshForm(faces=MIRRORED, vertices=4, positions=_mesh(3.0).positions)
    found = _judged(_through(3.0), mirrored)
    assert found.signature == "codec.roundtrip fail components-mirrored"
    assert isinstance(found.divergence, Divergence)
    assert found.divergence.face == 0
    assert found.divergence.place == "the mesh, at face 0 of the one sent"
    assert found.divergence.expected == "4 faces on 4 vertices"


@pytest.mark.parametrize(
    ("error", "x", "status"),
    [
        (None, 3.0, Status.PASS),
        (None, 3.25, Status.FAIL),
        (0.25, 3.25, Status.PASS),
        (0.25, 3.5, Status.FAIL),
    ],
)
def test_coordinates_move_within_the_error(error: float | None, x: float, status: Status) -> None:
    """Clause: ORCL-JUDGE-3: the error is the input's, none if it does not say."""
    found = _judged(_through(3.0, error), _back(x))
    assert found.status is status
    if status is Status.FAIL:
        assert found.signature == "codec.roundtrip fail position-moved"
        assert isinstance(found.divergence, Divergence)
        assert found.divergence.vertex == 3


def test_all_differences_are_named() -> None:
    """Clause: ORCL-DIVERGE-12."""
    got = form.MeshForm(faces=(*MIRRORED, (0, 1, 2)), vertices=4, positions=_mesh(3.0).positions)
    found = _judged(_through(3.0), got).divergence
    assert isinstance(found, Divergence)
    assert found.got.startswith("5 faces on 4 vertices: faces-added (1), face (")
    assert found.got.endswith("; also orientation-changed (3)")
    assert found.place == "the mesh, at face 0 of the one given back"
    assert found.face is msgspec.UNSET


def test_what_cannot_be_compared_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clauses: ORCL-JUDGE-10, ORCL-CODEC-8."""
    monkeypatch.setattr("clers.conformance.judging.meshes.MOST", 3)
    found = _judged(_through(3.0), _back(3.0))
    assert (found.status, found.signature) == (Status.ERROR, "codec.roundtrip error undecided")
    assert found.why == "undecided: more than 3 vertices"


def test_a_difference_of_the_whole_mesh() -> None:
    """Clause: ORCL-DIVERGE-12."""
    found = _judged(_through(3.0), form.MeshForm(faces=FACES, vertices=4))
    assert found.signature == "codec.roundtrip fail positions-lost"
    assert found.why.startswith("the mesh: expected 4 faces on 4 vertices, got 4 faces on 4")
