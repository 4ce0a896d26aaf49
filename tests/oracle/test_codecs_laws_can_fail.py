"""The laws on compared meshes, with wrong answers that each must see."""

import pytest
from compared_meshes import CORNERS, SOLID, placed

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Difference, Kind
from clers.conformance.judging.laws_meshes import LAWS, MeshPair, Planted
from clers.conformance.judging.meshes import (
    EXACT,
    Compared,
    Differs,
    Same,
    Undecided,
)
from clers.conventions.verdict import Fails, Holds


def test_laws_can_fail() -> None:
    """A wrong answer is seen by each law."""
    one, other = placed(SOLID, *CORNERS), placed(SOLID[1:], *CORNERS)
    laws = {law.name: law for law in LAWS}
    pair = MeshPair(one, other, EXACT)
    failed = laws["a-mesh-under-other-names-is-the-same"].check(pair)
    assert isinstance(failed, Fails)
    wrong = Planted(pair, ((Kind.FACES_LOST, 2),))
    assert isinstance(laws["differences-are-named"].check(wrong), Fails)
    right = Planted(pair, ((Kind.FACES_LOST, 1),))
    assert laws["differences-are-named"].check(right) == Holds()
    none = Planted(MeshPair(one, one, EXACT), ())
    assert isinstance(laws["differences-are-named"].check(none), Fails)


@pytest.mark.parametrize(
    ("law", "wrong"),
    [
        ("same-is-what-some-permutation-does", Same((0, 1, 2, 3))),
        ("same-is-what-some-permutation-does", Undecided("")),
        ("what-is-not-the-same-has-a-difference", Differs(())),
        (
            "what-is-not-the-same-has-a-difference",
            Differs((Difference(Kind.MOVED, 1), Difference(Kind.FACES_LOST, 1))),
        ),
        ("what-is-not-the-same-has-a-difference", Differs((Difference(Kind.MOVED, 0),))),
    ],
)
def test_laws_see_wrong_answers(law: str, wrong: Compared, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each law of tiny meshes fails when `compare` answers so."""
    pair = MeshPair(placed(SOLID, *CORNERS), placed(SOLID[1:], *CORNERS), EXACT)
    known = {each.name: each for each in LAWS}[law]
    assert known.check(pair) == Holds()
    monkeypatch.setattr("clers.conformance.judging.laws_meshes.compare", lambda *_: wrong)
    assert isinstance(known.check(pair), Fails)


def test_law_sees_a_wrong_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    """A map that carries no face, moves a place, or is none."""
    one = placed(SOLID, *CORNERS)
    known = LAWS[0]
    for image in ((1, 0, 2, 3), (0, 0, 1, 2), (1, 2, 0, 3), (0, 1, 2)):
        answer = Same(image)
        monkeypatch.setattr(
            "clers.conformance.judging.laws_meshes.compare", lambda *_, answer=answer: answer
        )
        assert isinstance(known.check(MeshPair(one, one, EXACT)), Fails)


def test_law_sees_one_sided_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-4."""
    one, other = placed(SOLID, *CORNERS), placed(SOLID[1:], *CORNERS)

    def sided(sent: form.MeshForm, came: form.MeshForm, _: object) -> Compared:
        return Same(()) if len(sent.faces) > len(came.faces) else Differs(())

    monkeypatch.setattr("clers.conformance.judging.laws_meshes.compare", sided)
    assert isinstance(LAWS[2].check(MeshPair(one, other, EXACT)), Fails)
