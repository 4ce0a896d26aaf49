"""Faces that are no oriented surface: one case for each way to be none. CPLX-REJECT-1 … -9."""

from collections.abc import Iterator, Sequence
from typing import Final

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.oracle.negatives.draft import Draft, Slip, bad, good
from clers.oracle.positives.asked import needed

Face = tuple[int, int, int]

OPERATIONS: Final = ("surface.classify", "word.encode")


def built(*faces: Face) -> Surface:
    """A surface that is written down here. Clause: CPLX-INPUT-2."""
    match surface(FaceList(faces, 1 + max(max(face) for face in faces))):
        case Accepted(value):
            return value
        case other:
            raise Slip(other.line())


def parent(op: str, slug: str, of: Surface) -> Draft:
    """The case of a good surface."""
    given = form.Faces(faces=tuple(of.triangles()), vertices=of.vertices)
    clause = Clause.ORCL_OP_2 if op == "surface.classify" else Clause.ORCL_OP_5
    return good(
        slug, op, given, (Clause.CPLX_INPUT_2, clause),
        requires=needed(of), size=of.faces,
    )  # fmt: skip


TWO_DISKS: Final = built((0, 1, 2), (3, 4, 5))
TWO_BALLS: Final = built(
    (0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3), (4, 5, 6), (4, 7, 5), (5, 7, 6), (4, 6, 7)
)
FAN: Final = built((0, 1, 2), (0, 2, 3), (0, 3, 4))
"""Three faces around a vertex of the border."""
BOW: Final = built((0, 1, 2), (0, 3, 4), (0, 2, 5), (0, 5, 3))
"""Four faces around a vertex of the border, the outer two given first."""
BIPYRAMID: Final = built((0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4))

PARENTS: Final = (
    ("tetrahedron", TETRAHEDRON),
    ("triangle", TRIANGLE),
    ("cube", CUBE),
    ("torus", TORUS),
    ("annulus", ANNULUS),
    ("two-triangles", TWO_DISKS),
    ("two-tetrahedra", TWO_BALLS),
    ("fan", FAN),
    ("bow", BOW),
    ("bipyramid", BIPYRAMID),
)


def put(at: int, *faces: Face) -> Edit:
    """Faces put in."""
    return replaced("/faces", at, [], [list(face) for face in faces])


def taken(at: int, *faces: Face) -> Edit:
    """Faces taken out."""
    return replaced("/faces", at, [list(face) for face in faces], [])


def other(at: int, old: Face, new: Sequence[int | str]) -> Edit:
    """A face exchanged for another."""
    return replaced("/faces", at, [list(old)], [list(new)])


def count(old: int, new: int | str) -> Edit:
    """Another number of vertices."""
    return replaced("/vertices", 0, old, new)


def drafts() -> Iterator[Draft]:
    """Good surfaces, and faults in them, each asked twice. Clauses: ORCL-OP-2, ORCL-OP-5."""
    for op in OPERATIONS:
        by_name = {name: parent(op, name, of) for name, of in PARENTS}
        yield from by_name.values()
        for name, kind, edits, reason, clause, flags in FAULTS:
            yield bad(by_name[name], kind, edits, reason, clause, flags=flags)


C = Clause
R = Reason
Row = tuple[str, str, tuple[Edit, ...], Reason, Clause, tuple[str, ...]]

