"""The first divergence of each operation, by hand on a tetrahedron (CRE) and small messages."""

import msgspec
import pytest
from judged_by_hand import divergence_of, judged_of, numbers_of, right_of

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.judged import Status
from clers.conformance.messages import Step
from clers.conformance.results import Result
from clers.conformance.samples import FACES, SAMPLES

WORD = form.WordForm(word="CRE", handles=(), components_with_boundary=0, vertex_order=(0, 1, 2, 3))
MESH = form.Faces(faces=FACES, vertices=4)
EXTRA = form.HandleForm(kind="handle", s="9007199254740993", at=1, side="right")
PLACES = form.Places(
    precision="f32", coordinates=(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
)
PLACED = form.MeshForm(faces=FACES, vertices=4, positions=PLACES)
BALL = form.ComponentForm(
    faces=4, vertices=4, edges=6, boundary_edges=0, curves=0, genus=0, euler=2
)
FIRST = form.StageForm(
    operator="",
    numbers={"vertices": 4, "faces": 4, "χ": 2, "components": 1, "genus": 0, "curves": 0},
)
SECOND = form.StageForm(
    operator="split-face 0",
    numbers={"vertices": 5, "faces": 6, "χ": 2, "components": 1, "genus": 0, "curves": 0},
)
replace = msgspec.structs.replace


def _bits(data: str, length: int) -> form.BitString:
    return form.BitString(hex=data, length=length)


def _placed(*coordinates: float) -> form.MeshForm:
    rest = PLACES.coordinates[len(coordinates) :]
    return replace(PLACED, positions=replace(PLACES, coordinates=(*coordinates, *rest)))


@pytest.mark.parametrize(
    ("op", "got", "kind", "place", "expected", "given", "numbers"),
    [
        (
            "word.encode", replace(WORD, word="CLE", handles=(EXTRA,)),
            "symbol", "symbol 1, at face 2, gate 3→1", "R", "L", {"symbol": 1, "face": 2},
        ),
        (
            "word.encode", replace(WORD, word="CR", vertex_order=()),
            "symbol", "symbol 2, at face 3, gate 3→0", "E", "nothing more",
            {"symbol": 2, "face": 3},
        ),
        (
            "word.encode", replace(WORD, word="CREE"),
            "symbol", "symbol 3", "nothing more", "E", {"symbol": 3},
        ),
        (
            "word.encode", replace(WORD, handles=(EXTRA,), components_with_boundary=1),
            "record", "handle record 0", "nothing more",
            "handle of S 9007199254740993, closed at 1, right", {"record": 0},
        ),
        (
            "word.encode", replace(WORD, components_with_boundary=1, vertex_order=()),
            "components with boundary", "the number of components with boundary", "0", "1", {},
        ),
        (
            "word.encode", replace(WORD, vertex_order=(0, 1, 3, 2)),
            "vertex order", "place 2 of the vertex order", "2", "3", {"vertex": 2},
        ),
        (
            "word.encode", replace(WORD, vertex_order=(0, 1, 2, 3, 7)),
            "vertex order", "place 4 of the vertex order", "nothing more", "7", {"vertex": 7},
        ),
        (
            "word.decode", replace(MESH, faces=((1, 2, 0), *FACES[1:]), vertices=5),
            "face", "face 0, made by P", "(0, 1, 2)", "(1, 2, 0)", {"face": 0},
        ),
        (
            "word.decode", replace(MESH, faces=(FACES[0], (2, 1, 3), *FACES[2:])),
            "face", "face 1, made by symbol 0 (C)", "(3, 2, 1)", "(2, 1, 3)",
            {"symbol": 0, "face": 1},
        ),
        (
            "word.decode", replace(MESH, faces=(*FACES[:2], (0, 1, 3), FACES[3])),
            "face", "face 2, made by symbol 1 (R)", "(0, 3, 1)", "(0, 1, 3)",
            {"symbol": 1, "face": 2},
        ),
        (
            "word.decode", replace(MESH, faces=FACES[:3]),
            "face", "face 3, made by symbol 2 (E)", "(2, 3, 0)", "nothing more",
            {"symbol": 2, "face": 3},
        ),
        (
            "word.decode", replace(MESH, faces=(*FACES, (5, 6, "9007199254740993"))),
            "face", "face 4", "nothing more", "(5, 6, 9007199254740993)", {"face": 4},
        ),
        (
            "word.decode", replace(MESH, vertices=5),
            "number of vertices", "the number of vertices", "4", "5", {},
        ),
        (
            "code.encode", _bits("9c", 6),
            "bit", "bit 2, written at symbol 1 (R)", "1", "0", {"bit": 2, "symbol": 1},
        ),
        (
            "code.encode", _bits("b8", 5),
            "bit", "bit 5, written at symbol 2 (E)", "1", "nothing more", {"bit": 5, "symbol": 2},
        ),
        ("code.encode", _bits("bc", 7), "bit", "bit 6", "nothing more", "0", {"bit": 6}),
        (
            "code.encode", _bits("bc", 9),
            "bit", "bit 6", "nothing more", "0", {"bit": 6},
        ),
        (
            "code.encode", _bits("bd", 6),
            "filling bits", "the bytes after bit 5", "bc at the end", "bd at the end", {},
        ),
        (
            "arithmetic.encode", _bits("da", 7),
            "bit", "bit 0, written at symbol 0 (1)", "0", "1", {"bit": 0, "symbol": 0},
        ),
        (
            "arithmetic.encode", _bits("58", 7),
            "bit", "bit 6, written at the end", "1", "0", {"bit": 6},
        ),
        (
            "arithmetic.decode", form.Symbols(symbols=(1, 0)),
            "symbol", "symbol 2", "2", "nothing more", {"symbol": 2},
        ),
        ("code.decode", form.JustWord(word="CLE"), "symbol", "symbol 1", "R", "L", {"symbol": 1}),
        (
            "surface.classify", form.Classified(components=(replace(BALL, genus=1, euler=0),)),
            "genus", "component 0, genus", "0", "1", {"component": 0},
        ),
        (
            "surface.classify", form.Classified(components=(BALL, BALL)),
            "component", "component 1", "1 in all", "2 in all", {"component": 1},
        ),
        (
            "operator.apply", form.Stages(stages=(FIRST,)),
            "stage", "stage 1", "2 in all", "1 in all", {"stage": 1},
        ),
        (
            "operator.apply", form.Stages(stages=(replace(FIRST, operator="x"), SECOND)),
            "operator", "stage 0 (the start), the operator", "none", "x", {"stage": 0},
        ),
        (
            "operator.apply",
            form.Stages(stages=(FIRST, replace(SECOND, numbers={**SECOND.numbers, "χ": 1}))),
            "number", "stage 1 (split-face 0), χ", "2", "1", {"stage": 1},
        ),
        (
            "operator.apply",
            form.Stages(stages=(FIRST, replace(SECOND, numbers={**SECOND.numbers, "n": 0}))),
            "number", "stage 1 (split-face 0), n", "none", "0", {"stage": 1},
        ),
        (
            "operator.apply", form.Stages(stages=(FIRST, replace(SECOND, idle="no room"))),
            "idle", "stage 1 (split-face 0), why nothing was done", "it was done", "no room",
            {"stage": 1},
        ),
        (
            "codec.roundtrip", replace(PLACED, positions=msgspec.UNSET),
            "positions", "the positions", "12 coordinates", "none", {},
        ),
        (
            "codec.roundtrip", replace(PLACED, positions=replace(PLACES, precision="f64")),
            "precision", "the precision of positions", "f32", "f64", {},
        ),
        (
            "codec.roundtrip", _placed(0.0, 0.0, 0.0, 1.0, 0.1),
            "coordinate", "vertex 1, axis y", "0.0 (0x0.0p+0)", "0.1 (0x1.999999999999ap-4)",
            {"vertex": 1},
        ),
        (
            "codec.roundtrip",
            replace(PLACED, positions=replace(PLACES, coordinates=PLACES.coordinates[:11])),
            "coordinate", "vertex 3, axis z", "1.0 (0x1.0000000000000p+0)", "nothing more",
            {"vertex": 3},
        ),
    ],
)  # fmt: skip
def test_the_first_divergence(
    op: str,
    got: Result,
    kind: str,
    place: str,
    expected: str,
    given: str,
    numbers: dict[str, int],
) -> None:
    """Clauses: ORCL-DIVERGE-1, -2, -3, ORCL-DIVERGE-5 … ORCL-DIVERGE-8, ORCL-JUDGE-4."""
    found = divergence_of(SAMPLES[op], got)
    assert (found.kind, found.place) == (kind, place)
    assert (found.expected, found.got) == (expected, given)
    assert numbers_of(found) == numbers


def test_a_number_of_bits_that_are_not_there_diverges() -> None:
    """Clause: ORCL-DIVERGE-3. Eight bits of which nine are said, beside eight."""
    request = message.ArithmeticEncode(
        id=0,
        input=form.ToCode(
            coder="arithmetic", model=form.StaticForm(frequencies=(1, 1)), symbols=(0,) * 6
        ),
    )
    right = right_of(request).result
    assert isinstance(right, form.BitString)
    assert right.length == 8
    found = divergence_of(request, replace(right, length=9))
    assert (found.kind, found.place) == ("number of bits", "the number of bits")
    assert (found.expected, found.got, numbers_of(found)) == ("8", "9", {})


@pytest.mark.parametrize(
    ("byte", "kind", "place", "numbers"),
    [
        (0, "byte", "byte 0: the magic", {}),
        (8, "byte", "byte 8: the version", {}),
        (12, "byte of HEAD", "byte 12 of HEAD: the tag", {}),
        (13, "byte of HEAD", "byte 13 of HEAD: the length of the payload", {}),
        (20, "byte of HEAD", "byte 20 of HEAD: the seal of tag and length", {}),
        (21, "byte of HEAD", "byte 21 of HEAD: the code of the word", {}),
        (22, "byte of HEAD", "byte 22 of HEAD: how positions are coded", {}),
        (23, "byte of HEAD", "byte 23 of HEAD: faces", {}),
        (24, "byte of HEAD", "byte 24 of HEAD: vertices", {}),
        (25, "byte of HEAD", "byte 25 of HEAD: components with boundary", {}),
        (26, "byte of HEAD", "byte 26 of HEAD: symbols", {}),
        (27, "byte of HEAD", "byte 27 of HEAD: handle records", {}),
        (31, "byte of HEAD", "byte 31 of HEAD: the seal of the payload", {}),
        (44, "byte of WORD", "byte 44 of WORD: number of bits", {}),
        (
            45,
            "byte of WORD",
            "byte 45 of WORD: the bits, bit 1, written at symbol 1 (R)",
            {"bit": 1, "symbol": 1},
        ),
        (49, "byte of WORD", "byte 49 of WORD: the seal of the payload", {}),
    ],
)
def test_the_first_byte(byte: int, kind: str, place: str, numbers: dict[str, int]) -> None:
    """Clause: ORCL-DIVERGE-4. The file of section 8.9, one digit of one byte changed."""
    right = right_of(SAMPLES["mesh.encode"]).result
    assert isinstance(right, form.FileForm)
    data = bytearray(bytes.fromhex(right.hex))
    was = data[byte]
    data[byte] ^= 0x40
    found = divergence_of(SAMPLES["mesh.encode"], form.FileForm(hex=data.hex()))
    assert (found.kind, found.place) == (kind, place)
    assert (found.expected, found.got) == (f"{was:02x}", f"{was ^ 0x40:02x}")
    assert numbers_of(found) == {"byte": byte, **numbers}


def test_a_file_that_is_too_short_or_too_long() -> None:
    """Clause: ORCL-DIVERGE-4."""
    right = right_of(SAMPLES["mesh.encode"]).result
    assert isinstance(right, form.FileForm)
    short = divergence_of(SAMPLES["mesh.encode"], form.FileForm(hex=right.hex[:90]))
    assert (short.place, short.expected, short.got) == (
        "byte 45 of WORD: the bits", "bc", "nothing more",
    )  # fmt: skip
    long = divergence_of(SAMPLES["mesh.encode"], form.FileForm(hex=right.hex + "00"))
    assert (long.kind, long.place, long.expected, long.got) == (
        "byte", "byte 50", "nothing more", "00",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("asked", "got", "place", "expected", "given"),
    [
        ({"a": True}, {"a": 1}, "the value at /a", "True", "1"),
        ({"a": 1}, {"a": True}, "the value at /a", "1", "True"),
        ({"a": 0}, {"a": None}, "the value at /a", "0", "None"),
        ({"a": {"b/c~": [1, 3]}}, {"a": {"b/c~": [1, 2]}}, "the value at /a/b~1c~0/1", "3", "2"),
        ({"a": [1]}, {"a": [1, 1]}, "the value at /a", "[1]", "[1, 1]"),
        ({"a": {}}, {"b": {}}, "the whole value", "['a']", "['b']"),
        ({"a": {"x": 1}}, {"a": []}, "the value at /a", "{'x': 1}", "[]"),
        ({"a": []}, {"a": {}}, "the value at /a", "[]", "{}"),
        ({"a": {}}, {"a": []}, "the value at /a", "{}", "[]"),
        ({"a": 1, "b": 2}, {"b": 3, "a": 4}, "the value at /a", "1", "4"),
        ({"a": [[1], [2]]}, {"a": [[3], [4]]}, "the value at /a/0/0", "1", "3"),
    ],
)
def test_echoes(
    asked: dict[str, object], got: dict[str, object], place: str, expected: str, given: str
) -> None:
    """Clauses: ORCL-DIVERGE-10, ORCL-OP-1."""
    found = divergence_of(message.Echo(id=0, input=asked), got)
    assert (found.kind, found.place) == ("value", place)
    assert (found.expected, found.got) == (expected, given)


@pytest.mark.parametrize("got", [{"b": [2.0], "a": 1}, {"a": 1.0, "b": [2]}])
def test_equal_echoes(got: dict[str, object]) -> None:
    """Clause: ORCL-DIVERGE-10: numbers are equal by value, and keys have no order."""
    request = message.Echo(id=0, input={"a": 1, "b": [2]})
    assert judged_of(request, got).status is Status.PASS


def test_numbers_are_equal_in_both_of_their_forms() -> None:
    """Clauses: ORCL-JUDGE-2, ORCL-VALUE-1, ORCL-VALUE-3."""
    minus = _placed(-0.0)
    assert judged_of(SAMPLES["codec.roundtrip"], minus).status is Status.PASS
    words = ("1000000000000000", 1000000000000000)
    request = message.ArithmeticDecode(
        id=0,
        input=form.Coded(
            coder="arithmetic", model=form.UniformForm(size=2), bits=_bits("40", 2), count=0
        ),
    )
    right = right_of(request).result
    assert isinstance(right, form.Symbols)
    assert right.symbols == ()
    found = divergence_of(request, form.Symbols(symbols=(words[0],)))
    assert (found.expected, found.got) == ("nothing more", str(words[1]))


def test_a_result_of_another_form() -> None:
    """Clause: ORCL-RUN-1: judging is total, whatever is called a result."""
    found = divergence_of(SAMPLES["word.decode"], form.JustWord(word="CRE"))
    assert (found.kind, found.expected, found.got) == ("form", "Faces", "JustWord")


WALK = right_of(SAMPLES["word.decode"]).steps


@pytest.mark.parametrize(
    ("steps", "kind", "place", "expected", "given", "numbers"),
    [
        (
            (WALK[0], replace(WALK[1], gate=(1, 2), stack=7), *WALK[2:]),
            "step, gate", "step 1", "(2, 1)", "(1, 2)", {"symbol": 0, "face": 1},
        ),
        (
            (replace(WALK[0], triangle=(1, 2, 0)), *WALK[1:]),
            "step, triangle", "step 0", "(0, 1, 2)", "(1, 2, 0)", {"face": 0},
        ),
        (WALK[:2], "step", "step 2", "symbol R", "nothing more", {"symbol": 1, "face": 2}),
        (
            (*WALK, Step(3, "E")),
            "step", "step 4", "nothing more", "symbol E", {"symbol": 3},
        ),
        (
            (Step(-1, "P"), Step(0, "C"), Step(1, "L"), Step(2, "E")),
            "step, symbol", "step 2", "R", "L", {"symbol": 1, "face": 2},
        ),
    ],
)  # fmt: skip
def test_steps(
    steps: tuple[Step, ...],
    kind: str,
    place: str,
    expected: str,
    given: str,
    numbers: dict[str, int],
) -> None:
    """Clauses: ORCL-DIVERGE-9, ORCL-JUDGE-9: even where the result is right."""
    found = divergence_of(SAMPLES["word.decode"], MESH, steps)
    assert (found.kind, found.place) == (kind, place)
    assert (found.expected, found.got) == (expected, given)
    assert numbers_of(found) == numbers


@pytest.mark.parametrize(
    "steps", [(), WALK, (Step(-1, "P"), Step(0, "C"), Step(1, "R", stack=0), Step(2, "E"))]
)
def test_right_steps_lead_on_to_the_result(steps: tuple[Step, ...]) -> None:
    """Clause: ORCL-DIVERGE-9."""
    assert judged_of(SAMPLES["word.decode"], MESH, steps).status is Status.PASS
    assert divergence_of(SAMPLES["word.decode"], replace(MESH, vertices=5), steps).got == "5"


def test_the_symbol_of_a_face_is_taken_from_the_file() -> None:
    """Clauses: ORCL-DIVERGE-2, ORCL-DIVERGE-5."""
    wrong = form.MeshForm(faces=(*FACES[:2], (0, 1, 3), FACES[3]), vertices=4)
    found = divergence_of(SAMPLES["mesh.decode"], wrong)
    assert found.place == "face 2, made by symbol 1 (R)"


def test_a_case_may_bring_its_own_walk() -> None:
    """Clauses: ORCL-CASE-1, ORCL-DIVERGE-9: it goes before the reference's."""
    from judged_by_hand import case_of

    from clers.conformance.judging.judge import judge
    from clers.conformance.outcome import Answered
    from clers.conformance.serve import INTRODUCTION

    case = replace(case_of(SAMPLES["word.decode"]), trace=(Step(0, "S", face=9),))
    found = judge(case, Answered(MESH, (Step(0, "S"),)), INTRODUCTION)
    assert found.status is Status.PASS
    found = judge(case, Answered(MESH, (Step(0, "C"),)), INTRODUCTION)
    assert found.why == "step 0: expected S, got C"
