"""An adapter's answers held against each other: no reference says what is right. ORCL-FUZZ-7."""

from collections import Counter
from collections.abc import Mapping
from typing import Final

import msgspec
from msgspec import Raw

from clers.codes.closings import closings
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.messages import Introduction, Operation
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.outcome import Answered, Declined, Outcome
from clers.conformance.served.forms import stream_of
from clers.conventions.result import Rejected
from clers.oracle.fuzz.behind import closing_forms
from clers.oracle.fuzz.checks import Asker, Check, Tried, is_asked
from clers.oracle.fuzz.question import question

COMES_BACK: Final = "comes-back"
NAMES: Final = "names-do-not-matter"

PARTNER: Final[Mapping[str, str]] = {
    "word.encode": "word.decode",
    "code.encode": "code.decode",
    "arithmetic.encode": "arithmetic.decode",
    "mesh.encode": "mesh.decode",
}
"""The operation that undoes an operation. Clause: ORCL-FUZZ-7."""


def failed(case: Case, law: str, kind: str, why: str) -> Judged:
    """A law that failed on an input. Clauses: ORCL-FUZZ-7, ORCL-JUDGE-5."""
    return Judged(
        id=case.id,
        op=case.op,
        clauses=("ORCL-FUZZ-7",),
        status=Status.FAIL,
        why=why,
        signature=f"{case.op} law {law}: {kind}",
    )


def held(case: Case) -> Judged:
    """A law that held on an input."""
    return Judged(id=case.id, op=case.op, clauses=case.clauses, status=Status.PASS)


def comes_back(of: Asker) -> Check:
    """What was encoded comes back from decoding. Clause: ORCL-FUZZ-7."""

    def check(operation: Operation) -> Tried | None:
        case = is_asked(question(operation), of.said)
        if case is None:
            return None
        request = of.request(operation)
        first = of.ask(request)
        back = _undoing(operation, first)
        if back is None:
            return None
        second = of.ask(of.request(back))
        found = _what_came(operation, first, second, of.said)
        if found is None:
            return None
        judged = failed(case, COMES_BACK, *found) if found[0] else held(case)
        return Tried(case, request, second, judged, COMES_BACK)

    return check


def _undoing(operation: Operation, first: Outcome) -> Operation | None:
    """The request that is to give the input back; none where there was no good answer."""
    if not isinstance(first, Answered):
        return None
    match operation, first.result:
        case message.WordEncode(), form.WordForm() as word:
            stream = form.StreamForm(
                word=word.word,
                handles=word.handles,
                components_with_boundary=word.components_with_boundary,
            )
            return message.WordDecode(id=0, input=stream)
        case message.CodeEncode(input=given), form.BitString() as bits:
            seen = closings(stream_of(given))
            if isinstance(seen, Rejected):
                return None
            asked = form.FromWord(
                code=given.code,
                bits=bits,
                symbols=len(given.word),
                components_with_boundary=from_wire(given.components_with_boundary),
                closings=closing_forms(seen.value),
            )
            return message.CodeDecode(id=0, input=asked)
        case message.ArithmeticEncode(input=told), form.BitString() as bits:
            coded = form.Coded(
                coder=told.coder, model=told.model, bits=bits, count=len(told.symbols)
            )
            return message.ArithmeticDecode(id=0, input=coded)
        case message.MeshEncode(input=mesh), form.FileForm() as file:
            exact = isinstance(mesh.accuracy, form.ExactForm)
            return message.MeshDecode(id=0, input=file) if exact else None
        case _:
            return None


def _what_came(
    operation: Operation, first: Outcome, second: Outcome, said: Introduction
) -> tuple[str, str] | None:
    """The kind of difference and what it is in words; two empty texts if there is none."""
    if isinstance(second, Declined):
        why = f"{second.rejection.fault} {second.rejection.reason}".strip()
        return f"{second.rejection.fault}", f"what it encoded itself, it declines: {why}"
    if not isinstance(first, Answered) or not isinstance(second, Answered):
        return None
    match operation, first.result, second.result:
        case message.WordEncode(input=faces), form.WordForm() as word, form.Faces() as back:
            return _renamed(faces, word.vertex_order, back)
        case message.CodeEncode(input=given), _, form.JustWord(word=letters):
            return _same(given.word, letters, "the word")
        case message.ArithmeticEncode(input=told), _, form.Symbols(symbols=symbols):
            return _same(told.symbols, symbols, "the message")
        case message.MeshEncode(input=mesh), _, form.MeshForm():
            return _isomorphic(mesh, second, said)
        case _:
            return None


