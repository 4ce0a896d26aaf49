"""Streams and files that no encoder wrote: complete, and accepted for the right reason."""

import struct
from collections import Counter
from dataclasses import replace
from functools import cache
from itertools import islice, product

import msgspec
import pytest
from negative_cases import accepted, suite

from clers.arithmetic import coder
from clers.codes.registry import CodeName
from clers.codes.registry import encode as encode_word
from clers.container.file import decode as decode_file
from clers.container.file import encode as encode_file
from clers.container.file import options_of
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.definition import decode_by_fold
from clers.edgebreaker.encode import encode
from clers.edgebreaker.grammar import rooted_triangulations
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.information.static import Static
from clers.oracle.negatives import by_hand, pencil
from clers.oracle.negatives.backwards import all_streams, random_streams
from clers.oracle.negatives.files import FILES
from clers.oracle.negatives.grammar import streams
from clers.oracle.negatives.words import spoken_of, stream_form
from clers.oracle.positives.asked import needed


@cache
def drawn() -> tuple[tuple[str, Stream], ...]:
    """The streams of the suite, drawn once."""
    return tuple(streams())


def _records(word: str) -> list[tuple[Record, ...]]:
    """Every handle data that a word could have, good or bad, each S with one record or none."""
    splits = [i for i, x in enumerate(word) if x == "S"]
    closers = [i for i, x in enumerate(word) if x in "RLE"]
    choices = [
        [None]
        + [
            Record(kind, s, at, side)
            for at, i in enumerate(closers)
            for side in Side
            for kind in Kind
            if i > splits[s] and word[i] in ("RE" if side is Side.RIGHT else "LE")
        ]
        for s in range(len(splits))
    ]
    return [tuple(r for r in chosen if r is not None) for chosen in product(*choices)]


@pytest.mark.parametrize(("symbols", "count"), [(1, 1), (2, 3), (3, 12), (4, 43)])
def test_none_is_missing(symbols: int, count: int) -> None:
    """All strings of symbols with all records, tried one by one. Clause: ORCL-GRAMMAR-1."""
    tried = {
        stream
        for letters in product("CLERS", repeat=symbols)
        for word in ["".join(letters)]
        for records in _records(word)
        for boundaries in range(symbols + 1)
        if isinstance(decode(stream := Stream(word, records, boundaries)), Accepted)
    }
    built = {s for s in all_streams(symbols) if isinstance(decode(s), Accepted)}
    assert built == tried
    assert len(built) == count


def test_all_of_six_with_a_record() -> None:
    """The annuli of six triangles, tried one by one. Clause: ORCL-GRAMMAR-1."""
    tried = {
        stream
        for letters in product("CLERS", repeat=5)
        for word in ["S" + "".join(letters), *(x + "".join(letters) for x in "CLR")]
        if word.count("S") == 1 and word.endswith("E") and word.count("E") == 1
        for records in _records(word)
        if records and isinstance(decode(stream := Stream(word, records, 1)), Accepted)
    }
    built = {s for s in all_streams(6, records=1) if isinstance(decode(s), Accepted)}
    assert built == tried
    assert len(built) == 7


@pytest.mark.parametrize("vertices", [4, 5, 6])
def test_spheres_are_counted(vertices: int) -> None:
    """Of one closed component without records there are as many as Tutte counted. EB-GRAMMAR-10."""
    built = [
        s
        for s in all_streams(2 * vertices - 5)
        if not s.records and s.components_with_boundary == 0
        if isinstance(found := decode(s), Accepted) and found.value.vertices == vertices
    ]
    assert len(built) == rooted_triangulations(vertices)


def test_the_walk_keeps_the_grammar() -> None:
    """What it builds is refused for EB-GRAMMAR-9 alone. Clauses: ORCL-GRAMMAR-1, EB-GRAMMAR-9."""
    every = [*all_streams(6), *islice(random_streams(5, 18), 300)]
    assert len(set(map(repr, every))) == len(every)
    for stream in every:
        match decode(stream):
            case Rejected(reason, clause):
                assert reason in (Reason.DOUBLE_EDGE, Reason.REPEATED_VERTEX)
                assert clause is Clause.EB_GRAMMAR_9
            case Accepted(surface):
                assert encode(surface).stream == stream


