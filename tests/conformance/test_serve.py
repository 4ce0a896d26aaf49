"""What the reference answers: by hand, and total whatever is asked."""

import io
import json
import subprocess
import sys
from typing import Final

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from clers.arithmetic.bits import Bits
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.rans import RANS
from clers.codes.closings import Closing
from clers.codes.registry import CodeName
from clers.conformance import payloads as form
from clers.conformance.adapter import answered, loop
from clers.conformance.lines import line_of
from clers.conformance.messages import Bye, Call, CodeDecode, Hello
from clers.conformance.results import RESULTS
from clers.conformance.samples import GARBAGE, SAMPLES
from clers.conformance.serve import INTRODUCTION, MAX_SYMBOLS, serve
from clers.conventions.result import Accepted
from clers.edgebreaker.stream import Kind, Side
from clers.information.static import static

FACES: Final = [[0, 1, 2], [3, 2, 1], [0, 3, 1], [2, 3, 0]]


def ask(operation: str, given_: object, trace: str = "none") -> list[dict[str, object]]:
    """The replies to a request, from line to lines."""
    request = {"op": operation, "id": 3, "in": given_, "trace": trace}
    found = answered(json.dumps(request).encode())
    assert not isinstance(found, Bye)
    return [json.loads(line_of(reply)) for reply in found]


def reason_of(reply: dict[str, object]) -> object:
    rejection = reply["reject"]
    assert isinstance(rejection, dict)
    return rejection["reason"]


def ok(operation: str, given_: object) -> object:
    (reply,) = ask(operation, given_)
    assert reply.keys() == {"id", "ok"}, reply
    assert reply["id"] == 3
    return reply["ok"]


def test_hello() -> None:
    """Clauses: ORCL-HELLO-2, ORCL-HELLO-3, ORCL-SERVE-1."""
    (reply,) = serve(Hello(0, 1, "1.0", ""))
    document = json.loads(line_of(reply))
    assert document["ok"]["name"] == "clers"
    assert document["ok"]["ops"] == list(RESULTS)
    assert document["ok"]["caps"]["max_symbols"] == 1048576
    assert set(document["ok"]["caps"]["trace"]) == {"word.encode", "word.decode"}
    assert document["ok"] == json.loads(msgspec.json.encode(INTRODUCTION))
    assert [json.loads(line_of(r)) for r in serve(Hello(0, 2, "1.0", ""))] == [
        {"id": 0, "unsupported": {"cap": "protocol"}}
    ]
    assert serve(Bye()) == ()


def test_echo() -> None:
    """ORCL-OP-1."""
    given_ = {"a": [1, None, True, "χ\n\x00"], "b": {"c": 0.1}}
    assert ok("echo", given_) == given_


def test_classify() -> None:
    """ORCL-OP-2: a tetrahedron and a triangle, by the tutorial's definitions."""
    sphere = {"faces": 4, "vertices": 4, "edges": 6, "boundary_edges": 0, "curves": 0}
    disc = {"faces": 1, "vertices": 3, "edges": 3, "boundary_edges": 3, "curves": 1}
    assert ok("surface.classify", {"faces": [*FACES, [4, 5, 6]], "vertices": 7}) == {
        "components": [{**sphere, "genus": 0, "euler": 2}, {**disc, "genus": 0, "euler": 1}]
    }
    moebius = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 0, 4], [4, 0, 1]]
    (reply,) = ask("surface.classify", {"faces": moebius, "vertices": 5})
    assert reason_of(reply) == "edge-twice-in-one-direction"


def test_apply() -> None:
    """ORCL-OP-3: an ear on nothing but closed surfaces does nothing, and says so."""
    found = ok("operator.apply", {"script": "split-face 0; add-ear 0"})
    start = {"vertices": 4, "faces": 4, "χ": 2, "components": 1, "genus": 0, "curves": 0}
    split = {**start, "vertices": 5, "faces": 6}
    assert found == {
        "stages": [
            {"operator": "", "numbers": start, "idle": ""},
            {"operator": "split-face 0", "numbers": split, "idle": ""},
            {"operator": "add-ear 0", "numbers": split, "idle": "no-candidate"},
        ]
    }
    (reply,) = ask("operator.apply", {"script": "attach 0 1; collapse 0 | 0 1 2"})
    assert "reject" in reply


