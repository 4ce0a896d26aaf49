"""What is timed: somebody who is given a mesh once, and codes it as often as asked."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from clers.complexes.corner_table import surface_of_indices
from clers.complexes.index_list import IndexList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.generate.flat_families import list_of
from clers.measure.clock import Spent
from clers.measure.path import must


class Kind(StrEnum):
    """Whose time it is: a code of ours, a step of its path, a peer's."""

    CODE = "code"
    STEP = "step"
    PEER = "peer"


class Way(StrEnum):
    """There or back."""

    ENCODE = "encode"
    DECODE = "decode"


@dataclass(frozen=True, slots=True)
class Given:
    """A mesh, as an index list and as the surface that it is."""

    name: str
    indices: IndexList
    surface: Surface


def given(name: str, surface: Surface) -> Given:
    """A surface to be coded."""
    faces = np.asarray(surface.vertex_row.flat).reshape(-1, 3)
    return Given(name, list_of(faces, surface.vertices), surface)


def listed(name: str, indices: IndexList) -> Given:
    """A mesh that was made to be coded, and so is a surface."""
    return Given(name, indices, must(surface_of_indices(indices)))


@dataclass(frozen=True, slots=True)
class Reading:
    """What one way took once; `bytes` is what was written, where something was."""

    name: str
    way: Way
    spent: Spent
    bytes: int | None = None


Attempt = Callable[[], Accepted[tuple[Reading, ...]] | Rejected]
"""Codes a mesh and decodes it, once."""


@dataclass(frozen=True, slots=True)
class Contender:
    """A name, whose it is, and how to ready it for a mesh: this is not timed. TOOL-SPEED-2."""

    name: str
    kind: Kind
    ready: Callable[[Given], Accepted[Attempt] | Rejected]
