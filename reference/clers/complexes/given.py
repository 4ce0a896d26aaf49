"""The domains that laws about surfaces range over; `clers.generate` draws from them."""

from typing import Final

from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.law import Given

Pair = tuple[Surface, Surface]

SURFACES: Final = Given(
    "surfaces", "oriented surfaces of any genus, curves and components", Surface
)
SMALL_SURFACES: Final = Given("small-surfaces", "the same, of few faces", Surface)
SPHERES: Final = Given("spheres", "closed connected surfaces of genus 0", Surface)
FACE_LISTS: Final = Given("face-lists", "face lists, good or slightly broken", FaceList)
REPAIRABLE: Final = Given(
    "repairable-face-lists",
    "surfaces with faces turned over, vertices pinched together, isolated vertices put between",
    FaceList,
)
CROSSCAPPED: Final = Given(
    "crosscapped-face-lists",
    "such face lists, most of them with cross-caps, which make them one-sided",
    FaceList,
)
RELABELLED: Final[Given[Pair]] = Given(
    "relabelled-surfaces", "a surface, and the same under other names", tuple
)
PAIRS: Final[Given[Pair]] = Given(
    "surface-pairs", "a surface, and the same, its mirror image, one a flip away, or any", tuple
)
TINY_PAIRS: Final[Given[Pair]] = Given(
    "tiny-surface-pairs", "such pairs with at most six vertices each", tuple
)
