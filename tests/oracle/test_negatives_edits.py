"""Edits of inputs: where they go, what they refuse, and how seals are made anew."""

from zlib import crc32

import msgspec
import pytest
from msgspec import Raw

from clers.conformance.cases import laws
from clers.conformance.cases.case import Case, Edit, FaultForm
from clers.conformance.cases.edits import (
    NoEdit,
    edited,
    inverse,
    replaced,
    same_input,
    undone,
)
from clers.conformance.cases.laws import LAWS, Editing
from clers.conformance.cases.seals import resealed
from clers.conformance.samples import SAMPLES
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Fails, Holds
from clers.oracle.negatives.by_hand import BALL, MAGIC, section
from laws import run

GIVEN = Raw(b'{"word": "CRE", "list": [1, [2, "x"], null], "n": 7, "a/b": {"~": true}}')


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses: ORCL-FAULT-2, ORCL-FAULT-6."""
    run(law)


EDITING = Editing(GIVEN, (replaced("/word", 1, "R", "L"),))


def test_the_law_of_edits_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: ORCL-FAULT-6."""
    (law, sealing) = LAWS
    assert law.check(EDITING) == Holds()
    assert isinstance(law.check(Editing(GIVEN, (replaced("/word", 1, "C", "L"),))), Fails)
    monkeypatch.setattr(laws, "inverse", lambda edits: edits)
    assert isinstance(law.check(EDITING), Fails)
    monkeypatch.setattr(laws, "inverse", lambda _: (replaced("/word", 0, "C", "C"),))
    assert isinstance(law.check(EDITING), Fails)
    assert sealing.check(BALL.data) == Holds()
    for spoil in (lambda d: d + b"\0", lambda d: d[:-1] + b"\0", lambda d: b"\0" + d[1:]):
        monkeypatch.setattr(laws, "resealed", spoil)
        assert isinstance(sealing.check(BALL.data), Fails)


@pytest.mark.parametrize(
    ("edit", "after"),
    [
        (replaced("/word", 1, "R", "LL"), {"word": "CLLE"}),
        (replaced("/word", 3, "", "C"), {"word": "CREC"}),
        (replaced("/word", 0, "CRE", ""), {"word": ""}),
        (replaced("/list", 1, [[2, "x"]], []), {"list": [1, None]}),
        (replaced("/list", 3, [], [4]), {"list": [1, [2, "x"], None, 4]}),
        (replaced("/list/1", 0, [2], []), {"list": [1, ["x"], None]}),
        (replaced("/list/1/1", 0, "x", "y"), {"list": [1, [2, "y"], None]}),
        (replaced("/list/2", 0, None, 1), {"list": [1, [2, "x"], 1]}),
        (replaced("/n", 0, 7, "8"), {"n": "8"}),
        (replaced("/n", 0, 7, [7]), {"n": [7]}),
        (replaced("/a~1b/~0", 0, True, False), {"a/b": {"~": False}}),
    ],
)
def test_an_edit_goes_to_its_place_and_back(edit: Edit, after: dict[str, object]) -> None:
    """Clauses: ORCL-FAULT-2, ORCL-FAULT-6."""
    found = edited(GIVEN, (edit,))
    assert isinstance(found, Raw)
    assert msgspec.json.decode(found) == {**msgspec.json.decode(GIVEN), **after}
    back = edited(found, inverse((edit,)))
    assert isinstance(back, Raw)
    assert same_input(GIVEN, back)
    assert not same_input(GIVEN, found)


@pytest.mark.parametrize(
    ("edit", "why"),
    [
        (replaced("/none", 0, "", ""), "/none leads nowhere"),
        (replaced("/word/0", 0, "", ""), "/word/0 leads nowhere"),
        (replaced("/list/3", 0, 1, 1), "/list/3 leads nowhere"),
        (replaced("/list/-1", 0, 1, 1), "/list/-1 leads nowhere"),
        (replaced("/word", 1, "E", ""), '"E" is not at /word, place 1'),
        (replaced("/word", 4, "", "C"), '"" is not at /word, place 4'),
        (replaced("/word", -1, "", "C"), '"" is not at /word, place -1'),
        (replaced("/list", 0, [2], []), "[2] is not at /list, place 0"),
        (replaced("/list", 4, [], [1]), "[] is not at /list, place 4"),
        (replaced("/list", -1, [], [1]), "[] is not at /list, place -1"),
        (replaced("/n", 0, 8, 9), "8 is not at /n, place 0"),
        (replaced("/n", 1, 7, 9), "7 is not at /n, place 1"),
        (replaced("/n", 0, 7.0, 9), "7.0 is not at /n, place 0"),
        (replaced("/a~1b/~0", 0, 1, 0), "1 is not at /a~1b/~0, place 0"),
        (replaced("/word", 0, [], ["C"]), "[] is not at /word, place 0"),
    ],
)
def test_an_edit_without_its_place_is_refused(edit: Edit, why: str) -> None:
    """Clause: ORCL-FAULT-6."""
    assert edited(GIVEN, (edit,)) == NoEdit(why)
    assert edited(GIVEN, (replaced("/n", 0, 7, 7), edit)) == NoEdit(why)


