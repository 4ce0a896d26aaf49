"""How large a request is: each step of shrinking makes it smaller. Clause: ORCL-SHRINK-2."""

from typing import assert_never

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.numbers import from_wire

Size = tuple[int | float | tuple[int, ...] | str, ...]
"""Compared from the left; of requests of one operation alike in form."""


def size_of(operation: Operation) -> Size:
    """The size of a request's input. Clause: ORCL-SHRINK-2."""
    match operation:
        case message.Echo(input=given):
            return (len(given),)
        case message.Classify(input=faces) | message.WordEncode(input=faces):
            return _of_faces(faces)
        case message.Roundtrip(input=mesh):
            return _of_mesh(mesh)
        case message.MeshEncode(input=file):
            return *_of_mesh(file), not isinstance(file.accuracy, form.ExactForm)
        case message.WordDecode(input=stream) | message.CodeEncode(input=stream):
            return _of_stream(stream)
        case message.CodeDecode(input=bits):
            return bits.symbols, bits.bits.length, len(bits.closings), bits.components_with_boundary
        case message.MeshDecode(input=written):
            return (len(written.hex),)
        case message.ArithmeticEncode(input=told):
            symbols = tuple(map(from_wire, told.symbols))
            return len(symbols), sum(map(abs, symbols)), *_of_model(told.model)
        case message.ArithmeticDecode(input=coded):
            return coded.count, coded.bits.length, *_of_model(coded.model)
        case message.Apply(input=script):
            numbers = sum(len(word) for word in script.script.split() if not word.isalpha())
            return script.script.count(";"), len(script.script), numbers, script.script
        case _:
            assert_never(operation)


def _of_faces(given: form.Faces) -> Size:
    return len(given.faces), abs(from_wire(given.vertices)), _flat(given)


def _flat(given: form.Faces) -> tuple[int, ...]:
    return tuple(from_wire(v) for face in given.faces for v in face)


def _of_mesh(given: form.MeshForm) -> Size:
    places = given.positions.coordinates if isinstance(given.positions, form.Places) else ()
    placed = (len(places), sum(x != 0.0 for x in places))
    return len(given.faces), abs(from_wire(given.vertices)), *placed, _flat(given)


def _of_stream(given: form.StreamForm) -> Size:
    numbers = [from_wire(n) for record in given.handles for n in (record.s, record.at)]
    boundary = from_wire(given.components_with_boundary)
    return len(given.word), len(given.handles), sum(map(abs, (*numbers, boundary))), given.word


def _of_model(model: form.ModelForm) -> Size:
    match model:
        case form.UniformForm(size=size):
            return 0, abs(from_wire(size))
        case form.StaticForm(frequencies=table):
            return len(table), sum(abs(from_wire(f)) for f in table)
        case form.AdaptiveForm(frequencies=table, increment=increment, limit=limit):
            more = abs(from_wire(increment)) + abs(from_wire(limit))
            return len(table), sum(abs(from_wire(f)) for f in table) + more + 1
        case _:
            assert_never(model)


def measure(operation: Operation) -> tuple[str, int]:
    """The unit that people count such an input in, and how many it has. Clause: ORCL-FIND-1."""
    match operation:
        case message.Echo():
            return "keys", len(operation.input)
        case message.MeshDecode(input=file):
            return "bytes", len(file.hex) // 2
        case message.WordDecode(input=stream) | message.CodeEncode(input=stream):
            return "symbols", len(stream.word)
        case message.CodeDecode(input=bits):
            return "symbols", bits.symbols
        case message.ArithmeticEncode(input=told):
            return "symbols", len(told.symbols)
        case message.ArithmeticDecode(input=coded):
            return "symbols", coded.count
        case message.Apply(input=script):
            return "operators", len([s for s in script.script.split(";") if s.strip()])
        case (
            message.Classify(input=faces)
            | message.WordEncode(input=faces)
            | message.Roundtrip(input=faces)
            | message.MeshEncode(input=faces)
        ):
            return "faces", len(faces.faces)
        case _:
            assert_never(operation)
