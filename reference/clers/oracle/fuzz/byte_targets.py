"""Every decoder of bytes or text, as a function that a fuzzer can drive.

A target answers with what is wrong, in words, or None. What it may not do is raise. Where a decoder
accepts, what it accepts is written again and must be what was read. Clause: CONV-RESULT-1.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from clers.arithmetic import coder, range_coder, rans
from clers.arithmetic.bits import Bits, pack, packed
from clers.codes import handle_data
from clers.codes.closings import Closing
from clers.codes.code import Shape
from clers.codes.registry import CODES, CodeName
from clers.complexes.complex_text import read_complex, write_complex
from clers.complexes.face_list import Limits
from clers.complexes.structures.arrays import (
    read_corner_table,
    read_half_edges,
    write_corner_table,
    write_half_edges,
)
from clers.conformance.adapter import answered
from clers.conformance.lines import NoMessage, object_in, reply_in, request_in, result_in
from clers.conformance.messages import Bye
from clers.conformance.samples import SAMPLES
from clers.conformance.serve import serve
from clers.conformance.session import asked
from clers.container.contents import MAGIC
from clers.container.laws_file import file_again
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.corpus.npm_module import parse as read_module
from clers.edgebreaker.decode import decode as decode_stream
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.generate.files import pool
from clers.generate.tamper import joined, parts_of
from clers.information.static import static
from clers.meshfile.formats import Format
from clers.meshfile.reading import parse
from clers.operators.families import read as read_script
from clers.oracle.finding import parse as read_finding
from clers.specification.markdown import page
from clers.specification.theorems import theorems

SMALL: Final = Limits(faces=1 << 12, vertices=1 << 12)
PROLOGUE: Final = MAGIC + b"\x01"
TAGS: Final = (b"HEAD", b"HAND", b"WORD", b"POSN")
NAMES: Final = tuple(CodeName)
CODERS: Final = (
    (coder.encode, coder.decode),
    (range_coder.encode, range_coder.decode),
    (rans.encode, rans.decode),
)
FORMATS: Final = tuple(Format)


@dataclass(frozen=True, slots=True)
class Target:
    """A decoder: what it reads, how bytes are tried on it, and good input to begin with."""

    reads: str
    tried: Callable[[bytes], str | None]
    seeds: Callable[[], Iterable[bytes]]


def _file(data: bytes) -> str | None:
    verdict = file_again(data)
    return None if not isinstance(verdict, Fails) else f"accepted, written {verdict.got[:80]}"


def _sealed(data: bytes) -> str | None:
    """Sections with good seals around bytes of any origin: two bytes of length before each."""
    parts: list[tuple[bytes, bytes]] = []
    at = 1
    for k, tag in enumerate(TAGS):
        if data[:1] and data[0] >> k & 1:
            size = int.from_bytes(data[at : at + 2], "big")
            parts.append((tag, data[at + 2 : at + 2 + size]))
            at += 2 + size
    return _file(joined(PROLOGUE, parts))


def _in_parts(file: bytes) -> bytes:
    """A sound file as `_sealed` reads it."""
    parts = dict(parts_of(file))
    flags = sum(1 << k for k, tag in enumerate(TAGS) if tag in parts)
    some = (parts[tag] for tag in TAGS if tag in parts)
    return bytes([flags]) + b"".join(len(p).to_bytes(2, "big") + p for p in some)


def _bits(data: bytes) -> Bits:
    """The first byte says how many bits of the last byte are left out."""
    found = b"".join(f"{byte:08b}".encode() for byte in data[1:])
    kept = found[: max(0, len(found) - (data[0] & 7 if data else 0))]
    return pack(byte & 1 for byte in kept)


def _closings(data: bytes) -> tuple[Closing, ...]:
    return tuple(
        Closing(
            a & 15,
            Kind.HANDLE if a & 16 else Kind.BOUNDARY,
            Side.LEFT if a & 32 else Side.RIGHT,
            b,
        )
        for a, b in zip(data[::2], data[1::2], strict=False)
    )


def _word(data: bytes) -> str | None:
    """Byte 0: the code; 1: what is implied; 2: symbols; 3: twice the records; these; the bits."""
    if len(data) < 5:
        return None
    code, many = CODES[NAMES[data[0] % len(NAMES)]], data[3] & 6
    shape = Shape(("", "C")[data[1] & 1], _closings(data[4 : 4 + many]))
    bits = _bits(data[4 + many :])
    match code.decode(bits, data[2], shape):
        case Accepted(word):
            again = code.encode(word, shape)
            return None if again == Accepted(bits) else f"{word} is written {again}"
        case Rejected():
            return None


def _handles(data: bytes) -> str | None:
    if len(data) < 3:
        return None
    count, symbols, bits = data[0] & 31, data[1] + 1, _bits(data[2:])
    match handle_data.decode(bits, count, symbols):
        case Accepted(seen):
            again = handle_data.encode(seen, symbols)
            return None if again == Accepted(bits) else f"{seen} is written {again}"
        case Rejected():
            return None


def _message(data: bytes) -> str | None:
    """Byte 0: which coder; 1: symbols asked for; 2: size of the table; the table; the bits."""
    if len(data) < 4:
        return None
    (encode, decode), size = CODERS[data[0] % len(CODERS)], data[2] & 7
    model = static([byte * byte for byte in data[3 : 3 + size]])
    if isinstance(model, Rejected):
        return None
    bits = _bits(data[3 + size :])
    match decode(model.value, bits, data[1]):
        case Accepted(symbols):
            again = encode(model.value, symbols)
            return None if again == Accepted(bits) else f"{symbols} is written {again}"
        case Rejected():
            return None


def _stream(data: bytes) -> str | None:
    """Byte 0: components with boundary; 1: records of three bytes each; these; the symbols."""
    if len(data) < 3:
        return None
    many = data[1] & 7
    rows = [data[2 + 3 * r : 5 + 3 * r] for r in range(many)]
    records = tuple(
        Record(
            Kind.HANDLE if row[0] & 1 else Kind.BOUNDARY,
            row[1],
            row[2],
            Side.LEFT if row[0] & 2 else Side.RIGHT,
        )
        for row in rows
        if len(row) == 3
    )
    word = "".join("CLERS?"[min(byte % 8, 5)] for byte in data[2 + 3 * many :])
    stream = Stream(word, records, data[0] & 3)
    match decode_stream(stream, SMALL):
        case Accepted(surface):
            again = encode_surface(surface).stream
            return None if again == stream else f"{stream} is written {again}"
        case Rejected():
            return None


def _line(data: bytes) -> str | None:
    """A line of the protocol, as a reply that is read and as a request that is served.

    An adapter says what its code raises and goes on; here it is raised.
    """
    reply_in(data)
    keys = object_in(data)
    if isinstance(keys, dict) and "ok" in keys:
        for operation in ("hello", "echo", "mesh.decode", "arithmetic.decode", "word.decode"):
            result_in(operation, keys["ok"])
    match request_in(data):
        case NoMessage() | Bye():
            answered(data)
        case request:
            serve(request)
    return None


def _mesh(data: bytes) -> str | None:
    if data:
        parse(FORMATS[data[0] % len(FORMATS)], data[1:], SMALL)
    return None


def _text(data: bytes) -> str | None:
    text = data.decode("utf-8", "replace")
    read_script(text)
    match read_complex(text):
        case Accepted(k):
            again = read_complex(write_complex(k))
            return None if again == Accepted(k) else f"{text!r} is another complex when written"
        case Rejected():
            return None


def _arrays(data: bytes) -> str | None:
    """Half-edges and corner tables as JSON; what is accepted is read again when written."""
    edges, table = read_half_edges(data), read_corner_table(data)
    if isinstance(edges, Accepted) and read_half_edges(write_half_edges(edges.value)) != edges:
        return "other half-edges when written"
    if isinstance(table, Accepted) and read_corner_table(write_corner_table(table.value)) != table:
        return "another corner table when written"
    return None


def _note(data: bytes) -> str | None:
    tuple(theorems(page("proofs_notes/a.md", data.decode("utf-8", "replace"))))
    return None


def _stored(data: bytes) -> str | None:
    """A finding as a file has it, and a JavaScript module of a mesh."""
    read_module(data)
    read_finding(data)
    return None


def _declared(data: bytes) -> str | None:
    if data:
        packed(data[1:], 8 * len(data) - data[0])
    return None


def _files() -> Iterable[bytes]:
    return pool(0, 20)


def _lines() -> Iterable[bytes]:
    for operation in SAMPLES.values():
        yield asked(1, operation).line
    yield b'{"id":4,"ok":{"value":1}}'
    yield b'{"id":4,"reject":{"reason":"truncated-bits","clause":"ARITH-STRICT-2"}}'


def _meshes() -> Iterable[bytes]:
    yield (
        b"\x00ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    )
    yield b"\x01OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    yield b"\x02v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    yield b"\x03" + bytes(80) + (1).to_bytes(4, "little") + bytes(50)


TARGETS: Final[Mapping[str, Target]] = {
    "file": Target("files as they are", _file, _files),
    "sealed": Target("files sealed anew", _sealed, lambda: map(_in_parts, _files())),
    "word": Target(
        "bits of words", _word, lambda: (bytes([k, 1, 4, 0, 0, 0x5A, 0xC3]) for k in range(12))
    ),
    "handles": Target("bits of handle data", _handles, lambda: (b"\x01\x10\x00\x5a\xa5",)),
    "message": Target(
        "bits of messages", _message, lambda: (bytes([k, 5, 3, 1, 2, 1, 0, 90]) for k in range(3))
    ),
    "stream": Target(
        "words and handle data", _stream, lambda: (b"\0\0\0\4\2", b"\0\0\0\0\0\4\0\4\4\0\4\4\2")
    ),
    "line": Target("lines of the protocol", _line, _lines),
    "mesh": Target("mesh files", _mesh, _meshes),
    "stored": Target(
        "findings, modules of meshes",
        _stored,
        lambda: (
            b"exports.positions = [[0,0,0],[1,0,0],[0,1,0]]\nexports.cells = [[0,1,2]]",
            b'{"request":"","name":"a"}',
        ),
    ),
    "text": Target(
        "scripts and complexes as text", _text, lambda: (b"attach 0; complete 1", b"0 1 2\n1 2 3\n")
    ),
    "arrays": Target(
        "half-edges and corner tables as JSON",
        _arrays,
        lambda: (
            b'{"vertex":[0,1,2],"opposite":[-1,-1,-1],"vertices":3}',
            b'{"next":[1,2,0],"previous":[2,0,1],"twin":[3,4,5],"origin":[0,1,2],"face":[0,0,0],'
            b'"of_vertex":[0,1,2],"of_face":[0]}',
        ),
    ),
    "note": Target("heads of proof notes", _note, lambda: (b"# A\n- **Theorem.** `a`\n",)),
    "declared": Target(
        "bits with a declared number", _declared, lambda: (b"\x08\xff", b"\x0b\xf0")
    ),
}
"""Every decoder of bytes or text, by name."""
