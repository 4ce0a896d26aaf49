"""The main path cut into steps, each a function of what the one before it made."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeVar

from clers.codes.closings import closings
from clers.codes.registry import CodeName
from clers.codes.registry import decode as decode_word
from clers.codes.registry import encode as encode_word
from clers.complexes.corner_table import surface_of_indices
from clers.complexes.index_list import IndexList
from clers.container import file
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.geometry.positions import Precision, positions
from clers.measure.clock import Spent, now

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Timed:
    """A step of the path, and what it took."""

    step: str
    spent: Spent


def must(result: Accepted[T] | Rejected) -> T:
    """The value of a step that cannot fail on the meshes measured here."""
    match result:
        case Accepted(value):
            return value
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def timed_path(given: IndexList, code: CodeName = CodeName.GOLDEN) -> Iterator[Timed]:
    """Walk the whole path once, from an index list to bytes and back, and time each step.

    The caller may end it after any step.
    """
    start = now()

    def since(step: str) -> Timed:
        nonlocal start
        spent = now() - start
        start = now()
        return Timed(step, spent)

    built = must(surface_of_indices(given))
    yield since("surface")
    encoding = encode(built)
    stream = encoding.stream
    yield since("walk")
    bits = must(encode_word(code, stream))
    yield since("code")
    seen = must(closings(stream))
    start = now()
    components = stream.components_with_boundary
    word = must(decode_word(code, bits, len(stream.word), components, seen))
    yield since("decode code")
    assert word == stream.word
    must(decode(stream))
    yield since("decode walk")
    count = given.vertices
    places = must(positions(Precision.F32, [float(i % 1024) for i in range(3 * count)], count))
    start = now()
    data = must(file.encode(built, places))
    yield since("write file")
    must(file.decode(data))
    yield since("read file")
