"""Streams, good and bad: what an encoder writes for a small surface, then a change or two."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import SYMBOLS, Kind, Record, Side, Stream
from clers.generate.surfaces import small_surfaces

_RECORDS: Final = st.builds(
    Record,
    kind=st.sampled_from(Kind),
    s=st.integers(-1, 6),
    at=st.integers(-1, 12),
    side=st.sampled_from(Side),
)


@st.composite
def _changed_word(draw: st.DrawFn, stream: Stream) -> Stream:
    """A symbol replaced, added, taken away, or two neighbours swapped."""
    word = stream.word
    i = draw(st.integers(0, max(0, len(word) - 1)))
    x = draw(st.sampled_from(SYMBOLS))
    other = draw(
        st.sampled_from(
            (
                word[:i] + x + word[i + 1 :],
                word[:i] + x + word[i:],
                word[:i] + word[i + 1 :],
                word[:i] + word[i + 1 : i + 2] + word[i : i + 1] + word[i + 2 :],
            )
        )
    )
    return Stream(other, stream.records, stream.components_with_boundary)


@st.composite
def _changed_records(draw: st.DrawFn, stream: Stream) -> Stream:
    """A record replaced, added, taken away, or changed in one field."""
    records = stream.records
    new = draw(_RECORDS)
    i = draw(st.integers(0, len(records)))
    options = [(*records[:i], new, *records[i:])]
    if i < len(records):
        old = records[i]
        flipped = Side.LEFT if old.side is Side.RIGHT else Side.RIGHT
        turned = Kind.HANDLE if old.kind is Kind.BOUNDARY else Kind.BOUNDARY
        changed = (
            Record(turned, old.s, old.at, old.side),
            Record(old.kind, new.s, old.at, old.side),
            Record(old.kind, old.s, new.at, old.side),
            Record(old.kind, old.s, old.at, flipped),
        )
        options += [(*records[:i], *one, *records[i + 1 :]) for one in ((r,) for r in changed)]
        options.append((*records[:i], *records[i + 1 :]))
    return Stream(stream.word, draw(st.sampled_from(options)), stream.components_with_boundary)


@st.composite
def streams(draw: st.DrawFn) -> Stream:
    """The stream of a small surface with no change, one, or two."""
    stream = encode(draw(small_surfaces())).stream
    for _ in range(draw(st.integers(0, 2))):
        change = draw(st.sampled_from(("word", "records", "boundary")))
        if change == "word":
            stream = draw(_changed_word(stream))
        elif change == "records":
            stream = draw(_changed_records(stream))
        else:
            step = draw(st.sampled_from((-1, 1)))
            count = stream.components_with_boundary + step
            stream = Stream(stream.word, stream.records, count)
    return stream


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {"streams": streams()}
"""The domains of this module, by name."""
