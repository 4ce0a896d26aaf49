"""What is timed: somebody who is given a mesh once, and codes it as often as asked."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

from clers.complexes.corner_table import face_list
from clers.complexes.index_list import IndexList, buffered
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.measure.clock import Spent


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
    return Given(name, buffered(face_list(surface)), surface)


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
