"""Layouts of numbers: fixed width, variable length in shortest form, one of a list."""

from collections.abc import Sequence
from enum import Enum
from typing import TypeVar

from clers.container.layout import Layout, Read, Window, renamed, truncated
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected

E = TypeVar("E", bound=Enum)


def raw(size: int) -> Layout[bytes]:
    """So many bytes as they are. Clause: FILE-NUMBER-1."""

    def read(window: Window, offset: int) -> Accepted[Read[bytes]] | Rejected:
        if window.stop - offset < size:
            return truncated(window, offset, size)
        return Accepted(Read(window.data[offset : offset + size], offset + size))

    return Layout(lambda value: value, read, size)


def _read_rest(window: Window, offset: int) -> Accepted[Read[bytes]] | Rejected:
    return Accepted(Read(window.data[offset : window.stop], window.stop))


REST: Layout[bytes] = Layout(lambda value: value, _read_rest, 0)
"""All bytes that are left in the section. Clause: FILE-NUMBER-1."""


def unsigned(size: int) -> Layout[int]:
    """A number of so many bytes, the lowest byte first. Clause: FILE-NUMBER-2."""
    return renamed(
        raw(size),
        lambda data: Accepted(int.from_bytes(data, "little")),
        lambda value: value.to_bytes(size, "little"),
    )


U8 = unsigned(1)
U32 = unsigned(4)


def varint(bits: int) -> Layout[int]:
    """A number below 2^bits, seven bits a byte, in the shortest form. Clause: FILE-NUMBER-3."""

    def write(value: int) -> bytes:
        out = bytearray()
        while value > 0x7F:
            out.append(value & 0x7F | 0x80)
            value >>= 7
        out.append(value)
        return bytes(out)

    def read(window: Window, offset: int) -> Accepted[Read[int]] | Rejected:
        value, shift, at = 0, 0, offset
        while True:
            if at == window.stop:
                return truncated(window, at, 1)
            byte = window.data[at]
            value |= (byte & 0x7F) << shift
            at += 1
            shift += 7
            if byte < 0x80:
                break
            if shift >= bits:
                return _bad(window, offset, f"more than {bits} bits")
        if byte == 0 and at > offset + 1:
            return _bad(window, offset, "not in its shortest form")
        if value >> bits:
            return _bad(window, offset, f"{value} has more than {bits} bits")
        return Accepted(Read(value, at))

    return Layout(write, read, 1)


def signed(bits: int) -> Layout[int]:
    """A number from −2^(bits−1) to 2^(bits−1) − 1, folded. Clause: FILE-NUMBER-4."""
    return renamed(
        varint(bits),
        lambda z: Accepted(-(z + 1) // 2 if z % 2 else z // 2),
        lambda n: 2 * n if n >= 0 else -2 * n - 1,
    )


def one_of(members: Sequence[E]) -> Layout[E]:
    """A byte that names a member by its place in the list, from 1. Clause: FILE-NUMBER-5."""

    def build(byte: int) -> Accepted[E] | Rejected:
        if 1 <= byte <= len(members):
            return Accepted(members[byte - 1])
        names = ", ".join(str(member.value) for member in members)
        detail = f"number {byte}; known are {names}, from 1"
        return Rejected(Reason.UNKNOWN_CODE, Clause.FILE_NUMBER_5, detail=detail)

    return renamed(U8, build, lambda member: members.index(member) + 1)


def _bad(window: Window, offset: int, detail: str) -> Rejected:
    """Clauses: FILE-NUMBER-3, FILE-NUMBER-4."""
    return Rejected(Reason.BAD_NUMBER, Clause.FILE_NUMBER_3, window.at(offset), detail)
