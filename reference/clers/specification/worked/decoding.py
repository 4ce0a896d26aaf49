"""Tables of decoding: undoing the word, wrapping and zipping, closing stars."""

from collections.abc import Iterator, Sequence

from clers.edgebreaker.by_lists import GATE, INFINITE, Edge, Loop, Pair, stars, undone, wrapped
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.edgebreaker.outline import Outline
from clers.specification.worked.table import NONE, Fault, Meshes, Worked, compared, listed


def _edge(edge: Edge) -> str:
    """An edge of a face in the order of creation: `5r`, the right edge of face 5."""
    names = {GATE: "gate", INFINITE: "∞"}
    return names.get(edge, f"{edge // 3}{'grl'[edge % 3]}")


def _pairs(pairs: Sequence[Pair]) -> str:
    return ", ".join(f"{_edge(one)}={_edge(other)}" for one, other in pairs) or NONE


def _loops(loops: Sequence[Loop]) -> str:
    return " / ".join(" ".join(map(_edge, loop)) for loop in loops) or NONE


def _outline(table: Worked, meshes: Meshes) -> Outline:
    return outlined(encode(meshes[table.words[0]].surface).stream)


def _symbol(outline: Outline, place: int, elsewhere: str) -> dict[str, str]:
    word = outline.stream.word
    first = place < 0
    return {"step": NONE if first else str(place), "symbol": elsewhere if first else word[place]}


def undo(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Spirale Reversi. Clauses: EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3."""
    outline = _outline(table, meshes)
    closed = iter([part.closed for part in reversed(outline.parts)])
    yield from compared(
        table,
        [
            {
                **_symbol(outline, step.symbol, _beginning(closed) if step.symbol < 0 else ""),
                "glues": _pairs(step.glued),
                "loops": _loops(step.loops),
                "beside": _loops(step.beside),
                "curves": _loops(step.curves),
            }
            for step in undone(outline)
        ],
    )


def _beginning(closed: Iterator[bool]) -> str:
    return "P" if next(closed) else "first curve"


def wrap(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Wrap and Zip; a loop of the border begins anywhere. Clauses: EB-WRAP-1, EB-WRAP-2."""
    outline = _outline(table, meshes)
    steps = wrapped(outline)
    yield from compared(
        table,
        [
            {
                **_symbol(outline, step.symbol, "P"),
                "glued": _pairs(step.glued),
                "zipped": _pairs(step.zipped),
                "border": _loops(step.border),
            }
            for step in steps
        ],
    )


def closed_stars(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Fast Zip. Clause: EB-FAST-1."""
    outline = _outline(table, meshes)
    rows = [
        {"tip": str(star.tip), "turned": listed(star.turned), "glues": _pairs([star.glued])}
        for star in stars(outline)
    ]
    yield from compared(table, rows)
