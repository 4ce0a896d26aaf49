"""Does a complex have the homology of a sphere or of a ball? What refutes, and never proves.

Also the definition of low-dimensional manifolds that knows no classification: CPLX-MANIFOLD-4.
"""

from collections.abc import Callable
from enum import StrEnum

from clers.complexes.homology import Field, betti
from clers.complexes.integral import Group, homology_over_z
from clers.complexes.simplicial import Complex, Simplex, boundary, dimension, link

Groups = tuple[Group, ...]
Reading = Callable[[Complex], Groups]
"""H_0 … H_n of a complex, over the integers or over a field, where there is no torsion."""


class Looks(StrEnum):
    """What the homology of a complex and of its boundary is. Clause: CPLX-SPHERE-3."""

    SPHERE = "sphere"
    BALL = "ball"
    NEITHER = "neither"


def over_gf2(k: Complex) -> Groups:
    """Over the field of two elements alone: enough up to dimension 3. Clause: CPLX-MANIFOLD-4."""
    return tuple(Group(b, ()) for b in betti(k, Field.GF2))


def looks(k: Complex, d: int, reading: Reading = homology_over_z) -> Looks:
    """Compare with a sphere and a ball of dimension d. Clause: CPLX-SPHERE-3.

    A sphere has the homology of a sphere and an empty boundary; a ball has the homology of a point,
    and its boundary that of a sphere of dimension d−1.
    """
    inside, outside = reading(k), reading(boundary(k))
    if inside == _sphere(d) and outside == ():
        return Looks.SPHERE
    if inside == _point(d) and outside == _sphere(d - 1):
        return Looks.BALL
    return Looks.NEITHER


def _point(d: int) -> Groups:
    return tuple(Group(int(m == 0), ()) for m in range(d + 1))


def _sphere(d: int) -> Groups:
    """The empty complex is the sphere of dimension −1; the sphere of dimension 0 is two points."""
    return tuple(Group(int(m == 0) + int(m == d), ()) for m in range(d + 1))


def suspect(k: Complex, simplex: Simplex, reading: Reading = homology_over_z) -> bool:
    """Does the link of a simplex look like neither? CPLX-MANIFOLD-4, CPLX-MANIFOLD-6."""
    d = dimension(k) - len(simplex)
    return looks(link(k, simplex), d, reading) is Looks.NEITHER


def is_manifold_by_homology(k: Complex) -> bool:
    """The definition for dimension 3 at most, by ranks over GF(2) alone: CPLX-MANIFOLD-4.

    In dimension 2 these are the surfaces of CPLX-SURFACE-1: CPLX-MANIFOLD-11.
    """
    return not any(suspect(k, simplex, over_gf2) for simplex in k.simplices)
