"""The classification of surfaces, with and without boundary, orientable and not."""

from collections import Counter
from dataclasses import dataclass

from clers.complexes.manifolds.incidence import components, rim
from clers.complexes.manifolds.kind import NotManifold
from clers.complexes.manifolds.manifold import manifold
from clers.complexes.manifolds.orient import Oriented, orient
from clers.complexes.manifolds.surface_type import NonOrientable, Orientable, SurfaceType
from clers.complexes.simplicial import Complex, dimension, euler
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtSimplex

Types = tuple[SurfaceType, ...]


@dataclass(frozen=True, slots=True)
class Homeomorphic:
    """The components of both have these types, in some order. Clause: CPLX-CLASSIFY-4."""

    types: Types


@dataclass(frozen=True, slots=True)
class Distinct:
    """Types that one has more often than the other, as often. Clause: CPLX-CLASSIFY-4."""

    first_only: Types
    second_only: Types


def classify(k: Complex) -> Accepted[Types] | Rejected:
    """The type of each component of a surface, by their lowest vertices. Linear.

    Rejects what is no 2-manifold, with the simplex to blame. Clauses: CPLX-CLASSIFY-1,
    CPLX-CLASSIFY-5; its witnesses: CPLX-CLASSIFY-6, CPLX-CLASSIFY-7.
    """
    if dimension(k) != 2:
        detail = f"dimension {dimension(k)}"
        return Rejected(Reason.UNSUPPORTED_DIMENSION, Clause.CPLX_CLASSIFY_5, detail=detail)
    answer = manifold(k)
    if isinstance(answer, NotManifold):
        where = AtSimplex(tuple(sorted(answer.simplex)))
        return Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_CLASSIFY_5, where, answer.flaw)
    return Accepted(tuple(map(_type, components(k))))


def _type(part: Complex) -> SurfaceType:
    """χ + b leaves the handles or the cross-caps. Clauses: CPLX-CLASSIFY-1, CPLX-CLASSIFY-2."""
    curves = len(components(rim(part)))
    missing = 2 - curves - euler(part)
    if isinstance(orient(part), Oriented):
        return Orientable(missing // 2, curves)
    return NonOrientable(missing, curves)


def homeomorphism(k: Complex, other: Complex) -> Accepted[Homeomorphic | Distinct] | Rejected:
    """Are two surfaces homeomorphic? Exactly if their types agree as multisets. CPLX-CLASSIFY-4."""
    return and_then(classify(k), lambda a: and_then(classify(other), lambda b: _compared(a, b)))


def _compared(a: Types, b: Types) -> Accepted[Homeomorphic | Distinct]:
    first, second = Counter(a), Counter(b)
    if first == second:
        return Accepted(Homeomorphic(_listed(first)))
    return Accepted(Distinct(_listed(first - second), _listed(second - first)))


def _listed(types: Counter[SurfaceType]) -> Types:
    """Orientable ones first, then by falling χ, then by curves. Clause: CPLX-CLASSIFY-4."""
    return tuple(
        sorted(
            types.elements(),
            key=lambda t: (isinstance(t, NonOrientable), -t.euler, t.curves),
        )
    )
