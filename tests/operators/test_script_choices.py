"""Scripts by hand, number by number: which element is chosen, and what stands where afterwards.

The tetrahedron is 012 031 023 132. Each case was worked out on paper from the clauses.
"""

from itertools import islice

import pytest

from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.operators.script import grow
from clers.operators.script_text import read
from clers.operators.split_mix import shuffled, split_mix


def faces_after(text: str) -> str:
    """The faces of the last mesh, each as its three digits."""
    script = read(text)
    assert isinstance(script, Accepted)
    return " ".join("".join(map(str, face)) for face in grow(script.value).faces)


@pytest.mark.parametrize(
    ("text", "faces"),
    [
        ("split-face 5", "012 034 023 132 314 104"),
        ("split-face -1", "012 031 023 134 324 214"),
        ("split-edge 0", "042 143 023 132 412 403"),
        ("split-edge 4", "012 031 240 341 430 421"),
        ("split-face 0; flip-edge 9", "403 314 023 132 124 204"),
        ("remove-face 0; add-ear 0", "031 023 132 014"),
        ("remove-face 0; remove-face 0; add-ear 2", "023 132 314"),
        ("remove-face 0; remove-face 0; fill-corner 0", "023 132 120"),
        ("remove-face 0; close-curve 0", "031 023 132 014 204 124"),
        ("remove-face 0; remove-face 0; remove-face 0", "021"),
        ("remove-face 0; remove-face 0; cut-edge 0", "045 132"),
        ("remove-face 0; cut-edge 0", "431 023 132"),
        ("split-face 0; remove-star 4", "031 023 132"),
        ("open-curve 0; open-curve 0", "023 132 104 314 035 405"),
        (
            "add-tetrahedron; join-components 0 -1",
            "031 023 132 456 475 467 016 065 127 176 205 257",
        ),
        ("add-handle 0 0", "023 132 124 014 035 105 316 536 157 617 207 275 046 067 425 456"),
    ],
)
def test_faces(text: str, faces: str) -> None:
    """OPER-SCRIPT-7, OPER-SCRIPT-8."""
    assert faces_after(text) == faces


def test_words_of_a_seed() -> None:
    """OPER-REFINE-5: the words that SplitMix64 is known for, and what a shuffle makes of them."""
    words = split_mix(1234567)
    assert [next(words) for _ in range(3)] == [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
    ]
    assert shuffled(4, iter([3, 2, 1])) == [0, 1, 2, 3]
    assert shuffled(4, iter([0, 0, 0])) == [1, 2, 3, 0]
    assert shuffled(4, iter([4, 4, 5])) == [3, 2, 1, 0]


def test_seeds_are_modulo_two_to_the_64() -> None:
    """OPER-REFINE-4: so that a word of 64 bits is enough for every seed; 0 changes nothing."""
    assert faces_after(f"relabel {1 << 64}") == faces_after("relabel 0") == faces_after("")
    assert faces_after(f"relabel {(1 << 64) - 5}") == faces_after("relabel -5") != faces_after("")


def test_relabel() -> None:
    """OPER-REFINE-4: words for the vertices, then for the faces, then for the turns."""
    words = list(islice(split_mix(1), 10))
    number = shuffled(4, iter(words[:3]))
    order = shuffled(4, iter(words[3:6]))
    old = ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2))
    faces = []
    for k in range(4):
        named = [number[v] for v in old[order[k]]]
        turn = words[6 + k] % 3
        faces.append("".join(map(str, named[turn:] + named[:turn])))
    assert faces_after("relabel 1") == " ".join(faces)


def test_white_space_is_blanks_and_tabs() -> None:
    """OPER-SCRIPT-6: what other languages count as white space, some and others not, is none."""
    assert faces_after("\t split-face \t 5\r\n;") == faces_after("split-face 5")
    for other in ("\v", "\f", "\x1c", "\x85", "\xa0", "\u2028"):
        answer = read(f"split-face{other}5")
        assert isinstance(answer, Rejected)
        assert answer.reason is Reason.UNKNOWN_OPERATOR
        answer = read(f"split-face 5{other}")
        assert isinstance(answer, Rejected)
        assert answer.reason is Reason.BAD_OPERAND
