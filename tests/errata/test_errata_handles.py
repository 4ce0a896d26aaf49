"""ERRATUM-5, 6 and 9: what closes the left edge of an S, and how the tutorial counts it."""

from itertools import product
from typing import Final

from every_small_surface import from_every_gate

from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TORUS
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.generate.exhaustive import rooted_surfaces

WORD: Final = "CCCCRCSCRSSRLSEEE"
"""Figure 22."""

NARROW: Final = ((3, 2, 5), (1, 3, 0), (4, 0, 3), (3, 5, 4), (0, 2, 1), (0, 5, 2))
"""An annulus."""

PRINTED: Final = (4, 3)
"""`0—4, 0—3`: the second numbers of the records of the first and the second S."""


def test_an_annulus_closes_on_either_side() -> None:
    """ERRATUM-5: of one surface, by its start gate, on the right of an E or on its left.

    EB-HANDLE-4. Found by enumeration of all surfaces up to six faces: no smaller one has an S_b.
    """
    found = {
        (stream.word, record.side)
        for surface in from_every_gate(6)
        for stream in (encode(surface).stream,)
        for record in stream.records
    }
    assert ("SLRRLE", Side.RIGHT) in found
    assert ("SLLRLE", Side.LEFT) in found
    assert not any(encode(surface).stream.records for surface in from_every_gate(5))
    streams = {_stream(begun) for begun in rooted_surfaces(NARROW)}
    assert {("SLRRLE", Side.RIGHT), ("SLLRLE", Side.LEFT)} <= {
        (stream.word, stream.records[0].side) for stream in streams
    }


def _stream(surface: Surface) -> Stream:
    return encode(surface).stream


def test_an_l_closes_too() -> None:
    """ERRATUM-5: from seven triangles on the closing triangle may be an L, so L must be counted."""
    closers = {
        (len(stream.word), [x for x in stream.word if x in "RLE"][record.at])
        for surface in from_every_gate(7)
        for stream in (encode(surface).stream,)
        for record in stream.records
        if record.kind is Kind.BOUNDARY
    }
    assert closers == {(6, "E"), (7, "E"), (7, "R"), (7, "L")}


def test_the_torus_has_one_handle_data() -> None:
    """ERRATUM-6: both S of Figure 22 close across the right edge of an E, and nothing else fits.

    EB-HANDLE-3, EB-HANDLE-4. Tried: every pair of S, every closing symbol, either side.
    """
    closers = sum(x in "RLE" for x in WORD)
    splits = [(s, t) for s in range(4) for t in range(s + 1, 4)]
    accepted = [
        stream
        for (s, t), at, until, side, other in product(
            splits, range(closers), range(closers), Side, Side
        )
        for stream in (
            Stream(WORD, (Record(Kind.HANDLE, s, at, side), Record(Kind.HANDLE, t, until, other))),
        )
        if isinstance(decode(stream), Accepted)
    ]
    right = (Record(Kind.HANDLE, 0, 6, Side.RIGHT), Record(Kind.HANDLE, 1, 5, Side.RIGHT))
    assert accepted == [Stream(WORD, right)]
    assert encode(TORUS).stream == accepted[0]


def _counted(letters: str, origin: str, itself: bool) -> tuple[int, ...]:
    """How many of some letters stand before the closing E of the first and of the second S."""
    splits = [i for i, x in enumerate(WORD) if x == "S"]
    start = {"the word": (0, 0), "its own S": splits[:2], "the first S": splits[:1] * 2}[origin]
    return tuple(
        sum(x in letters for x in WORD[begin : end + itself])
        for begin, end in zip(start, (16, 15), strict=True)
    )


ORIGINS: Final = ("the word", "its own S", "the first S")


def test_the_printed_numbers_fit_no_rule_that_is_told() -> None:
    """ERRATUM-6: neither the text's R, L, E nor Algorithm 5's #RE, counted from anywhere told.

    EB-HANDLE-3.
    """
    told = product(("RLE", "RE"), ("the word", "its own S"), (False, True))
    assert PRINTED not in {_counted(*rule) for rule in told}
    assert _counted("RLE", "the word", itself=False) == (6, 5)  # ours


def test_rules_that_do_fit_the_printed_numbers() -> None:
    """ERRATUM-6: R and E after the first S; or L and E with the closing one, of the wrong side."""
    every = product(("RLE", "RE", "LE"), ORIGINS, (False, True))
    assert {rule for rule in every if _counted(*rule) == PRINTED} == {
        ("RE", "the first S", False),
        ("LE", "the word", True),
        ("LE", "the first S", True),
        ("LE", "its own S", True),
    }


def test_records_are_written_as_they_close() -> None:
    """ERRATUM-6: Algorithm 5 writes the second S first, for its E comes first. EB-HANDLE-5."""
    records = encode(TORUS).stream.records
    assert [r.s for r in sorted(records, key=lambda r: r.at)] == [1, 0]
    assert [r.s for r in records] == [0, 1]


def test_zero_has_no_sign() -> None:
    """ERRATUM-9: Algorithm 7 takes `s > 0` for a handle; the first S of Figure 22 is number 0.

    EB-HANDLE-2.
    """
    read = ["handle" if record.s > 0 else "boundary" for record in encode(TORUS).stream.records]
    assert read == ["boundary", "handle"]
    assert all(record.kind is Kind.HANDLE for record in encode(TORUS).stream.records)
