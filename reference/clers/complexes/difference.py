"""The first difference between two surfaces that their profiles show, in words."""

from collections import Counter
from collections.abc import Iterator, Sequence
from enum import StrEnum
from typing import Final

from clers.complexes.profile import Profile


class Difference(StrEnum):
    """What two surfaces may first differ in, in the order of CPLX-ISO-7."""

    FACES = "faces"
    VERTICES = "vertices"
    COMPONENTS = "components"
    COUNTS = "counts"
    CURVES = "curves"
    VALENCES = "valences"
    KINDS = "kinds"
    WALKS = "walks"


COUNTED: Final = ("faces", "vertices", "edges", "boundary edges", "curves", "handles")


def first_difference(
    first: Sequence[Profile], second: Sequence[Profile]
) -> tuple[Difference, str] | None:
    """The first difference between two lists of components; None if all but the walks is equal.

    Clause: CPLX-ISO-7.
    """
    for what, index in ((Difference.FACES, 0), (Difference.VERTICES, 1)):
        n, m = (sum(profile.counts[index] for profile in side) for side in (first, second))
        if n != m:
            return what, f"{n} {what} against {m}"
    if len(first) != len(second):
        return Difference.COMPONENTS, f"{len(first)} components against {len(second)}"
    for level, what in enumerate(LEVELS):
        if Counter(_known(p, level) for p in first) != Counter(_known(p, level) for p in second):
            return what, _in_words(what, first, second)
    return None


LEVELS: Final = (Difference.COUNTS, Difference.CURVES, Difference.VALENCES, Difference.KINDS)


def _known(profile: Profile, level: int) -> tuple[object, ...]:
    """A profile up to a level."""
    return (profile.counts, profile.curves, profile.valences, profile.kinds)[: level + 1]


def _in_words(what: Difference, first: Sequence[Profile], second: Sequence[Profile]) -> str:
    """The first thing that occurs another number of times; if none does, it is how they spread."""
    n_of, m_of = _census(what, first), _census(what, second)
    for thing in sorted(n_of | m_of):
        if n_of[thing] != m_of[thing]:
            return f"{thing}: {n_of[thing]} against {m_of[thing]}"
    return f"the same {what}, but otherwise spread over the components"


def _census(what: Difference, profiles: Sequence[Profile]) -> Counter[str]:
    """How often each thing of a level occurs in the whole surface."""
    census: Counter[str] = Counter()
    for profile in profiles:
        for thing, count in _things(what, profile):
            census[thing] += count
    return census


def _things(what: Difference, profile: Profile) -> Iterator[tuple[str, int]]:
    if what == Difference.COUNTS:
        counts = zip(profile.counts, COUNTED, strict=True)
        yield "component with " + ", ".join(f"{n} {name}" for n, name in counts), 1
    elif what == Difference.CURVES:
        yield from ((f"curve of {length} edges", n) for length, n in profile.curves)
    elif what == Difference.VALENCES:
        yield from ((_vertex(valence), n) for valence, n in profile.valences)
    else:
        yield from (
            (f"corner at {_vertex(a)}, then {_vertex(b)}, then {_vertex(c)}", n)
            for (a, b, c), n in profile.kinds
        )


def _vertex(valence: int) -> str:
    """A vertex of so many faces; the number is negative on the boundary."""
    return f"inner vertex of {valence}" if valence > 0 else f"border vertex of {-valence}"
