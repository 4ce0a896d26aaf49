"""The random spheres that codes are measured on."""

from clers.complexes.corner_table import surface
from clers.complexes.surface import Surface
from clers.generate.irregular import irregular_sphere
from clers.measure.path import must


def random_sphere(faces: int, seed: int) -> Surface:
    """A sphere of `faces` faces (even, ≥ 4); the same for the same arguments."""
    return must(surface(irregular_sphere(faces, seed)))
