"""Compression: Algorithms 3, 4 and 5 of the tutorial, linear, without recursion."""

from clers.complexes.row import flat_row
from clers.complexes.surface import Surface
from clers.edgebreaker.stream import Encoding, Kind, Record, Side, Stream
from clers.kernels.walk import Walk, walked


def encode(surface: Surface) -> Encoding:
    """The canonical stream of a surface, with the orders that tie the two.

    Algorithm 4: components with boundary first. Total: every surface has a stream. Linear in the
    number of faces. Clauses: EB-COMPONENT-1 … EB-COMPONENT-4, EB-TRAVERSE-1 … EB-TRAVERSE-7,
    EB-HANDLE-1 … EB-HANDLE-5, EB-ORDER-1 … EB-ORDER-3. What the symbols and records then count:
    EB-COUNT-1 … EB-COUNT-4.
    """
    walk = walked(surface.vertex_row.flat, surface.opposite_row.flat, surface.vertices)
    word = walk.word.getvalue().decode("ascii")
    stream = Stream(word, _records(walk), walk.with_boundary)
    return Encoding(stream, flat_row(walk.order), flat_row(walk.tips))


def _records(walk: Walk) -> tuple[Record, ...]:
    """The handle data, by the numbers of its S. Clauses: EB-HANDLE-1 … EB-HANDLE-5."""
    closed = ((s, at) for s, at in enumerate(walk.closed) if at >= 0)
    return tuple(
        Record(
            Kind.BOUNDARY if walk.reaches[s] else Kind.HANDLE,
            s,
            at >> 1,
            Side.LEFT if at & 1 else Side.RIGHT,
        )
        for s, at in closed
    )
