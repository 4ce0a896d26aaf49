"""Codecs of other people as contenders."""

from typing import Final

import numpy as np

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.measure.clock import Spent, now
from clers.measure.peers.draco import Arrays, arrays, encoded_arrays
from clers.measure.peers.draco_file import connectivity
from clers.measure.peers.draco_inside import watched
from clers.measure.peers.index_list import Indices, by_index_codec, index_list, renumbered
from clers.measure.peers.peer import not_installed
from clers.measure.speed.contender import Attempt, Contender, Given, Kind, Reading, Way

ZSTD_LEVEL: Final = 19
WHOLE_CALL: Final = " (whole call)"
SLOWEST: Final = "draco-10"
LEVELS: Final = (("draco-standard", 5), ("draco-valence", 7), (SLOWEST, 10))
"""Draco's compression levels, by name. Clause: TOOL-SPEED-4."""


def changed(name: str) -> Rejected:
    """The answer of a peer that does not bring back what it was given."""
    return Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_SPEED_4, detail=name)


def draco(name: str, level: int) -> Contender:
    """Draco at a compression level, connectivity alone and the whole call. TOOL-SPEED-4."""

    def ready(given: Given) -> Accepted[Attempt] | Rejected:
        made = arrays(given.surface)
        return and_then(
            encoded_arrays(made, level), lambda _: Accepted(lambda: _draco(name, level, made))
        )

    return Contender(name, Kind.PEER, ready)


def _draco(name: str, level: int, given: Arrays) -> Accepted[tuple[Reading, ...]] | Rejected:
    import DracoPy

    with watched() as watch:
        start = now()
        data = encoded_arrays(given, level)
        encoded = now() - start
        encoded_inside = watch.spent
    if isinstance(data, Rejected):
        return data
    with watched() as watch:
        start = now()
        mesh = DracoPy.decode(data.value)
        decoded = now() - start
        decoded_inside = watch.spent
    if len(mesh.faces) != len(given.faces):
        return changed(name)
    inside = _inside(name, data.value, encoded_inside, decoded_inside)
    whole = (
        Reading(name + WHOLE_CALL, Way.ENCODE, encoded, len(data.value)),
        Reading(name + WHOLE_CALL, Way.DECODE, decoded),
    )
    return and_then(inside, lambda found: Accepted((*found, *whole)))


def _inside(
    name: str, data: bytes, encoded: Spent | None, decoded: Spent | None
) -> Accepted[tuple[Reading, ...]] | Rejected:
    """What was spent on connectivity alone, if that was seen. Clause: TOOL-SPEED-4."""
    if encoded is None or decoded is None:
        return Accepted(())
    return and_then(
        connectivity(data),
        lambda section: Accepted(
            (
                Reading(name, Way.ENCODE, encoded, section.bytes),
                Reading(name, Way.DECODE, decoded),
            )
        ),
    )


def _meshoptimizer(given: Given) -> Accepted[Attempt] | Rejected:
    def attempt(named: Indices) -> Accepted[tuple[Reading, ...]] | Rejected:
        import meshoptimizer

        start = now()
        data = by_index_codec(named, given.surface.vertices)
        encoded = now() - start
        start = now()
        back = meshoptimizer.decode_index_buffer(len(named), 4, data)
        decoded = now() - start
        if not _same_faces(back, named):
            return changed("meshoptimizer")
        return Accepted(
            (
                Reading("meshoptimizer", Way.ENCODE, encoded, len(data)),
                Reading("meshoptimizer", Way.DECODE, decoded),
            )
        )

    return and_then(renumbered(given.surface), lambda named: Accepted(lambda: attempt(named)))


def _same_faces(one: Indices, other: Indices) -> bool:
    """Whether two lists have the same faces in the same order, each from any corner on."""
    a, b = one.reshape(-1, 3), other.reshape(-1, 3)
    turned = [(np.roll(a, k, axis=1) == b).all(axis=1) for k in range(3)]
    return bool((turned[0] | turned[1] | turned[2]).all())


def _zstd(given: Given) -> Accepted[Attempt] | Rejected:
    try:
        import zstandard
    except ImportError:
        return not_installed("zstandard")
    listed = index_list(given.surface).tobytes()

    def attempt() -> Accepted[tuple[Reading, ...]] | Rejected:
        start = now()
        data = zstandard.ZstdCompressor(level=ZSTD_LEVEL).compress(listed)
        encoded = now() - start
        start = now()
        back = zstandard.ZstdDecompressor().decompress(data)
        decoded = now() - start
        if back != listed:
            return changed("zstd")
        return Accepted(
            (
                Reading("zstd", Way.ENCODE, encoded, len(data)),
                Reading("zstd", Way.DECODE, decoded),
            )
        )

    return Accepted(attempt)


PEERS: Final = (
    *(draco(name, level) for name, level in LEVELS),
    Contender("meshoptimizer", Kind.PEER, _meshoptimizer),
    Contender("zstd", Kind.PEER, _zstd),
)
"""Clause: TOOL-SPEED-4."""
