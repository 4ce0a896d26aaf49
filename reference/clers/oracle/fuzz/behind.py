"""The mesh behind a request, and the same request about another mesh. Clause: ORCL-SHRINK-3."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import assert_never

import msgspec
from msgspec import UNSET

from clers.arithmetic.bits import Bits
from clers.codes import registry
from clers.codes.closings import Closing, closings, records
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.served.codes import named
from clers.conformance.served.forms import bits_form, bits_of, handle_forms, stream_of
from clers.container.file import decode as decode_file
from clers.container.file import encode as encode_file
from clers.container.file import options_of
from clers.container.options import Options
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Kind, Side, Stream
from clers.geometry.positions import Positions, Precision

Triangle = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Net:
    """Faces, whatever they are, and maybe a place for each vertex: three numbers."""

    faces: tuple[Triangle, ...]
    vertices: int
    precision: Precision = Precision.F64
    places: tuple[tuple[float, float, float], ...] | None = None

    @property
    def mesh(self) -> FaceList:
        """The faces alone."""
        return FaceList(self.faces, self.vertices)


Rebuild = Callable[[Net], Operation | None]


@dataclass(frozen=True, slots=True)
class Behind:
    """A mesh, and how the request is made of a mesh; none where it cannot be."""

    net: Net
    rebuild: Rebuild


def behind(operation: Operation) -> Behind | None:
    """The mesh that a request is about, if it is about any. Clause: ORCL-SHRINK-3."""
    match operation:
        case message.Classify(input=faces) | message.WordEncode(input=faces):
            return Behind(_net(faces), lambda net: _with(operation, _faces(net)))
        case message.Roundtrip(input=sent):
            return Behind(_net(sent), lambda net: _with(operation, _through(net, sent)))
        case message.MeshEncode(input=mesh):
            return Behind(_net(mesh), lambda net: _with(operation, _to_file(net, mesh)))
        case message.WordDecode(input=stream):
            return _of_stream(stream_of(stream), lambda s: _with(operation, stream_form(s)))
        case message.CodeEncode(input=worded):
            return _of_stream(
                stream_of(worded), lambda s: _with(operation, to_word(worded.code, s))
            )
        case message.CodeDecode(input=given):
            found = _stream_of_bits(given)
            if isinstance(found, Rejected):
                return None
            return _of_stream(found.value, lambda s: _optional(operation, from_word(given.code, s)))
        case message.MeshDecode(input=file):
            return _of_file(operation, bytes.fromhex(file.hex))
        case message.Echo() | message.Apply() | message.ArithmeticEncode():
            return None
        case message.ArithmeticDecode():
            return None
        case _:
            assert_never(operation)


def _with(operation: Operation, given: form.Payload) -> Operation:
    return msgspec.structs.replace(operation, input=given)


def _optional(operation: Operation, given: form.Payload | None) -> Operation | None:
    return None if given is None else _with(operation, given)


def _net(given: form.Faces) -> Net:
    faces = tuple((from_wire(a), from_wire(b), from_wire(c)) for a, b, c in given.faces)
    places = given.positions if isinstance(given, form.MeshForm) else UNSET
    vertices = from_wire(given.vertices)
    if not isinstance(places, form.Places) or len(places.coordinates) != 3 * vertices:
        return Net(faces, vertices)
    flat = places.coordinates
    triples = tuple(zip(flat[0::3], flat[1::3], flat[2::3], strict=True))
    return Net(faces, vertices, Precision(places.precision), triples)


def _faces(net: Net) -> form.Faces:
    return form.Faces(faces=_wired(net.faces), vertices=to_wire(net.vertices))


def _wired(faces: tuple[Triangle, ...]) -> tuple[form.Triple, ...]:
    return tuple((to_wire(a), to_wire(b), to_wire(c)) for a, b, c in faces)


def places_form(net: Net) -> form.Places | msgspec.UnsetType:
    """The positions of a net as a message has them. Clause: ORCL-VALUE-3."""
    if net.places is None:
        return UNSET
    flat = tuple(x for place in net.places for x in place)
    return form.Places(
        precision="f32" if net.precision is Precision.F32 else "f64", coordinates=flat
    )


def _through(net: Net, like: form.ThroughForm) -> form.ThroughForm:
    return form.ThroughForm(
        faces=_wired(net.faces),
        vertices=to_wire(net.vertices),
        positions=places_form(net),
        error=like.error,
    )


def _to_file(net: Net, like: form.ToFile) -> form.ToFile:
    return form.ToFile(
        faces=_wired(net.faces),
        vertices=to_wire(net.vertices),
        positions=places_form(net),
        code=like.code,
        accuracy=like.accuracy,
    )


def net_of(of: Surface, placed: Positions | None = None) -> Net:
    """A surface as a net, with its positions."""
    faces = tuple((int(a), int(b), int(c)) for a, b, c in of.triangles())
    if placed is None:
        return Net(faces, of.vertices)
    flat = placed.coordinates
    triples = tuple(zip(flat[0::3], flat[1::3], flat[2::3], strict=True))
    return Net(faces, of.vertices, placed.precision, triples)


def surface_of_net(net: Net) -> Surface | None:
    """The surface of a net, if it is one."""
    built = surface(net.mesh)
    return built.value if isinstance(built, Accepted) else None


def stream_form(stream: Stream) -> form.StreamForm:
    """A stream as a message has it. Clause: ORCL-OP-5."""
    return form.StreamForm(
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=to_wire(stream.components_with_boundary),
    )


def to_word(code: str, stream: Stream) -> form.ToWord:
    """A word to turn into bits. Clause: ORCL-OP-6."""
    return form.ToWord(
        code=code,
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=to_wire(stream.components_with_boundary),
    )


def from_word(code: str, stream: Stream) -> form.FromWord | None:
    """The bits of a word, to turn back; none if the code does not take it. Clause: ORCL-OP-6."""
    name = named(code)
    seen = closings(stream)
    if name is None or isinstance(seen, Rejected):
        return None
    bits = registry.encode(name, stream)
    return _from_word(code, stream, bits.value, seen.value) if isinstance(bits, Accepted) else None


def _from_word(code: str, stream: Stream, bits: Bits, seen: tuple[Closing, ...]) -> form.FromWord:
    return form.FromWord(
        code=code,
        bits=bits_form(bits),
        symbols=len(stream.word),
        components_with_boundary=stream.components_with_boundary,
        closings=closing_forms(seen),
    )


def closing_forms(seen: tuple[Closing, ...]) -> tuple[form.ClosingForm, ...]:
    """The handle data as it is seen from the end. Clause: ORCL-OP-6."""
    return tuple(
        form.ClosingForm(
            passed=to_wire(c.passed),
            kind="boundary" if c.kind is Kind.BOUNDARY else "handle",
            side="left" if c.side is Side.LEFT else "right",
            between=to_wire(c.between),
        )
        for c in seen
    )


def _stream_of_bits(given: form.FromWord) -> Accepted[Stream] | Rejected:
    """The stream that bits and closings describe. Clauses: ORCL-OP-6, CODE-HAND-3."""
    seen = tuple(
        Closing(from_wire(c.passed), Kind(c.kind), Side(c.side), from_wire(c.between))
        for c in given.closings
    )
    code = named(given.code) or registry.CodeName.PLAIN
    word = and_then(
        bits_of(given.bits),
        lambda bits: registry.decode(
            code, bits, given.symbols, given.components_with_boundary, seen
        ),
    )
    return and_then(
        word,
        lambda w: and_then(
            records(w, seen), lambda r: Accepted(Stream(w, r, given.components_with_boundary))
        ),
    )


def _of_stream(stream: Stream, rebuild: Callable[[Stream], Operation | None]) -> Behind | None:
    found = decode(stream)
    if isinstance(found, Rejected):
        return None

    def of_net(net: Net) -> Operation | None:
        built = surface_of_net(net)
        return None if built is None else rebuild(encode(built).stream)

    return Behind(net_of(found.value), of_net)


def _of_file(operation: Operation, data: bytes) -> Behind | None:
    found, options = decode_file(data), options_of(data)
    if isinstance(found, Rejected) or isinstance(options, Rejected):
        return None
    written = options.value

    def of_net(net: Net) -> Operation | None:
        file = file_of(net, written)
        return None if file is None else _with(operation, file)

    mesh = found.value
    return Behind(net_of(mesh.surface, mesh.positions), of_net)


def file_of(net: Net, options: Options) -> form.FileForm | None:
    """The file of a net, if it has one. Clause: ORCL-OP-7."""
    built = surface_of_net(net)
    if built is None:
        return None
    placed = None
    if net.places is not None:
        placed = Positions(net.precision, tuple(x for place in net.places for x in place))
    data = encode_file(built, placed, options)
    return form.FileForm(hex=data.value.hex()) if isinstance(data, Accepted) else None
