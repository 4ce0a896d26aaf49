"""Files spoilt in ways that reach every part of a reader: most of them sealed again afterwards.

A file that is merely damaged fails at its first seal. To test what lies behind the seals, payloads
are changed and then sealed as if they were right.
"""

from collections.abc import Callable, Sequence
from random import Random
from typing import Final

from clers.arithmetic.bits import pack
from clers.codes.closings import closings
from clers.codes.closings_definition import SIDES
from clers.codes.handle_data import encode as encode_handles
from clers.codes.registry import CodeName
from clers.codes.registry import encode as encode_word
from clers.container.contents import MAGIC
from clers.container.head import HEAD, Head, PositionCoding
from clers.container.layout import Window, read, write
from clers.container.numbers import varint
from clers.container.places import BITS
from clers.container.section import SECTION, sections
from clers.conventions.result import Accepted, and_then
from clers.edgebreaker.stream import SYMBOLS, Kind, Record, Stream

Part = tuple[bytes, bytes]
"""The tag and the payload of a section."""

PROLOGUE: Final = len(MAGIC) + 1

COUNTS: Final = (0, 1, 2, 3, 4, 127, 128, 1 << 16, (1 << 26) - 1, 1 << 26, (1 << 32) - 1)
"""Sizes that an enemy would declare."""


def parts_of(data: bytes) -> list[Part]:
    """The sections of a sound file."""
    found = sections(data, PROLOGUE)
    assert isinstance(found, Accepted), found
    return [(s.tag.encode("ascii"), data[s.start : s.stop]) for s in found.value]


def joined(prologue: bytes, parts: Sequence[Part]) -> bytes:
    """A file of these sections, each sealed, whatever is in them."""
    sealed = (write(SECTION, ((tag, len(payload)), payload)) for tag, payload in parts)
    return prologue + b"".join(sealed)


def _spoilt(payload: bytes, random: Random) -> bytes:
    """A few bytes changed, put in, taken out or repeated."""
    out = bytearray(payload)
    for _ in range(random.choice((1, 1, 1, 2, 3, 8))):
        at = random.randrange(len(out) + 1)
        match random.randrange(6):
            case 0 | 1 if at < len(out):
                out[at] ^= 1 << random.randrange(8)
            case 2 if at < len(out):
                out[at] = random.choice((0, 1, 0x7F, 0x80, 0xFF, random.randrange(256)))
            case 3:
                out[at:at] = random.randbytes(random.choice((1, 1, 2, 9)))
            case 4:
                del out[at : at + random.choice((1, 1, 2, 9))]
            case _:
                out[at:at] = out[at : at + random.choice((1, 4, 16))]
    return bytes(out)


def damaged(data: bytes, random: Random) -> bytes:
    """Bytes of the file changed, and not sealed again."""
    return _spoilt(data, random)


def spoilt(data: bytes, random: Random) -> bytes:
    """One payload changed, sealed again."""
    parts = parts_of(data)
    i = random.randrange(len(parts))
    parts[i] = (parts[i][0], _spoilt(parts[i][1], random))
    return joined(data[:PROLOGUE], parts)


def miscounted(data: bytes, random: Random) -> bytes:
    """One field of HEAD replaced, sealed again."""
    parts = parts_of(data)
    out = bytearray(parts[0][1][:2])
    fields = list(_fields(parts[0][1]))
    field = random.randrange(7)
    if field < 2:
        out[field] = random.choice((0, 1, 2, 3, 4, 5, 255))
    else:
        near = fields[field - 2] + random.choice((-1, 1, 2, -2))
        fields[field - 2] = max(0, random.choice((*COUNTS, near, near, near)))
    out += b"".join(write(varint(64), value) for value in fields)
    parts[0] = (parts[0][0], bytes(out))
    return joined(data[:PROLOGUE], parts)


def _fields(payload: bytes) -> tuple[int, ...]:
    """The five counts of a sound HEAD."""
    found = read(HEAD, Window(payload, len(payload)))
    assert isinstance(found, Accepted), found
    head = found.value
    return (head.faces, head.vertices, head.components_with_boundary, head.symbols, head.records)


