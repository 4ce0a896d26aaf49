"""Handle data seen from the end: the examples by hand, and what cannot be seen so."""

import pytest

from clers.arithmetic.bits import pack
from clers.codes.closings import Closing, closings, records
from clers.codes.registry import CodeName, decode
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtRecord
from clers.edgebreaker.stream import Kind, Record, Side, Stream

H, B = Kind.HANDLE, Kind.BOUNDARY
RIGHT, LEFT = Side.RIGHT, Side.LEFT


@pytest.mark.parametrize(
    ("word", "given", "seen"),
    [
        ("SLRRLE", (Record(B, 0, 4, RIGHT),), (Closing(0, B, RIGHT, 2),)),
        ("SLRRLE", (Record(H, 0, 4, LEFT),), (Closing(0, H, LEFT, 2),)),
        ("SLRRLE", (Record(H, 0, 0, LEFT),), (Closing(0, H, LEFT, 0),)),
        ("SLRRLE", (), ()),
        # Two S passed before the second, none between it and the first.
        (
            "CCCCRCSCRSSRLSEEE",
            (Record(H, 0, 6, RIGHT), Record(H, 1, 5, RIGHT)),
            (Closing(2, H, RIGHT, 2), Closing(0, H, RIGHT, 4)),
        ),
        # The E at the end closes both sides of the first S.
        ("SSEE", (Record(H, 0, 1, LEFT),), (Closing(1, H, LEFT, 1),)),
    ],
)
def test_by_hand(word: str, given: tuple[Record, ...], seen: tuple[Closing, ...]) -> None:
    """CODE-HAND-1, CODE-HAND-3, EB-HANDLE-4: sides of R, L and E; C has none."""
    assert closings(Stream(word, given)) == Accepted(seen)
    assert records(word, seen) == Accepted(given)


@pytest.mark.parametrize(
    ("word", "given", "index"),
    [
        ("SLRRLE", (Record(H, 1, 4, RIGHT),), 0),  # no such S
        ("SLRRLE", (Record(H, 0, 0, RIGHT),), 0),  # an L has no such side
        ("SLRRLE", (Record(H, 0, 1, LEFT),), 0),  # nor an R
        ("RSE", (Record(H, 0, 0, RIGHT),), 0),  # before its S
        ("SLRRLE", (Record(H, 0, 5, RIGHT),), 0),  # no such closer
        ("SSEE", (Record(H, 1, 0, LEFT), Record(H, 0, 0, LEFT)), 0),  # not increasing
        ("SSEE", (Record(H, 1, 9, LEFT), Record(H, 1, 0, LEFT)), 0),  # twice
        ("SSEE", (Record(H, 0, 0, LEFT), Record(H, 1, 9, LEFT)), 1),
    ],
)
def test_other_records_are_not_representable(
    word: str, given: tuple[Record, ...], index: int
) -> None:
    """CODE-HAND-2: the last record that is wrong is blamed."""
    refused = closings(Stream(word, given))
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.clause) == (Reason.NOT_REPRESENTABLE, Clause.CODE_HAND_2)
    assert refused.where == AtRecord(index)


@pytest.mark.parametrize(
    ("word", "seen", "index"),
    [
        ("SLRRLE", (Closing(1, H, RIGHT, 0),), 0),  # no second S
        ("SLRRLE", (Closing(0, H, RIGHT, 3),), 0),  # three right edges, the fourth is asked for
        ("SSEE", (Closing(0, H, LEFT, 0), Closing(1, H, LEFT, 0)), 0),
        ("SSEE", (Closing(0, H, LEFT, 2), Closing(0, H, LEFT, 0)), 1),
        ("CRE", (Closing(0, H, LEFT, 0),), 0),
    ],
)
def test_closings_that_go_back_too_far(word: str, seen: tuple[Closing, ...], index: int) -> None:
    """CODE-HAND-3."""
    refused = records(word, seen)
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.clause) == (Reason.RECORD_OUT_OF_RANGE, Clause.CODE_HAND_3)
    assert refused.where == AtRecord(index)


@pytest.mark.parametrize("code", list(CodeName))
@pytest.mark.parametrize("seen", [Closing(-1, H, RIGHT, 0), Closing(0, H, RIGHT, -1)])
def test_negative_closings_are_refused_by_every_code(code: CodeName, seen: Closing) -> None:
    """CODE-HAND-3: the record is numbered as in the handle data, from the beginning."""
    sound = Closing(0, H, RIGHT, 0)
    found = decode(code, pack([0] * 9), 9, 0, (sound, seen, sound, sound))
    assert isinstance(found, Rejected)
    assert (found.reason, found.clause) == (Reason.RECORD_OUT_OF_RANGE, Clause.CODE_HAND_3)
    assert found.where == AtRecord(2)


def test_closings_as_far_as_numbers_go() -> None:
    """CODE-CONTEXT-3: an S that no closing can close is none, however far it goes back."""
    near = decode(CodeName.CONTEXT, pack([0] * 9), 9, 1, (Closing(9, H, RIGHT, 9),))
    far = decode(CodeName.CONTEXT, pack([0] * 9), 9, 1, (Closing(10**40, H, RIGHT, 10**40),))
    assert near == far
