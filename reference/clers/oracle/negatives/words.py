"""Streams that no surface has: a word or a record changed in one place. EB-GRAMMAR-1 … -9.

Each parent is changed in every single place in every way listed here; what the grammar refuses is a
negative, and of those alike in parent, way, reason and clause the first few are kept. What it still
accepts is a word that nobody encoded, and kept too.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import msgspec
from msgspec import UnsetType

from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit, Origin
from clers.conformance.cases.edits import replaced
from clers.conformance.numbers import to_wire
from clers.conformance.served.forms import handle_forms, stream_of
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TORUS
from clers.edgebreaker.stream import SYMBOLS, Kind, Record, Side, Stream
from clers.oracle.negatives.draft import Draft, Slip, bad, good, spoilt
from clers.oracle.positives.asked import needed

Way = tuple[str, Edit]
"""What kind of change it is, and the change."""

KEPT: Final = 1
"""How many that are alike are kept."""

FEW: Final = 3
"""The symbols of the words into which strangers are put."""


def stream_form(stream: Stream) -> form.StreamForm:
    """A stream as a message has it. Clause: ORCL-OP-5."""
    return form.StreamForm(
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=to_wire(stream.components_with_boundary),
    )


def accepted(
    slug: str, stream: Stream, *, origin: Origin = "hand", flags: Sequence[str] = ()
) -> Draft | None:
    """The case of a stream that some surface has; None of any other. Clause: EB-DECODE-2."""
    found = decode(stream)
    if not isinstance(found, Accepted):
        return None
    return good(
        slug, "word.decode", stream_form(stream), (Clause.EB_DECODE_1, Clause.EB_DECODE_2),
        requires=needed(found.value), size=found.value.faces, origin=origin, flags=flags,
        trace="full" if stream.records else "none",
    )  # fmt: skip


def word_changes(word: str) -> Iterator[Way]:
    """Each symbol replaced, doubled by another, taken out, or swapped with the next."""
    for i in range(len(word) + 1):
        here = word[i : i + 1]
        for x in SYMBOLS:
            if here not in ("", x):
                yield f"{here}-for-{x}".lower(), replaced("/word", i, here, x)
            yield f"{x}-put-in".lower(), replaced("/word", i, "", x)
        if here:
            yield f"{here}-taken-out".lower(), replaced("/word", i, here, "")
        two = word[i : i + 2]
        if len(set(two)) > 1:
            yield "two-swapped", replaced("/word", i, two, two[::-1])


def stranger_changes(word: str) -> Iterator[Way]:
    """Characters that are no symbols."""
    for x, kind in (
        ("P", "first-triangle-written"),
        ("c", "small-letter"),
        (" ", "space"),
        ("\u0421", "cyrillic-letter"),
        ("\x00", "zero-byte"),
    ):
        yield kind, replaced("/word", 0, "", x)
    yield "small-letters", replaced("/word", 0, word, word.lower())
    yield "line-feed-at-the-end", replaced("/word", len(word), "", "\n")


def record_changes(stream: Stream) -> Iterator[Way]:
    """Each record with another kind, S, closing symbol or side; or gone, twice, or a new one."""
    forms = [_json(record) for record in stream.records]
    closers = sum(x in "RLE" for x in stream.word)
    splits = stream.word.count("S")
    for k, record in enumerate(stream.records):
        at = f"/handles/{k}"
        old, new = _other(record.kind, Kind), _other(record.side, Side)
        yield "other-kind", replaced(f"{at}/kind", 0, record.kind.value, old)
        yield "other-side", replaced(f"{at}/side", 0, record.side.value, new)
        for s in range(-1, splits + 1):
            if s != record.s:
                yield _off("s", s - record.s), replaced(f"{at}/s", 0, record.s, s)
        for closer in range(-1, closers + 1):
            if closer != record.at:
                off = _off("closer", closer - record.at)
                yield off, replaced(f"{at}/at", 0, record.at, closer)
        yield "record-missing", replaced("/handles", k, [forms[k]], [])
        yield "record-twice", replaced("/handles", k, [], [forms[k]])
        far = str((1 << 64) + record.at)
        yield "closer-wraps-at-64-bits", replaced(f"{at}/at", 0, record.at, far)
        yield "s-wraps-at-32-bits", replaced(f"{at}/s", 0, record.s, (1 << 32) + record.s)
    if len(forms) > 1:
        yield "records-swapped", replaced("/handles", 0, forms[:2], forms[1::-1])
    taken = {record.s for record in stream.records}
    for s in range(splits + 1):
        if s not in taken:
            k = sum(record.s < s for record in stream.records)
            for closer in range(closers):
                for kind in Kind:
                    for side in Side:
                        put = _json(Record(kind, s, closer, side))
                        yield f"{kind}-record-put-in", replaced("/handles", k, [], [put])


def count_changes(stream: Stream) -> Iterator[Way]:
    """Another number of components with boundary."""
    old = stream.components_with_boundary
    for new in (-1, 0, old - 1, old + 1, old + 2):
        if new != old:
            yield _off("boundary-count", new - old), _count(old, new)
    yield "boundary-count-wraps-at-32-bits", _count(old, (1 << 32) + old)
    yield "boundary-count-wraps-at-64-bits", _count(old, str((1 << 64) + old))


def _count(old: int, new: int | str) -> Edit:
    return replaced("/components_with_boundary", 0, old, new)


def _json(record: Record) -> dict[str, str | int]:
    return {"kind": record.kind.value, "s": record.s, "at": record.at, "side": record.side.value}


def _other(here: Kind | Side, kinds: type[Kind] | type[Side]) -> str:
    return next(kind.value for kind in kinds if kind is not here)


def _off(what: str, by: int) -> str:
    match by:
        case 1:
            return f"{what}-one-more"
        case -1:
            return f"{what}-one-less"
        case _:
            return f"{what}-{'more' if by > 0 else 'less'}"


def changed(parent: Draft, stream: Stream) -> Iterator[Draft]:
    """The cases of a stream's changes, at most so many of those alike. Clause: ORCL-FAULT-1."""
    seen: Counter[tuple[str, str, str]] = Counter()
    for ways in (word_changes(stream.word), record_changes(stream), count_changes(stream)):
        for kind, edit in ways:
            draft = spoilt(parent, kind, (edit,))
            reject = draft.case.reject
            if isinstance(reject, UnsetType):
                yield from survived(stream_in(draft))
                continue
            way = kind.partition("-")[2] if edit.path == "/word" else kind
            alike = (way, reject.reason, reject.clause)
            seen[alike] += 1
            if seen[alike] <= KEPT:
                flags, needs = (FLAG_OF[reject.reason],), spoken_of(stream_in(draft))
                yield spoilt(parent, kind, (edit,), requires=needs, flags=flags)