def test_walks_reach_handles_curves_and_components() -> None:
    """Clause: ORCL-GRAMMAR-1."""
    walked = list(islice(random_streams(16, 16), 600))
    kinds = Counter(kind for stream in walked for kind in {r.kind for r in stream.records})
    assert kinds[Kind.HANDLE] > 20
    assert kinds[Kind.BOUNDARY] > 20
    assert {s.components_with_boundary for s in walked} >= {0, 1}
    assert walked[:50] == list(islice(random_streams(16, 16), 50))
    assert walked[:50] != list(islice(random_streams(17, 16), 50))


def test_the_definition_says_the_same_of_what_was_built() -> None:
    """A decoder that folds operators agrees on every stream. Clauses: EB-DECODE-3, EB-FOLD-1."""
    for number, (_, stream) in enumerate(drawn()):
        if len(stream.word) <= 6 and number % 3 == 0:
            fast, slow = decode(stream), decode_by_fold(stream)
            assert isinstance(fast, Accepted) == isinstance(slow, Accepted)
            if isinstance(fast, Accepted):
                assert fast == slow


def test_the_suite_has_them() -> None:
    """Clause: ORCL-GRAMMAR-1."""
    given = dict(reversed([(stream, slug) for slug, stream in drawn()]))
    good = {s: slug for s, slug in given.items() if isinstance(decode(s), Accepted)}
    slugs = Counter(slug.partition("-")[0] for slug in good.values())
    assert slugs["all"] == 1 + 3 + 12 + 43 + 173
    assert slugs["curve"] == 7 + 91
    assert slugs["drawn"] > 100
    asked = {bytes(case.input) for case in accepted() if case.op == "word.decode"}
    assert asked >= {msgspec.json.encode(stream_form(stream)) for stream in good}
    words = [case for case in accepted() if case.op == "word.decode" and case.origin == "grammar"]
    assert len(words) > 400
    assert any(case.trace for case in words)


@pytest.mark.parametrize(
    ("stream", "needs"),
    [
        (Stream("CRE"), ()),
        (Stream("CRE", (), 1), ("boundaries.one",)),
        (Stream("CRE", (), 2), ("boundaries.many", "components")),
        (Stream("CRE", (), -1), ()),
        (Stream("CREE"), ("components",)),
        (Stream("CREC"), ("components",)),
        (Stream("SEE"), ()),
        (Stream("SEEE"), ("components",)),
        (Stream("SE", (Record(Kind.HANDLE, 0, 0, Side.LEFT),)), ("handles",)),
        (Stream("SEE", (Record(Kind.HANDLE, 0, 0, Side.LEFT),)), ("components", "handles")),
        (Stream("SEE", (Record(Kind.HANDLE, 1, 0, Side.LEFT),)), ("handles",)),
        (Stream("SSEE", (Record(Kind.BOUNDARY, 1, 0, Side.LEFT),)), ("boundaries.one",)),
        (Stream("SE", (Record(Kind.BOUNDARY, 0, 0, Side.LEFT),), 1), ("boundaries.many",)),
        (Stream("SE", (Record(Kind.BOUNDARY, 0, 0, Side.LEFT),), -1), ("boundaries.one",)),
        (Stream(""), ()),
    ],
)
def test_what_a_stream_speaks_of(stream: Stream, needs: tuple[str, ...]) -> None:
    """Clause: ORCL-CASE-4."""
    assert spoken_of(stream) == needs


def test_a_good_stream_speaks_of_what_its_surface_needs() -> None:
    """Clauses: ORCL-CASE-4, EB-COUNT-4."""
    for number, (_, stream) in enumerate(drawn()):
        if number % 2 == 0 and isinstance(found := decode(stream), Accepted):
            assert set(spoken_of(stream)) == set(needed(found.value))


