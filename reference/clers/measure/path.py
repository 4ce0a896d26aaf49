"""The main path cut into steps, each a function of what the one before it made."""

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random
from time import perf_counter
from typing import TypeVar

from clers.codes.registry import CodeName
from clers.codes.registry import decode as decode_word
from clers.codes.registry import encode as encode_word
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.container import file
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.geometry.positions import Precision, positions

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Timed:
    """A step of the path and the seconds it took."""

    step: str
    seconds: float


def shuffled(given: FaceList, seed: int) -> FaceList:
    """The same mesh with faces and vertices in random order: no cache helps any more."""
    random = Random(seed)
    name = list(range(given.vertices))
    random.shuffle(name)
    faces = [(name[a], name[b], name[c]) for a, b, c in given.faces]
    random.shuffle(faces)
    return FaceList(tuple(faces), given.vertices)


def must(result: Accepted[T] | Rejected) -> T:
    """The value of a step that cannot fail on the meshes measured here."""
    match result:
        case Accepted(value):
            return value
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def timed_path(given: FaceList) -> Iterator[Timed]:
    """Walk the whole path once, from a face list to bytes and back, and time each step."""
    start = perf_counter()

    def since(step: str) -> Timed:
        nonlocal start
        timed = Timed(step, perf_counter() - start)
        start = perf_counter()
        return timed

    built = must(surface(given))
    yield since("surface")
    encoding = encode(built)
    yield since("walk")
    bits = must(encode_word(CodeName.GOLDEN, encoding.stream))
    yield since("code")
    word = must(
        decode_word(
            CodeName.GOLDEN,
            bits,
            len(encoding.stream.word),
            encoding.stream.components_with_boundary,
        )
    )
    yield since("decode code")
    assert word == encoding.stream.word
    must(decode(encoding.stream))
    yield since("decode walk")
    count = given.vertices
    places = must(positions(Precision.F32, [float(i % 1024) for i in range(3 * count)], count))
    start = perf_counter()
    data = must(file.encode(built, places))
    yield since("write file")
    must(file.decode(data))
    yield since("read file")
