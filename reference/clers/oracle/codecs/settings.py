"""The codecs that are surveyed, each in one setting. Clause: ORCL-CODEC-14."""

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.sites import Bound
from clers.conformance.judging.meshes import EXACT
from clers.oracle.codecs.draco import promise

Allowed = Callable[[form.MeshForm], Bound]
"""The error that a codec is held to on a mesh."""


@dataclass(frozen=True, slots=True)
class Setting:
    """A name, the words after `clers adapter`, the package, and the error that it promises."""

    name: str
    words: tuple[str, ...]
    package: str
    allowed: Allowed

    @property
    def command(self) -> tuple[str, ...]:
        """The adapter's command line."""
        return (sys.executable, "-P", "-m", "clers", "adapter", *self.words)


def _exact(_: form.MeshForm) -> Bound:
    return EXACT


def _quantised(bits: int) -> Allowed:
    """What Draco promises. Clause: ORCL-CODEC-11."""

    def allowed(mesh: form.MeshForm) -> Bound:
        if not isinstance(mesh.positions, form.Places):
            return EXACT
        bound = promise(np.array(mesh.positions.coordinates).reshape(-1, 3), bits)
        return bound, bound, bound

    return allowed


def _draco(method: str) -> tuple[str, ...]:
    return ("draco", "--method", method)


SETTINGS: Final = (
    Setting("draco-sequential", _draco("sequential"), "DracoPy", _exact),
    Setting("draco-standard", _draco("edgebreaker-standard"), "DracoPy", _exact),
    Setting("draco-valence", _draco("edgebreaker-valence"), "DracoPy", _exact),
    Setting(
        "draco-standard-11-bits",
        (*_draco("edgebreaker-standard"), "--quantization", "11"),
        "DracoPy",
        _quantised(11),
    ),
    Setting("meshopt-triangles", ("meshoptimizer",), "meshoptimizer", _exact),
    Setting("meshopt-sequence", ("meshoptimizer", "--method", "sequence"), "meshoptimizer", _exact),
)
"""Clause: ORCL-CODEC-14."""