PARENTS = dict(FILES)


@pytest.mark.parametrize("name", sorted(PARENTS))
@pytest.mark.parametrize("code", sorted(by_hand.CODES))
def test_a_file_by_hand_is_the_file(name: str, code: str) -> None:
    """Byte for byte what the reference writes for what it reads. ORCL-GRAMMAR-2, FILE-ROUND-3."""
    file = replace(PARENTS[name], code=code)
    found, options = decode_file(file.data), options_of(file.data)
    assert isinstance(found, Accepted)
    assert isinstance(options, Accepted)
    assert options.value.code == code
    again = encode_file(found.value.surface, found.value.positions, options.value)
    assert again == Accepted(file.data)
    assert (found.value.surface.faces, found.value.surface.vertices) == (file.faces, file.vertices)
    assert f"file-{name.removeprefix('file-')}-{code}" in {i[:-9] for i in suite()}


def test_positions_by_hand() -> None:
    """Clauses: ORCL-GRAMMAR-2, GEOM-EXACT-1, FILE-POSN-2."""
    for file in (by_hand.F32, by_hand.F64, by_hand.LATTICE):
        found = decode_file(file.data)
        assert isinstance(found, Accepted)
        assert found.value.positions is not None
        assert found.value.positions.coordinates == by_hand.CORNER
    assert by_hand.F64.posn == struct.pack("<12d", *by_hand.CORNER)
    assert by_hand.LATTICE.posn.hex(" ") == "01 00 00 00 02 02 02 24 03 b1 41 02 90"


WORDS = ("CRE", "CCCRCRRCRRE", "CCRRE", "SLRRLE", "E", "RLRE", "CCCCRCSCRSSRLSEEE" * 12)


@pytest.mark.parametrize("code", sorted(by_hand.CODES))
@pytest.mark.parametrize("word", WORDS, ids=lambda word: word[:12])
def test_bits_by_pencil(code: str, word: str) -> None:
    """The definitions give the bits of the codes. Clause: ORCL-GRAMMAR-2."""
    boundaries = 0 if word.startswith("C") else 1
    found = encode_word(CodeName(code), Stream(word, (), boundaries))
    assert isinstance(found, Accepted)
    written = by_hand.CODES[code][1](word, "" if boundaries else "C")
    assert written == found.value.digits()


def test_counts_by_pencil_are_halved() -> None:
    """Clauses: INFO-ADAPT-1, INFO-ADAPT-2."""
    counts = pencil.Counts((1, 2, 3), 2, 8)
    assert counts.slot(0) == (0, 1, 6)
    assert counts.frequencies == [3, 2, 3]
    assert counts.slot(2) == (5, 8, 8)
    assert counts.frequencies == [2, 1, 3]
    assert counts.slot(1) == (2, 3, 6)
    assert counts.frequencies == [2, 3, 3]


@pytest.mark.parametrize("symbols", [(), (1,), (0, 2), (1,) * 70 + (2,), (2, 0) * 40])
def test_long_addition(symbols: tuple[int, ...]) -> None:
    """Clauses: ARITH-CARRY-1, ORCL-GRAMMAR-2."""
    table = (0, 1, 3, 4)
    slots = [(table[s], table[s + 1], 4) for s in symbols]
    found = coder.encode(Static(table), symbols)
    assert isinstance(found, Accepted)
    assert pencil.long_addition(slots) == found.value.digits()


def test_numbers_by_hand() -> None:
    """Clauses: FILE-NUMBER-3, FILE-NUMBER-4, FILE-BITS-1."""
    assert [by_hand.varint(n).hex() for n in (0, 127, 128, 300)] == ["00", "7f", "8001", "ac02"]
    assert [by_hand.signed(n).hex() for n in (0, -1, 1, -2, 64)] == ["00", "01", "02", "03", "8001"]
    assert by_hand.bits("101111").hex() == "06bc"
    assert by_hand.bits("").hex() == "00"
    assert by_hand.bits("1" * 9).hex() == "09ff80"
