"""Words in codes: bits that nobody writes, and words that have no bits. Chapter 6."""

from collections.abc import Iterator, Mapping
from typing import Final

from msgspec import UnsetType

from clers.codes.closings import closings
from clers.codes.registry import CodeName
from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.conformance.served.forms import handle_forms
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.stream import Stream
from clers.oracle.negatives.by_hand import CODES
from clers.oracle.negatives.draft import Draft, Slip, bad, good, spoilt
from clers.oracle.negatives.messages import bit_edits, digits_of, packed, string
from clers.oracle.negatives.words import PARENTS
from clers.oracle.positives.asked import needed
from clers.oracle.positives.words import closing_form

C = Clause
R = Reason

STREAMS: Final = {
    slug: stream
    for slug, stream in PARENTS
    if slug in ("tetrahedron", "cube", "two-disks", "annulus", "torus")
}
"""A few of the streams of `words`, by name."""

SPHERES: Final = ("tetrahedron", "cube")

LONGER: Final[Mapping[str, tuple[R, C]]] = {
    "plain": (R.TRAILING_BITS, C.CODE_PLAIN_2),
    "huffman": (R.TRAILING_BITS, C.INFO_PREFIX_3),
    "king-rossignac": (R.TRAILING_BITS, C.CODE_KR_3),
}
"""What a bit too many is, by code; in the others what the coder of chapter 2 says."""


def asked_of(code: str, slug: str, stream: Stream) -> tuple[Draft, Draft]:
    """The cases of a word to encode, and of its bits to decode. Clause: ORCL-OP-6."""
    surface, seen = decode(stream), closings(stream)
    if not isinstance(surface, Accepted) or not isinstance(seen, Accepted):
        raise Slip(slug)
    requires = (f"code.{code}", *needed(surface.value))
    size, boundaries = len(stream.word), stream.components_with_boundary
    asked = good(
        f"{code}-{slug}", "code.encode",
        form.ToWord(
            code=code, word=stream.word, handles=handle_forms(stream.records),
            components_with_boundary=boundaries,
        ),
        (C.CODE_NAME_1, C.CODE_NAME_2), requires=requires, size=size,
    )  # fmt: skip
    digits = digits_of(asked)
    if code in CODES and digits != CODES[code][1](stream.word, "" if boundaries else "C"):
        raise Slip(f"{asked.slug}: {digits}")
    given = good(
        f"{code}-{slug}", "code.decode",
        form.FromWord(
            code=code, bits=string(digits), symbols=size, components_with_boundary=boundaries,
            closings=tuple(map(closing_form, seen.value)),
        ),
        (C.CODE_NAME_1, C.CODE_NAME_2), requires=requires, size=size,
    )  # fmt: skip
    return asked, given


def drafts() -> Iterator[Draft]:
    """Words and bits in every code, and what is wrong with them. Clause: ORCL-OP-6."""
    for code in map(str, CodeName):
        for slug, stream in STREAMS.items():
            if code.startswith(("minimax", "enumerative")) and slug not in SPHERES:
                continue
            asked, given = asked_of(code, slug, stream)
            yield asked
            yield given
            yield from loose(given, digits_of(asked), code)
            if slug == "cube":
                yield from packed(given, digits_of(asked))
                yield from unwritable(asked, code, stream.word)
            if slug == "torus":
                yield from unfounded(asked)
    yield from special()


def loose(given: Draft, digits: str, code: str) -> Iterator[Draft]:
    """Bits too many, too few, turned; symbols too many or too few. Clause: CODE-NAME-2."""
    flag = ("bits-not-compared",)
    if code != "best":
        longer = LONGER.get(code, (R.TRAILING_BITS, C.ARITH_STRICT_3))
        for kind, more in (("one-bit-more", "0"), ("one-bit-set-more", "1")):
            yield bad(given, kind, bit_edits(digits, digits + more), *longer, flags=flag)
    ways = {
        "no-bits": "",
        "first-bit-turned": str(1 - int(digits[0])) + digits[1:],
        "last-bit-turned": digits[:-1] + str(1 - int(digits[-1])),
        "last-bit-missing": digits[:-1],
        "first-bit-missing": digits[1:],
        "bits-backwards": digits[::-1],
    }
    for kind, new in ways.items():
        if new != digits:
            yield from refused(given, kind, bit_edits(digits, new), flag)
    size = given.case.size
    for kind, symbols in (("one-symbol-more", size + 1), ("one-symbol-less", size - 1)):
        edit = replaced("/symbols", 0, size, symbols)
        yield from refused(given, kind, (edit,), ("count-trusted",))


