"""Between mesh files as they are read, unjudged, and what codecs are asked and give back."""

from clers.complexes.face_list import FaceList
from clers.conformance import payloads as form
from clers.geometry.positions import Precision
from clers.meshfile.mesh import RawMesh
from clers.oracle.codecs.prepared import Prepared


def mesh_in(raw: RawMesh) -> form.MeshForm:
    """The mesh of a file as a message has it, a surface or not. Clause: ORCL-CODEC-2."""
    at = form.Places(
        precision="f32" if raw.precision is Precision.F32 else "f64", coordinates=raw.coordinates
    )
    return form.MeshForm(faces=raw.faces.faces, vertices=raw.faces.vertices, positions=at)


def raw_of(mesh: Prepared) -> RawMesh:
    """What a file of this mesh says. Clause: ORCL-CODEC-13."""
    faces = tuple((a, b, c) for a, b, c in mesh.faces.tolist())
    places = tuple(mesh.places.reshape(-1).tolist())
    return RawMesh(FaceList(faces, len(mesh.places)), places, Precision(mesh.precision))