def test_an_edit_may_be_written_with_spaces() -> None:
    """What an edit removes is compared as a value. Clause: ORCL-FAULT-2."""
    edit = Edit(path="/list", at=1, remove=Raw(b'[ [2,  "x"] ]'), insert=Raw(b"[ ]"))
    found = edited(GIVEN, (edit,))
    assert isinstance(found, Raw)
    assert msgspec.json.decode(found)["list"] == [1, None]


def test_what_is_no_json_is_refused() -> None:
    """Clause: ORCL-FAULT-6."""
    edit = Edit(path="/n", remove=Raw(b"7"), insert=Raw(b"{"))
    assert isinstance(edited(GIVEN, (edit,)), NoEdit)
    assert isinstance(edited(Raw(b"{"), ()), NoEdit)
    assert isinstance(edited(Raw(b'{"a":"\xff"}'), ()), NoEdit)


def test_inputs_are_compared_as_values() -> None:
    """Clause: ORCL-FAULT-2."""
    assert same_input(Raw(b'{"a":1,"b":[ 2]}'), Raw(b'{"b":[2],"a": 1}'))
    for one, other in ((b"1", b"1.0"), (b"1", b"true"), (b"0", b"-0.0"), (b"[1,2]", b"[2,1]")):
        assert not same_input(Raw(one), Raw(other))


def test_undoing_needs_a_fault() -> None:
    """Clause: ORCL-FAULT-2."""
    case = Case(
        id="x-aaaaaaaa", op="word.decode", clauses=(), origin="hand",
        input=Raw(b'{"word":"CRE"}'),
    )  # fmt: skip
    assert undone(case) == NoEdit("the case has no fault")
    undo = (replaced("/word", 0, "C", ""),)
    fault = FaultForm(kind="c-put-in", parent="y-aaaaaaaa", undo=undo)
    mended = undone(msgspec.structs.replace(case, fault=fault))
    assert isinstance(mended, Raw)
    assert bytes(mended) == b'{"word":"RE"}'
    sealed = msgspec.structs.replace(fault, sealed=True)
    assert undone(msgspec.structs.replace(case, fault=sealed)) == NoEdit("only a file has seals")


def test_seals_are_made_anew_section_by_section() -> None:
    """Clauses: ORCL-FAULT-2, FILE-SECTION-2."""
    data = BALL.data
    start = len(MAGIC) + 1
    head = section(*BALL.parts[0])
    for at in (start + 8, start + 12, start + len(head) - 4, start + len(head) + 8, len(data) - 1):
        spoilt = bytearray(data)
        spoilt[at] ^= 0x40
        mended = resealed(bytes(spoilt))
        inside = at == start + 12
        assert (mended == data) is not inside
        if inside:  # the payload itself: its seal alone follows
            after = start + len(head)
            assert mended[at] == spoilt[at]
            assert mended[: after - 4] == spoilt[: after - 4]
            assert mended[after - 4 : after] != data[after - 4 : after]
            assert mended[after:] == data[after:]


def test_a_file_that_ends_too_soon_is_sealed_as_far_as_it_goes() -> None:
    """Clause: ORCL-FAULT-2."""
    data = BALL.data
    assert resealed(data[:5]) == data[:5]
    for end in range(len(data)):
        assert resealed(data[:end]) == data[:end]
    assert resealed(data + b"\0" * 11) == data + b"\0" * 11
    assert resealed(data + b"\0" * 12)[-4:] == section(b"\0\0\0\0", b"")[8:12]


def test_all_four_bytes_of_a_length_count() -> None:
    """A section that is said to be long is sealed no further than its header. FILE-SECTION-1."""
    head, rest = BALL.data[:9], BALL.data[9:]
    for length in (2 + (1 << 8), 2 + (1 << 16), 2 + (1 << 24)):
        header = b"WORD" + length.to_bytes(4, "little")
        file = head + header + bytes(4) + b"ab" + bytes(4) + rest
        mended = resealed(file)
        assert mended[17:21] == crc32(header).to_bytes(4, "little")
        assert mended[21:] == file[21:]


def test_sealed_edits_are_of_files() -> None:
    """Clause: ORCL-FAULT-2."""
    given = Raw(msgspec.json.encode({"hex": BALL.data.hex()}))
    place = replaced("/hex", 2 * 21, "0101", "0201")
    found = edited(given, (place,), sealed=True)
    assert isinstance(found, Raw)
    assert found != edited(given, (place,))
    back = edited(found, inverse((place,)), sealed=True)
    assert isinstance(back, Raw)
    assert same_input(given, back)
    assert edited(SAMPLE, (), sealed=True) == NoEdit("only a file has seals")
    more = Raw(b'{"hex":"00","more":1}')
    assert edited(more, (), sealed=True) == NoEdit("only a file has seals")


SAMPLE = Raw(msgspec.json.encode(SAMPLES["word.decode"]))