def refused(
    given: Draft, kind: str, edits: tuple[Edit, ...], flags: tuple[str, ...]
) -> Iterator[Draft]:
    """The case, if the edits make it a bad one: some bits are those of another word."""
    draft = spoilt(given, kind, edits, flags=flags)
    if not isinstance(draft.case.reject, UnsetType):
        yield draft


def unwritable(asked: Draft, code: str, word: str) -> Iterator[Draft]:
    """Words that have no bits in a code. Clauses: CODE-IMPLIED-2, CODE-HAND-2."""
    flag = ("word-not-checked",)
    edits = {
        "first-symbol-not-c": replaced("/word", 0, word[0], "R"),
        "symbol-x": replaced("/word", 3, word[3], "X"),
        "small-letters": replaced("/word", 0, word, word.lower()),
        "l-after-c": replaced("/word", 3, word[3], "L"),
        "e-after-c": replaced("/word", 3, word[3], "E"),
        "empty": replaced("/word", 0, word, ""),
    }
    for kind, edit in edits.items():
        yield from refused(asked, kind, (edit,), flag)
    put = {"kind": "handle", "s": 0, "at": 0, "side": "right"}
    record = replaced("/handles", 0, [], [put])
    yield bad(
        asked, "record-without-s", (record,), R.NOT_REPRESENTABLE, C.CODE_HAND_2,
        flags=flag, requires=("handles",),
    )  # fmt: skip


def unfounded(asked: Draft) -> Iterator[Draft]:
    """Records that no edge belongs to. Clause: CODE-HAND-2."""
    for kind, edit in (
        ("closer-before-its-s", replaced("/handles/0/at", 0, 6, 0)),
        ("closer-beyond-the-word", replaced("/handles/1/at", 0, 5, 7)),
        ("s-beyond-the-word", replaced("/handles/1/s", 0, 1, 4)),
        ("s-negative", replaced("/handles/0/s", 0, 0, -1)),
        ("s-of-the-record-before", replaced("/handles/1/s", 0, 1, 0)),
    ):
        yield bad(
            asked, kind, (edit,), R.NOT_REPRESENTABLE, C.CODE_HAND_2, flags=("unchecked-record",)
        )


def special() -> Iterator[Draft]:
    """What only one code can get wrong."""
    yield from of_huffman()
    yield from of_king_rossignac()
    yield from of_best()
    yield from not_for_all()
    for code in map(str, CodeName):
        yield from with_closings(code)
        if code != "enumerative":
            yield from of_nothing(code)
    for code in ("plain", "golden"):
        _, given = asked_of(code, "tetrahedron", STREAMS["tetrahedron"])
        edit = replaced("/symbols", 0, 3, 0)
        yield bad(
            given, "no-symbols", (edit,), R.EMPTY_WORD, C.CODE_IMPLIED_2, flags=("count-trusted",)
        )


def of_huffman() -> Iterator[Draft]:
    """Clauses: CODE-HUFFMAN-2, CODE-HUFFMAN-3, INFO-KRAFT-2, INFO-PREFIX-3."""
    asked, given = asked_of("huffman", "tetrahedron", STREAMS["tetrahedron"])
    digits = digits_of(asked)
    flag = ("table-not-checked",)
    for kind, new, reason, clause in (
        # lengths of C, L, E, R, S; for RE the right ones are 0 0 1 1 0
        ("table-of-too-many", "000001001001000" + "10", R.BAD_TABLE, C.INFO_KRAFT_2),
        ("table-of-longer-words", "000000010010000" + "0100", R.NOT_CANONICAL, C.CODE_HUFFMAN_3),
        ("table-with-another-symbol", "000000001010010" + "100", R.NOT_CANONICAL, C.CODE_HUFFMAN_3),
        ("table-of-none", "000000000000000" + "10", R.NOT_CANONICAL, C.INFO_PREFIX_3),
        ("table-of-none-alone", "000000000000000", R.TRUNCATED_BITS, C.INFO_PREFIX_3),
        ("table-cut", "00000000100100", R.TRUNCATED_BITS, C.CODE_HUFFMAN_3),
        ("no-words-after-the-table", "000000001001000", R.TRUNCATED_BITS, C.INFO_PREFIX_3),
    ):
        yield bad(given, kind, bit_edits(digits, new), reason, clause, flags=flag)


