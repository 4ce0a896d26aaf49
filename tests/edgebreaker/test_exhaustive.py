"""EB-GRAMMAR-10, EB-DECODE-2: on small surfaces nothing valid is missed, nothing else accepted."""

import pytest

from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.grammar import rooted_triangulations, sphere_words
from clers.edgebreaker.outline import outline
from clers.edgebreaker.stream import Stream
from clers.generate.exhaustive import (
    all_streams,
    connected_surfaces,
    rooted_surfaces,
    sphere_triangulations,
)

# Tutte's numbers of rooted simple triangulations, V = 4 … 11.
COUNTS = (1, 3, 13, 68, 399, 2530, 16965, 118668)


@pytest.mark.parametrize(("vertices", "count"), list(zip(range(4, 12), COUNTS, strict=True)))
def test_as_many_sphere_words_as_rooted_triangulations(vertices: int, count: int) -> None:
    """EB-GRAMMAR-10."""
    assert rooted_triangulations(vertices) == count
    assert sum(1 for _ in sphere_words(vertices)) == count


@pytest.mark.parametrize("vertices", range(4, 9))
def test_sphere_words_are_those_of_all_triangulations(vertices: int) -> None:
    """EB-GRAMMAR-10: the flip closure knows nothing of words and gives the same set."""
    encoded = {
        encode(rooted).stream.word
        for faces in sphere_triangulations(vertices)
        for rooted in rooted_surfaces(faces)
    }
    assert set(sphere_words(vertices)) == encoded


def test_all_short_streams_accepted_are_those_of_small_surfaces() -> None:
    """EB-DECODE-2: all words to five symbols and those of six that end as words do, in E.

    With every choice of records, closed and with boundary.
    """
    encoded = {
        encode(rooted).stream
        for faces in connected_surfaces(6)
        for rooted in rooted_surfaces(faces)
    }
    streams = [*(all_streams(n) for n in range(1, 6)), all_streams(6, "E")]
    accepted = {stream for some in streams for stream in some if _connected(stream)}
    assert len(encoded) > 100
    assert accepted == {stream for stream in encoded if len(stream.word) <= 6}


def _connected(stream: Stream) -> bool:
    """Accepted, and as one component."""
    if not isinstance(decode(stream), Accepted):
        return False
    match outline(stream):
        case Accepted(found):
            return len(found.parts) == 1
        case _:
            return False
