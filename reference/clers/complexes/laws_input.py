"""Laws of reading: the corner table accepts and rejects what the definition does, and is sound."""

from typing import Final

from clers.complexes.corner_table import by_clauses, face_list, surface, surface_of_indices
from clers.complexes.definition import first_fault, is_coherent_surface, is_surface, sides
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.fans import fans
from clers.complexes.given import FACE_LISTS, REPAIRABLE, SMALL_SURFACES, SURFACES
from clers.complexes.index_list import buffered, listed_faces
from clers.complexes.matching import mates
from clers.complexes.simplicial import closure, link, pieces
from clers.complexes.surface import (
    BORDER,
    Corner,
    Surface,
    face_of,
    next_corner,
    previous_corner,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtFace, AtVertex
from clers.kernels.table import WORD


def _fault(given: FaceList) -> Verdict:
    expected = first_fault(given)
    got = surface(given)
    match got:
        case Accepted():
            return (
                Holds() if expected is None else Fails(expected.line(), "accepted", expected.where)
            )
        case Rejected():
            if expected is None:
                return Fails("accepted", got.line(), got.where)
            return same(
                (expected.reason, expected.clause, expected.where),
                (got.reason, got.clause, got.where),
                expected.where,
            )


def _by_clauses(given: FaceList) -> Verdict:
    return same(by_clauses(given), surface(given))


def _in_words(given: FaceList) -> bool:
    """Whether the numbers go into an index list."""
    return all(0 <= v <= WORD for face in given.faces for v in face)


def _buffered(given: FaceList) -> Verdict:
    return same(given, listed_faces(buffered(given))) if _in_words(given) else Holds()


def _indices(given: FaceList) -> Verdict:
    if not _in_words(given):
        return Holds()
    return same(surface(given), surface_of_indices(buffered(given)))


def _accepted(given: FaceList) -> Verdict:
    return same(is_coherent_surface(given), isinstance(surface(given), Accepted))


def _numbers(given: FaceList) -> Verdict:
    built = surface(given)
    return same(given, face_list(built.value)) if isinstance(built, Accepted) else Holds()


def _limits(of: Surface) -> Verdict:
    given = face_list(of)
    few_faces = surface(given, Limits(of.faces - 1, of.vertices))
    few_vertices = surface(given, Limits(of.faces, of.vertices - 1))
    return every(
        same(Accepted(of), surface(given, Limits(of.faces, of.vertices))),
        same(Reason.TOO_MANY_FACES, few_faces.reason if isinstance(few_faces, Rejected) else None),
        same(
            Reason.TOO_MANY_VERTICES,
            few_vertices.reason if isinstance(few_vertices, Rejected) else None,
        ),
    )


def _is_surface(of: Surface) -> Verdict:
    return same(True, is_surface(closure(of.triangles())))


def _oriented(of: Surface) -> Verdict:
    runs = [(side.tail, side.head) for side in sides(face_list(of))]
    return same(len(runs), len(set(runs)))


def _fans(given: FaceList) -> Verdict:
    matched = mates(given, DEFAULT_LIMITS)
    if isinstance(matched, Rejected):
        return Holds()
    vertex = [v for face in given.faces for v in face]
    heads = [vertex[c] for c, lowest in enumerate(fans(vertex, matched.value)) if c == lowest]
    k = closure(given.faces)
    return every(
        *(
            same(len(pieces(link(k, frozenset([v])))), heads.count(v), AtVertex(v))
            for v in range(given.vertices)
        )
    )


def _turns(of: Surface) -> Verdict:
    return every(
        *(
            same((c, c, face_of(c)), (next_corner(previous_corner(c)), thrice, face_of(after)))
            for c in _corners(of)
            for after in [next_corner(c)]
            for thrice in [next_corner(next_corner(after))]
        )
    )


def _corners(of: Surface) -> list[Corner]:
    return [Corner(c) for c in range(len(of.vertex))]


def _edge(of: Surface, c: Corner) -> tuple[int, int]:
    return of.vertex[next_corner(c)], of.vertex[previous_corner(c)]


def _opposites(of: Surface) -> Verdict:
    runs = {_edge(of, c) for c in _corners(of)}
    for c in _corners(of):
        d, (tail, head), at = of.opposite[c], _edge(of, c), AtFace(face_of(c))
        if d == BORDER:
            verdict = same(False, (head, tail) in runs, at)
        else:
            verdict = every(
                same(c, of.opposite[d], at),
                same((head, tail), _edge(of, d), at),
                same(True, face_of(c) != face_of(d) and of.vertex[c] != of.vertex[d], at),
            )
        if isinstance(verdict, Fails):
            return verdict
    return Holds()


def _swings(of: Surface) -> Verdict:
    at: dict[int, set[Corner]] = {}
    for c in _corners(of):
        at.setdefault(of.vertex[c], set()).add(c)
    for first in _corners(of):
        around, closed = _orbit(of, first)
        v = of.vertex[first]
        verdict = every(
            same(sorted(at[v]), sorted(around), AtVertex(v)),
            same(closed, all(of.opposite[next_corner(c)] != BORDER for c in at[v]), AtVertex(v)),
        )
        if isinstance(verdict, Fails):
            return verdict
    return Holds()


def _orbit(of: Surface, first: Corner) -> tuple[list[Corner], bool]:
    """The corners that swings reach, each as often as it is met; and whether they close up."""
    around, c = [first], first
    while (d := of.opposite[next_corner(c)]) != BORDER and len(around) <= len(of.vertex):
        c = next_corner(d)
        if c == first:
            return around, True
        around.append(c)
    c = first
    while (d := of.opposite[previous_corner(c)]) != BORDER and len(around) <= len(of.vertex):
        c = previous_corner(d)
        around.append(c)
    return around, False


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "accepts-and-rejects-as-defined",
        Clause.CPLX_INPUT_2,
        "The linear reading and the definition agree on every face list: accepted by both, or "
        "rejected by both for one reason, by one clause, at one element.",
        FACE_LISTS,
        _fault,
    ),
    Law(
        "kernels-accept-what-clauses-accept",
        Clause.TOOL_BUILD_6,
        "By sorting comes the corner table that comes by the clauses one after another.",
        FACE_LISTS,
        _by_clauses,
    ),
    Law(
        "index-lists-are-face-lists",
        Clause.CPLX_INPUT_5,
        "A face list in a buffer, read again, is the same face list.",
        FACE_LISTS,
        _buffered,
    ),
    Law(
        "index-lists-are-judged-as-face-lists",
        Clause.CPLX_INPUT_6,
        "An index list has the surface of its face list, or is rejected for the same reason there.",
        FACE_LISTS,
        _indices,
    ),
    Law(
        "repairable-index-lists-are-judged-as-face-lists",
        Clause.CPLX_INPUT_6,
        "So it is where faces are turned over, vertices pinched together or not used.",
        REPAIRABLE,
        _indices,
    ),
    Law(
        "kernels-refuse-what-clauses-refuse",
        Clause.TOOL_BUILD_6,
        "So it is where faces are turned over, vertices pinched together or not used.",
        REPAIRABLE,
        _by_clauses,
    ),
    Law(
        "accepts-exactly-oriented-surfaces",
        Clause.CPLX_INPUT_4,
        "A face list is accepted exactly if its closure is a surface, oriented, with each vertex "
        "used and no triangle twice.",
        FACE_LISTS,
        _accepted,
    ),
    Law(
        "repairable-faults-are-named-as-defined",
        Clause.CPLX_REJECT_7,
        "So it is where faces are turned over, vertices pinched together or not used.",
        REPAIRABLE,
        _fault,
    ),
    Law(
        "repairable-face-lists-are-told-from-surfaces",
        Clause.CPLX_INPUT_4,
        "A surface with faces turned over, vertices pinched together or not used is accepted "
        "exactly if it is an oriented surface still.",
        REPAIRABLE,
        _accepted,
    ),
    Law(
        "numbers-are-kept",
        Clause.CPLX_INPUT_1,
        "An accepted face list is the face list of its surface.",
        FACE_LISTS,
        _numbers,
    ),
    Law(
        "limits-are-kept",
        Clause.CPLX_INPUT_3,
        "A surface is accepted at its own size, and rejected by a limit one below it.",
        SURFACES,
        _limits,
    ),
    Law(
        "links-are-circles-and-arcs",
        Clause.CPLX_SURFACE_1,
        "The triangles of a surface close up to a pure complex whose links are circles or arcs.",
        SMALL_SURFACES,
        _is_surface,
    ),
    Law(
        "no-edge-is-run-twice",
        Clause.CPLX_SURFACE_2,
        "No two faces of a surface run an edge in the same direction.",
        SURFACES,
        _oriented,
    ),
    Law(
        "fans-are-the-pieces-of-links",
        Clause.CPLX_SURFACE_3,
        "Where every edge has two faces at most, a vertex has as many fans as its link has pieces.",
        FACE_LISTS,
        _fans,
    ),
    Law(
        "corners-turn-within-their-face",
        Clause.CPLX_CORNER_1,
        "Three turns of `next` are none, `previous` undoes `next`, and both keep the face.",
        SURFACES,
        _turns,
    ),
    Law(
        "border-corners-have-no-opposite",
        Clause.CPLX_CORNER_2,
        "A corner is opposite to BORDER exactly if no face runs its edge the other way.",
        SURFACES,
        _opposites,
    ),
    Law(
        "opposite-is-an-involution",
        Clause.CPLX_CORNER_3,
        "The opposite of the opposite is the corner; the two are in two faces, at two vertices, "
        "and run their edge in opposite directions.",
        SURFACES,
        _opposites,
    ),
    Law(
        "swings-reach-each-corner-of-a-vertex-once",
        Clause.CPLX_CORNER_4,
        "From any corner, swings reach all corners of its vertex, each once, in a cycle or a path.",
        SMALL_SURFACES,
        _swings,
    ),
)
