"""Spheres and balls: recognised exactly up to dimension 2, and by homology never wrongly beyond."""

from typing import assert_never

from clers.complexes.manifolds.homology_type import Looks, looks
from clers.complexes.manifolds.incidence import components, flaw_at_a_wall, rim, vertex_links
from clers.complexes.manifolds.kind import (
    Ball,
    Flaw,
    LinkKind,
    Neither,
    Sphere,
    Undecided,
)
from clers.complexes.simplicial import Complex, dimension, euler, of_dimension


def recognise(k: Complex) -> LinkKind:
    """Sphere, ball or neither; undecided only from dimension 3 on.

    Linear up to dimension 2. Clauses: CPLX-SPHERE-1, CPLX-SPHERE-2, CPLX-SPHERE-3.
    """
    n = dimension(k)
    if n <= 0:
        return _points(len(of_dimension(k, 0)))
    fault = flaw_at_a_wall(k)
    if fault is not None:
        return Neither(fault.flaw)
    if n == 1:
        return _curve(k)
    return _surface(k) if n == 2 else _by_homology(k)


def _points(count: int) -> LinkKind:
    match count:
        case 0:
            return Sphere(-1)
        case 1:
            return Ball(0)
        case 2:
            return Sphere(0)
        case _:
            return Neither(Flaw.DISCONNECTED)


def _curve(k: Complex) -> LinkKind:
    """A graph with one edge or two at each vertex is a circle or an arc, if it is connected."""
    if len(components(k)) > 1:
        return Neither(Flaw.DISCONNECTED)
    return Ball(1) if rim(k).simplices else Sphere(1)


def _surface(k: Complex) -> LinkKind:
    """By the classification only the sphere has χ = 2, and with a boundary only the disc χ = 1."""
    if not all(isinstance(_curve(around), Sphere | Ball) for _, around in vertex_links(k)):
        return Neither(Flaw.BAD_LINK)
    if len(components(k)) > 1:
        return Neither(Flaw.DISCONNECTED)
    match euler(k), bool(rim(k).simplices):
        case 2, False:
            return Sphere(2)
        case 1, True:
            return Ball(2)
        case _:
            return Neither(Flaw.WRONG_HOMOLOGY)


def _by_homology(k: Complex) -> LinkKind:
    """Homology refutes; what it does not refute it leaves open. Clause: CPLX-SPHERE-3."""
    seen = looks(k, dimension(k))
    match seen:
        case Looks.NEITHER:
            return Neither(Flaw.WRONG_HOMOLOGY)
        case Looks.SPHERE | Looks.BALL:
            return Undecided(f"has the homology of a {seen.value}; no moves were tried")
        case _:
            assert_never(seen)
