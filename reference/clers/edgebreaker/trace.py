"""What the walk does at each face, for people and for comparing implementations step by step."""

from dataclasses import dataclass
from typing import Final

from clers.complexes.border import curve_from
from clers.complexes.surface import Corner, Surface, Vertex, next_corner, previous_corner
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.stream import Encoding, Kind

EULER_OF: Final = {"P": 1, "C": 0, "L": 0, "E": 1, "R": 0, "S": -1}
"""The change of χ of the visited part by each letter. Clause: OPER-EFFECT-1."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One face of the walk. Clause: EB-TRACE-1.

    `symbol` is P or a letter of the word, `index` its place in the word (-1 for P), `face` the
    number in the mesh, `triangle` tip first, `gate` from left end to right end, `stack` the number
    of gates kept after this step, `new` the vertices that become known, `opens` the record of an S
    (-1: none), `closes` the records this face closes, `euler` χ of the part visited so far.
    """

    component: int
    index: int
    symbol: str
    face: int
    triangle: tuple[Vertex, Vertex, Vertex]
    gate: tuple[Vertex, Vertex]
    stack: int
    new: tuple[Vertex, ...]
    opens: int
    closes: tuple[int, ...]
    euler: int


def trace(surface: Surface, encoding: Encoding, outlined: Outline) -> tuple[Entry, ...]:
    """The walk over a surface, face by face, in the mesh's own numbers. Linear. EB-TRACE-1."""
    word, records = outlined.stream.word, outlined.stream.records
    closes: dict[int, list[int]] = {}
    for r, edge in enumerate(outlined.glue):
        closes.setdefault(edge // 3, []).append(r)
    entries: list[Entry] = []
    for number, part in enumerate(outlined.parts):
        stack: list[int] = []  # for each gate kept, the record of its S, or -1
        euler = 0 if part.closed else 1
        for made in range(part.face, part.first + part.stop - part.start):
            i = part.start + made - part.first if made >= part.first else -1
            symbol = word[i] if i >= 0 else "P"
            opens = outlined.record_of[i] if symbol == "S" else -1
            reaches = opens >= 0 and records[opens].kind is Kind.BOUNDARY
            if symbol == "S":
                stack.append(opens)
            elif symbol == "E":
                while stack and stack.pop() >= 0:
                    pass
            euler += 0 if reaches else EULER_OF[symbol]
            tip = encoding.tip_order[made]
            first = made == part.first and not part.closed
            new = (
                *(curve_from(surface, next_corner(tip)) if first else ()),
                *(curve_from(surface, tip) if reaches else ()),
                *_created(surface, symbol, tip),
            )
            v, a, b = _triangle(surface, tip)
            closed = tuple(closes.get(made, ()))
            entries.append(
                Entry(
                    number, i, symbol, tip // 3, (v, a, b), (a, b), len(stack), new, opens, closed,
                    euler,
                )
            )  # fmt: skip
    return tuple(entries)


def _triangle(surface: Surface, tip: Corner) -> tuple[Vertex, Vertex, Vertex]:
    """Apex, left end, right end. Clause: EB-GATE-1."""
    v = surface.vertex
    return v[tip], v[next_corner(tip)], v[previous_corner(tip)]


def _created(surface: Surface, symbol: str, tip: Corner) -> tuple[Vertex, ...]:
    """What P and C add by themselves."""
    triangle = _triangle(surface, tip)
    return triangle if symbol == "P" else triangle[:1] if symbol == "C" else ()
