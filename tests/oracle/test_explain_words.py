"""What is said of a case: the input, the answer, the way to it, the fault. By hand."""

import msgspec
import pytest
from judged_by_hand import case_of, right_of

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case, Edit, FaultForm
from clers.conformance.messages import Rejection, Step
from clers.conformance.samples import FACES, GARBAGE, SAMPLES
from clers.conventions.reason import Fault
from clers.oracle.explaining.explain import UNKNOWN, explanation, undoing
from clers.oracle.explaining.explanation import Table, Told
from clers.oracle.explaining.found import NoCase, case_named
from clers.oracle.explaining.inputs import MOST, WIDE, asked_in_short, cut, listed, result_in_short
from clers.oracle.explaining.tables import BITS, BYTES, WALK

TRIANGLES = "4 faces on 4 vertices: (0,1,2) (3,2,1) (0,3,1) (2,3,0)"
WORD = "word CRE, no handle data, 0 with boundary"
FILE = (
    "50 bytes: 89434c4552530d0a0148454144070000001643c97d010104040003003b6588a1574f52440200"
    "0000d8bfbece06bcde4a54d5"
)


@pytest.mark.parametrize(
    ("op", "asks", "right"),
    [
        ("echo", "{}", "{}"),
        ("surface.classify", TRIANGLES, "1 components"),
        ("operator.apply", "script: split-face 0", "2 stages"),
        ("arithmetic.encode", "arithmetic, static 1 2 1, symbols 1 0 2", "7 bits: 5a"),
        (
            "arithmetic.decode",
            "arithmetic, static 1 2 1, 3 symbols from 7 bits: 5a",
            "symbols 1 0 2",
        ),
        ("word.encode", TRIANGLES, f"{WORD}; vertex order 0 1 2 3"),
        ("word.decode", WORD, TRIANGLES),
        ("code.encode", f"code plain, {WORD}", "6 bits: bc"),
        (
            "code.decode",
            "code plain, 3 symbols, 0 with boundary, 0 closings, from 6 bits: bc",
            "word CRE",
        ),
        ("mesh.encode", f"{TRIANGLES}; no positions; code plain, accuracy exact", FILE),
        ("mesh.decode", FILE, f"{TRIANGLES}; no positions"),
        ("codec.roundtrip", f"{TRIANGLES}; f32 positions", f"{TRIANGLES}; f32 positions"),
    ],
)
def test_inputs_and_answers_in_short(op: str, asks: str, right: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    assert asked_in_short(SAMPLES[op]) == asks
    assert result_in_short(right_of(SAMPLES[op]).result) == right
    found = explanation(case_of(SAMPLES[op]), {}, {})
    assert (found.op, found.asks, found.answer) == (op, asks, right)


@pytest.mark.parametrize(
    ("accuracy", "said"),
    [
        (form.LatticeForm(exponent=-3), "a lattice of step 2^-3"),
        (form.BitsForm(bits=12), "12 bits an axis"),
        (form.ErrorForm(bound=0.1), "an error of 0.1 at most"),
    ],
)
def test_accuracies(accuracy: form.AccuracyForm, said: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    given = form.ToFile(faces=FACES, vertices=4, code="best", accuracy=accuracy)
    text = asked_in_short(message.MeshEncode(id=0, input=given))
    assert text.endswith(f"code best, accuracy {said}")


@pytest.mark.parametrize(
    ("model", "said"),
    [
        (form.UniformForm(size=7), "uniform over 7"),
        (
            form.AdaptiveForm(frequencies=(1, 2), increment=3, limit=40),
            "adaptive from 1 2 by 3 up to 40",
        ),
    ],
)
def test_models(model: form.ModelForm, said: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    given = form.ToCode(coder="rans", model=model, symbols=())
    assert asked_in_short(message.ArithmeticEncode(id=0, input=given)) == f"rans, {said}, symbols "


def test_handle_data_and_long_lists_are_cut() -> None:
    """Clause: ORCL-EXPLAIN-1."""
    record = form.HandleForm(kind="boundary", s=3, at=5, side="left")
    stream = form.StreamForm(word="", handles=(record,) * (MOST + 1), components_with_boundary=1)
    told = asked_in_short(message.WordDecode(id=0, input=stream))
    assert told.startswith("word empty, handle data boundary 3/5/left; boundary 3/5/left;")
    assert told.count("boundary 3/5/left") == MOST
    assert told.endswith(f" … ({MOST + 1}), 1 with boundary")
    assert listed(range(MOST)) == " ".join(map(str, range(MOST)))
    assert listed(range(MOST + 1)) == f"{listed(range(MOST))} … ({MOST + 1})"
    assert cut("x" * WIDE) == "x" * WIDE
    assert cut("x" * (WIDE + 1)) == f"{'x' * WIDE}… ({WIDE + 1} characters)"
    assert asked_in_short(message.Apply(id=0, input=form.ScriptForm(script=""))) == "script: empty"
    assert result_in_short(form.BitString(hex="", length=0)) == "0 bits: none"


THE_WALK = Table(
    title="the walk",
    heads=WALK,
    rows=(
        ("0", "P", "0", "–", "0", "0", "1", "0 1 2", ""),
        ("1", "C", "1", "2→1", "3", "0", "1", "3", ""),
        ("2", "R", "2", "3→1", "0", "0", "1", "", ""),
        ("3", "E", "3", "3→0", "2", "0", "2", "", ""),
    ),
)
THE_FILE = Table(
    title="the file",
    heads=BYTES,
    rows=(
        ("0", "", "89 43 4c 45 52 53 0d 0a", "the magic", ""),
        ("8", "", "01", "the version", ""),
        ("9", "HEAD", "48 45 41 44", "the tag", "HEAD"),
        ("13", "HEAD", "07 00 00 00", "the length of the payload", "7"),
        ("17", "HEAD", "16 43 c9 7d", "the seal of tag and length", ""),
        ("21", "HEAD", "01", "the code of the word", "plain"),
        ("22", "HEAD", "01", "how positions are coded", "none"),
        ("23", "HEAD", "04", "faces", "4"),
        ("24", "HEAD", "04", "vertices", "4"),
        ("25", "HEAD", "00", "components with boundary", "0"),
        ("26", "HEAD", "03", "symbols", "3"),
        ("27", "HEAD", "00", "handle records", "0"),
        ("28", "HEAD", "3b 65 88 a1", "the seal of the payload", ""),
        ("32", "WORD", "57 4f 52 44", "the tag", "WORD"),
        ("36", "WORD", "02 00 00 00", "the length of the payload", "2"),
        ("40", "WORD", "d8 bf be ce", "the seal of tag and length", ""),
        ("44", "WORD", "06", "number of bits", "6"),
        ("45", "WORD", "bc", "the bits", ""),
        ("46", "WORD", "de 4a 54 d5", "the seal of the payload", ""),
    ),
)
THE_BITS = Table(title="the bits", heads=BITS, rows=(("1", "R", "101"), ("2", "E", "111")))
THE_CODE = Table(
    title="the bits",
    heads=BITS,
    rows=(("0", "1", "–"), ("1", "0", "010"), ("2", "2", "11"), ("", "the end", "01")),
)


@pytest.mark.parametrize(
    ("op", "tables"),
    [
        ("echo", ()),
        ("word.encode", (THE_WALK,)),
        ("word.decode", (THE_WALK,)),
        ("mesh.encode", (THE_FILE, THE_WALK)),
        ("mesh.decode", (THE_FILE, THE_WALK)),
        ("code.encode", (THE_BITS,)),
        ("code.decode", (THE_BITS,)),
        ("codec.roundtrip", ()),
        (
            "surface.classify",
            (
                Table(
                    title="the components",
                    heads=(
                        "component", "faces", "vertices", "edges", "boundary_edges", "curves",
                        "genus", "euler",
                    ),
                    rows=(("0", "4", "4", "6", "0", "0", "0", "2"),),
                ),
            ),
        ),
        (
            "operator.apply",
            (
                Table(
                    title="the stages",
                    heads=(
                        "stage", "operator", "vertices", "faces", "χ", "components", "genus",
                        "curves", "nothing done",
                    ),
                    rows=(
                        ("0", "the start", "4", "4", "2", "1", "0", "0", ""),
                        ("1", "split-face 0", "5", "6", "2", "1", "0", "0", ""),
                    ),
                ),
            ),
        ),
    ],
)  # fmt: skip
def test_the_way_to_the_answer(op: str, tables: tuple[Table, ...]) -> None:
    """Clause: ORCL-EXPLAIN-2: the tetrahedron of section 8.9."""
    assert explanation(case_of(SAMPLES[op]), {}, {}).tables == tables


@pytest.mark.parametrize("op", ["arithmetic.encode", "arithmetic.decode"])
def test_the_bits_of_a_message(op: str) -> None:
    """Clause: ORCL-EXPLAIN-2: together they are all bits, in order, one group a symbol."""
    (table,) = explanation(case_of(SAMPLES[op]), {}, {}).tables
    assert [row[:2] for row in table.rows] == [("0", "1"), ("1", "0"), ("2", "2"), ("", "the end")]
    assert "".join(row[2].replace("–", "") for row in table.rows) == "0101101"


def test_bits_that_nothing_is_known_of_have_no_table() -> None:
    """Clause: ORCL-EXPLAIN-2."""
    given = form.ToWord(code="king-rossignac", word="CRE", handles=(), components_with_boundary=0)
    assert explanation(case_of(message.CodeEncode(id=0, input=given)), {}, {}).tables == ()


def test_the_bits_of_a_word_with_handles_that_is_read() -> None:
    """Clauses: ORCL-EXPLAIN-2, CODE-HAND-3: a torus; the groups need its records."""
    given = form.FromWord(
        code="adaptive-1",
        bits=form.BitString(hex="", length=0),
        symbols=17,
        components_with_boundary=0,
        closings=(
            form.ClosingForm(passed=0, kind="handle", side="right", between=0),
            form.ClosingForm(passed=0, kind="handle", side="right", between=0),
        ),
    )
    case = msgspec.structs.replace(
        case_of(SAMPLES["code.decode"]),
        input=msgspec.Raw(msgspec.json.encode(given)),
        ok=msgspec.Raw(b'{"word":"CCCCRCSCRSSRLSEEE"}'),
    )
    (table,) = explanation(case, {}, {}).tables
    assert [row[1] for row in table.rows] == [*"CCCRCSCRSSRLSEEE", "the end"]
    many = msgspec.structs.replace(given, closings=given.closings * 3)
    case = msgspec.structs.replace(case, input=msgspec.Raw(msgspec.json.encode(many)))
    assert explanation(case, {}, {}).tables == ()


def test_a_walk_with_records() -> None:
    """Clause: ORCL-EXPLAIN-2: an annulus, whose S reaches the other curve."""
    faces: list[tuple[int, int, int]] = []
    for i in range(3):
        j = (i + 1) % 3
        faces += [(i, j, 3 + i), (j, 3 + j, 3 + i)]
    given = form.Faces(faces=tuple(faces), vertices=6)
    (table,) = explanation(case_of(message.WordEncode(id=0, input=given)), {}, {}).tables
    told = [row[-1] for row in table.rows]
    assert sorted(text for text in told if text) == ["closes 0", "opens 0"]


def test_a_walk_of_which_little_is_known() -> None:
    """Clause: ORCL-EXPLAIN-2: what a case's own steps do not say is left out."""
    case = msgspec.structs.replace(case_of(SAMPLES["word.decode"]), trace=(Step(0, "C"),))
    (table,) = explanation(case, {}, {}).tables
    assert table.rows == (("0", "C", "", "–", "", "", "", "", ""),)


def test_texts_and_flags() -> None:
    """Clause: ORCL-EXPLAIN-1."""
    case = msgspec.structs.replace(
        case_of(SAMPLES["echo"]),
        clauses=("ORCL-OP-1", "ORCL-LINE-1"),
        flags=("deaf", "mute"),
        requires=("handles",),
        comment="a comment",
        size=3,
        compare="isomorphic",
    )
    found = explanation(case, {"ORCL-OP-1": "echo"}, {"mute": "says nothing"})
    assert found.clauses == (
        Told(name="ORCL-OP-1", text="echo"),
        Told(name="ORCL-LINE-1", text=UNKNOWN),
    )
    assert found.flags == (Told(name="deaf", text=""), Told(name="mute", text="says nothing"))
    assert (found.id, found.origin, found.size) == (case.id, "generated", 3)
    assert (found.requires, found.comment, found.compare) == (
        ("handles",),
        "a comment",
        "isomorphic",
    )
    assert (found.blamed, found.fault) == ("", msgspec.UNSET)


UNDO = FaultForm(
    kind="letter",
    parent="parent-aaaaaaaa",
    undo=(
        Edit(path="/word", at=2, remove=msgspec.Raw(b'"X"'), insert=msgspec.Raw(b'"E"')),
        Edit(path="/faces", at=0, remove=msgspec.Raw(b"[[0,1]]"), insert=msgspec.Raw(b"[]")),
        Edit(path="/vertices", remove=msgspec.Raw(b"3"), insert=msgspec.Raw(b"4")),
    ),
)


def test_faults() -> None:
    """Clause: ORCL-EXPLAIN-3."""
    case = msgspec.structs.replace(case_of(GARBAGE["word.decode"][0]), fault=UNDO)
    found = explanation(case, {}, {})
    assert found.answer == "reject invalid: unknown-symbol at symbol 0 [EB-GRAMMAR-1]: 'X'"
    assert (found.blamed, found.fault, found.tables) == ("symbol 0", UNDO, ())
    assert undoing(UNDO) == (
        '/word, from 2 on: "X" becomes "E"',
        "/faces, from 0 on: [[0,1]] becomes []",
        "/vertices: 3 becomes 4",
    )
    sealed = msgspec.structs.replace(UNDO, undo=(), sealed=True)
    assert undoing(sealed) == ("then the checksums are made anew",)


def test_a_rejection_of_the_whole_input() -> None:
    """Clause: ORCL-EXPLAIN-3."""
    case = msgspec.structs.replace(
        case_of(GARBAGE["word.decode"][1]), reject=Rejection(Fault.LIMIT)
    )
    found = explanation(case, {}, {})
    assert (found.answer, found.blamed) == ("reject limit", "the whole input")


def test_what_is_no_case_is_told_as_far_as_it_goes() -> None:
    """Clause: ORCL-EXPLAIN-1: explaining is total."""
    case = msgspec.structs.replace(case_of(SAMPLES["word.decode"]), input=msgspec.Raw(b"{}"))
    found = explanation(case, {}, {})
    assert "word" in found.asks
    assert found.tables == ()
    case = msgspec.structs.replace(case_of(SAMPLES["word.decode"]), ok=msgspec.Raw(b"{}"))
    found = explanation(case, {}, {})
    assert "faces" in found.answer
    assert found.tables == ()


def _case(name: str) -> Case:
    return msgspec.structs.replace(case_of(SAMPLES["echo"]), id=name)


CASES = tuple(map(_case, ("torus-aaaaaaaa", "torus-two-aaaaaaaa", "sphere-bbbbbbbb")))


@pytest.mark.parametrize("name", ["sphere-bbbbbbbb", "sphere", "s"])
def test_a_case_by_its_id_or_the_beginning_of_it(name: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    assert case_named(name, CASES) == CASES[2]
    assert case_named("torus-aaaaaaaa", (CASES[1], CASES[0])) == CASES[0]


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("torus", "2 cases begin with 'torus': torus-aaaaaaaa, torus-two-aaaaaaaa"),
        ("spere-bbbbbbbb", "no case 'spere-bbbbbbbb'; near it: sphere-bbbbbbbb"),
        ("bbbb", "no case 'bbbb'; near it: sphere-bbbbbbbb"),
        ("quartz", "no case 'quartz'"),
    ],
)
def test_what_names_no_case_or_several(name: str, why: str) -> None:
    """Clause: ORCL-EXPLAIN-1."""
    assert case_named(name, CASES) == NoCase(why)


def test_many_ids_are_counted() -> None:
    """Clause: ORCL-EXPLAIN-1."""
    many = tuple(_case(f"many-{k}-aaaaaaaa") for k in range(10))
    found = case_named("many", many)
    assert isinstance(found, NoCase)
    assert found.why.startswith("10 cases begin with 'many': many-0-aaaaaaaa, ")
    assert found.why.endswith("many-7-aaaaaaaa and 2 more")
