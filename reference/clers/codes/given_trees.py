"""The domains of tree words and of spheres at random."""

from typing import Final

from clers.complexes.surface import Surface
from clers.conventions.law import Given

UNIFORM: Final = Given(
    "uniform-spheres", "rooted spheres, each of so many vertices as likely as any other", Surface
)
TREE_WORDS: Final = Given(
    "tree-words", "tree words of small spheres, most of them with a change or two", bytes
)
