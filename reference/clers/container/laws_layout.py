"""Laws of layouts: one value, one sequence of bytes, in both directions."""

from typing import Final, TypeVar

from clers.container.given import NUMBERS, RAW_BYTES
from clers.container.head import CODES, PositionCoding
from clers.container.layout import Layout, Window, dependent, pair, read, renamed, times, write
from clers.container.numbers import REST, U8, U32, one_of, raw, signed, varint
from clers.container.places import BITS, LATTICE
from clers.container.section import SECTION, sealed
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtByte

X = TypeVar("X")


def _canonical(layout: Layout[X], data: bytes) -> Verdict:
    """What is read from the beginning of some bytes is written as those bytes."""
    match layout.read(Window(data, len(data)), 0):
        case Accepted(found):
            taken = found.offset
            return every(
                same(data[:taken].hex(), write(layout, found.value).hex()),
                Holds() if taken >= layout.least else Fails(f"≥ {layout.least}", str(taken), WHOLE),
            )
        case Rejected():
            return Holds()


def every_layout_canonical(data: bytes) -> Verdict:
    """Whatever bytes a layout reads, it writes the same."""
    return every(
        _canonical(U8, data),
        _canonical(U32, data),
        _canonical(raw(3), data),
        _canonical(REST, data),
        _canonical(varint(32), data),
        _canonical(varint(7), data),
        _canonical(signed(12), data),
        _canonical(signed(54), data),
        _canonical(one_of(CODES), data),
        _canonical(one_of(tuple(PositionCoding)), data),
        _canonical(pair(varint(14), signed(14)), data),
        _canonical(times(3, varint(9)), data),
        _canonical(dependent(U8, lambda n: times(n % 4, varint(16))), data),
        _canonical(renamed(U8, lambda n: Accepted(n + 1), lambda n: n - 1), data),
        _canonical(pair(varint(34), signed(33)), data),
        _canonical(BITS, data),
        _canonical(LATTICE, data),
    )


def sealed_canonical(data: bytes) -> Verdict:
    """What is sealed is read back, and the sealed bytes are followed by four more."""
    written = write(sealed(raw(len(data))), data)
    section = write(SECTION, ((b"WORD", len(data)), data))
    return every(
        same(data, written[:-4]),
        same(Accepted(data), read(sealed(raw(len(data))), Window(written, len(written)))),
        same(Accepted(((b"WORD", len(data)), data)), read(SECTION, Window(section, len(section)))),
        same(16 + len(data), len(section)),
    )


def varint_by_definition(n: int) -> bytes:
    """Groups of seven binary digits, lowest first, all but the last with 128 added."""
    digits = f"{n:b}"
    padded = digits.zfill(-(-len(digits) // 7) * 7)
    groups = [int(padded[i : i + 7], 2) for i in range(0, len(padded), 7)]
    return bytes([group + 128 for group in groups[:0:-1]] + [groups[0]])


def varint_is_the_shortest(n: int) -> Verdict:
    """Written as defined and read back; one group of zeros more is refused."""
    data = write(varint(64), n)
    padded = data[:-1] + bytes((data[-1] | 0x80, 0))
    longer = read(varint(64), Window(padded, len(padded)))
    return every(
        same(varint_by_definition(n), data),
        same(Accepted(n), read(varint(64), Window(data, len(data)))),
        _refused(longer, Clause.FILE_NUMBER_3, 0),
    )


def varint_bounded(n: int) -> Verdict:
    """A number is read where its binary digits fit, and refused where one does not."""
    data, size = write(varint(64), n), n.bit_length()
    narrow = read(varint(max(0, size - 1)), Window(data, len(data)))
    return every(
        same(Accepted(n), read(varint(size), Window(data, len(data)))),
        Holds() if size == 0 else _refused(narrow, Clause.FILE_NUMBER_3, 0),
    )


def signed_both_ways(n: int) -> Verdict:
    """n and −n − 1 are next to each other, and both come back."""
    low, high = write(signed(65), -n - 1), write(signed(65), n)
    return every(
        same(write(varint(65), 2 * n), high),
        same(write(varint(65), 2 * n + 1), low),
        same(Accepted(n), read(signed(65), Window(high, len(high)))),
        same(Accepted(-n - 1), read(signed(65), Window(low, len(low)))),
    )


def nothing_may_follow(data: bytes) -> Verdict:
    """A value read to the end of its window is refused if one byte is left."""
    longer = Window(data + b"\0", len(data) + 1)
    return every(
        same(Accepted(data), read(raw(len(data)), Window(data, len(data)))),
        _refused(read(raw(len(data)), longer), Clause.FILE_LAYOUT_2, len(data)),
    )


def nothing_may_lack(data: bytes) -> Verdict:
    """A value that needs one byte more than there are is refused."""
    found = read(raw(len(data) + 1), Window(data, len(data)))
    return _refused(found, Clause.FILE_LAYOUT_3, 0)


def _refused(result: object, clause: Clause, offset: int) -> Verdict:
    if isinstance(result, Rejected):
        return same((clause, AtByte(offset)), (result.clause, result.where))
    return Fails("a rejection", repr(result), AtByte(offset))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "layouts-canonical",
        Clause.FILE_LAYOUT_1,
        "write (read bytes) is bytes, for every layout and whatever bytes it reads",
        RAW_BYTES,
        every_layout_canonical,
    ),
    Law(
        "sections-sealed",
        Clause.FILE_SECTION_1,
        "read (write section) is section, and sealing adds four bytes",
        RAW_BYTES,
        sealed_canonical,
    ),
    Law(
        "varint-shortest",
        Clause.FILE_NUMBER_3,
        "a varint has the fewest groups, and a longer form is refused",
        NUMBERS,
        varint_is_the_shortest,
    ),
    Law(
        "varint-bounded",
        Clause.FILE_NUMBER_3,
        "a varint of n bits takes the numbers below 2^n and no other",
        NUMBERS,
        varint_bounded,
    ),
    Law(
        "signed-numbers",
        Clause.FILE_NUMBER_4,
        "n and −n−1 are written as the varints 2n and 2n+1",
        NUMBERS,
        signed_both_ways,
    ),
    Law(
        "layouts-end-with-their-window",
        Clause.FILE_LAYOUT_2,
        "bytes left after the last value are refused",
        RAW_BYTES,
        nothing_may_follow,
    ),
    Law(
        "layouts-need-their-bytes",
        Clause.FILE_LAYOUT_3,
        "a value that lacks a byte is refused",
        RAW_BYTES,
        nothing_may_lack,
    ),
)
