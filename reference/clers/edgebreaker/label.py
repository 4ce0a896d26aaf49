"""From glued triangles to a surface: name the vertices in the order of their creation, then check.

All decoders but the definition end here; they differ in how they find which edges are one.
"""

from collections.abc import Sequence

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.corner_table import by_clauses
from clers.complexes.face_list import FaceList, Limits
from clers.complexes.surface import Surface, corners_flat
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtEdge, AtFace, AtSymbol, Where
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.scanning import scanned
from clers.kernels import table
from clers.kernels.naming import named
from clers.kernels.scan import Scan


def label(outlined: Outline, glued: Sequence[int]) -> Accepted[Surface] | Rejected:
    """The surface of glued triangles, or the symbol whose triangle makes it no simplicial complex.

    `glued[c]` is the corner opposite to c, or BORDER. Vertices are numbered by EB-ORDER-1. Linear.
    Clauses: EB-ORDER-1, EB-GRAMMAR-9.
    """
    return and_then(scanned(outlined.stream), lambda scan: labelled(scan, vec[i64](glued)))


def labelled(scan: Scan, opposite: vec[i64]) -> Accepted[Surface] | Rejected:
    """The same of a stream that was scanned.

    Each name goes to one fan, so that only faces with a vertex twice, faces on the same vertices,
    and edges with three faces are left to look for.
    """
    naming = named(scan, opposite)
    found = corners_flat(naming.vertex, opposite, naming.count)
    if table.fit(naming.vertex, naming.count) and table.simple(
        naming.vertex, opposite, naming.count
    ):
        return Accepted(found)
    return _simplicial(scan, found)


def _simplicial(scan: Scan, glued: Surface) -> Accepted[Surface] | Rejected:
    """Triangles that share two vertices share the edge, and no more. Clause: EB-GRAMMAR-9.

    A face list that reads as a surface reads as this one. Two edges on the same two vertices that
    are both inside, or one of them, make an edge with three faces; both on curves, they are run one
    after the other (a vertex is on one curve, once), and a curve of two edges was refused before.
    """
    no_limit = Limits(glued.faces, glued.vertices)
    match by_clauses(FaceList(tuple(glued.triangles()), glued.vertices), no_limit):
        case Accepted(value):
            return Accepted(value)
        case Rejected(reason, _, where, detail):
            repeated = reason is Reason.REPEATED_INDEX
            why = Reason.REPEATED_VERTEX if repeated else Reason.DOUBLE_EDGE
            here = _symbol_of(scan, _face_in(where))
            return Rejected(why, Clause.EB_GRAMMAR_9, here, f"{reason}: {detail}")


def _face_in(where: Where) -> int:
    match where:
        case AtFace(face) | AtEdge(_, _, face):
            return face
        case _:
            return 0


def _symbol_of(scan: Scan, face: int) -> AtSymbol:
    """The symbol that made a face; P is told by the first symbol after it."""
    part = max(p for p in range(scan.components) if scan.face[p] <= face)
    return AtSymbol(scan.start[part] + max(0, face - scan.first(part)))
