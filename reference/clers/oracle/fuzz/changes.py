"""One change to a good input: mostly it makes it bad, and the reference says whether it does.

Each is a total function of the input and two numbers.
"""

from collections.abc import Callable
from typing import Final

import msgspec

from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.payloads import SAFE
from clers.edgebreaker.stream import SYMBOLS

Changed = Callable[[form.StreamForm, int, int], form.StreamForm]


def _word(stream: form.StreamForm, word: str) -> form.StreamForm:
    return msgspec.structs.replace(stream, word=word)


def _replaced(stream: form.StreamForm, i: int, j: int) -> form.StreamForm:
    at, symbol = i % max(len(stream.word), 1), (SYMBOLS + "P")[j % 6]
    return _word(stream, stream.word[:at] + symbol + stream.word[at + 1 :])


def _inserted(stream: form.StreamForm, i: int, j: int) -> form.StreamForm:
    at = i % (len(stream.word) + 1)
    return _word(stream, stream.word[:at] + SYMBOLS[j % 5] + stream.word[at:])


def _removed(stream: form.StreamForm, i: int, _: int) -> form.StreamForm:
    at = i % max(len(stream.word), 1)
    return _word(stream, stream.word[:at] + stream.word[at + 1 :])


def _swapped(stream: form.StreamForm, i: int, _: int) -> form.StreamForm:
    at, word = i % max(len(stream.word), 1), stream.word
    return _word(stream, word[:at] + word[at + 1 : at + 2] + word[at : at + 1] + word[at + 2 :])


def _counted(stream: form.StreamForm, i: int, _: int) -> form.StreamForm:
    count = from_wire(stream.components_with_boundary) + (1, -1)[i % 2]
    return msgspec.structs.replace(stream, components_with_boundary=to_wire(count))


def _with_records(stream: form.StreamForm, records: tuple[form.HandleForm, ...]) -> form.StreamForm:
    return msgspec.structs.replace(stream, handles=records)


def _record_added(stream: form.StreamForm, i: int, j: int) -> form.StreamForm:
    record = form.HandleForm(
        kind=("handle", "boundary")[i % 2],
        s=j % (stream.word.count("S") + 1),
        at=j // 7 % (len(stream.word) + 1),
        side=("right", "left")[i // 2 % 2],
    )
    at = i // 4 % (len(stream.handles) + 1)
    return _with_records(stream, (*stream.handles[:at], record, *stream.handles[at:]))


def _record_removed(stream: form.StreamForm, i: int, _: int) -> form.StreamForm:
    at = i % max(len(stream.handles), 1)
    return _with_records(stream, stream.handles[:at] + stream.handles[at + 1 :])


def _record_changed(stream: form.StreamForm, i: int, j: int) -> form.StreamForm:
    if not stream.handles:
        return stream
    at = i % len(stream.handles)
    old = stream.handles[at]
    step = (1, -1, 2, -2, SAFE + 1)[j // 4 % 5]
    match j % 4:
        case 0:
            new = msgspec.structs.replace(old, s=to_wire(from_wire(old.s) + step))
        case 1:
            new = msgspec.structs.replace(old, at=to_wire(from_wire(old.at) + step))
        case 2:
            new = msgspec.structs.replace(old, side="left" if old.side == "right" else "right")
        case _:
            turned = "handle" if old.kind == "boundary" else "boundary"
            new = msgspec.structs.replace(old, kind=turned)
    return _with_records(stream, (*stream.handles[:at], new, *stream.handles[at + 1 :]))


STREAM_CHANGES: Final[tuple[Changed, ...]] = (
    _replaced,
    _inserted,
    _removed,
    _swapped,
    _counted,
    _record_added,
    _record_removed,
    _record_changed,
    _record_changed,
)
"""What may be changed in a word and its handle data. Clause: ORCL-FUZZ-1."""


def bits_changed(bits: form.BitString, i: int, j: int) -> form.BitString:
    """A bit turned, the last one taken away, or one more. Clause: ORCL-FUZZ-1."""
    digits = digits_of(bits)
    at = i % max(len(digits), 1)
    match j % 4:
        case 0:
            return bits_of_digits(digits[:-1])
        case 1:
            return bits_of_digits(digits + "01"[i % 2])
        case 2:
            return bits_of_digits(digits[:at] + digits[at + 1 :])
        case _:
            turned = "1" if digits[at : at + 1] == "0" else "0"
            return bits_of_digits(digits[:at] + turned + digits[at + 1 :])


def digits_of(bits: form.BitString) -> str:
    """The bits as a string of 0 and 1."""
    return bin(int("1" + bits.hex, 16))[3:][: bits.length] if bits.hex else ""


def bits_of_digits(digits: str) -> form.BitString:
    """A string of 0 and 1 as a message has it. Clauses: ORCL-VALUE-2, ARITH-BITS-2."""
    whole = digits + "0" * (-len(digits) % 8)
    data = bytes(int(whole[k : k + 8], 2) for k in range(0, len(whole), 8))
    return form.BitString(hex=data.hex(), length=len(digits))


def text_changed(text: str, i: int, j: int) -> str:
    """One character of a script taken away, doubled, or made another. Clause: ORCL-FUZZ-1."""
    at = i % max(len(text), 1)
    new = ("", text[at : at + 1] * 2, "-", "9", "x", ";", " ")[j % 7]
    return text[:at] + new + text[at + 1 :]
