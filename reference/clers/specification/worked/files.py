"""Tables of files: every byte with its offset."""

from collections.abc import Iterator

from clers.codes.registry import CodeName
from clers.container.file import encode
from clers.container.options import Options
from clers.conventions.result import Accepted
from clers.specification.worked.bits import CODE_NAMES
from clers.specification.worked.table import Fault, Meshes, Worked


def file(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The file of a mesh without positions in a code. Clauses: FILE-LAYOUT-4, FILE-SECTION-1."""
    name = table.words[1] if len(table.words) > 1 else ""
    if name not in CODE_NAMES:
        yield table.line, f"there is no code {name!r}"
        return
    made = encode(meshes[table.words[0]], None, Options(CodeName(name)))
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
