"""The list of vertex numbers, by general compressors and by meshoptimizer's index codec."""

import lzma
import zlib
from typing import Final

import numpy as np
import numpy.typing as npt

from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected, and_then
from clers.measure.peers.peer import Peer, not_installed

Indices = npt.NDArray[np.uint32]


def index_list(surface: Surface) -> Indices:
    """Three vertex numbers for each face, in the mesh's order. Clause: TOOL-BITS-4."""
    return np.asarray(surface.vertex_row.flat).astype("<u4")


def by_zlib(surface: Surface) -> Accepted[int] | Rejected:
    """Clause: TOOL-BITS-4."""
    return Accepted(len(zlib.compress(index_list(surface).tobytes(), 9)))


def by_lzma(surface: Surface) -> Accepted[int] | Rejected:
    """Clause: TOOL-BITS-4."""
    return Accepted(len(lzma.compress(index_list(surface).tobytes(), preset=9)))


def by_zstd(surface: Surface) -> Accepted[int] | Rejected:
    """Clause: TOOL-BITS-4."""
    return _zstd(index_list(surface).tobytes())


def _zstd(data: bytes) -> Accepted[int] | Rejected:
    try:
        import zstandard
    except ImportError:
        return not_installed("zstandard")
    return Accepted(len(zstandard.ZstdCompressor(level=19).compress(data)))


def by_meshoptimizer(surface: Surface) -> Accepted[int] | Rejected:
    """Clause: TOOL-BITS-4."""
    return and_then(reordered(surface), _zstd)


def reordered(surface: Surface) -> Accepted[bytes] | Rejected:
    """The output of meshoptimizer's index codec, before zstd. Clause: TOOL-BITS-4."""
    return and_then(
        renumbered(surface), lambda named: Accepted(by_index_codec(named, surface.vertices))
    )


def renumbered(surface: Surface) -> Accepted[Indices] | Rejected:
    """The list that meshoptimizer's index codec is given. Clause: TOOL-BITS-4."""
    try:
        import meshoptimizer
    except ImportError:
        return not_installed("meshoptimizer")
    given = index_list(surface)
    cached, named = np.zeros_like(given), np.zeros_like(given)
    meshoptimizer.optimize_vertex_cache_strip(cached, given, len(given), surface.vertices)
    names = np.zeros(surface.vertices, dtype=np.uint32)
    meshoptimizer.optimize_vertex_fetch_remap(names, cached, len(cached), surface.vertices)
    meshoptimizer.remap_index_buffer(named, cached, len(cached), names)
    return Accepted(named)


def by_index_codec(named: Indices, vertices: int) -> bytes:
    """meshoptimizer's index codec itself. Clauses: TOOL-BITS-4, TOOL-SPEED-4."""
    import meshoptimizer

    return bytes(meshoptimizer.encode_index_buffer(named, len(named), vertices))


INDEX_LISTS: Final = (
    Peer("meshopt-zstd", "meshoptimizer", by_meshoptimizer),
    Peer("zlib", "", by_zlib),
    Peer("zstd", "zstandard", by_zstd),
    Peer("lzma", "", by_lzma),
)
"""Clause: TOOL-BITS-4."""
