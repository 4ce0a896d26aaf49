"""The random spheres that codes are measured on."""

from clers.complexes.surface import Surface
from clers.generate.uniform import uniform_sphere


def random_sphere(faces: int, seed: int) -> Surface:
    """A sphere of `faces` faces (even, ≥ 4), all as likely; the same for the same arguments.

    T = 2V − 4. Clauses: TOOL-BITS-8, TOOL-BITS-10.
    """
    return uniform_sphere(faces // 2 + 2, seed)
