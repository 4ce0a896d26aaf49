"""Draco, by the package DracoPy. Clauses: ORCL-CODEC-9, ORCL-CODEC-11."""

from collections.abc import Mapping
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from typing import Final

import numpy as np

from clers.conformance import payloads as form
from clers.conformance.messages import Lacking
from clers.oracle.codecs.codec import Answer, Codec, Missing, refused
from clers.oracle.codecs.prepared import Places, Prepared, prepared, returned

LEVELS: Final[Mapping[str, int]] = {
    "sequential": 0,
    "edgebreaker-standard": 5,
    "edgebreaker-valence": 7,
}
"""The compression level at which DracoPy takes each method. Clause: ORCL-CODEC-11."""

MOST_BITS: Final = 24
"""Draco takes memory and time in proportion to 2^bits: at 30 bits 4 GB, whatever the mesh."""
ROUNDING: Final = 2.0**-22
"""Of the greatest coordinate: what binary32 arithmetic may add to half a step, and more."""


def draco(method: str, quantization: int | None) -> Codec | Missing:
    """The codec, or that the package is not there. Clauses: ORCL-CODEC-9 … ORCL-CODEC-11."""
    try:
        number = version("DracoPy")
        import DracoPy  # noqa: F401
    except (PackageNotFoundError, ImportError):
        return Missing("DracoPy is not installed: pip install 'clers[peers]'")
    bits = "from the error" if quantization is None else str(quantization)
    through = partial(_through, LEVELS[method], quantization)
    policy = {"method": method, "bits": bits}
    return Codec("draco", f"DracoPy {number}", "c++", through, policy, ("f32",))


def promise(places: Places, bits: int) -> float:
    """How far Draco may move a coordinate when it quantises so: half a step. ORCL-CODEC-11."""
    if not bits or not len(places):
        return 0.0
    extent = float((places.max(axis=0) - places.min(axis=0)).max())
    return float(extent / ((1 << bits) - 1) / 2 + ROUNDING * np.abs(places).max())


def _bits(places: Places, room: float) -> int:
    """The fewest bits that promise enough; 0, no quantisation, if none do."""
    enough = (bits for bits in range(1, MOST_BITS + 1) if promise(places, bits) <= room)
    return next(enough, 0)


def _through(level: int, quantization: int | None, given: form.ThroughForm) -> Answer:
    mesh = prepared(given)
    if not isinstance(mesh, Prepared):
        return mesh
    singles = mesh.places.astype(np.float32)
    rounded = np.abs(singles.astype(np.float64) - mesh.places).max(axis=0, initial=0.0)
    if quantization is None and (rounded > mesh.error).any():
        return Lacking("error")
    room = float((np.array(mesh.error) - rounded).min())
    bits = _bits(mesh.places, room) if quantization is None else quantization
    import DracoPy

    try:
        data = DracoPy.encode(singles, mesh.faces, quantization_bits=bits, compression_level=level)
        found = DracoPy.decode(data)
    except (DracoPy.EncodingFailedException, DracoPy.FileTypeException, ValueError) as fault:
        return refused(f"DracoPy: {type(fault).__name__}: {fault}")
    faces = found.faces if isinstance(found, DracoPy.DracoMesh) else mesh.faces[:0]
    return returned(mesh, faces, found.points.astype(np.float32))
