"""meshoptimizer's vertex and index codecs, by its Python package. Clause: ORCL-CODEC-12."""

from functools import partial
from importlib.metadata import PackageNotFoundError, version
from typing import Final

import numpy as np

from clers.conformance import payloads as form
from clers.conventions.reason import Reason
from clers.oracle.codecs.codec import Answer, Codec, Missing, refused
from clers.oracle.codecs.prepared import Prepared, prepared, returned

METHODS: Final = ("triangles", "sequence")


def meshoptimizer(method: str) -> Codec | Missing:
    """The codec, or that the package is not there. Clauses: ORCL-CODEC-9, -10, -12."""
    try:
        number = version("meshoptimizer")
        import meshoptimizer  # noqa: F401
    except (PackageNotFoundError, ImportError):
        return Missing("meshoptimizer is not installed: pip install 'clers[peers]'")
    return Codec("meshoptimizer", number, "c++", partial(_through, method), {"method": method})


def _through(method: str, given: form.ThroughForm) -> Answer:
    mesh = prepared(given)
    if not isinstance(mesh, Prepared):
        return mesh
    import meshoptimizer as library

    kind = np.dtype(np.float32 if mesh.precision == "f32" else np.float64)
    places = mesh.places.astype(kind)
    if (places != mesh.places).any():
        return refused("a coordinate is no binary32 value", str(Reason.NOT_REPRESENTABLE))
    flat, size = mesh.faces.reshape(-1), 3 * kind.itemsize
    try:
        vertices = library.encode_vertex_buffer(places, len(places), size)
        back = library.decode_vertex_buffer(len(places), size, vertices)
        if method == "triangles":
            data = library.encode_index_buffer(flat, len(flat), len(places))
            faces = library.decode_index_buffer(len(flat), 4, data)
        else:
            data = library.encode_index_sequence(flat, len(flat), len(places))
            faces = library.decode_index_sequence(len(flat), 4, data)
    except (ValueError, RuntimeError) as fault:
        return refused(f"meshoptimizer: {type(fault).__name__}: {fault}")
    return returned(mesh, faces, back.reshape(-1).view(kind).reshape(-1, 3))
