"""Layouts: one declaration of some bytes, interpreted in both directions.

A layout is a value. `write` turns what it describes into bytes, `read` turns bytes back or says at
which byte they stop being such a layout. What is declared once cannot differ in two directions.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte

A = TypeVar("A")
B = TypeVar("B")
A_co = TypeVar("A_co", covariant=True)


@dataclass(frozen=True, slots=True)
class Window:
    """The bytes of a file from its beginning up to `stop`, read as the section named."""

    data: bytes
    stop: int
    section: str = ""

    def at(self, offset: int) -> AtByte:
        """The place of a byte."""
        return AtByte(offset, self.section)


@dataclass(frozen=True, slots=True)
class Read(Generic[A_co]):
    """A value, and the offset of the first byte after it."""

    value: A_co
    offset: int


@dataclass(frozen=True, slots=True)
class Layout(Generic[A]):
    """How values of one type stand in bytes. Clause: FILE-LAYOUT-1.

    `least` is the fewest bytes that a value takes: what a declared count must find left.
    """

    write: Callable[[A], bytes]
    read: Callable[[Window, int], Accepted[Read[A]] | Rejected]
    least: int


def write(layout: Layout[A], value: A) -> bytes:
    """The bytes of a value. Clause: FILE-LAYOUT-1."""
    return layout.write(value)


def read(layout: Layout[A], window: Window, start: int = 0) -> Accepted[A] | Rejected:
    """The value of which a window's bytes from `start` are the layout, all of them.

    Clauses: FILE-LAYOUT-1, FILE-LAYOUT-2.
    """
    match layout.read(window, start):
        case Accepted(Read(value, offset)):
            if offset == window.stop:
                return Accepted(value)
            detail = f"{window.stop - offset} bytes too many"
            clause = Clause.FILE_LAYOUT_2
            return Rejected(Reason.TRAILING_BYTES, clause, window.at(offset), detail)
        case Rejected() as rejected:
            return rejected


def truncated(window: Window, offset: int, needed: int) -> Rejected:
    """Fewer bytes are left than a value needs. Clause: FILE-LAYOUT-3."""
    detail = f"{needed} bytes needed, {window.stop - offset} left"
    return Rejected(Reason.TRUNCATED_FILE, Clause.FILE_LAYOUT_3, window.at(offset), detail)


def pair(first: Layout[A], second: Layout[B]) -> Layout[tuple[A, B]]:
    """One after the other. Clause: FILE-LAYOUT-4."""

    def write_both(value: tuple[A, B]) -> bytes:
        return first.write(value[0]) + second.write(value[1])

    def read_both(window: Window, offset: int) -> Accepted[Read[tuple[A, B]]] | Rejected:
        one = first.read(window, offset)
        if isinstance(one, Rejected):
            return one
        two = second.read(window, one.value.offset)
        if isinstance(two, Rejected):
            return two
        return Accepted(Read((one.value.value, two.value.value), two.value.offset))

    return Layout(write_both, read_both, first.least + second.least)


def times(count: int, item: Layout[A]) -> Layout[tuple[A, ...]]:
    """So many, one after another. Clauses: FILE-LAYOUT-4, FILE-COUNT-1."""

    def write_all(values: tuple[A, ...]) -> bytes:
        return b"".join(item.write(value) for value in values)

    def read_all(window: Window, offset: int) -> Accepted[Read[tuple[A, ...]]] | Rejected:
        if count * item.least > window.stop - offset:
            detail = f"{count} items of {item.least} bytes or more, {window.stop - offset} left"
            where = window.at(offset)
            return Rejected(Reason.IMPOSSIBLE_COUNT, Clause.FILE_COUNT_1, where, detail)
        values: list[A] = []
        for _ in range(count):
            got = item.read(window, offset)
            if isinstance(got, Rejected):
                return got
            values.append(got.value.value)
            offset = got.value.offset
        return Accepted(Read(tuple(values), offset))

    return Layout(write_all, read_all, count * item.least)


def dependent(first: Layout[A], rest: Callable[[A], Layout[B]]) -> Layout[tuple[A, B]]:
    """A value, and then a layout that depends on it. Clause: FILE-LAYOUT-4."""

    def write_both(value: tuple[A, B]) -> bytes:
        return first.write(value[0]) + rest(value[0]).write(value[1])

    def read_both(window: Window, offset: int) -> Accepted[Read[tuple[A, B]]] | Rejected:
        one = first.read(window, offset)
        if isinstance(one, Rejected):
            return one
        two = rest(one.value.value).read(window, one.value.offset)
        if isinstance(two, Rejected):
            return two
        return Accepted(Read((one.value.value, two.value.value), two.value.offset))

    return Layout(write_both, read_both, first.least)


def renamed(
    layout: Layout[A],
    build: Callable[[A], Accepted[B] | Rejected],
    take_apart: Callable[[B], A],
) -> Layout[B]:
    """Other values on the same bytes: built, perhaps refused, after reading.

    A refusal that blames no element is given the byte where the value starts.
    Clause: FILE-LAYOUT-4.
    """

    def write_parts(value: B) -> bytes:
        return layout.write(take_apart(value))

    def read_parts(window: Window, offset: int) -> Accepted[Read[B]] | Rejected:
        got = layout.read(window, offset)
        if isinstance(got, Rejected):
            return got
        match build(got.value.value):
            case Accepted(value):
                return Accepted(Read(value, got.value.offset))
            case Rejected(reason, clause, _, detail):
                return Rejected(reason, clause, window.at(offset), detail)

    return Layout(write_parts, read_parts, layout.least)
