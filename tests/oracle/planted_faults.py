"""The reference with one planted fault: as a function for tests, and as an adapter.

    python planted_faults.py NAME

A fault changes what comes of a request; as an adapter a crash ends the process and a time-out
sleeps.
"""

import os
import sys
import time
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Final

import msgspec

from clers.conformance import payloads as form
from clers.conformance.adapter import answered
from clers.conformance.lines import line_of, request_in
from clers.conformance.messages import (
    Bye,
    Call,
    Caps,
    Hello,
    Introduction,
    OkReply,
    Operation,
    Rejection,
    RejectReply,
    Reply,
)
from clers.conformance.numbers import from_wire
from clers.conformance.outcome import Answered, Crash, Declined, Outcome, TimedOut
from clers.conformance.serve import INTRODUCTION, serve
from clers.conformance.session import Asked
from clers.oracle.fuzz.asking import Ask, asking

Fault = Callable[[Operation, Outcome], Outcome]

SAID: Final[Introduction] = msgspec.structs.replace(
    INTRODUCTION, caps=msgspec.structs.replace(INTRODUCTION.caps, trace=())
)


def bearing(
    *, handles: bool = True, boundaries: str = "many", components: bool = True
) -> Introduction:
    """What the adapter says of itself, with less in it."""
    caps: Caps = SAID.caps
    curves = msgspec.convert(boundaries, type=_CURVES)
    return msgspec.structs.replace(
        SAID,
        caps=msgspec.structs.replace(
            caps, handles=handles, boundaries=curves, components=components
        ),
    )


_CURVES: Final = Caps.__annotations__["boundaries"]


def _word(outcome: Outcome) -> form.WordForm | None:
    result = outcome.result if isinstance(outcome, Answered) else None
    return result if isinstance(result, form.WordForm) else None


def mirrors_handles(_: Operation, outcome: Outcome) -> Outcome:
    """L for R and R for L, where there is a handle."""
    word = _word(outcome)
    if word is None or all(record.kind == "boundary" for record in word.handles):
        return outcome
    letters = word.word.translate(str.maketrans("LR", "RL"))
    return Answered(msgspec.structs.replace(word, word=letters))


def miscounts_second_handle(_: Operation, outcome: Outcome) -> Outcome:
    """The last record is off by one, where there are two handles."""
    word = _word(outcome)
    if word is None or sum(record.kind == "handle" for record in word.handles) < 4:
        return outcome
    last = word.handles[-1]
    moved = msgspec.structs.replace(last, at=from_wire(last.at) + 1)
    return Answered(msgspec.structs.replace(word, handles=(*word.handles[:-1], moved)))


def crashes_on_seven(operation: Operation, outcome: Outcome) -> Outcome:
    """At a vertex with seven neighbours."""
    if not isinstance(operation.input, form.Faces) or _word(outcome) is None:
        return outcome
    pairs = {(u, v) for a, b, c in operation.input.faces for u, v in ((a, b), (b, c), (c, a))}
    neighbours = Counter(u for u, _ in pairs | {(v, u) for u, v in pairs})
    return Crash(-11, "") if max(neighbours.values()) >= 7 else outcome


def hangs_on_two(operation: Operation, outcome: Outcome) -> Outcome:
    """On two components or more: E − S + records counts them."""
    word = _word(outcome)
    if word is None:
        return outcome
    count = word.word.count("E") - word.word.count("S") + len(word.handles)
    return TimedOut(5.0, "") if count > 1 else outcome


def forgets_a_bit(_: Operation, outcome: Outcome) -> Outcome:
    """The last one."""
    bits = outcome.result if isinstance(outcome, Answered) else None
    if not isinstance(bits, form.BitString) or bits.length == 0:
        return outcome
    digits = bin(int("1" + bits.hex, 16))[3:][: bits.length - 1]
    whole = digits + "0" * (-len(digits) % 8)
    data = bytes(int(whole[k : k + 8], 2) for k in range(0, len(whole), 8))
    return Answered(form.BitString(hex=data.hex(), length=len(digits)))


def turns_second_curve(_: Operation, outcome: Outcome) -> Outcome:
    """The vertices of a curve that is reached later come in the wrong order."""
    word = _word(outcome)
    if word is None or all(record.kind == "handle" for record in word.handles):
        return outcome
    order = (*word.vertex_order[:-2], *reversed(word.vertex_order[-2:]))
    return Answered(msgspec.structs.replace(word, vertex_order=order))


def believes_seals(operation: Operation, outcome: Outcome) -> Outcome:
    """A damaged file is a tetrahedron."""
    wrong = isinstance(outcome, Declined) and outcome.rejection.reason == "bad-checksum"
    faces = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
    return Answered(form.MeshForm(faces=faces, vertices=4)) if wrong else outcome


def rejects_long_words(operation: Operation, outcome: Outcome) -> Outcome:
    """Where a word has an S."""
    given = operation.input
    if isinstance(given, form.StreamForm) and "S" in given.word and isinstance(outcome, Answered):
        return Declined(Rejection(msgspec.convert("invalid", type=_CLASS)))
    return outcome


_CLASS: Final = Rejection.__annotations__["fault"]


def sound(_: Operation, outcome: Outcome) -> Outcome:
    """No fault at all."""
    return outcome


FAULTS: Final[Mapping[str, Fault]] = {
    "mirrors-handles": mirrors_handles,
    "miscounts-second-handle": miscounts_second_handle,
    "crashes-on-seven": crashes_on_seven,
    "hangs-on-two": hangs_on_two,
    "forgets-a-bit": forgets_a_bit,
    "turns-second-curve": turns_second_curve,
    "believes-seals": believes_seals,
    "rejects-long-words": rejects_long_words,
    "sound": sound,
}


def planted(fault: Fault) -> Ask:
    """The reference, with a fault."""
    right = asking(serve)

    def ask(asked: Asked) -> Outcome:
        request = request_in(asked.line)
        assert isinstance(request, Call)
        return fault(request, right(asked))

    return ask


def main() -> None:
    """Serve as an adapter."""
    fault = FAULTS[sys.argv[1]]
    ask = planted(fault)
    for line in sys.stdin.buffer:
        request = request_in(line)
        if isinstance(request, Bye):
            return
        replies: tuple[Reply, ...]
        if isinstance(request, Hello):
            replies = (OkReply(request.id, msgspec.Raw(msgspec.json.encode(SAID))),)
        elif isinstance(request, Call):
            replies = (
                _reply(ask(Asked(_name(request), request.id, False, line)), request.id, line),
            )
        else:
            found = answered(line)
            assert not isinstance(found, Bye)
            replies = found
        sys.stdout.buffer.write(b"".join(map(line_of, replies)))
        sys.stdout.buffer.flush()


def _name(request: Operation) -> str:
    return str(type(request).__struct_config__.tag)


def _reply(outcome: Outcome, number: int, line: bytes) -> Reply:
    match outcome:
        case Answered(result):
            return OkReply(number, msgspec.Raw(msgspec.json.encode(result)))
        case Declined(rejection):
            return RejectReply(number, rejection)
        case Crash():
            os._exit(3)
        case TimedOut():
            time.sleep(3600)
        case _:
            pass
    found = answered(line)
    assert not isinstance(found, Bye)
    return found[-1]


if __name__ == "__main__":
    main()
