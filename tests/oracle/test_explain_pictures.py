"""Pictures of where an answer diverges. Clause: ORCL-EXPLAIN-5."""

from typing import Final

import msgspec
import pytest
from judged_by_hand import case_of, divergence_of, right_of

from clers.codes import registry
from clers.codes.closings import closings
from clers.complexes.corner_table import surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import Divergence
from clers.conformance.messages import Operation, Rejection
from clers.conformance.outcome import Answered, Declined
from clers.conformance.results import Result
from clers.conformance.samples import FACES, GARBAGE, SAMPLES
from clers.conformance.served.forms import bits_form, faces_form
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.encode import encode
from clers.generate.families import grid_torus
from clers.oracle.explaining.pictured import WIDE, Bounds, cut, headed, picture, pointer
from clers.oracle.explaining.subject import Subject, got_by, subject_of
from clers.pictures.options import Pointer
from clers.pictures.scene import Scene, Words

replace = msgspec.structs.replace
MESH: Final = form.Faces(faces=FACES, vertices=4)


def _torus() -> form.Faces:
    built = surface(grid_torus(3, 3))
    assert isinstance(built, Accepted)
    return faces_form(built.value)


TORUS: Final = _torus()
TURNED: Final = form.Faces(faces=tuple(reversed(TORUS.faces)), vertices=9)


def _subject(request: Operation, stage: int | None = None) -> Subject:
    found = subject_of(request, right_of(request).result, stage)
    assert isinstance(found, Accepted), found
    return found.value


def _words(image: Scene) -> list[str]:
    return [item.text for group in image.groups for item in group.items if isinstance(item, Words)]


def _drawn(found: Accepted[Scene] | Rejected) -> Scene:
    assert isinstance(found, Accepted), found
    return found.value


@pytest.mark.parametrize(
    ("op", "faces"),
    [
        ("surface.classify", 4),
        ("word.encode", 4),
        ("word.decode", 4),
        ("code.encode", 4),
        ("code.decode", 4),
        ("mesh.encode", 4),
        ("mesh.decode", 4),
        ("codec.roundtrip", 4),
        ("operator.apply", 6),
    ],
)
def test_what_a_case_is_about(op: str, faces: int) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    found = _subject(SAMPLES[op])
    assert found.mesh.surface.faces == faces
    assert found.encoding == encode(found.mesh.surface)
    assert (found.mesh.positions is not None) == (op == "codec.roundtrip")


def test_a_word_that_is_read_with_its_handle_data() -> None:
    """Clauses: ORCL-EXPLAIN-5, CODE-HAND-3: the torus, whose records are seen from the end."""
    surface_ = _subject(message.WordEncode(id=0, input=TORUS))
    stream = surface_.encoding.stream
    seen, bits = closings(stream), registry.encode(registry.CodeName.PLAIN, stream)
    assert isinstance(seen, Accepted)
    assert isinstance(bits, Accepted)
    request = message.CodeDecode(
        id=0,
        input=form.FromWord(
            code="plain",
            bits=bits_form(bits.value),
            symbols=len(stream.word),
            components_with_boundary=0,
            closings=tuple(
                form.ClosingForm(
                    passed=c.passed,
                    kind="handle",
                    side="right" if c.side == "right" else "left",
                    between=c.between,
                )
                for c in seen.value
            ),
        ),
    )
    found = _subject(request)
    assert found.encoding.stream == stream
    got = got_by(request, form.JustWord(word=stream.word))
    assert isinstance(got, Accepted)
    assert got.value == found


def test_the_stage_that_diverges_of_a_script() -> None:
    """Clause: ORCL-EXPLAIN-5: a stage too much is the last."""
    assert _subject(SAMPLES["operator.apply"], 0).mesh.surface.faces == 4
    assert _subject(SAMPLES["operator.apply"], 9).mesh.surface.faces == 6


@pytest.mark.parametrize(
    ("request_", "reason"),
    [
        (SAMPLES["echo"], Reason.NOT_DRAWABLE),
        (SAMPLES["arithmetic.encode"], Reason.NOT_DRAWABLE),
        (SAMPLES["arithmetic.decode"], Reason.NOT_DRAWABLE),
        (
            message.Apply(id=0, input=form.ScriptForm(script="attach 0 1 2")),
            Reason.NOT_DRAWABLE,
        ),
        (GARBAGE["word.decode"][0], Reason.UNKNOWN_SYMBOL),
        (GARBAGE["surface.classify"][0], Reason.REPEATED_INDEX),
        (GARBAGE["mesh.decode"][0], Reason.TRUNCATED_FILE),
    ],
)
def test_what_is_about_no_surface(request_: Operation, reason: Reason) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    found = subject_of(request_, None)
    assert isinstance(found, Rejected)
    assert found.reason is reason


