"""Everything that chapters 3 and 4 know of a complex, in one value: for people who have one."""

from dataclasses import dataclass
from typing import assert_never

from clers.complexes.integral import Group, homology_over_z
from clers.complexes.manifolds.classification import classify
from clers.complexes.manifolds.kind import NotManifold
from clers.complexes.manifolds.manifold import Manifold, UndecidedAt, manifold
from clers.complexes.manifolds.orient import OneSided, Oriented, orient
from clers.complexes.manifolds.surface_type import in_words
from clers.complexes.parts import f_vector
from clers.complexes.simplicial import Complex, Simplex, euler, is_pure, pieces
from clers.conventions.result import Accepted, Rejected
from clers.operators.moves.collapsible import (
    Collapsible,
    Exhausted,
    NotCollapsible,
    Stuck,
    Undecided,
    WrongHomology,
    collapse_to_point,
)
from clers.operators.moves.recognise import recognise

Vertices = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Portrait:
    """What is known of a complex. Clause: OPER-PORTRAIT-1.

    `manifold`, `orientable`, `collapsible`: yes, or why not, or undecided, in words; `simplex`: the
    one that shows that it is no manifold; `one_sided`: the simplices around which an orientation
    comes back reversed; `types`: of the components of a surface.
    """

    f_vector: tuple[int, ...]
    euler: int
    components: int
    pure: bool
    homology: tuple[str, ...]
    manifold: str
    simplex: Vertices
    orientable: str
    one_sided: tuple[Vertices, ...]
    types: tuple[str, ...]
    collapsible: str


def portrait(k: Complex) -> Portrait:
    """Everything that is known of a complex. Clause: OPER-PORTRAIT-1."""
    shape, simplex = _shape(k)
    orientable, cycle = _orientable(k)
    typed = classify(k)
    return Portrait(
        f_vector=f_vector(k),
        euler=euler(k),
        components=len(pieces(k)),
        pure=is_pure(k),
        homology=tuple(map(group_in_words, homology_over_z(k))),
        manifold=shape,
        simplex=simplex,
        orientable=orientable,
        one_sided=cycle,
        types=tuple(map(in_words, typed.value)) if isinstance(typed, Accepted) else (),
        collapsible=_collapsible(k),
    )


def group_in_words(of: Group) -> str:
    """Z^2 + Z/3, or 0. Clause: OPER-PORTRAIT-1."""
    free = {0: (), 1: ("Z",)}.get(of.rank, (f"Z^{of.rank}",))
    return " + ".join((*free, *(f"Z/{d}" for d in of.torsion))) or "0"


def _sorted(simplex: Simplex) -> Vertices:
    return tuple(sorted(simplex))


def _shape(k: Complex) -> tuple[str, Vertices]:
    answer = manifold(k, recognise)
    match answer:
        case Manifold(n, _, bounding):
            return f"of dimension {n}, {'with' if bounding else 'without'} boundary", ()
        case NotManifold(simplex, flaw):
            return f"no: {flaw}", _sorted(simplex)
        case UndecidedAt(simplex, why):
            return f"undecided: {why}", _sorted(simplex)
        case _:
            assert_never(answer)


def _orientable(k: Complex) -> tuple[str, tuple[Vertices, ...]]:
    answer = orient(k)
    match answer:
        case Oriented():
            return "yes", ()
        case OneSided(cycle):
            return "no", tuple(map(_sorted, cycle))
        case Rejected(detail=detail):
            return f"no meaning: {detail}", ()
        case _:
            assert_never(answer)


def _collapsible(k: Complex) -> str:
    answer = collapse_to_point(k)
    match answer:
        case Collapsible(moves):
            return f"yes, by {len(moves)} collapses"
        case NotCollapsible(why):
            return f"no: {_proof(why)}"
        case Undecided(budget):
            return f"undecided after {budget} collapses"
        case _:
            assert_never(answer)


def _proof(why: WrongHomology | Stuck | Exhausted) -> str:
    match why:
        case WrongHomology(numbers):
            return f"the Betti numbers over GF(2) are {', '.join(map(str, numbers)) or 'none'}"
        case Stuck(()):
            return "no collapse can begin"
        case Stuck(moves):
            return f"{len(moves)} collapses lead to where there is no more, and order is free"
        case Exhausted(complexes):
            return f"no order of collapses does, through {complexes} complexes"
        case _:
            assert_never(why)
