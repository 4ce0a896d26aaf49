"""Between the reference's values and the forms they have in messages."""

from clers.arithmetic.bits import Bits, packed
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire, to_wire
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.positions import Positions, Precision, positions


def surface_of(given: form.Faces) -> Accepted[Surface] | Rejected:
    """The surface that faces and vertices describe. Clause: ORCL-OP-2."""
    faces = tuple((from_wire(a), from_wire(b), from_wire(c)) for a, b, c in given.faces)
    return surface(FaceList(faces, from_wire(given.vertices)))


def mesh_of(given: form.MeshForm) -> Accepted[Mesh] | Rejected:
    """The mesh of a message. Clauses: ORCL-OP-7, ORCL-OP-8, ORCL-VALUE-3."""
    places = given.positions
    if not isinstance(places, form.Places):
        return and_then(surface_of(given), mesh)

    def placed(of: Surface) -> Accepted[Mesh] | Rejected:
        found = positions(Precision(places.precision), places.coordinates, of.vertices)
        return and_then(found, lambda p: mesh(of, p))

    return and_then(surface_of(given), placed)


def faces_form(of: Surface) -> form.Faces:
    """Faces and vertices. Clause: ORCL-OP-5."""
    return form.Faces(faces=tuple(of.triangles()), vertices=of.vertices)


def mesh_form(of: Mesh) -> form.MeshForm:
    """A mesh as a message has it. Clause: ORCL-OP-7."""
    faces = tuple(of.surface.triangles())
    if of.positions is None:
        return form.MeshForm(faces=faces, vertices=of.surface.vertices)
    return form.MeshForm(faces=faces, vertices=of.surface.vertices, positions=_places(of.positions))


def _places(of: Positions) -> form.Places:
    return form.Places(
        precision="f32" if of.precision is Precision.F32 else "f64", coordinates=of.coordinates
    )


def bits_of(given: form.BitString) -> Accepted[Bits] | Rejected:
    """Bits from their bytes and number. Clauses: ORCL-VALUE-2, ARITH-BITS-3."""
    return packed(bytes.fromhex(given.hex), given.length)


def bits_form(bits: Bits) -> form.BitString:
    """Bits as a message has them. Clause: ORCL-VALUE-2."""
    return form.BitString(hex=bits.data.hex(), length=bits.length)


def stream_of(given: form.StreamForm) -> Stream:
    """The stream of a message; nothing is checked yet. Clause: ORCL-OP-5."""
    records = tuple(
        Record(Kind(h.kind), from_wire(h.s), from_wire(h.at), Side(h.side)) for h in given.handles
    )
    return Stream(given.word, records, from_wire(given.components_with_boundary))


def handle_forms(records: tuple[Record, ...]) -> tuple[form.HandleForm, ...]:
    """Handle data as a message has it. Clause: ORCL-OP-5."""
    return tuple(
        form.HandleForm(
            kind="boundary" if r.kind is Kind.BOUNDARY else "handle",
            s=to_wire(r.s),
            at=to_wire(r.at),
            side="left" if r.side is Side.LEFT else "right",
        )
        for r in records
    )
