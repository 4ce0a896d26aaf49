"""The body of a PLY file, row by row, or its first fault. Clause: TOOL-PLY-1."""

from collections.abc import Iterator
from dataclasses import dataclass
from struct import calcsize, unpack_from
from typing import Final

from clers.conventions.result import Rejected
from clers.conventions.where import AtByte
from clers.meshfile.faults import bad_line, ends_early, unreadable
from clers.meshfile.numeral import integer, real, singles
from clers.meshfile.ply_header import INTEGERS, Element, Header


@dataclass(frozen=True, slots=True)
class Row:
    """Row number `index` of an element, with the values of each property: of a scalar, one."""

    element: Element
    index: int
    values: tuple[tuple[float, ...], ...]


def rows(data: bytes, head: Header) -> Iterator[Row | Rejected]:
    """All rows in the file's order; a rejection is the last. Clauses: TOOL-PLY-1, TOOL-READ-5."""
    return _binary(data, head) if head.order else _text(data, head)


def _binary(data: bytes, head: Header) -> Iterator[Row | Rejected]:
    """One after another, without padding."""
    at = head.end
    for element in head.elements:
        for index in range(element.rows):
            values: list[tuple[float, ...]] = []
            for known in element.properties:
                length = 1
                if known.count:
                    if len(data) - at < calcsize(known.count):
                        yield ends_early(len(data), f"within {element.name} {index}")
                        return
                    (length,) = unpack_from(head.order + known.count, data, at)
                    at += calcsize(known.count)
                    if length < 0:
                        yield unreadable(f"a list of length {length}", AtByte(at))
                        return
                size = length * calcsize(known.code)
                if len(data) - at < size:
                    yield ends_early(len(data), f"within {element.name} {index}")
                    return
                values.append(unpack_from(f"{head.order}{length}{known.code}", data, at))
                at += size
            yield Row(element, index, tuple(values))
    if at < len(data):
        yield unreadable(f"{len(data) - at} bytes after the last element", AtByte(at))


def _text(data: bytes, head: Header) -> Iterator[Row | Rejected]:
    """One on a line."""
    lines = enumerate(data[head.end :].splitlines(), start=head.lines + 1)
    said = ((line, words) for line, text in lines if (words := text.split()))
    for element in head.elements:
        for index in range(element.rows):
            line, words = next(said, (0, []))
            if not words:
                yield unreadable(f"{index} of {element.rows} elements {element.name}")
                return
            values = _row(element, words)
            if values is None:
                yield bad_line(line, f"no {element.name} {index}")
                return
            yield Row(element, index, values)
    line, words = next(said, (0, []))
    if words:
        yield bad_line(line, "after the last element")


def _row(element: Element, words: list[bytes]) -> tuple[tuple[float, ...], ...] | None:
    """The values of the words of a line, if they are just those of one element."""
    row: list[tuple[float, ...]] = []
    at = 0
    for known in element.properties:
        length: float | None = 1
        if known.count:
            length = _value(known.count, words[at]) if at < len(words) else None
            at += 1
        if length is None or not 0 <= length <= len(words) - at:
            return None
        values = [_value(known.code, word) for word in words[at : at + int(length)]]
        found = tuple(value for value in values if value is not None)
        if len(found) != len(values):
            return None
        row.append(found)
        at += len(values)
    return tuple(row) if at == len(words) else None


def _value(code: str, word: bytes) -> float | None:
    """What a word means as a value of a type; None if it is none. Clause: TOOL-READ-7."""
    if code in INTEGERS:
        number = integer(word)
        low, high = _RANGES[code]
        return number if number is not None and low <= number <= high else None
    value = real(word)
    return singles([value])[0] if code == "f" and value is not None else value


def _range(code: str) -> tuple[int, int]:
    bits = 8 * calcsize("<" + code)
    return (-(1 << bits - 1), (1 << bits - 1) - 1) if code.islower() else (0, (1 << bits) - 1)


_RANGES: Final = {code: _range(code) for code in INTEGERS}