def test_arithmetic() -> None:
    """ORCL-OP-4: there and back, and the bits of the coder that is named."""
    model = {"kind": "static", "frequencies": [1, 2, 1]}
    bits = ok("arithmetic.encode", {"coder": "arithmetic", "model": model, "symbols": [1, 0, 2]})
    back = {"coder": "arithmetic", "model": model, "bits": bits, "count": 3}
    assert ok("arithmetic.decode", back) == {"symbols": [1, 0, 2]}
    table = static((1, 2, 1))
    assert isinstance(table, Accepted)
    for name, coder in (("range", RANGE_CODER), ("rans", RANS)):
        direct = coder.encode(table.value, (1, 0, 2))
        assert isinstance(direct, Accepted)
        asked = {"coder": name, "model": model, "symbols": [1, 0, 2]}
        assert ok("arithmetic.encode", asked) == {
            "hex": direct.value.data.hex(),
            "length": direct.value.length,
        }


@pytest.mark.parametrize(
    "model",
    [
        {"kind": "uniform", "size": 8},
        {"kind": "adaptive", "frequencies": [1] * 8, "increment": 2, "limit": 20},
    ],
)
def test_models(model: object) -> None:
    """ORCL-OP-4: three bits a symbol at least where all are alike; there and back."""
    symbols = [7, 0, 7, 7, 1]
    for coder in ("arithmetic", "range", "rans"):
        bits = ok("arithmetic.encode", {"coder": coder, "model": model, "symbols": symbols})
        back = {"coder": coder, "model": model, "bits": bits, "count": 5}
        assert ok("arithmetic.decode", back) == {"symbols": symbols}
    (reply,) = ask(
        "arithmetic.encode",
        {"coder": "rans", "model": {"kind": "uniform", "size": 0}, "symbols": []},
    )
    assert reason_of(reply) == "bad-table"


def test_words() -> None:
    """ORCL-OP-5: the tetrahedron is CRE; its faces as the chapter's page shows them."""
    stream = {"word": "CRE", "handles": [], "components_with_boundary": 0}
    assert ok("word.decode", stream) == {"faces": FACES, "vertices": 4}
    assert ok("word.encode", {"faces": FACES, "vertices": 4}) == {
        **stream,
        "vertex_order": [0, 1, 2, 3],
    }


def test_words_with_handle_data() -> None:
    """ORCL-OP-5: an annulus of six triangles; one record, of a boundary."""
    faces = [[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5]]
    encoded = ok("word.encode", {"faces": faces, "vertices": 6})
    assert isinstance(encoded, dict)
    assert [handle["kind"] for handle in encoded["handles"]] == ["boundary"]
    order = encoded.pop("vertex_order")
    decoded = ok("word.decode", encoded)
    assert isinstance(decoded, dict)
    back = {frozenset(order[v] for v in face) for face in decoded["faces"]}
    assert back == {frozenset(face) for face in faces}
    closings_free = {"code": "plain", **encoded}
    assert isinstance(ok("code.encode", closings_free), dict)


def test_traces() -> None:
    """ORCL-EVENT-1: the walk, in order; and none of what is rejected, or not asked for."""
    stream = {"word": "CRE", "handles": [], "components_with_boundary": 0}
    *events, last = ask("word.decode", stream, "full")
    assert "ok" in last
    steps = [event["ev"] for event in events]
    assert steps[1] == {
        "i": 0, "symbol": "C", "component": 0, "face": 1, "triangle": [3, 2, 1], "gate": [2, 1],
        "stack": 0, "new": [3], "opens": -1, "closes": [], "euler": 1,
    }  # fmt: skip
    assert [(step["i"], step["symbol"]) for step in steps] == [  # type: ignore[index]
        (-1, "P"), (0, "C"), (1, "R"), (2, "E")
    ]  # fmt: skip
    relabelled = {"faces": [[0, 1, 2], [3, 2, 1], [2, 3, 0], [0, 3, 1]], "vertices": 4}
    *events, last = ask("word.encode", relabelled, "full")
    assert "ok" in last
    assert [event["ev"]["face"] for event in events] == [0, 1, 3, 2]  # type: ignore[index]
    assert len(ask("word.decode", {**stream, "word": "CRX"}, "full")) == 1
    assert len(ask("word.decode", stream)) == 1
    assert len(ask("echo", {}, "full")) == 1


@pytest.mark.parametrize("code", CodeName)
def test_codes(code: str) -> None:
    """ORCL-OP-6: whatever codes there are, by name; the plain code by hand."""
    word = "CCRRE"
    given_ = {"code": code, "word": word, "handles": [], "components_with_boundary": 0}
    bits = ok("code.encode", given_)
    if code == "plain":  # after the implied C: C 0, R 101, R 101, E 111
        assert bits == {"hex": "5bc0", "length": 10}
    back = {"code": code, "bits": bits, "symbols": 5, "components_with_boundary": 0}
    assert ok("code.decode", back) == {"word": word}


