"""`word.encode` and `word.decode`, each with its trace."""

from clers.complexes.row import listed
from clers.complexes.surface import Corner, Surface, Vertex
from clers.conformance import payloads as form
from clers.conformance.messages import Step
from clers.conformance.served.forms import faces_form, handle_forms, stream_of, surface_of
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.decode import decode as decode_stream
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.outline import outline
from clers.edgebreaker.stream import Encoding, Stream
from clers.edgebreaker.trace import Entry, trace


def encode(given: form.Faces) -> Accepted[form.WordForm] | Rejected:
    """Faces to a word, its handle data and the order of vertices. Clause: ORCL-OP-5."""
    return and_then(surface_of(given), lambda s: Accepted(_word_form(encode_surface(s))))


def _word_form(encoding: Encoding) -> form.WordForm:
    stream = encoding.stream
    return form.WordForm(
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=stream.components_with_boundary,
        vertex_order=encoding.vertex_order,
    )


def decode(given: form.StreamForm) -> Accepted[form.Faces] | Rejected:
    """A word and its handle data to faces in the order of creation. Clause: ORCL-OP-5."""
    return and_then(decode_stream(stream_of(given)), lambda s: Accepted(faces_form(s)))


def steps_of_encoding(given: form.Faces) -> Accepted[tuple[Step, ...]] | Rejected:
    """The walk over the faces as they are numbered. Clause: ORCL-EVENT-1."""
    return and_then(surface_of(given), lambda s: _walk(s, encode_surface(s)))


def steps_of_decoding(given: form.StreamForm) -> Accepted[tuple[Step, ...]] | Rejected:
    """The walk over the decoded faces, which are numbered as created. Clause: ORCL-EVENT-1."""
    stream = stream_of(given)
    return and_then(decode_stream(stream), lambda s: _walk(s, _as_created(s, stream)))


def _as_created(surface: Surface, stream: Stream) -> Encoding:
    """How a stream meets the surface that it is decoded to: everything in order. EB-ORDER-1."""
    vertices = tuple(Vertex(v) for v in range(surface.vertices))
    return Encoding(
        stream, listed(vertices), listed(tuple(Corner(3 * f) for f in range(surface.faces)))
    )


def _walk(surface: Surface, encoding: Encoding) -> Accepted[tuple[Step, ...]] | Rejected:
    return and_then(
        outline(encoding.stream),
        lambda outlined: Accepted(tuple(map(_step, trace(surface, encoding, outlined)))),
    )


def _step(entry: Entry) -> Step:
    return Step(
        i=entry.index,
        symbol=entry.symbol,
        component=entry.component,
        face=entry.face,
        triangle=entry.triangle,
        gate=entry.gate,
        stack=entry.stack,
        new=entry.new,
        opens=entry.opens,
        closes=entry.closes,
        euler=entry.euler,
    )
