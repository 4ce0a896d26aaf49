"""The element that a rejection points at, as JSON has it. Clause: CONV-RESULT-2."""

from typing import assert_never

from clers.conventions.where import (
    AtByte,
    AtCell,
    AtEdge,
    AtEntry,
    AtFace,
    AtPair,
    AtRecord,
    AtSimplex,
    AtStep,
    AtSymbol,
    AtVertex,
    Where,
    Whole,
)


def where_record(where: Where) -> dict[str, int | str | list[int]]:
    """The element as JSON has it: a key for each number or list of vertices. CONV-RESULT-2."""
    match where:
        case Whole():
            return {}
        case AtFace(face):
            return {"face": face}
        case AtVertex(vertex):
            return {"vertex": vertex}
        case AtEdge(tail, head, face):
            return {"tail": tail, "head": head, "face": face}
        case AtSymbol(index):
            return {"symbol": index}
        case AtRecord(index):
            return {"record": index}
        case AtStep(index):
            return {"step": index}
        case AtByte(offset, section):
            return {"byte": offset, "section": section}
        case AtSimplex(vertices):
            return {"simplex": list(vertices)}
        case AtPair(first, second):
            return {"simplex": list(first), "other": list(second)}
        case AtCell(dimension, number):
            return {"cell": number, "dimension": dimension}
        case AtEntry(array, index):
            return {"array": array, "entry": index}
        case _:
            assert_never(where)
