"""All streams of up to four symbols, and those of all small surfaces: four decoders agree."""

from clers.conventions.result import Accepted
from clers.edgebreaker.codec import FAST_ZIP, FOLD, REFERENCE, WRAP_AND_ZIP
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.generate.exhaustive import all_streams, connected_surfaces, rooted_surfaces


def agree(stream: Stream) -> bool:
    """Whether all answer with the same surface, or all refuse."""
    answers = [codec.decode(stream) for codec in (REFERENCE, FOLD, WRAP_AND_ZIP, FAST_ZIP)]
    values = [answer.value if isinstance(answer, Accepted) else None for answer in answers]
    return values.count(values[0]) == 4


def test_all_short_streams() -> None:
    """Clause: EB-DECODE-3."""
    short = [stream for count in range(1, 5) for stream in all_streams(count)]
    assert len(short) > 5000
    assert [stream for stream in short if not agree(stream)] == []


def test_the_streams_of_all_small_surfaces() -> None:
    """Which are all that are accepted of so many symbols. Clause: EB-DECODE-3."""
    streams = [
        encode(rooted).stream
        for faces in connected_surfaces(6)
        for rooted in rooted_surfaces(faces)
    ]
    assert len(streams) > 100
    assert [stream for stream in streams if not agree(stream)] == []
