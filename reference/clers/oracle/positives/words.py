"""Words in every code: each code's bits there and back, with the handle data as it is seen."""

from collections.abc import Iterable, Iterator
from itertools import cycle, islice
from typing import Final

from clers.arithmetic.bits import Bits
from clers.codes.closings import Closing, closings
from clers.codes.registry import PARTIAL, CodeName
from clers.codes.registry import encode as encode_word
from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Origin
from clers.conformance.numbers import to_wire
from clers.conformance.served.forms import bits_form
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.oracle.positives.asked import Asked, needed
from clers.oracle.positives.exhaustive import slug_of, sphere, sphere_words
from clers.oracle.positives.features import features
from clers.oracle.positives.stock import Named, at_random, by_hand, by_rule, by_scripts
from clers.oracle.positives.walks import stream_form

OF_CODE: Final = {
    CodeName.PLAIN: (Clause.CODE_PLAIN_1, Clause.CODE_PLAIN_2),
    CodeName.KING_ROSSIGNAC: (Clause.CODE_KR_1, Clause.CODE_KR_2, Clause.CODE_KR_3),
    CodeName.GOLDEN: (Clause.CODE_GOLDEN_1, Clause.CODE_GOLDEN_2, Clause.CODE_GOLDEN_3),
    CodeName.MINIMAX_3: (Clause.CODE_MINIMAX_2, Clause.CODE_MINIMAX_4),
    CodeName.MINIMAX_8: (Clause.CODE_MINIMAX_3, Clause.CODE_MINIMAX_4),
    CodeName.ENUMERATIVE: (Clause.CODE_ENUM_2, Clause.CODE_TREE_5, Clause.CODE_TREE_8),
    CodeName.HUFFMAN: (Clause.CODE_HUFFMAN_1, Clause.CODE_HUFFMAN_2),
    CodeName.ADAPTIVE_1: (Clause.CODE_ADAPTIVE_1,),
    CodeName.ADAPTIVE_3: (Clause.CODE_ADAPTIVE_1,),
    CodeName.ADAPTIVE_6: (Clause.CODE_ADAPTIVE_1,),
    CodeName.CONTEXT: (
        Clause.CODE_CONTEXT_1,
        Clause.CODE_CONTEXT_2,
        Clause.CODE_CONTEXT_3,
        Clause.CODE_CONTEXT_4,
        Clause.CODE_CONTEXT_5,
        Clause.CODE_CONTEXT_6,
        Clause.CODE_CONTEXT_7,
    ),
    CodeName.BEST: (Clause.CODE_BEST_1,),
}
"""The clauses that say what the bits of a code are. Clause: CODE-NAME-1."""


def coded(code: CodeName, slug: str, surface: Surface, origin: Origin) -> Iterator[Asked]:
    """A surface's word there and back in a code; nothing where the code refuses it. CODE-NAME-5."""
    stream = encode(surface).stream
    bits = encode_word(code, stream)
    seen = closings(stream)
    if not isinstance(bits, Accepted) or not isinstance(seen, Accepted):
        if code in PARTIAL:
            return
        raise AssertionError(f"{code} refuses {slug}")
    flags = tuple(flag for flag in features(surface) if flag in _OF_WORDS)
    requires = (*needed(surface), f"code.{code}")
    yield from _there_and_back(code, slug, stream, bits.value, seen.value, origin, requires, flags)


def _there_and_back(
    code: CodeName,
    slug: str,
    stream: Stream,
    bits: Bits,
    seen: tuple[Closing, ...],
    origin: Origin,
    requires: tuple[str, ...],
    flags: tuple[str, ...] = (),
) -> Iterator[Asked]:
    closed = stream.components_with_boundary == 0
    clauses = (
        Clause.CODE_NAME_2,
        *OF_CODE[code],
        *([Clause.CODE_IMPLIED_1] if closed else []),
        *([Clause.CODE_HAND_1] if stream.records else []),
    )
    whole = stream_form(stream)
    there = form.ToWord(
        code=code,
        word=whole.word,
        handles=whole.handles,
        components_with_boundary=whole.components_with_boundary,
    )
    back = form.FromWord(
        code=code,
        bits=bits_form(bits),
        symbols=len(stream.word),
        components_with_boundary=stream.components_with_boundary,
        closings=tuple(map(closing_form, seen)),
    )
    name, size = f"{code}-{slug}", len(stream.word)
    yield Asked(
        name, "code.encode", message.CodeEncode(id=0, input=there), clauses, origin, requires,
        size, flags,
    )  # fmt: skip
    yield Asked(
        name, "code.decode", message.CodeDecode(id=0, input=back), clauses, origin, requires,
        size, flags,
    )  # fmt: skip


OF_NO_SURFACE: Final = (
    ("joined-below", Stream("SLSEE", (Record(Kind.HANDLE, 1, 2, Side.RIGHT),), 1)),
)
"""Streams that chapter 5 refuses and codes do not: a closing edge in the loop of a gate below."""


def of_no_surface() -> Iterator[Asked]:
    """Words that no surface has, in `context`, which undoes them all the same. CODE-CONTEXT-2."""
    for slug, stream in OF_NO_SURFACE:
        bits, seen = encode_word(CodeName.CONTEXT, stream), closings(stream)
        if not isinstance(bits, Accepted) or not isinstance(seen, Accepted):
            raise AssertionError(slug)
        requires = ("boundaries.one", "handles", f"code.{CodeName.CONTEXT}")
        yield from _there_and_back(
            CodeName.CONTEXT, slug, stream, bits.value, seen.value, "hand", requires
        )


_OF_WORDS: Final = (
    "many-components", "closed-by-e", "shared-closer", "handle-left", "handle-right", "curve-left",
    "curve-right", "deep-stack", "long-run", "high-genus", "lone-triangle",
)  # fmt: skip
"""The flags that have to do with a word and its handle data."""


def closing_form(closing: Closing) -> form.ClosingForm:
    """A closing as a message has it. Clauses: ORCL-OP-6, CODE-HAND-1."""
    return form.ClosingForm(
        passed=to_wire(closing.passed),
        kind="boundary" if closing.kind is Kind.BOUNDARY else "handle",
        side="left" if closing.side is Side.LEFT else "right",
        between=to_wire(closing.between),
    )


def by_turns(surfaces: Iterable[Named], each: int) -> Iterator[Asked]:
    """Each surface in some of the codes, so many, all codes having their turn."""
    codes = cycle(CodeName)
    for named in surfaces:
        for code in islice(codes, each):
            yield from coded(code, named.slug, named.surface, named.origin)


def of_spheres(vertices: int) -> Iterator[Named]:
    """All spheres of so many vertices."""
    for word in sphere_words(vertices):
        yield Named(slug_of(word), sphere(word), "exhaustive")


def words() -> Iterator[Asked]:
    """Small spheres and all that is made by hand or by rule in every code; the rest by turns."""
    every = len(CodeName)
    for vertices in (4, 5, 6):
        yield from by_turns(of_spheres(vertices), every)
    yield from by_turns(of_spheres(7), 2)
    yield from by_turns(islice(of_spheres(8), 0, None, 7), 2)
    yield from by_turns(by_hand(), every)
    yield from by_turns(by_rule(), every)
    yield from by_turns(by_scripts(), 3)
    yield from by_turns(at_random(), every)
    yield from of_no_surface()
