"""One mesh through the whole path and back, every promise on the way checked."""

from dataclasses import dataclass

from clers.complexes.isomorphism import Isomorphic, is_isomorphism
from clers.complexes.surface import Corner, Surface, Vertex, next_corner
from clers.complexes.topology import components
from clers.container.file import decode, inspect
from clers.container.given import ToWrite
from clers.container.laws_file import comes_back, written
from clers.container.options import Options
from clers.conventions.clause import Clause
from clers.conventions.law import every
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Verdict
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Encoding
from clers.geometry.mesh import Mesh


@dataclass(frozen=True, slots=True)
class Trip:
    """A mesh that came back as it went: its counts and what its file weighs. TOOL-ROUND-1.

    `connectivity_bytes` are the payloads of HAND and WORD, `file_bytes` all of the file.
    """

    vertices: int
    faces: int
    components: int
    genus: int
    curves: int
    connectivity_bytes: int
    file_bytes: int


def certificate(surface: Surface, encoding: Encoding) -> Isomorphic:
    """The isomorphism onto the decoded surface that the encoder's orders claim. EB-DECODE-1."""
    vertices = [Vertex(0)] * surface.vertices
    for number, v in enumerate(encoding.vertex_order):
        vertices[v] = Vertex(number)
    corners = [Corner(0)] * len(surface.vertex)
    for face, tip in enumerate(encoding.tip_order):
        after = next_corner(tip)
        for k, corner in enumerate((tip, after, next_corner(after))):
            corners[corner] = Corner(3 * face + k)
    return Isomorphic(tuple(vertices), tuple(corners))


def isomorphic_by_orders(mesh: Mesh, data: bytes) -> Verdict:
    """The decoded surface is isomorphic to the first by the encoder's orders. EB-DECODE-1."""
    match decode(data):
        case Accepted(decoded):
            claim = certificate(mesh.surface, encode(mesh.surface))
            return is_isomorphism(mesh.surface, decoded.surface, claim)
        case Rejected() as rejected:
            return Fails("a mesh", rejected.line(), rejected.where)


def round_trip(mesh: Mesh, options: Options) -> Accepted[Trip] | Rejected:
    """Write a mesh and read it, and compare: equal under the orders, isomorphic, positions kept.

    Clauses: TOOL-ROUND-1, FILE-ROUND-1, EB-DECODE-1.
    """
    data = written(ToWrite(mesh, options))
    verdict = every(comes_back(ToWrite(mesh, options)), isomorphic_by_orders(mesh, data))
    if isinstance(verdict, Fails):
        detail = f"expected {verdict.expected:.80}, got {verdict.got:.80}"
        return Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_ROUND_1, verdict.where, detail)
    parts = components(mesh.surface)

    def weigh(payloads: dict[str, int]) -> Accepted[Trip] | Rejected:
        return Accepted(
            Trip(
                mesh.surface.vertices,
                mesh.surface.faces,
                len(parts),
                sum(c.genus for c in parts),
                sum(c.curves for c in parts),
                payloads["WORD"] + payloads.get("HAND", 0),
                len(data),
            )
        )

    return and_then(
        inspect(data), lambda found: weigh({s.tag: s.stop - s.start for s in found.sections})
    )
