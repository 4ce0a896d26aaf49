"""What a complex is recognised as when it is asked whether it is a sphere or a ball."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

from clers.complexes.simplicial import Complex, Simplex


class Flaw(StrEnum):
    """Why a complex is no sphere and no ball, or no manifold. Clause: CPLX-MANIFOLD-3."""

    NOT_PURE = "a maximal simplex of too low a dimension"
    CROWDED_WALL = "a wall in three simplices"
    DISCONNECTED = "several components"
    BAD_LINK = "a vertex with neither a circle nor an arc for its link"
    WRONG_HOMOLOGY = "the homology of neither a sphere nor a ball"


@dataclass(frozen=True, slots=True)
class Sphere:
    """Proved to be a combinatorial sphere. Clauses: CPLX-SPHERE-1, CPLX-SPHERE-2."""

    dimension: int


@dataclass(frozen=True, slots=True)
class Ball:
    """Proved to be a combinatorial ball. Clauses: CPLX-SPHERE-1, CPLX-SPHERE-2."""

    dimension: int


@dataclass(frozen=True, slots=True)
class Neither:
    """Proved to be homeomorphic to no sphere and no ball. Clauses: CPLX-SPHERE-1, -2."""

    flaw: Flaw


@dataclass(frozen=True, slots=True)
class Undecided:
    """Neither recognised nor refuted; what was tried, in words. Clause: CPLX-SPHERE-2."""

    why: str


@dataclass(frozen=True, slots=True)
class NotManifold:
    """Refuted, with the simplex to blame. Clauses: CPLX-MANIFOLD-3, CPLX-MANIFOLD-6."""

    simplex: Simplex
    flaw: Flaw


LinkKind = Sphere | Ball | Neither | Undecided

Recogniser = Callable[[Complex], LinkKind]
"""A procedure that may be incomplete, but is never wrong. Clause: CPLX-SPHERE-2."""
