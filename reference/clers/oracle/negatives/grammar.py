"""Streams that the grammar gives and no encoder of ours wrote: all must be decoded."""

from collections.abc import Iterator
from itertools import islice
from typing import Final

from clers.edgebreaker.stream import Stream
from clers.oracle.negatives.backwards import all_streams, random_streams
from clers.oracle.negatives.draft import Draft
from clers.oracle.negatives.words import accepted

ALL_OF: Final = 5
"""Of so many symbols at most all streams are asked."""

RECORDED: Final = (6, 7)
"""Of so many symbols all streams with a record."""

DRAWN: Final = (12, 16, 20, 24)
"""Of about so many symbols some drawn at random."""

TRIED: Final = 250
"""How many are drawn of each size."""


def streams() -> Iterator[tuple[str, Stream]]:
    """Streams that keep EB-GRAMMAR-1 … EB-GRAMMAR-8, each with words for its id."""
    for symbols in range(1, ALL_OF + 1):
        yield from named("all", sorted(all_streams(symbols), key=repr))
    for symbols in RECORDED:
        yield from named("curve", sorted(all_streams(symbols, records=1), key=repr))
    for symbols in DRAWN:
        yield from named("drawn", islice(random_streams(symbols, symbols), TRIED))


def named(first: str, some: Iterator[Stream] | list[Stream]) -> Iterator[tuple[str, Stream]]:
    """Streams under their words."""
    return ((f"{first}-{stream.word.lower()}", stream) for stream in some)


def drafts() -> Iterator[Draft]:
    """Those of them that are surfaces, each once. Clauses: ORCL-GRAMMAR-1, EB-DECODE-2."""
    seen: set[Stream] = set()
    for slug, stream in streams():
        if stream not in seen:
            seen.add(stream)
            found = accepted(slug, stream, origin="grammar", flags=("decoder-knows-one-encoder",))
            if found is not None:
                yield found
