"""The dual tree of a stream, and what it leaves: the primal remainder and the Morse edges."""

from dataclasses import dataclass

from clers.complexes.surface import BORDER, Corner, Surface
from clers.edgebreaker.outline import Outline


@dataclass(frozen=True, slots=True)
class Tree:
    """The edges of one component, by what the walk did with them. Clauses: EB-REMAINDER-1 … -3.

    An edge is named by the lower of the corners opposite to it. `crossed`: the gates the walk went
    through, links of the dual tree; `remainder`: all others; `morse`: those of the remainder that
    are left edges of an S with a record; `faces`: the component's faces, a range in creation order.
    """

    faces: range
    crossed: tuple[Corner, ...]
    remainder: tuple[Corner, ...]
    morse: tuple[Corner, ...]


def trees(outlined: Outline, decoded: Surface) -> tuple[Tree, ...]:
    """The dual tree and the remainder of each component of a decoded surface. Linear.

    Clauses: EB-REMAINDER-1, EB-REMAINDER-2, EB-REMAINDER-3.
    """
    opposite = decoded.opposite
    found: list[Tree] = []
    for part in outlined.parts:
        faces = range(part.face, part.first + part.stop - part.start)
        tips = [Corner(3 * outlined.face[i]) for i in range(part.start, part.stop)]
        gates = {_edge(decoded, tip) for tip in tips if opposite[tip] != BORDER}
        morse = {
            _edge(decoded, Corner(3 * outlined.face[i] + 2))
            for i in range(part.start, part.stop)
            if outlined.record_of[i] >= 0
        }
        corners = (Corner(c) for c in range(3 * faces.start, 3 * faces.stop))
        rest = [c for c in corners if _edge(decoded, c) == c and c not in gates]
        found.append(Tree(faces, tuple(sorted(gates)), tuple(rest), tuple(sorted(morse))))
    return tuple(found)


def _edge(surface: Surface, corner: Corner) -> Corner:
    across = surface.opposite[corner]
    return corner if across == BORDER else min(corner, across)
