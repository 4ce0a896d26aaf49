"""Tables of codewords, and of the handle data as it is seen from the end of the word."""

from collections.abc import Iterator
from typing import Final

from clers.codes.closings import closings as closings_of
from clers.codes.implied import coded_part
from clers.codes.registry import CodeName
from clers.codes.registry import encode as encode_word
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.specification.worked.table import NONE, Fault, Meshes, Worked, compared

CODE_NAMES: Final = frozenset(CodeName)


def closings(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The handle data from the end. Clause: CODE-HAND-1."""
    match closings_of(encode(meshes[table.words[0]].surface).stream):
        case Accepted(found):
            rows = [
                {
                    "passed": str(closing.passed),
                    "kind": closing.kind.value,
                    "side": closing.side.value,
                    "between": str(closing.between),
                }
                for closing in found
            ]
            yield from compared(table, rows)
        case rejected:
            yield table.line, rejected.line()


def codewords(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Codewords that follow one another, each with its symbol or what else it says.

    Clauses: CODE-PLAIN-1, CODE-KR-1, CODE-KR-2.
    """
    name = table.words[1] if len(table.words) > 1 else ""
    if name not in CODE_NAMES:
        yield table.line, f"there is no code {name!r}"
        return
    stream = encode(meshes[table.words[0]].surface).stream
    match encode_word(CodeName(name), stream), coded_part(stream):
        case Accepted(bits), Accepted(word):
            written = "".join(table.column("bits"))
            if written != bits.digits():
                yield table.line, f"the bits are {bits.digits()}, the column has {written}"
            symbols = "".join(cell for cell in table.column("symbol") if len(cell) == 1)
            if symbols != word:
                yield table.line, f"the coded symbols are {word}, the column has {symbols}"
        case refused:
            yield table.line, f"{name} refuses this word: {refused}"


def every_code(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The word in every code, or why not. Clauses: CODE-NAME-1, CODE-NAME-5."""
    stream = encode(meshes[table.words[0]].surface).stream
    rows: list[dict[str, str]] = []
    for name in CodeName:
        match encode_word(name, stream):
            case Accepted(bits):
                rows.append(
                    {"code": name, "bits": bits.digits() or NONE, "length": str(bits.length)}
                )
            case refused:
                rows.append({"code": name, "bits": refused.reason, "length": NONE})
    yield from compared(table, rows)