FAULTS: Final[tuple[Row, ...]] = (
    ("triangle", "no-face", (taken(0, (0, 1, 2)), count(3, 0)),
     R.EMPTY_MESH, C.CPLX_REJECT_1, ("empty-input",)),
    ("tetrahedron", "vertices-over-limit", (count(4, (1 << 26) + 1),),
     R.TOO_MANY_VERTICES, C.CPLX_REJECT_2, ("size-trusted",)),
    ("tetrahedron", "vertices-beyond-64-bits", (count(4, str(1 << 64)),),
     R.TOO_MANY_VERTICES, C.CPLX_REJECT_2, ("integer-wraps", "size-trusted")),
    ("tetrahedron", "index-is-count", (other(2, (1, 3, 2), (1, 4, 2)),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("index-off-by-one",)),
    ("tetrahedron", "count-too-low", (count(4, 3),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("index-off-by-one",)),
    ("tetrahedron", "no-vertices", (count(4, 0),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("index-off-by-one",)),
    ("tetrahedron", "vertices-negative", (count(4, -4),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("negative-number",)),
    ("tetrahedron", "index-negative", (other(0, (0, 1, 2), (0, 1, -1)),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("negative-number",)),
    ("tetrahedron", "index-wraps-at-8-bits", (other(0, (0, 1, 2), (256, 1, 2)),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("integer-wraps",)),
    ("tetrahedron", "index-wraps-at-16-bits", (other(0, (0, 1, 2), (0, 65537, 2)),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("integer-wraps",)),
    ("tetrahedron", "index-wraps-at-32-bits", (other(0, (0, 1, 2), (0, 1, (1 << 32) + 2)),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("integer-wraps",)),
    ("tetrahedron", "index-wraps-at-64-bits", (other(0, (0, 1, 2), (0, 1, str((1 << 64) + 2))),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("integer-wraps",)),
    ("tetrahedron", "index-wraps-negative-at-64-bits",
     (other(0, (0, 1, 2), (0, 1, str(2 - (1 << 64)))),),
     R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, ("integer-wraps", "negative-number")),
    ("tetrahedron", "first-and-second-vertex-one", (other(1, (0, 3, 1), (0, 0, 1)),),
     R.REPEATED_INDEX, C.CPLX_REJECT_4, ("degenerate-face",)),
    ("tetrahedron", "second-and-third-vertex-one", (other(1, (0, 3, 1), (0, 3, 3)),),
     R.REPEATED_INDEX, C.CPLX_REJECT_4, ("degenerate-face",)),
    ("tetrahedron", "first-and-third-vertex-one", (other(1, (0, 3, 1), (0, 3, 0)),),
     R.REPEATED_INDEX, C.CPLX_REJECT_4, ("degenerate-face",)),
    ("cube", "degenerate-face-added", (put(12, (7, 7, 7)),),
     R.REPEATED_INDEX, C.CPLX_REJECT_4, ("degenerate-face",)),
    ("cube", "degenerate-face-first", (put(0, (0, 0, 1)),),
     R.REPEATED_INDEX, C.CPLX_REJECT_4, ("degenerate-face",)),
    ("tetrahedron", "face-twice", (put(4, (0, 2, 3)),),
     R.DUPLICATE_FACE, C.CPLX_REJECT_5, ("duplicate-face",)),
    ("triangle", "face-twice-turned", (put(1, (1, 2, 0)),),
     R.DUPLICATE_FACE, C.CPLX_REJECT_5, ("duplicate-face",)),
    ("triangle", "face-and-its-mirror-image", (put(1, (0, 2, 1)),),
     R.DUPLICATE_FACE, C.CPLX_REJECT_5, ("duplicate-face", "two-sided-triangle")),
    ("bipyramid", "wall-inside", (put(6, (0, 1, 2)),),
     R.EDGE_WITH_THREE_FACES, C.CPLX_REJECT_6, ("non-manifold-edge",)),
    ("fan", "third-face-at-an-edge", (put(3, (2, 0, 5)), count(5, 6)),
     R.EDGE_WITH_THREE_FACES, C.CPLX_REJECT_6, ("non-manifold-edge",)),
    ("tetrahedron", "face-turned-over", (other(3, (0, 2, 3), (0, 3, 2)),),
     R.EDGE_TWICE_IN_ONE_DIRECTION, C.CPLX_REJECT_7, ("orientation-ignored",)),
    ("fan", "middle-face-turned-over", (other(1, (0, 2, 3), (0, 3, 2)),),
     R.EDGE_TWICE_IN_ONE_DIRECTION, C.CPLX_REJECT_7, ("orientation-ignored",)),
    ("fan", "last-face-turned-over", (other(2, (0, 3, 4), (0, 4, 3)),),
     R.EDGE_TWICE_IN_ONE_DIRECTION, C.CPLX_REJECT_7, ("orientation-ignored",)),
    ("torus", "face-turned-over", (other(17, (8, 0, 6), (0, 8, 6)),),
     R.EDGE_TWICE_IN_ONE_DIRECTION, C.CPLX_REJECT_7, ("orientation-ignored",)),
    ("two-triangles", "tips-are-one-vertex",
     (other(1, (3, 4, 5), (0, 3, 4)), count(6, 5)),
     R.PINCHED_VERTEX, C.CPLX_REJECT_8, ("pinched-vertex",)),
    ("two-tetrahedra", "joined-at-a-vertex",
     (other(4, (4, 5, 6), (3, 4, 5)), other(5, (4, 7, 5), (3, 6, 4)),
      other(6, (5, 7, 6), (4, 6, 5)), other(7, (4, 6, 7), (3, 5, 6)), count(8, 7)),
     R.PINCHED_VERTEX, C.CPLX_REJECT_8, ("pinched-vertex",)),
    ("bow", "fan-in-two", (taken(2, (0, 2, 5)), taken(2, (0, 5, 3)), count(6, 5)),
     R.PINCHED_VERTEX, C.CPLX_REJECT_8, ("pinched-vertex",)),
    ("tetrahedron", "one-vertex-more", (count(4, 5),),
     R.ISOLATED_VERTEX, C.CPLX_REJECT_9, ("isolated-vertex",)),
    ("triangle", "vertex-0-not-named", (other(0, (0, 1, 2), (1, 2, 3)), count(3, 4)),
     R.ISOLATED_VERTEX, C.CPLX_REJECT_9, ("isolated-vertex",)),
    ("triangle", "vertex-1-not-named", (other(0, (0, 1, 2), (0, 3, 2)), count(3, 4)),
     R.ISOLATED_VERTEX, C.CPLX_REJECT_9, ("isolated-vertex",)),
    ("annulus", "many-vertices-more", (count(6, 1000),),
     R.ISOLATED_VERTEX, C.CPLX_REJECT_9, ("isolated-vertex",)),
)  # fmt: skip
"""Parent, kind, edits, and why it is rejected. Clauses: CPLX-REJECT-1 … CPLX-REJECT-9."""