def rearranged(data: bytes, random: Random) -> bytes:
    """A section dropped, doubled, renamed, or two of them swapped."""
    parts = parts_of(data)
    i, j = random.randrange(len(parts)), random.randrange(len(parts))
    match random.randrange(4):
        case 0:
            del parts[i]
        case 1:
            parts.insert(j, parts[i])
        case 2:
            parts[i], parts[j] = parts[j], parts[i]
        case _:
            tag = random.choice((b"HEAD", b"HAND", b"WORD", b"POSN", b"TEXT", b"head", b"\0\0\0\0"))
            parts[i] = (tag, parts[i][1])
    return joined(data[:PROLOGUE], parts)


def resized(data: bytes, random: Random) -> bytes:
    """Cut short, or gone on."""
    if random.randrange(2):
        return data[: random.randrange(len(data))]
    return data + random.randbytes(random.choice((1, 4, 16, 40)))


def grammatical(data: bytes, random: Random) -> bytes:
    """Another word and other handle data, in the right code and with the right counts of them.

    The word is random or the file's own with a change; either way the bits are good.
    """
    size = random.choice((1, 3, 5, 7, 9, 12, 16, 24))
    word = "C" * random.randrange(2) + "".join(random.choices(SYMBOLS, (9, 2, 3, 5, 3), k=size))
    edges = [(i, side) for i, symbol in enumerate(word) for side in SIDES[symbol]]
    records: tuple[Record, ...] = ()
    for s, i in enumerate(i for i, symbol in enumerate(word) if symbol == "S"):
        after = [edge for edge in edges if edge[0] > i]
        if after and random.randrange(2):
            closer, side = random.choice(after)
            at = sum(word[:closer].count(x) for x in "RLE")
            records += (Record(random.choice(tuple(Kind)), s, at, side),)
    code = random.choice(tuple(CodeName))
    components = random.choice((0, 0, 1, 1, 2))
    stream = Stream(word, records, components)
    bits = encode_word(code, stream)
    handles = and_then(closings(stream), lambda seen: encode_handles(seen, len(word)))
    if not isinstance(bits, Accepted) or not isinstance(handles, Accepted):
        return data
    faces = len(word) + random.randrange(2)
    head = Head(
        code, PositionCoding.NONE, faces, faces // 2 + 2, components, len(word), len(records)
    )
    hand = [(b"HAND", write(BITS, handles.value))] if records else []
    parts = [(b"HEAD", write(HEAD, head)), *hand, (b"WORD", write(BITS, bits.value))]
    return joined(data[:PROLOGUE], parts)


def noisy(data: bytes, random: Random) -> bytes:
    """Random bits for the word or the positions, sealed; or random bytes for everything."""
    parts = parts_of(data)
    i = random.randrange(len(parts) + 1)
    if i == len(parts):
        return data[: random.choice((0, PROLOGUE))] + random.randbytes(random.randrange(80))
    tag = parts[i][0]
    count = random.randrange(200)
    bits = pack(random.randrange(2) for _ in range(count))
    payload = write(BITS, bits) if tag in (b"HAND", b"WORD") else random.randbytes(len(parts[i][1]))
    parts[i] = (tag, payload)
    return joined(data[:PROLOGUE], parts)


def untouched(data: bytes, random: Random) -> bytes:
    """The file itself."""
    del random
    return data


TAMPERINGS: Final[tuple[Callable[[bytes, Random], bytes], ...]] = (
    untouched,
    damaged,
    spoilt,
    spoilt,
    spoilt,
    miscounted,
    rearranged,
    resized,
    grammatical,
    grammatical,
    noisy,
)


def tampered(pool: Sequence[bytes], random: Random) -> tuple[str, bytes]:
    """One of the files, tampered with in one way; the way's name first."""
    way = random.choice(TAMPERINGS)
    return way.__name__, way(random.choice(pool), random)