def test_a_code_by_another_name() -> None:
    """Clauses: ORCL-OP-6, ORCL-OP-7, ORCL-REPLY-3."""
    stream = {"word": "CRE", "handles": [], "components_with_boundary": 0}
    mesh = {"faces": FACES, "vertices": 4, "accuracy": {"kind": "exact"}}
    bits = {"bits": {"hex": "", "length": 0}, "symbols": 0, "components_with_boundary": 0}
    for operation, given_ in (
        ("code.encode", stream),
        ("mesh.encode", mesh),
        ("code.decode", bits),
    ):
        (reply,) = ask(operation, {"code": "morse", **given_})
        assert reply == {"id": 3, "unsupported": {"cap": "code.morse"}}


def test_too_many_symbols() -> None:
    """ORCL-SERVE-1."""
    lacking = {"id": 3, "unsupported": {"cap": "max_symbols"}}
    bits = {"hex": "", "length": 0}
    code = {"code": "plain", "bits": bits, "components_with_boundary": 0}
    (reply,) = ask("code.decode", {**code, "symbols": MAX_SYMBOLS + 1})
    assert reply == lacking
    (reply,) = ask("code.decode", {**code, "symbols": MAX_SYMBOLS})
    assert "reject" in reply
    model = {"kind": "uniform", "size": 8}
    message = {"coder": "arithmetic", "model": model, "bits": bits}
    (reply,) = ask("arithmetic.decode", {**message, "count": MAX_SYMBOLS + 1})
    assert reply == lacking
    (reply,) = ask("arithmetic.decode", {**message, "count": MAX_SYMBOLS})
    assert "reject" in reply


CORNERS: Final = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.1, 0.0, -0.0]


@pytest.mark.parametrize(
    ("accuracy", "x"),
    [
        ({"kind": "exact"}, 0.1),
        ({"kind": "lattice", "exponent": -1}, 0.0),
        ({"kind": "bits", "bits": 3}, 0.0),
        ({"kind": "error", "bound": 0.5}, 0.0),
    ],
)
def test_files(accuracy: object, x: float) -> None:
    """Clauses: ORCL-OP-7, ORCL-VALUE-3: bytes and back; 0.1 is exact, or moves to a lattice."""
    mesh = {"faces": FACES, "vertices": 4}
    positions = {"precision": "f64", "coordinates": CORNERS}
    given_ = {**mesh, "positions": positions, "code": "golden", "accuracy": accuracy}
    found = ok("mesh.decode", ok("mesh.encode", given_))
    assert isinstance(found, dict)
    assert (found["faces"], found["vertices"]) == (FACES, 4)
    assert found["positions"]["coordinates"][9] == x


def test_files_without_positions() -> None:
    """Clauses: ORCL-OP-7, ORCL-OP-8."""
    mesh = {"faces": FACES, "vertices": 4}
    given_ = {**mesh, "code": "golden", "accuracy": {"kind": "exact"}}
    assert ok("mesh.decode", ok("mesh.encode", given_)) == mesh
    assert ok("codec.roundtrip", mesh) == mesh
    positions = {"precision": "f64", "coordinates": CORNERS}
    assert ok("codec.roundtrip", {**mesh, "positions": positions}) == {
        **mesh,
        "positions": positions,
    }
    short = {"precision": "f32", "coordinates": CORNERS[:9]}
    (reply,) = ask("codec.roundtrip", {**mesh, "positions": short})
    assert reason_of(reply) == "count-mismatch"
    wide = {"precision": "f32", "coordinates": CORNERS}
    (reply,) = ask("codec.roundtrip", {**mesh, "positions": wide})
    assert reason_of(reply) == "not-representable"