def of_king_rossignac() -> Iterator[Draft]:
    """Clause: CODE-KR-3."""
    asked, given = asked_of("king-rossignac", "tetrahedron", STREAMS["tetrahedron"])
    digits = digits_of(asked)  # the R after the implied C is 11, the E 01 in code II
    flag = ("bits-not-compared",)
    for kind, new, reason in (
        ("fourth-selector", "11" + digits[2:], R.NOT_CANONICAL),
        ("written-in-code-one", "0011111", R.NOT_CANONICAL),
        ("written-in-code-three", "101111", R.NOT_CANONICAL),
        ("half-a-selector", "0", R.TRUNCATED_BITS),
        ("selector-alone", "01", R.TRUNCATED_BITS),
    ):
        yield bad(given, kind, bit_edits(digits, new), reason, C.CODE_KR_3, flags=flag)


def of_best() -> Iterator[Draft]:
    """Clause: CODE-BEST-2."""
    flag = ("bits-not-compared",)
    selectors = {"golden": "101", "king-rossignac": "110", "plain": "111", "enumerative": "100"}
    for slug in SPHERES:
        asked, given = asked_of("best", slug, STREAMS[slug])
        digits = digits_of(asked)
        for code, selector in selectors.items():
            other, _ = asked_of(code, slug, STREAMS[slug])
            new = selector + digits_of(other)
            if not digits.startswith(selector):
                edits = bit_edits(digits, new)
                yield bad(
                    given, f"written-in-{code}", edits, R.NOT_CANONICAL, C.CODE_BEST_2, flags=flag
                )
        for kind, new in (("half-a-selector", "1"), ("selector-of-two-bits", "10")):
            edits = bit_edits(digits, new)
            yield bad(given, kind, edits, R.TRUNCATED_BITS, C.CODE_BEST_2, flags=flag)


def with_closings(code: str) -> Iterator[Draft]:
    """A sphere's bits, told with a closing that no S uses. Clauses: ORCL-OP-6, CODE-BEST-2."""
    _, given = asked_of(code, "tetrahedron", STREAMS["tetrahedron"])
    for kind, passed, between in (
        ("unused", 7, 0),
        ("passed-negative", -1, 0),
        ("negative", 0, -1),
    ):
        closing = {"passed": passed, "kind": "handle", "side": "right", "between": between}
        edit = replaced("/closings", 0, [], [closing])
        words, needs = f"closing-{kind}", ("handles",)
        if kind != "unused":
            yield bad(
                given, words, (edit,), R.RECORD_OUT_OF_RANGE, C.CODE_HAND_3,
                requires=needs, flags=("unchecked-record",),
            )  # fmt: skip
        elif code == "enumerative":
            yield bad(
                given, words, (edit,), R.NOT_REPRESENTABLE, C.CODE_ENUM_1,
                requires=needs, flags=("code-not-for-all",),
            )  # fmt: skip
        else:
            yield spoilt(given, words, (edit,), requires=needs)
    if code == "enumerative":
        yield bad(
            given, "with-boundary", (replaced("/components_with_boundary", 0, 0, 1),),
            R.NOT_REPRESENTABLE, C.CODE_ENUM_1,
            requires=("boundaries.one",), flags=("code-not-for-all",),
        )  # fmt: skip


def of_nothing(code: str) -> Iterator[Draft]:
    """A word of no symbols, with boundary: no surface has it, a code writes it. CODE-IMPLIED-2."""
    requires, clauses = (f"code.{code}", "boundaries.one"), (C.CODE_NAME_2, C.CODE_IMPLIED_2)
    asked = good(
        f"{code}-of-nothing", "code.encode",
        form.ToWord(code=code, word="", handles=(), components_with_boundary=1),
        clauses, requires=requires,
    )  # fmt: skip
    yield asked
    yield good(
        f"{code}-of-nothing", "code.decode",
        form.FromWord(
            code=code, bits=string(digits_of(asked)), symbols=0, components_with_boundary=1
        ),
        clauses, requires=requires,
    )  # fmt: skip


def not_for_all() -> Iterator[Draft]:
    """Surfaces that a code refuses, by a change of the code's name. CODE-NAME-5."""
    for slug in ("torus", "annulus", "two-disks"):
        asked, _ = asked_of("plain", slug, STREAMS[slug])
        edit = replaced("/code", 0, "plain", "enumerative")
        yield bad(
            asked, "as-enumerative", (edit,), R.NOT_REPRESENTABLE, C.CODE_ENUM_1,
            flags=("code-not-for-all",), requires=("code.enumerative",),
        )  # fmt: skip
