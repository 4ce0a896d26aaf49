"""Shrinking what somebody brings: a finding, a vector, or a mesh. Clause: ORCL-SHRINK-6."""

from math import isfinite
from pathlib import Path
from typing import Final

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case, operation_of
from clers.conformance.lines import NoMessage
from clers.conformance.messages import Operation
from clers.conformance.numbers import to_wire
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry.positions import Precision
from clers.meshfile.mesh import RawMesh
from clers.meshfile.reading import read as read_mesh
from clers.oracle.finding import Finding, Party, Shrunk
from clers.oracle.fuzz.checks import Check, Tried
from clers.oracle.fuzz.found import finding, shrunk_from
from clers.oracle.fuzz.shrinking.engine import DEFAULT_PATIENCE, Patience, least

MESH_OPERATIONS: Final = ("word.encode", "codec.roundtrip", "surface.classify", "mesh.encode")
"""What can be asked about a mesh file. Clause: ORCL-SHRINK-6."""


def smallest(
    operation: Operation,
    check: Check,
    adapter: Party,
    second: Party | None = None,
    before: Shrunk | None = None,
    patience: Patience = DEFAULT_PATIENCE,
) -> Finding | Tried | None:
    """The finding, shrunk; or what was tried, if it passes; none if it cannot be asked.

    Clauses: ORCL-SHRINK-4, ORCL-SHRINK-6.
    """
    tried = check(operation)
    if tried is None or tried.good or tried.gone:
        return tried
    found = least(operation, tried, check, patience)
    return finding(found.tried, adapter, second, shrunk_from(operation, found, before))


def of_case(case: Case) -> Accepted[Operation] | Rejected:
    """The request of a vector. Clause: ORCL-SHRINK-6."""
    operation = operation_of(case)
    if isinstance(operation, NoMessage):
        return Rejected(Reason.UNREADABLE_FILE, Clause.ORCL_SHRINK_6, detail=operation.why)
    return Accepted(operation)


def of_mesh(path: Path, op: str, code: str) -> Accepted[Operation] | Rejected:
    """A request about a mesh file, whatever its faces are. Clause: ORCL-SHRINK-6."""
    return and_then(read_mesh(path), lambda mesh: _about(mesh, op, code))


def _about(mesh: RawMesh, op: str, code: str) -> Accepted[Operation] | Rejected:
    if not all(map(isfinite, mesh.coordinates)):
        return Rejected(Reason.NON_FINITE_COORDINATE, Clause.ORCL_SHRINK_6)
    faces = tuple((to_wire(a), to_wire(b), to_wire(c)) for a, b, c in mesh.faces.faces)
    vertices = to_wire(mesh.faces.vertices)
    places = form.Places(
        precision="f32" if mesh.precision is Precision.F32 else "f64",
        coordinates=mesh.coordinates,
    )
    bare = form.Faces(faces=faces, vertices=vertices)
    match op:
        case "word.encode":
            return Accepted(message.WordEncode(id=0, input=bare))
        case "surface.classify":
            return Accepted(message.Classify(id=0, input=bare))
        case "codec.roundtrip":
            sent = form.ThroughForm(faces=faces, vertices=vertices, positions=places)
            return Accepted(message.Roundtrip(id=0, input=sent))
        case _:
            file = form.ToFile(
                faces=faces,
                vertices=vertices,
                positions=places,
                code=code,
                accuracy=form.ExactForm(),
            )
            return Accepted(message.MeshEncode(id=0, input=file))