def test_closings_are_handed_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-OP-6: a record seen from the end becomes one of chapter 6."""
    given_: list[object] = []

    def decode(*arguments: object) -> Accepted[str]:
        given_.extend(arguments)
        return Accepted("CRE")

    monkeypatch.setattr("clers.codes.registry.decode", decode)
    closing = form.ClosingForm(passed=1, kind="handle", side="left", between=2)
    asked = SAMPLES["code.decode"]
    assert isinstance(asked, CodeDecode)
    with_one = msgspec.structs.replace(asked.input, components_with_boundary=4, closings=(closing,))
    (reply,) = serve(msgspec.structs.replace(asked, input=with_one))
    assert b'"CRE"' in line_of(reply)
    bits = Bits(bytes([0xBC]), 6)
    assert given_ == [CodeName.PLAIN, bits, 3, 4, (Closing(1, Kind.HANDLE, Side.LEFT, 2),)]


@pytest.mark.parametrize("name", GARBAGE)
def test_garbage_is_rejected(name: str) -> None:
    """Clauses: ORCL-REPLY-2, ORCL-DOCTOR-2."""
    for operation in GARBAGE[name]:
        *events, last = serve(operation)
        assert not events
        document = json.loads(line_of(last))
        assert document["reject"]["class"] in {"malformed", "invalid"}


def test_a_rejection_in_full() -> None:
    """ORCL-REPLY-2: class, reason, element, clause, detail."""
    (reply,) = ask("word.decode", {"word": "CXE", "handles": [], "components_with_boundary": 0})
    assert reply["reject"] == {
        "class": "invalid",
        "reason": "unknown-symbol",
        "at": {"symbol": 1},
        "clause": "EB-GRAMMAR-1",
        "detail": "'X'",
    }


@pytest.mark.parametrize(
    ("line", "reply"),
    [
        (b'{"op":"nope","id":9,"in":{}}', {"id": 9, "unsupported": {"cap": "nope"}}),
        (b'{"op":"nope","id":-9}', None),
        (b'{"op":"nope","id":"x"}', None),
        (b'{"op":7,"id":9}', 9),
        (b'{"op":"echo","id":9,"in":3}', 9),
        (b'{"op":"hello","id":9}', 9),
        (b'{"op":"hello","id":0,"protocol":2,"spec":"9","suite":"","more":1}', 0),
        (b'{"op":"bye","id":9}', 9),
        (b"rubbish", None),
        (b"", None),
        (b"\xff{}", None),
        (b'{"op":"echo\xff","id":9,"in":{}}', None),
        (b"[" * 100_000, None),
    ],
)
def test_lines_that_are_no_request(line: bytes, reply: object) -> None:
    """Clauses: ORCL-REPLY-3, ORCL-REPLY-4."""
    found = answered(line)
    assert not isinstance(found, Bye)
    (document,) = (json.loads(line_of(r)) for r in found)
    if isinstance(reply, dict):
        assert document == reply
    else:
        assert (document["id"], document.keys()) == (reply, {"id", "error"})


def test_a_fault_of_the_adapter_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-REPLY-4."""

    def fails(_: object) -> tuple[()]:
        raise ValueError("no luck")

    monkeypatch.setattr("clers.conformance.adapter.serve", fails)
    (reply,) = ask("echo", {})
    assert reply == {"id": 3, "error": {"message": "ValueError: no luck"}}


@given(st.binary(max_size=60), st.sampled_from(sorted(RESULTS)), st.integers(0, 9))
def test_every_line_is_answered(noise: bytes, name: str, keep: int) -> None:
    """Clauses: ORCL-REPLY-1, ORCL-REPLY-4: whole lines, and lines cut and soiled."""
    line = json.dumps({"op": name, "id": 1, "in": noise.decode("latin-1")}).encode()
    for tried in (noise, line[: len(line) - keep]):
        found = answered(tried)
        assert isinstance(found, Bye) or len(found) == 1


@pytest.mark.parametrize("line", [b'{"op":"\xb2","id":1}', b'{"id":"\xb2"}', b'{"op":1,"id":"1"}'])
def test_text_that_is_no_utf8_is_answered(line: bytes) -> None:
    """Clauses: ORCL-REPLY-1, ORCL-REPLY-4."""
    found = answered(line)
    assert not isinstance(found, Bye)
    assert [type(reply).__name__ for reply in found] == ["ErrorReply"]


def test_the_loop() -> None:
    """Clauses: ORCL-LINE-1, ORCL-LINE-2, ORCL-BYE-1: nothing is read after bye."""
    echo = b'{"op":"echo","id":1,"in":{"a":1}}\n'
    out = io.BytesIO()
    given_ = io.BytesIO(echo + b"\n" + b'{"op":"bye"}\n' + echo)
    loop(given_, out)
    first, second = out.getvalue().splitlines()
    assert json.loads(first) == {"id": 1, "ok": {"a": 1}}
    assert "error" in json.loads(second)
    assert given_.read() == echo


def test_as_a_program() -> None:
    """Clauses: ORCL-SERVE-1, ORCL-BYE-1: at the end of input it ends with code 0."""
    code = "from clers.cli.main import main; main()"
    command = (sys.executable, "-c", code, "adapter", "reference")
    done = subprocess.run(
        command, input=b'{"op":"echo","id":1,"in":{}}\n', capture_output=True, timeout=60
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, b'{"id":1,"ok":{}}\n', b"")


def test_samples_are_of_all_operations() -> None:
    """ORCL-DOCTOR-2: each sample has the name it stands under."""
    assert list(SAMPLES) == list(RESULTS)
    for name, operation in [*SAMPLES.items(), *((n, o) for n in GARBAGE for o in GARBAGE[n])]:
        assert isinstance(operation, Call)
        assert type(operation).__struct_config__.tag == name
        assert type(operation) is RESULTS[name][0]
