"""The first difference of two surfaces as sets and counting show it: CPLX-ISO-7 read aloud."""

from typing import Final

from clers.complexes.difference import Difference
from clers.complexes.face_list import FaceList
from clers.complexes.simplicial import Complex, boundary, closure, of_dimension, pieces, star

IN_ORDER: Final = (
    Difference.FACES,
    Difference.VERTICES,
    Difference.COMPONENTS,
    Difference.COUNTS,
    Difference.CURVES,
    Difference.VALENCES,
    Difference.KINDS,
)
"""All but the walks."""


def first_difference_by_definition(first: FaceList, second: FaceList) -> Difference | None:
    """The first of CPLX-ISO-7's differences but the walks, or None if all those are equal."""
    pairs = zip(IN_ORDER, _seen(first), _seen(second), strict=True)
    return next((what for what, one, other in pairs if one != other), None)


def _seen(given: FaceList) -> tuple[str, ...]:
    """What is compared, in the order of comparing, each printed."""
    parts = [_of_piece(given, piece) for piece in pieces(closure(given.faces))]
    levels = (sorted(part[: level + 1] for part in parts) for level in range(4))
    totals = (len(given.faces), given.vertices, len(parts))
    return (*map(str, totals), *map(str, levels))


def _of_piece(given: FaceList, piece: Complex) -> tuple[str, str, str, str]:
    """Counts, lengths of curves, valences of vertices, and valences around corners, printed."""
    rim = boundary(piece)
    loops = pieces(rim)
    triangles = frozenset(of_dimension(piece, 2))
    valence = {
        v: (len(star(piece, point) & triangles), point in rim.simplices)
        for point in of_dimension(piece, 0)
        for v in point
    }
    faces = [face for face in given.faces if frozenset(face) in triangles]
    turns = [turn for a, b, c in faces for turn in ((a, b, c), (b, c, a), (c, a, b))]
    counts = [len(of_dimension(piece, m)) for m in range(3)]
    return (
        str([*counts, len(of_dimension(rim, 1)), len(loops)]),
        str(sorted(len(of_dimension(loop, 1)) for loop in loops)),
        str(sorted(valence.values())),
        str(sorted((valence[a], valence[b], valence[c]) for a, b, c in turns)),
    )