@pytest.mark.parametrize(
    ("op", "result", "faces"),
    [
        ("word.encode", right_of(SAMPLES["word.encode"]).result, 4),
        ("word.decode", TORUS, 18),
        ("code.decode", form.JustWord(word="CCRRE"), 6),
        ("mesh.encode", right_of(SAMPLES["mesh.encode"]).result, 4),
        ("mesh.decode", form.MeshForm(faces=TORUS.faces, vertices=9), 18),
    ],
)
def test_what_an_answer_describes(op: str, result: Result, faces: int) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    found = got_by(SAMPLES[op], result)
    assert isinstance(found, Accepted), found
    assert found.value.mesh.surface.faces == faces


@pytest.mark.parametrize(
    ("op", "result"),
    [
        ("code.decode", form.JustWord(word="CXE")),
        ("code.decode", form.JustWord(word="S")),
        ("word.decode", form.Faces(faces=((0, 1, 9),), vertices=3)),
        ("surface.classify", form.Classified(components=())),
        ("mesh.encode", form.FileForm(hex="00")),
    ],
)
def test_an_answer_that_describes_no_surface(op: str, result: Result) -> None:
    """Clause: ORCL-EXPLAIN-5."""
    assert isinstance(got_by(SAMPLES[op], result), Rejected)


def _at(**numbers: int | tuple[int, int, int]) -> Divergence:
    found = Divergence(kind="k", place="p", expected="e", got="g")
    return replace(found, **numbers)


def test_what_is_pointed_at() -> None:
    """Clause: ORCL-EXPLAIN-5: by the mesh's own numbers, whose last face is walked first."""
    of = _subject(message.WordEncode(id=0, input=TURNED))
    walk = right_of(message.WordEncode(id=0, input=TURNED, trace="full")).steps
    face_of = {step.i: step.face for step in walk}
    stream = of.encoding.stream
    splits = [i for i, x in enumerate(stream.word) if x == "S"]
    assert pointer(of, _at()) == Pointer()
    assert pointer(of, _at(face=5)) == Pointer((5,))
    assert pointer(of, _at(face=5, symbol=0, record=0, component=0)) == Pointer((5,))
    for i in range(len(stream.word)):
        assert pointer(of, _at(symbol=i)).faces == (face_of[i],)
    for r, record in enumerate(stream.records):
        assert pointer(of, _at(record=r)).faces == (face_of[splits[record.s]],)
    assert pointer(of, _at(component=0)) == Pointer((0,))
    assert pointer(of, _at(vertex=7)) == Pointer((), (7,))
    for nothing in (
        _at(symbol=99),
        _at(record=2),
        _at(component=1),
        _at(record=-1),
        _at(symbol=-1),
    ):
        assert pointer(of, nothing) == Pointer()


def test_the_triangle_got_instead_is_pointed_at_unless_it_is_the_face() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    of = _subject(SAMPLES["word.decode"])
    assert pointer(of, _at(face=2, triangle=(0, 1, 2))).triangle == (0, 1, 2)
    assert pointer(of, _at(face=2, triangle=(0, 1, 3))).triangle is None
    assert pointer(of, _at(triangle=(0, 1, 3))).triangle == (0, 1, 3)


