"""Tables of the arithmetic coder: each symbol's slot, the interval, the bits; and back again."""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from clers.arithmetic import coder as arithmetic
from clers.arithmetic.steps import PRECISION, Place, narrow, offset, places, shifted
from clers.codes import golden, handle_data
from clers.codes.closings import closings
from clers.codes.implied import NUMBER, coded_part, implied
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.geometry import residual
from clers.geometry.mesh import Mesh
from clers.geometry.predict import residuals
from clers.information.model import Model, Slot, slots
from clers.specification.worked.places import on_lattice
from clers.specification.worked.table import NONE, Fault, Meshes, Worked, compared


@dataclass(frozen=True, slots=True)
class Message:
    """What is coded: a model and its symbols, each with the words of its cell."""

    model: Model
    symbols: tuple[int, ...]
    told: tuple[str, ...]


def _message(table: Worked, meshes: Meshes) -> Message | str:
    """The word in `golden`, the handle data, or positions in some bits.

    Clauses: CODE-GOLDEN-2, CODE-HAND-4, GEOM-CODE-3.
    """
    mesh = meshes[table.words[0]]
    match table.words[1:]:
        case ("golden",):
            return _word(encode(mesh.surface).stream)
        case ("HAND",):
            return _hand(encode(mesh.surface).stream)
        case ("POSN", bits):
            return _positions(mesh, bits)
        case others:
            return f"the coder's tables are of golden, HAND or POSN, not {' '.join(others)!r}"


def _word(stream: Stream) -> Message | str:
    part = coded_part(stream)
    if not isinstance(part, Accepted):
        return part.line()
    model = golden.model(implied(stream.components_with_boundary))
    return Message(model, tuple(NUMBER[x] for x in part.value), tuple(part.value))


def _hand(stream: Stream) -> Message | str:
    seen = closings(stream)
    if not isinstance(seen, Accepted):
        return seen.line()
    model, symbols = handle_data.message(seen.value, len(stream.word))
    return Message(model, symbols, tuple(map(str, symbols)))


def _positions(mesh: Mesh, bits: str) -> Message | str:
    stored = on_lattice(mesh, bits)
    if isinstance(stored, str):
        return stored
    of, given = stored
    symbols = tuple(residual.symbols(residuals(of, given.box, given.indices)))
    return Message(residual.model(of, given.box), symbols, tuple(map(str, symbols)))


def _slots(of: Message) -> tuple[Slot, ...] | str:
    found = slots(of.model, of.symbols)
    return found.value if isinstance(found, Accepted) else found.line()


def _sent(slot: Slot, before: Place) -> tuple[tuple[str, str], str, int]:
    """Low and high after narrowing, what the shifts say, and how many at the end say nothing yet.

    A shift of the lower half is `0`, of the higher half `1`, of the central half `c`.

    Clauses: ARITH-NARROW-1, ARITH-SHIFT-1, ARITH-SHIFT-2.
    """
    state = narrow(before.state, slot)
    ends = (f"{state.low:08X}", f"{state.high:08X}")
    taken = ""
    while (away := offset(state)) is not None:
        taken += "0c1"[away >> (PRECISION - 2)]
        state = shifted(state, away)
    return ends, taken, len(taken) - len(taken.rstrip("c"))


def steps(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Encoding, symbol by symbol. Clauses: ARITH-ENCODE-1, ARITH-END-1."""
    of = _message(table, meshes)
    found = of if isinstance(of, str) else _slots(of)
    if isinstance(of, str) or isinstance(found, str):
        yield table.line, str(found)
        return
    bits = arithmetic.encode(of.model, of.symbols)
    if not isinstance(bits, Accepted):
        yield table.line, bits.line()
        return
    digits, at, pending, rows = bits.value.digits(), 0, 0, list[dict[str, str]]()
    trace = places(found)
    for told, slot, before, after in zip(of.told, found, trace[:-1], trace[1:], strict=True):
        ends, taken, more = _sent(slot, before)
        sends = len(taken) - more + pending if more < len(taken) else 0
        pending = more if sends else pending + more
        rows.append(
            {
                "symbol": told,
                "slot": f"{slot.below}–{slot.upto} of {slot.total}",
                "low": ends[0],
                "high": ends[1],
                "sends": digits[at : at + sends] or NONE,
                "pending": str(pending),
                "low then": f"{after.state.low:08X}",
                "high then": f"{after.state.high:08X}",
            }
        )
        at += sends
    end = dict.fromkeys(rows[0], NONE) | {"symbol": "end", "sends": digits[at:]}
    yield from compared(table, [*rows, end])


def back(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Decoding, symbol by symbol. Clauses: ARITH-DECODE-1, ARITH-DECODE-2."""
    of = _message(table, meshes)
    if isinstance(of, str):
        yield table.line, of
        return
    bits = arithmetic.encode(of.model, of.symbols)
    if not isinstance(bits, Accepted):
        yield table.line, bits.line()
        return
    yield from compared(table, _decoded(of, bits.value.digits()))


def _decoded(of: Message, digits: str) -> Sequence[dict[str, str]]:
    """What a decoder sees of these bits, by the steps of chapter 2 alone."""
    model, place, rows = of.model, Place(), list[dict[str, str]]()
    for told in of.told:
        value = _value(digits, place)
        low, width, total = place.state.low, place.state.width, model.cumulative[-1]
        count = ((value - low + 1) * total - 1) // width
        symbol = bisect_right(model.cumulative, count) - 1
        slot = Slot(model.cumulative[symbol], model.cumulative[symbol + 1], total)
        state, base, shifts = narrow(place.state, slot), place.base, place.shifts
        while (away := offset(state)) is not None:
            state, base, shifts = shifted(state, away), 2 * (base + away), shifts + 1
        place, model = Place(state, base, shifts), model.after(symbol)
        rows.append({"value": f"{value:08X}", "count": str(count), "symbol": told})
    return rows


def _value(digits: str, place: Place) -> int:
    """The value at a place: the first digits as a number, less what the shifts took away."""
    read = digits[: PRECISION + place.shifts].ljust(PRECISION + place.shifts, "0")
    return int(read, 2) - place.base
