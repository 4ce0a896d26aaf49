"""Is a complex a manifold? Proved, refuted, or left undecided; never a guess."""

from dataclasses import dataclass

from clers.complexes.manifolds.homology_type import suspect
from clers.complexes.manifolds.incidence import flaw_at_a_wall, vertex_links
from clers.complexes.manifolds.kind import (
    Ball,
    Flaw,
    Neither,
    NotManifold,
    Recogniser,
    Sphere,
    Undecided,
)
from clers.complexes.manifolds.spheres import recognise
from clers.complexes.simplicial import Complex, Simplex, dimension


@dataclass(frozen=True, slots=True)
class Manifold:
    """Proved: each vertex has a sphere for its link (`inner`), or a ball (`bounding`).

    Both in increasing order. Clauses: CPLX-MANIFOLD-1, CPLX-MANIFOLD-5, CPLX-MANIFOLD-10.
    """

    dimension: int
    inner: tuple[int, ...]
    bounding: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class UndecidedAt:
    """Neither proved nor refuted: what the link of the vertex is, is not known. CPLX-MANIFOLD-7."""

    simplex: Simplex
    why: str


Answer = Manifold | NotManifold | UndecidedAt


def manifold(k: Complex, recogniser: Recogniser = recognise) -> Answer:
    """Decide, exactly up to dimension 3; from 4 on as far as a recogniser and homology reach.

    Linear up to dimension 3. The recogniser is asked about the links of vertices, and only from
    dimension 4 on. Clauses: CPLX-MANIFOLD-1 … CPLX-MANIFOLD-7.
    """
    fault = flaw_at_a_wall(k)
    if fault is not None:
        return fault
    n = dimension(k)
    inner: list[int] = []
    bounding: list[int] = []
    unknown: dict[int, str] = {}
    for v, around in vertex_links(k):
        kind = recogniser(around) if n > 3 else recognise(around)
        match kind:
            case Sphere():
                inner.append(v)
            case Ball():
                bounding.append(v)
            case Neither(flaw) if n <= 3:
                return NotManifold(frozenset({v}), flaw)
            case Neither(why) | Undecided(why):
                unknown[v] = why
    refuted = _suspect_at(k, frozenset(unknown))
    if refuted is not None:
        return NotManifold(refuted, Flaw.WRONG_HOMOLOGY)
    for v, why in unknown.items():
        return UndecidedAt(frozenset({v}), why)
    return Manifold(n, tuple(inner), tuple(bounding))


def _suspect_at(k: Complex, vertices: frozenset[int]) -> Simplex | None:
    """The first simplex, at some vertices, whose link's homology refutes. CPLX-MANIFOLD-6."""
    near = [simplex for simplex in k.simplices if simplex & vertices]
    for simplex in sorted(near, key=lambda s: (len(s), sorted(s))):
        if suspect(k, simplex):
            return simplex
    return None
