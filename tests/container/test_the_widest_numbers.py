"""The widest number that each place of quantised positions takes, and one more."""

from collections.abc import Sequence

import pytest

from clers.arithmetic.bits import pack
from clers.container.layout import Layout, Window, read, write
from clers.container.numbers import U32, signed, varint
from clers.container.places import LATTICE
from clers.container.section import HEADER, LONGEST, SECTION, sealed
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.geometry.box import Box
from clers.geometry.quantised import Coded

WIDE = (signed(90), *[signed(90)] * 3, *[varint(90)] * 3, varint(90))
"""What is written by these is what narrower ones would write, if they could: FILE-NUMBER-3."""

LEAST = (-(2**11), *[-(2**53)] * 3, 0, 0, 0)
MOST = (2**11 - 1, *[2**53 - 1] * 3, *[2**30 - 1] * 3)


def payload(numbers: Sequence[int], length: int = 0) -> bytes:
    """FILE-POSN-2, without bits."""
    there = zip(WIDE, (*numbers, length), strict=True)
    return b"".join(write(layout, number) for layout, number in there)


@pytest.mark.parametrize("place", range(7))
@pytest.mark.parametrize(("numbers", "beyond"), [(LEAST, -1), (MOST, 1)])
def test_numbers_of_a_lattice(place: int, numbers: tuple[int, ...], beyond: int) -> None:
    """Clauses: FILE-POSN-2, FILE-NUMBER-3, FILE-NUMBER-4."""
    one = [0] * 7
    one[place] = numbers[place]
    data = payload(one)
    coded = Coded(one[0], Box((one[1], one[2], one[3]), (one[4], one[5], one[6])), pack(()))
    assert read(LATTICE, Window(data, len(data))) == Accepted(coded)
    assert write(LATTICE, coded) == data
    one[place] += beyond
    if one[place] != -1:  # extents have no sign
        data = payload(one)
        found = read(LATTICE, Window(data, len(data)))
        assert isinstance(found, Rejected)
        assert found.reason is Reason.BAD_NUMBER


@pytest.mark.parametrize(
    ("length", "reason"),
    [(2**40 - 1, Reason.TRUNCATED_FILE), (2**40, Reason.BAD_NUMBER), (2**41, Reason.BAD_NUMBER)],
)
def test_the_number_of_bits(length: int, reason: Reason) -> None:
    """FILE-BITS-1."""
    data = payload([0] * 7, length)
    found = read(LATTICE, Window(data, len(data)))
    assert isinstance(found, Rejected)
    assert found.reason is reason


def test_the_fewest_bytes() -> None:
    """FILE-SECTION-1, FILE-LAYOUT-1: tag, length, seal; then at least the seal of no payload."""
    assert HEADER.least == len(write(HEADER, (b"HEAD", 0))) == 12
    assert write(SECTION, ((b"HEAD", 0), b"")) == write(HEADER, (b"HEAD", 0)) + bytes(4)
    empty: Layout[int] = sealed(varint(7))
    assert empty.least == len(write(empty, 0)) == 5


def test_the_longest_payload_is_what_its_length_can_say() -> None:
    """Clause: FILE-SECTION-1."""
    assert read(U32, Window(b"\xff" * 4, 4)) == Accepted(LONGEST)
