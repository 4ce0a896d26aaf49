"""Inputs and results in a line each, for people. Clause: ORCL-EXPLAIN-1."""

from collections.abc import Sequence

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.results import Result

MOST = 12
"""Items of a list that are shown."""

WIDE = 100
"""Characters of a text that are shown."""


def asked_in_short(request: Operation) -> str:
    """What a request gives. Total. Clause: ORCL-EXPLAIN-1."""
    match request:
        case message.Echo(input=given):
            return cut(str(given))
        case message.Classify(input=given) | message.WordEncode(input=given):
            return _faces(given)
        case message.Apply(input=script):
            return f"script: {cut(script.script) or 'empty'}"
        case message.ArithmeticEncode(input=coding):
            return f"{coding.coder}, {_model(coding.model)}, symbols {listed(coding.symbols)}"
        case message.ArithmeticDecode(input=coded):
            bits = _bits(coded.bits)
            return f"{coded.coder}, {_model(coded.model)}, {coded.count} symbols from {bits}"
        case message.WordDecode(input=stream):
            return _stream(stream)
        case message.CodeEncode(input=word):
            return f"code {word.code}, {_stream(word)}"
        case message.CodeDecode(input=bits):
            seen = f"{len(bits.closings)} closings"
            what = f"{bits.symbols} symbols, {bits.components_with_boundary} with boundary, {seen}"
            return f"code {bits.code}, {what}, from {_bits(bits.bits)}"
        case message.MeshEncode(input=mesh):
            return f"{_mesh(mesh)}; code {mesh.code}, accuracy {_accuracy(mesh.accuracy)}"
        case message.MeshDecode(input=data):
            return f"{len(data.hex) // 2} bytes: {cut(data.hex)}"
        case message.Roundtrip(input=through):
            return _mesh(through)


def result_in_short(result: Result) -> str:
    """What a result says. Total. Clause: ORCL-EXPLAIN-1."""
    match result:
        case form.Classified(components=parts):
            return f"{len(parts)} components"
        case form.Stages(stages=stages):
            return f"{len(stages)} stages"
        case form.BitString():
            return _bits(result)
        case form.Symbols(symbols=symbols):
            return f"symbols {listed(symbols)}"
        case form.WordForm(vertex_order=order):
            return f"{_stream(result)}; vertex order {listed(order)}"
        case form.JustWord(word=word):
            return f"word {cut(word)}"
        case form.FileForm(hex=data):
            return f"{len(data) // 2} bytes: {cut(data)}"
        case form.MeshForm():
            return _mesh(result)
        case form.Faces():
            return _faces(result)
        case _:
            return cut(str(result))


def cut(text: str) -> str:
    """The text, or its beginning with its length."""
    return text if len(text) <= WIDE else f"{text[:WIDE]}… ({len(text)} characters)"


def listed(items: Sequence[object]) -> str:
    """The items, or the first of them and how many there are."""
    shown = " ".join(str(item).replace(", ", ",") for item in items[:MOST])
    return shown if len(items) <= MOST else f"{shown} … ({len(items)})"


def _faces(given: form.Faces) -> str:
    return f"{len(given.faces)} faces on {given.vertices} vertices: {listed(given.faces)}"


def _mesh(given: form.MeshForm) -> str:
    places = given.positions
    where = f"{places.precision} positions" if isinstance(places, form.Places) else "no positions"
    return f"{_faces(given)}; {where}"


def _bits(given: form.BitString) -> str:
    return f"{given.length} bits: {cut(given.hex) or 'none'}"


def _stream(given: form.StreamForm) -> str:
    records = [f"{h.kind} {h.s}/{h.at}/{h.side}" for h in given.handles]
    handles = f", handle data {'; '.join(records[:MOST])}" if records else ", no handle data"
    more = f" … ({len(records)})" if len(records) > MOST else ""
    word = cut(given.word) or "empty"
    return f"word {word}{handles}{more}, {given.components_with_boundary} with boundary"


def _model(given: form.ModelForm) -> str:
    match given:
        case form.StaticForm(frequencies=table):
            return f"static {listed(table)}"
        case form.UniformForm(size=size):
            return f"uniform over {size}"
        case form.AdaptiveForm(frequencies=table, increment=step, limit=limit):
            return f"adaptive from {listed(table)} by {step} up to {limit}"


def _accuracy(given: form.AccuracyForm) -> str:
    match given:
        case form.ExactForm():
            return "exact"
        case form.LatticeForm(exponent=exponent):
            return f"a lattice of step 2^{exponent}"
        case form.BitsForm(bits=bits):
            return f"{bits} bits an axis"
        case form.ErrorForm(bound=bound):
            return f"an error of {bound!r} at most"
