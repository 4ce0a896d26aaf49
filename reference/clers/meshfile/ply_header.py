"""The header of a PLY file: what its elements are called and made of. Clause: TOOL-PLY-1."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.result import Rejected
from clers.meshfile.faults import bad_line, unreadable
from clers.meshfile.numeral import integer

TYPES: Final = {
    name: code
    for names, code in (
        (("char", "int8"), "b"),
        (("uchar", "uint8"), "B"),
        (("short", "int16"), "h"),
        (("ushort", "uint16"), "H"),
        (("int", "int32"), "i"),
        (("uint", "uint32"), "I"),
        (("float", "float32"), "f"),
        (("double", "float64"), "d"),
    )
    for name in names
}
"""The scalar types, by both their names, as the codes of `struct`."""

INTEGERS: Final = "bBhHiI"
WITHIN_BINARY32: Final = "bBhHf"

_ORDERS: Final = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True, slots=True)
class Property:
    """A scalar of type `code`, or a list of them if `count` is the type of a list's length."""

    name: str
    code: str
    count: str = ""


@dataclass(frozen=True, slots=True)
class Element:
    """A name, how many rows there are of it, and what is in a row."""

    name: str
    rows: int
    properties: tuple[Property, ...]

    def place(self, name: str) -> int | None:
        """Which property has this name."""
        names = [known.name for known in self.properties]
        return names.index(name) if name in names else None


@dataclass(frozen=True, slots=True)
class Header:
    """`order` is empty for ASCII, else how `struct` writes the byte order.

    The body begins at byte `end`, and at line `lines` + 1.
    """

    order: str
    elements: tuple[Element, ...]
    end: int
    lines: int


def header(data: bytes) -> Header | Rejected:
    """The header, or the first line of it that is none. Clause: TOOL-PLY-1."""
    newline = next((n for n in (b"\r\n", b"\n", b"\r") if data.startswith(b"ply" + n)), None)
    if newline is None:
        return unreadable("no PLY header")
    order: str | None = None
    elements: list[Element] = []
    at, line = len(b"ply" + newline), 1
    while (stop := data.find(newline, at)) >= 0:
        words = data[at:stop].decode("latin-1").split()
        at, line = stop + len(newline), line + 1
        match words:
            case ["comment" | "obj_info", *_]:
                pass
            case ["format", kind, "1.0"] if kind in _ORDERS and order is None:
                order = _ORDERS[kind]
            case ["element", name, rows] if name not in [known.name for known in elements]:
                count = integer(rows.encode("latin-1"))
                if count is None or count < 0:
                    return bad_line(line, f"no number of elements {name}")
                elements.append(Element(name, count, ()))
            case ["property", *rest] if elements and (found := _property(rest)) is not None:
                last = elements[-1]
                if last.place(found.name) is not None:
                    return bad_line(line, f"second property {found.name}")
                elements[-1] = Element(last.name, last.rows, (*last.properties, found))
            case ["end_header"] if order is not None:
                return Header(order, tuple(elements), at, line)
            case _:
                return bad_line(line, "no line of a PLY header")
    return unreadable("the header does not end")


def _property(words: list[str]) -> Property | None:
    match words:
        case ["list", count, kind, name] if count in TYPES and kind in TYPES:
            return Property(name, TYPES[kind], TYPES[count]) if TYPES[count] in INTEGERS else None
        case [kind, name] if kind in TYPES:
            return Property(name, TYPES[kind])
        case _:
            return None
