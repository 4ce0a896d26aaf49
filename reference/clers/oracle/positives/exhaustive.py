"""All triangulated spheres of few vertices, from every gate. Clause: EB-GRAMMAR-10."""

from collections.abc import Iterator
from functools import cache
from typing import Final

from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.served.forms import faces_form
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.generate.exhaustive import rooted_surfaces, sphere_triangulations
from clers.oracle.positives.asked import Asked
from clers.oracle.positives.shuffled import shuffled

COUNTS: Final = {4: 1, 5: 3, 6: 13, 7: 68, 8: 399, 9: 2530}
"""How many rooted triangulations of the sphere have so many vertices. Clause: EB-GRAMMAR-10."""

WITH_TRACE: Final = 8
"""The most vertices of those with a trace; all with one more are without, for brevity."""


@cache
def sphere_words(vertices: int) -> tuple[str, ...]:
    """The words of all rooted spheres of so many vertices, sorted. Clause: EB-GRAMMAR-10."""
    words = {
        encode(rooted).stream.word
        for faces in sphere_triangulations(vertices)
        for rooted in rooted_surfaces(faces)
    }
    if len(words) != COUNTS[vertices]:
        raise AssertionError(f"{len(words)} spheres of {vertices} vertices")
    return tuple(sorted(words))


def sphere(word: str) -> Surface:
    """The sphere of a word."""
    decoded = decode(Stream(word))
    if not isinstance(decoded, Accepted):
        raise AssertionError(f"{word}: {decoded.line()}")
    return decoded.value


def slug_of(word: str) -> str:
    """A sphere's name: its word, in lower case."""
    return f"sphere-{word.lower()}"


def decoded() -> Iterator[Asked]:
    """Every word to its sphere."""
    for vertices in COUNTS:
        for word in sphere_words(vertices):
            yield Asked(
                slug_of(word),
                "word.decode",
                message.WordDecode(
                    id=0,
                    trace="full" if vertices <= WITH_TRACE else "none",
                    input=form.StreamForm(word=word, handles=(), components_with_boundary=0),
                ),
                (Clause.EB_DECODE_1, Clause.EB_DECODE_2, Clause.EB_GRAMMAR_10),
                "exhaustive",
                size=len(word) + 1,
            )


def encoded() -> Iterator[Asked]:
    """Spheres with other names of vertices and faces, from the same gate, to their words.

    All of at most 8 vertices, and every tenth of 9.
    """
    for vertices in COUNTS:
        for number, word in enumerate(sphere_words(vertices)):
            if vertices < 9 or number % 10 == 0:
                yield Asked(
                    slug_of(word),
                    "word.encode",
                    message.WordEncode(
                        id=0,
                        trace="full" if vertices <= WITH_TRACE else "none",
                        input=faces_form(shuffled(sphere(word), 100 * vertices + number)),
                    ),
                    (Clause.EB_COMPONENT_2, Clause.EB_TRAVERSE_1, Clause.EB_ORDER_1),
                    "exhaustive",
                    size=len(word) + 1,
                    flags=("shuffled-numbering",),
                )


def classified() -> Iterator[Asked]:
    """Spheres in numbers: all of at most 6 vertices, and some of 7 to 9."""
    for vertices, every in ((4, 1), (5, 1), (6, 1), (7, 7), (8, 40), (9, 250)):
        for word in sphere_words(vertices)[::every]:
            yield Asked(
                slug_of(word),
                "surface.classify",
                message.Classify(id=0, input=faces_form(sphere(word))),
                (Clause.CPLX_COMPONENT_2, Clause.CPLX_COMPONENT_3),
                "exhaustive",
                size=len(word) + 1,
            )


def exhaustive() -> Iterator[Asked]:
    """Clause: EB-GRAMMAR-10."""
    yield from decoded()
    yield from encoded()
    yield from classified()
