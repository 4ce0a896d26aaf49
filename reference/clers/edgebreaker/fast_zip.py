"""Wrap with Fast Zip, Algorithms 7 to 9: the stars are closed in one pass over the Cs backwards."""

from clers.complexes.surface import BORDER
from clers.edgebreaker.outline import Outline


def wrap_and_fast_zip(outlined: Outline) -> list[int]:
    """The opposite corner of each corner, of a stream that is known to be valid.

    Linear: the turns around all apexes are as many as the corners. Clauses: EB-WRAP-1, EB-FAST-1.
    """
    opposite: list[int] = [BORDER] * (3 * outlined.faces)
    for tip in reversed(_wrap(outlined, opposite)):
        c = tip
        while (d := opposite[c - 2 if c % 3 == 2 else c + 1]) != BORDER:
            c = d - 2 if d % 3 == 2 else d + 1
        last, left = (c - 2 if c % 3 == 2 else c + 1), (tip + 2 if tip % 3 == 0 else tip - 1)
        opposite[last], opposite[left] = left, last
    return opposite


def _wrap(outlined: Outline, opposite: list[int]) -> list[int]:
    """Glue the dual tree and the handle data; return the corners whose stars are to be closed."""
    word, record_of = outlined.stream.word, outlined.record_of
    tips: list[int] = []
    for part in outlined.parts:
        gates: list[int] = [3 * part.face if part.closed else BORDER]
        if part.closed:
            tips += (3 * part.face, 3 * part.face + 2)  # the third star of P closes with the others
        for i in range(part.start, part.stop):
            tip, gate = 3 * outlined.face[i], gates.pop()
            if gate != BORDER:
                opposite[tip], opposite[gate] = gate, tip
            match word[i]:
                case "C":
                    tips.append(tip)
                    gates.append(tip + 1)
                case "R":
                    gates.append(tip + 2)
                case "L":
                    gates.append(tip + 1)
                case "E":
                    pass
                case _:
                    r = record_of[i]
                    if r < 0:
                        gates.append(tip + 2)
                    else:
                        closing = outlined.glue[r]
                        opposite[tip + 2], opposite[closing] = closing, tip + 2
                    gates.append(tip + 1)
    return tips
