"""The domains that laws about surfaces range over; `clers.generate` draws from them."""

from typing import Final

from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.law import Given

SURFACES: Final = Given(
    "surfaces", "oriented surfaces of any genus, curves and components", Surface
)
SMALL_SURFACES: Final = Given("small-surfaces", "the same, of forty faces at most", Surface)
SPHERES: Final = Given("spheres", "closed connected surfaces of genus 0", Surface)
FACE_LISTS: Final = Given("face-lists", "face lists, good or slightly broken", FaceList)
