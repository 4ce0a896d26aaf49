"""Tables of files: every byte with its offset."""

from collections.abc import Iterator

from clers.codes.registry import CodeName
from clers.container.file import encode
from clers.container.options import Exact, InBits, Options
from clers.conventions.result import Accepted
from clers.specification.worked.bits import CODE_NAMES
from clers.specification.worked.table import Fault, Meshes, Worked


def file(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The file of a mesh in a code, with positions if their bits are said.

    Clauses: FILE-LAYOUT-4, FILE-SECTION-1, FILE-POSN-2.
    """
    name, *bits = table.words[1:] or ("",)
    if name not in CODE_NAMES or not all(word.isdecimal() for word in bits):
        yield table.line, f"a file needs a code, then perhaps a number of bits, not {name!r}"
        return
    mesh = meshes[table.words[0]]
    accuracy = InBits(int(bits[0])) if bits else Exact()
    positions = mesh.positions if bits else None
    made = encode(mesh.surface, positions, Options(CodeName(name), accuracy))
    if not isinstance(made, Accepted):
        yield table.line, made.line()
        return
    at = 0
    for line, row in table.rows:
        try:
            told = bytes.fromhex(row.get("bytes", ""))
        except ValueError:
            yield line, "the column bytes has no hexadecimal digits, two a byte"
            return
        if row.get("offset") != str(at):
            yield line, f"offset: expected {at}, got {row.get('offset')}"
        if made.value[at : at + len(told)] != told:
            has = made.value[at : at + len(told)].hex(" ").upper()
            yield line, f"bytes: expected {has}, got {told.hex(' ').upper()}"
        at += len(told)
    if at != len(made.value):
        yield table.line, f"the file has {len(made.value)} bytes, the table {at}"