FLAG_OF: Final[Mapping[str, str]] = {
    Reason.EMPTY_WORD: "empty-input",
    Reason.UNFINISHED_WORD: "end-of-word-not-checked",
    Reason.TOO_FEW_COMPONENTS: "components-not-counted",
    Reason.RECORD_ORDER: "records-in-any-order",
    Reason.RECORD_OUT_OF_RANGE: "record-out-of-range-used",
    Reason.RECORD_SIDE: "side-not-checked",
    Reason.RECORD_OUTSIDE_BRANCH: "branch-not-checked",
    Reason.EDGE_CLOSED_TWICE: "edge-glued-twice",
    Reason.LOOP_TOO_SHORT: "short-loop-glued",
    Reason.LOOP_NOT_CLOSED: "open-loop-left",
    Reason.NOT_A_CURVE: "handle-taken-for-curve",
    Reason.REPEATED_VERTEX: "result-not-simplicial",
    Reason.DOUBLE_EDGE: "result-not-simplicial",
}
"""The mistake that a stream rejected for this reason brings to light. Clause: ORCL-FLAG-1."""


def survived(stream: Stream) -> Iterator[Draft]:
    """A changed stream that some surface has after all, under its own word. EB-DECODE-2."""
    found = accepted(f"changed-{stream.word.lower()}", stream, origin="grammar")
    if found is not None:
        yield found


def stream_in(draft: Draft) -> Stream:
    """The stream that a case asks to decode."""
    return stream_of(msgspec.json.decode(draft.case.input, type=form.StreamForm))


def spoken_of(stream: Stream) -> tuple[str, ...]:
    """What a stream speaks of, good or bad: who does not do that may say so. Clause: ORCL-CASE-4.

    The components are counted as EB-GRAMMAR-3 counts them.
    """
    recorded = {record.s for record in stream.records}
    depth, splits, several = 1, 0, False
    for symbol in stream.word:
        several |= depth == 0
        depth += depth == 0
        if symbol == "S":
            depth += splits not in recorded
            splits += 1
        elif symbol == "E":
            depth -= 1
    boundaries = stream.components_with_boundary
    kinds = [record.kind for record in stream.records]
    curves = max(boundaries, 0) + kinds.count(Kind.BOUNDARY)
    needed = {
        "boundaries.many": curves > 1,
        "boundaries.one": curves == 1,
        "components": boundaries > 1 or several,
        "handles": Kind.HANDLE in kinds,
    }
    return tuple(name for name, is_needed in needed.items() if is_needed)


def drafts() -> Iterator[Draft]:
    """Streams of some surfaces, and what comes of changes to them. Clause: ORCL-OP-5."""
    for name, stream in PARENTS:
        parent = accepted(name, stream)
        if parent is None:
            raise Slip(name)
        yield parent
        yield from changed(parent, stream)
        if len(stream.word) == FEW:
            for kind, edit in stranger_changes(stream.word):
                yield bad(
                    parent, kind, (edit,), Reason.UNKNOWN_SYMBOL, Clause.EB_GRAMMAR_1,
                    flags=("unchecked-alphabet",),
                )  # fmt: skip


def _stream(word: str, *records: tuple[Kind, int, int, Side], boundaries: int = 1) -> Stream:
    return Stream(word, tuple(Record(*record) for record in records), boundaries)


R, L, B, H = Side.RIGHT, Side.LEFT, Kind.BOUNDARY, Kind.HANDLE

PARENTS: Final = (
    ("tetrahedron", Stream("CRE")),
    ("triangle", _stream("E")),
    ("two-triangles", _stream("RE")),
    ("two-disks", _stream("EE", boundaries=2)),
    ("two-tetrahedra", Stream("CRECRE")),
    ("disk-and-ball", _stream("ECRE")),
    ("split-ball", Stream("CCCRSEE")),
    ("split-disk", _stream("CRSCREE")),
    ("strip", _stream("SRRRLLEE")),
    ("cube", encode(CUBE).stream),
    ("annulus", encode(ANNULUS).stream),
    ("annulus-and-split", _stream("SLRRSEE", (B, 0, 3, R))),
    ("annulus-and-inside", _stream("CSLSRLRCREE", (B, 0, 5, R))),
    ("torus", encode(TORUS).stream),
    ("open-torus", _stream("SLLSLLCRLLLRRE", (H, 0, 7, L), (H, 1, 10, R))),
    ("open-torus-to-the-left", _stream("SLLCRSRLRRRLLLE", (H, 0, 4, L), (H, 1, 11, L))),
)
"""Streams to change; the last two have a handle and a boundary. Clause: ORCL-FAULT-1."""
