"""Laws that tie the steps told with plain lists to the decoders in linear time."""

from collections.abc import Iterable
from typing import Final

from clers.complexes.given import SMALL_SURFACES
from clers.complexes.surface import BORDER, Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds, Verdict
from clers.edgebreaker.by_lists import Pair, stars, undone, wrapped
from clers.edgebreaker.encode import encode
from clers.edgebreaker.fast_zip import wrap_and_fast_zip
from clers.edgebreaker.given import outlined
from clers.edgebreaker.reversi import reversi
from clers.edgebreaker.wrap_zip import wrap_and_zip


def _opposite(faces: int, pairs: Iterable[Pair]) -> list[int]:
    """The table of opposites that some gluings make; an edge glued twice shows as a difference."""
    table: list[int] = [BORDER] * (3 * faces)
    for one, other in pairs:
        again = table[one] != BORDER or table[other] != BORDER
        table[one], table[other] = (one, other) if again else (other, one)
    return table


def _undone(surface: Surface) -> Verdict:
    outline = outlined(encode(surface).stream)
    glued = (pair for step in undone(outline) for pair in step.glued)
    return same(reversi(outline), Accepted(_opposite(outline.faces, glued)))


def _wrapped(surface: Surface) -> Verdict:
    outline = outlined(encode(surface).stream)
    steps = wrapped(outline)
    glued = (pair for step in steps for pair in (*step.glued, *step.zipped))
    ended = same((), steps[-1].border) if outline.parts[-1].closed else Holds()
    return every(same(wrap_and_zip(outline), _opposite(outline.faces, glued)), ended)


def _stars(surface: Surface) -> Verdict:
    outline = outlined(encode(surface).stream)
    wrap = (pair for step in wrapped(outline) for pair in step.glued)
    glued = (*wrap, *(star.glued for star in stars(outline)))
    return same(wrap_and_fast_zip(outline), _opposite(outline.faces, glued))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "undoing-with-lists-is-reversi",
        Clause.EB_REVERSI_2,
        "Undoing the word with plain lists, row by row of the table, glues what Spirale Reversi "
        "glues in linked lists.",
        SMALL_SURFACES,
        _undone,
    ),
    Law(
        "zipping-with-lists-is-zip",
        Clause.EB_WRAP_2,
        "Wrapping with plain lists, and gluing neighbours on the border that fit as long as there "
        "are any, glues what Wrap and Zip glues.",
        SMALL_SURFACES,
        _wrapped,
    ),
    Law(
        "closing-stars-one-by-one-is-fast-zip",
        Clause.EB_FAST_1,
        "Turning around each tip from its right edge to the last free edge, from the last tip to "
        "the first, glues what Fast Zip glues.",
        SMALL_SURFACES,
        _stars,
    ),
)
"""Clauses: EB-REVERSI-2, EB-WRAP-2, EB-FAST-1."""
