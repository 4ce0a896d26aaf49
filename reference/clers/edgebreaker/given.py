"""The domain of chapter 5's own, and two readings of a surface that its laws share."""

from typing import Final

from clers.complexes.surface import Surface, Vertex, next_corner, previous_corner
from clers.conventions.law import Given
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.outline import Outline, outline
from clers.edgebreaker.stream import Encoding, Stream

STREAMS: Final = Given(
    "streams", "streams of small surfaces, as they are or with a change or two", Stream
)


def renumbered(surface: Surface, encoding: Encoding) -> tuple[Vertex, ...]:
    """The corners' vertices that EB-DECODE-1 demands of the decoded surface."""
    number = {v: Vertex(k) for k, v in enumerate(encoding.vertex_order)}
    return tuple(
        number[surface.vertex[c]]
        for tip in encoding.tip_order
        for c in (tip, next_corner(tip), previous_corner(tip))
    )


def outlined(stream: Stream) -> Outline:
    """The outline of a stream that an encoder wrote; it is accepted, or the encoder is broken."""
    match outline(stream):
        case Accepted(value):
            return value
        case Rejected() as rejected:
            raise AssertionError(rejected.line())