def test_the_step_of_a_face() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    of = _subject(message.WordEncode(id=0, input=TURNED))
    order = [tip // 3 for tip in of.encoding.tip_order]
    assert [of.step_of(face) for face in order] == list(range(1, 19))
    assert of.step_of(99) == 18


def test_a_case_without_a_divergence_is_drawn_step_by_step() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    image = _drawn(picture(case_of(SAMPLES["word.decode"])))
    steps = [group.name for group in image.groups if group.name.startswith("step-")]
    assert steps == ["step-0", "step-1", "step-2", "step-3", "step-4"]


WRONG: Final = form.Faces(faces=(*FACES[:2], (0, 1, 3), FACES[3]), vertices=4)


def test_a_divergence_is_drawn_at_its_face_under_its_heading() -> None:
    """Clause: ORCL-EXPLAIN-5: face 2 is the third."""
    request = SAMPLES["word.decode"]
    found = divergence_of(request, WRONG)
    image = _drawn(picture(case_of(request), found))
    assert image.title == f"{case_of(request).id}: face 2, made by symbol 1 (R)"
    assert [group.name for group in image.groups] == ["heading-0", "0-step-3", "0-legend"]
    assert "expected (0, 3, 1), got (0, 1, 3)" in _words(image)
    assert "the face pointed at" in _words(image)


def test_what_the_answer_describes_stands_beside_it() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    request = SAMPLES["word.decode"]
    other = form.Faces(faces=(*FACES[:2], (0, 3, 1), (0, 2, 3)), vertices=4)
    found = divergence_of(request, other)
    both = _drawn(picture(case_of(request), found, Answered(other)))
    assert {"expected (2, 3, 0)", "got (0, 2, 3)"} <= set(_words(both))
    names = [group.name for group in both.groups]
    assert names == ["heading-0", "0-step-4", "0-legend", "heading-1", "1-step-4", "1-legend"]
    alone = picture(case_of(request), divergence_of(request, WRONG), Answered(WRONG))
    assert len(_drawn(alone).groups) == 3
    declined = picture(case_of(request), found, Declined(Rejection(Fault.LIMIT)))
    assert len(_drawn(declined).groups) == 3


def test_a_fault_is_shown_at_its_parent() -> None:
    """Clause: ORCL-EXPLAIN-5: with what is blamed, and with what was got if there is anything."""
    parent = case_of(SAMPLES["word.decode"])
    bad = replace(
        case_of(GARBAGE["word.decode"][0]),
        reject=Rejection(Fault.INVALID, "unknown-symbol", {"symbol": 1}),
    )
    image = _drawn(picture(bad, parent=parent))
    assert "0-step-3" in {group.name for group in image.groups}
    assert "the parent; to blame: symbol 1" in _words(image)
    got = Divergence(kind="k", place="p", expected="invalid", got="malformed")
    image = _drawn(picture(bad, got, parent=parent))
    assert "0-step-3" in {group.name for group in image.groups}
    assert "expected invalid, got malformed" in _words(image)
    whole = replace(bad, reject=Rejection(Fault.LIMIT))
    assert "the parent; to blame: the whole input" in _words(_drawn(picture(whole, parent=parent)))
    assert isinstance(picture(bad), Rejected)
    assert isinstance(picture(bad, got), Rejected)


@pytest.mark.parametrize(
    ("key", "step"), [("face", "0-step-2"), ("symbol", "0-step-3"), ("vertex", "0-step-4")]
)
def test_each_kind_of_blame(key: str, step: str) -> None:
    """Clause: ORCL-EXPLAIN-5: face 1 is second, symbol 1 is third, a vertex is seen at the end."""
    bad = replace(case_of(GARBAGE["word.decode"][0]), reject=Rejection(Fault.INVALID, "", {key: 1}))
    image = _drawn(picture(bad, parent=case_of(SAMPLES["word.decode"])))
    assert step in {group.name for group in image.groups}


def test_a_record_is_blamed_at_its_split() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    encoded = right_of(message.WordEncode(id=0, input=TORUS)).result
    assert isinstance(encoded, form.WordForm)
    given = form.StreamForm(word=encoded.word, handles=encoded.handles, components_with_boundary=0)
    parent = case_of(message.WordDecode(id=0, input=given))
    split = encoded.word.index("S")
    bad = replace(
        case_of(GARBAGE["word.decode"][0]), reject=Rejection(Fault.INVALID, "", {"record": 0})
    )
    image = _drawn(picture(bad, parent=parent))
    assert f"0-step-{split + 2}" in {group.name for group in image.groups}


def test_bounds() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    case, found = case_of(SAMPLES["word.decode"]), divergence_of(SAMPLES["word.decode"], WRONG)
    small = _drawn(picture(case, found, bounds=Bounds(4, 300)))
    large = _drawn(picture(case, found, bounds=Bounds(4, 600)))
    assert small.width < large.width
    refused = picture(case, found, bounds=Bounds(3, 300))
    assert isinstance(refused, Rejected)
    assert refused.reason is Reason.NOT_DRAWABLE
    assert refused.detail == "4 faces, pictures are of at most 3"


def test_headings() -> None:
    """Clause: ORCL-EXPLAIN-5."""
    long = _at(vertex=1)
    assert headed(long) == "expected e, got g"
    assert headed(replace(long, expected="", place="here")) == "the parent; to blame: here"
    assert cut("x" * WIDE) == "x" * WIDE
    assert cut("x" * (WIDE + 1)) == "x" * (WIDE - 1) + "…"


def test_what_is_no_case_is_not_drawn() -> None:
    """Clause: ORCL-EXPLAIN-5: total."""
    broken: Case = replace(case_of(SAMPLES["word.decode"]), input=msgspec.Raw(b"{}"))
    found = picture(broken)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.NOT_DRAWABLE
