"""The law of the context code: the algorithm writes what the definition says."""

from typing import Final

from clers.arithmetic import coder
from clers.codes import context
from clers.codes.closings import closings
from clers.codes.code import Shape
from clers.codes.context_definition import Told, Undone
from clers.codes.implied import implied
from clers.complexes.given import SMALL_SURFACES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, same
from clers.conventions.result import Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface


def by_definition(surface: Surface) -> Verdict:
    """Loops in linked lists and counts that are kept give the bits that recounting gives."""
    stream = encode_surface(surface).stream
    head = implied(stream.components_with_boundary)
    rest = stream.word[len(head) :]
    seen = closings(stream)
    if isinstance(seen, Rejected):
        return Fails("closings", seen.line(), WHOLE)
    decisions = [bit for symbol in reversed(rest) for bit in context.DECISIONS[symbol]]
    expected = coder.encode(Told(len(rest), Undone(seen.value)), decisions)
    return same(expected, context.encode(rest, Shape(head, seen.value)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "context-definition",
        Clause.CODE_CONTEXT_2,
        "the bits of the context code are those of loops as tuples and triangles counted anew",
        SMALL_SURFACES,
        by_definition,
    ),
)
