"""All small surfaces in the order of their size: where a counterexample is smallest, it is here."""

from collections.abc import Iterator
from functools import cache

from clers.complexes.surface import Surface
from clers.generate.exhaustive import connected_surfaces, rooted_surfaces


@cache
def small_surfaces(most_faces: int) -> tuple[tuple[int, tuple[Surface, ...]], ...]:
    """For each connected surface up to so many faces: how many, and it begun at each gate."""
    found = sorted(connected_surfaces(most_faces), key=lambda faces: (len(faces), faces))
    return tuple((len(faces), tuple(rooted_surfaces(faces))) for faces in found)


def from_every_gate(most_faces: int) -> Iterator[Surface]:
    """Every connected surface up to so many faces, begun at every gate, small ones first."""
    return (begun for _, all_begun in small_surfaces(most_faces) for begun in all_begun)
