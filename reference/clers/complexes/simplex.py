"""One simplex by itself: its faces, its frontier, and what it has to do with another."""

from clers.complexes.simplicial import Simplex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex


def faces(simplex: Simplex, m: int | None = None) -> frozenset[Simplex]:
    """Its subsets that are not empty; with m, those of dimension m. Clause: CPLX-SIMPLEX-1."""
    every = closure([simplex]).simplices
    return every if m is None else frozenset(face for face in every if len(face) == m + 1)


def frontier(simplex: Simplex) -> frozenset[Simplex]:
    """∂σ, its proper faces. Clause: CPLX-SIMPLEX-1."""
    return faces(simplex) - {simplex}


def is_incident(simplex: Simplex, face: Simplex) -> bool:
    """Is the second a proper face of the first? Clause: CPLX-SIMPLEX-2."""
    return bool(face) and face < simplex


def are_adjacent(one: Simplex, other: Simplex) -> bool:
    """Are two different simplices incident to a common one? Clause: CPLX-SIMPLEX-2."""
    return one != other and any(is_incident(one, f) and is_incident(other, f) for f in faces(one))


def join_simplices(one: Simplex, other: Simplex) -> Accepted[Simplex] | Rejected:
    """The simplex on the vertices of both, which have none in common. Clause: CPLX-SIMPLEX-3."""
    if one & other:
        return Rejected(
            Reason.SHARED_VERTEX, Clause.CPLX_SIMPLEX_3, AtVertex(min(one & other)), "join"
        )
    return Accepted(one | other)
