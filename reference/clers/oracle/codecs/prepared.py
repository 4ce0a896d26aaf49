"""A mesh of a message as arrays, checked so far that no library is led out of its memory."""

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.soup import soup
from clers.conformance.judging.meshes import error_of
from clers.conformance.messages import Rejection
from clers.conventions.reason import Fault, Reason
from clers.oracle.codecs.codec import refused

ROW: Final = 4096
MOST: Final = 1 << 26

Places = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Prepared:
    """Faces of shape (F, 3), places of shape (V, 3); whether the mesh has them, and how exact.

    A mesh without positions is given places, all different and binary32 values: vertex i is at
    (i mod 4096, ⌊i/4096⌋, 0). They are not given back. Clause: ORCL-CODEC-9.
    """

    faces: npt.NDArray[np.uint32]
    places: Places
    placed: bool
    precision: str
    error: tuple[float, float, float]


def prepared(given: form.ThroughForm) -> Prepared | Rejection:
    """The arrays of a mesh, or why no codec is asked about it. Clause: ORCL-CODEC-9."""
    mesh = soup(given)
    if mesh.vertices > MOST:
        detail = f"{mesh.vertices} vertices, at most {MOST} are handed on"
        return Rejection(Fault.LIMIT, str(Reason.TOO_MANY_VERTICES), detail=detail)
    for t, face in enumerate(mesh.faces):
        if not all(0 <= v < mesh.vertices for v in face):
            detail = f"face {t} is {face}, there are {mesh.vertices} vertices"
            return refused(detail, str(Reason.INDEX_OUT_OF_RANGE))
    if mesh.places is not None and mesh.coordinates != 3 * mesh.vertices:
        detail = f"{mesh.coordinates} coordinates for {mesh.vertices} vertices"
        return refused(detail, str(Reason.COUNT_MISMATCH))
    numbers = np.arange(mesh.vertices)
    made = np.stack((numbers % ROW, numbers // ROW, 0 * numbers), axis=1)
    places = np.array(made if mesh.places is None else mesh.places, dtype=np.float64)
    faces = np.array(mesh.faces, dtype=np.uint32).reshape(-1, 3)
    precision = given.positions.precision if isinstance(given.positions, form.Places) else "f32"
    placed = mesh.places is not None
    return Prepared(faces, places.reshape(-1, 3), placed, precision, error_of(given))


def returned(
    of: Prepared, faces: npt.NDArray[np.uint32], places: npt.NDArray[np.float32] | Places
) -> form.MeshForm:
    """The mesh that came back, in binary32 or binary64 as its places are. Clause: ORCL-OP-8."""
    triples = tuple((a, b, c) for a, b, c in faces.reshape(-1, 3).tolist())
    if not of.placed:
        return form.MeshForm(faces=triples, vertices=len(places))
    coordinates = tuple(places.astype(np.float64).reshape(-1).tolist())
    at = form.Places(
        precision="f32" if places.dtype == np.float32 else "f64", coordinates=coordinates
    )
    return form.MeshForm(faces=triples, vertices=len(places), positions=at)
