"""What is drawn when nothing is asked for, and what is refused."""

from dataclasses import replace

import pytest
from pictured import globe, picture, placed

from clers.complexes.row import listed
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import Encoding, Stream
from clers.pictures.draw import draw
from clers.pictures.options import Layout, Options, steps_of


def test_small_meshes_are_shown_step_by_step() -> None:
    """Sixty faces are the most. Clause: TOOL-PICTURE-10."""
    small, _ = globe(4, 10)
    larger, _ = globe(5, 8)
    assert (small.faces, larger.faces) == (60, 64)
    assert [panel.step for panel in picture(small).panels] == list(range(61))
    assert [panel.step for panel in picture(larger).panels] == [64]
    assert picture(small).labels
    assert not picture(larger).labels
    assert not picture(larger).panels[0].marks


def test_labels_as_asked_for() -> None:
    """Clause: TOOL-PICTURE-10."""
    larger, _ = globe(5, 8)
    assert len(picture(larger, Options(labels=True)).panels[0].marks) == larger.vertices
    assert not picture(TORUS, Options(labels=False)).panels[0].marks
    assert not picture(TORUS, Options(labels=False)).panels[0].notes


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("0", (0,)),
        ("0,5,10-12", (0, 5, 10, 11, 12)),
        (" 3 , 1-2 ", (1, 2, 3)),
        ("5,5,4-6", (4, 5, 6)),
        ("18", (18,)),
    ],
)
def test_lists_of_steps(text: str, steps: tuple[int, ...]) -> None:
    """Clause: TOOL-PICTURE-10."""
    assert steps_of(text, 18) == Accepted(steps)


@pytest.mark.parametrize("text", ["", ",", "1,", "a", "-1", "1-", "1--2", "1.5", "١", "9" * 13])
def test_no_lists_of_steps(text: str) -> None:
    """Clause: TOOL-PICTURE-10."""
    got = steps_of(text, 18)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause) == (Reason.BAD_NUMBER, Clause.TOOL_PICTURE_10)


@pytest.mark.parametrize("text", ["19", "0-19", "5-4", "0,1,100", "999999999999"])
def test_steps_that_are_not_there(text: str) -> None:
    """Clause: TOOL-PICTURE-10."""
    got = steps_of(text, 18)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause) == (Reason.NO_SUCH_STEP, Clause.TOOL_PICTURE_10)


def reason(encoding: Encoding, options: Options, points: int = 8) -> Reason | None:
    """Why the cube is not drawn, with positions for some vertices."""
    surface = CUBE if points == CUBE.vertices else TETRAHEDRON
    at = (
        placed(surface, [(float(v), v * v / 2, v % 3 + 0.0) for v in range(points)])
        if points
        else None
    )
    got = draw(CUBE, encoding, at, options)
    if isinstance(got, Accepted):
        return None
    assert got.clause is Clause.TOOL_PICTURE_11
    return got.reason


@pytest.mark.parametrize(
    ("options", "points", "expected"),
    [
        (Options(), 0, None),
        (Options(), 4, Reason.COUNT_MISMATCH),
        (Options(layout=Layout.VIEW), 0, Reason.NOT_DRAWABLE),
        (Options(layout=Layout.VIEW), 8, None),
        (Options(view=(0, 0, 0)), 8, Reason.NOT_DRAWABLE),
        (Options(view=(0, float("nan"), 1)), 8, Reason.NOT_DRAWABLE),
        (Options(view=(0, 0, float("inf"))), 0, Reason.NOT_DRAWABLE),
        (Options(size=39), 0, Reason.NOT_DRAWABLE),
        (Options(size=40), 0, None),
        (Options(size=8000, steps=(1,)), 0, None),
        (Options(size=8001), 0, Reason.NOT_DRAWABLE),
        (Options(steps=(13,)), 0, Reason.NO_SUCH_STEP),
        (Options(steps=(12,)), 0, None),
        (Options(steps=(0, -1)), 0, Reason.NO_SUCH_STEP),
    ],
)
def test_what_is_refused(options: Options, points: int, expected: Reason | None) -> None:
    """Clause: TOOL-PICTURE-11."""
    assert reason(encode(CUBE), options, points) == expected


def test_another_encoding_is_refused() -> None:
    """Clause: TOOL-PICTURE-11."""
    own = encode(CUBE)
    other = replace(own, vertex_row=listed(own.vertex_order[::-1]))
    assert reason(other, Options()) is Reason.NOT_DRAWABLE
    assert reason(encode(TORUS), Options()) is Reason.NOT_DRAWABLE
    broken = draw(CUBE, replace(own, stream=Stream("CX")))
    assert isinstance(broken, Rejected)
    assert broken.reason is Reason.UNKNOWN_SYMBOL


def test_too_much_is_refused() -> None:
    """2^22 faces in all panels together, but any one panel. Clause: TOOL-PICTURE-11."""
    large, _ = globe(52, 100)
    encoding = encode(large)
    over = (1 << 22) // large.faces + 1
    ribbon = Options(layout=Layout.RIBBON)
    got = draw(large, encoding, None, replace(ribbon, steps=tuple(range(over))))
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause) == (Reason.TOO_MANY_FACES, Clause.TOOL_PICTURE_11)
    assert isinstance(draw(large, encoding, None, replace(ribbon, steps=(5, 6))), Accepted)
    flat = draw(large, encoding, None, Options(layout=Layout.FLAT))
    assert isinstance(flat, Rejected)
    assert flat.reason is Reason.NOT_DRAWABLE