def _same(right: object, got: object, what: str) -> tuple[str, str]:
    return ("", "") if right == got else (what, f"{what} was {right!r} and comes back as {got!r}")


def _renamed(faces: form.Faces, order: tuple[int, ...], back: form.Faces) -> tuple[str, str]:
    """The faces that came back, by the names their vertices had. Clause: EB-DECODE-1."""
    if sorted(order) != list(range(from_wire(faces.vertices))):
        return "vertex order", "the vertex order does not name each vertex once"
    came = [tuple(map(from_wire, face)) for face in back.faces]
    if any(not 0 <= v < len(order) for face in came for v in face):
        return "vertices", f"a face that came back has a vertex of none of {len(order)}"
    right = Counter(_turned(tuple(map(from_wire, face))) for face in faces.faces)
    got = Counter(_turned(tuple(order[v] for v in face)) for face in came)
    if right == got:
        return "", ""
    lost, new = sorted((right - got).elements()), sorted((got - right).elements())
    return "faces", f"faces {lost[:3]} were encoded and {new[:3]} come back"


def _turned(face: tuple[int, ...]) -> tuple[int, ...]:
    """The face begun with its least vertex."""
    first = face.index(min(face))
    return (*face[first:], *face[:first])


def _isomorphic(mesh: form.ToFile, back: Answered, said: Introduction) -> tuple[str, str]:
    """Up to names, every position as it was. Clause: ORCL-JUDGE-3."""
    alone = form.MeshForm(faces=mesh.faces, vertices=mesh.vertices, positions=mesh.positions)
    raw = Raw(msgspec.json.encode(alone))
    case = Case(
        id="comes-back-aaaaaaaa",
        op="codec.roundtrip",
        clauses=(),
        origin="generated",
        input=raw,
        ok=raw,
        compare="isomorphic",
    )
    judged = judge(case, back, said)
    return ("", "") if judged.status in GOOD else (judged.signature, judged.why)


def names_do_not_matter(of: Asker) -> Check:
    """Other names of the vertices change nothing but the vertex order. Clause: ORCL-FUZZ-7."""

    def check(operation: Operation) -> Tried | None:
        case = is_asked(question(operation), of.said)
        if case is None or not isinstance(operation, message.WordEncode):
            return None
        request = of.request(operation)
        first = of.ask(request)
        second = of.ask(of.request(_other_names(operation)))
        words = [o.result for o in (first, second) if isinstance(o, Answered)]
        match words:
            case [form.WordForm() as one, form.WordForm() as other]:
                kind, why = _compared(one, other, from_wire(operation.input.vertices))
            case _:
                return None
        judged = failed(case, NAMES, kind, why) if kind else held(case)
        return Tried(case, request, second, judged, NAMES)

    return check


def _other_names(operation: message.WordEncode) -> Operation:
    """Vertex v is named V−1−v."""
    last = from_wire(operation.input.vertices) - 1

    def name(v: form.Number) -> form.Number:
        return to_wire(last - from_wire(v))

    faces = tuple((name(a), name(b), name(c)) for a, b, c in operation.input.faces)
    renamed = form.Faces(faces=faces, vertices=operation.input.vertices)
    return msgspec.structs.replace(operation, input=renamed)


def _compared(one: form.WordForm, other: form.WordForm, vertices: int) -> tuple[str, str]:
    if one.word != other.word:
        return _same(one.word, other.word, "the word")
    if one.handles != other.handles:
        return _same(one.handles, other.handles, "the handle data")
    if one.components_with_boundary != other.components_with_boundary:
        numbers = one.components_with_boundary, other.components_with_boundary
        return _same(*numbers, "the number of components with boundary")
    renamed = tuple(vertices - 1 - v for v in other.vertex_order)
    return _same(one.vertex_order, renamed, "the vertex order")
