"""What is remarkable about a surface and its walk, as flags. Clause: ORCL-CASE-5."""

from itertools import groupby
from typing import Final

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Kind, Side, Stream

DEEP: Final = 8
LONG: Final = 16
MANY_HANDLES: Final = 4
MANY_PARTS: Final = 3
"""From these numbers on a stack is deep, a run long, and so on."""


def features(surface: Surface) -> tuple[str, ...]:
    """The flags of a surface, in alphabetical order. Linear. Clause: ORCL-CASE-5."""
    parts = components(surface)
    stream = encode(surface).stream
    found = set(_of_stream(stream))
    lowest = [part.lowest for part in parts if not part.curves]
    has = {
        "boundary-first": any(
            part.curves and any(face < part.lowest for face in lowest) for part in parts
        ),
        "many-components": len(parts) >= MANY_PARTS,
        "lone-triangle": any(part.faces == 1 for part in parts),
        "high-genus": sum(part.genus for part in parts) >= MANY_HANDLES,
    }
    return tuple(sorted(found | {name for name, is_so in has.items() if is_so}))


def _of_stream(stream: Stream) -> set[str]:
    word = stream.word
    closers = [symbol for symbol in word if symbol in "RLE"]
    splits = [place for place, symbol in enumerate(word) if symbol == "S"]
    ends = [record.at for record in stream.records]
    found = {
        f"{'curve' if record.kind is Kind.BOUNDARY else 'handle'}-"
        f"{'left' if record.side is Side.LEFT else 'right'}"
        for record in stream.records
    }
    late = any(
        record.kind is Kind.BOUNDARY and 2 * splits[record.s] > len(word)
        for record in stream.records
    )
    has = {
        "closed-by-e": any(closers[at] == "E" for at in ends),
        "shared-closer": len(set(ends)) < len(ends),
        "late-curve": late,
        "deep-stack": _depth(stream) >= DEEP,
        "long-run": any(
            symbol == "C" and sum(1 for _ in run) >= LONG for symbol, run in groupby(word)
        ),
    }
    return found | {name for name, is_so in has.items() if is_so}


def _depth(stream: Stream) -> int:
    """The most gates that wait at once, gates to be passed over among them. EB-TRAVERSE-5."""
    passed_over = {record.s for record in stream.records}
    stack: list[bool] = []
    deepest = splits = 0
    for symbol in stream.word:
        if symbol == "S":
            stack.append(splits in passed_over)
            splits += 1
            deepest = max(deepest, len(stack))
        elif symbol == "E":
            while stack and stack.pop():
                pass
    return deepest
