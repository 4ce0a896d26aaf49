"""Laws of repairs: nothing on good meshes, the fault gone on others, and nothing else changed."""

from collections.abc import Callable
from itertools import permutations
from typing import Final

from clers.complexes.corner_table import face_list, surface
from clers.complexes.definition import first_fault, is_orientable
from clers.complexes.face_list import FaceList
from clers.complexes.given import CROSSCAPPED, FACE_LISTS, REPAIRABLE, SURFACES
from clers.complexes.repair import (
    GONE,
    Copied,
    Dropped,
    Repaired,
    Turned,
    drop_isolated,
    orient,
    split_pinched,
    then,
)
from clers.complexes.simplicial import closure, link, of_dimension, pieces
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds, Verdict
from clers.conventions.where import AtFace, AtVertex

Repair = Callable[[FaceList], Accepted[Repaired] | Rejected]

REPAIRS: Final[tuple[Repair, ...]] = (orient, split_pinched, drop_isolated)

BEFORE_NEIGHBOURS: Final = (
    Reason.EMPTY_MESH,
    Reason.TOO_MANY_FACES,
    Reason.TOO_MANY_VERTICES,
    Reason.INDEX_OUT_OF_RANGE,
    Reason.REPEATED_INDEX,
    Reason.DUPLICATE_FACE,
    Reason.EDGE_WITH_THREE_FACES,
)
"""The reasons of CPLX-REJECT-1 … CPLX-REJECT-6."""


def _is_named(fault: Rejected | None, *reasons: Reason) -> bool:
    return fault is not None and fault.reason in reasons


def _nothing(of: Surface) -> Verdict:
    given = face_list(of)
    all_vertices = tuple(range(of.vertices))
    unchanged = Accepted(Repaired(given, all_vertices, all_vertices, ()))
    return every(*(same(unchanged, repair(given)) for repair in REPAIRS))


def _again(given: FaceList) -> Verdict:
    verdicts: list[Verdict] = []
    for repair in REPAIRS:
        once = repair(given)
        if isinstance(once, Accepted):
            twice = repair(once.value.face_list)
            acted = twice.value.actions if isinstance(twice, Accepted) else (twice,)
            verdicts += [same((), acted), _tells_where_from(given, once.value)]
    return every(*verdicts)


def _tells_where_from(given: FaceList, repaired: Repaired) -> Verdict:
    """Source and target name vertices of the two face lists, and agree."""
    new = repaired.face_list
    kept = tuple(v if to != GONE else GONE for v, to in enumerate(repaired.target))
    back = tuple(GONE if to == GONE else repaired.source[to] for to in repaired.target)
    return every(
        same((new.vertices, given.vertices), (len(repaired.source), len(repaired.target))),
        same(len(given.faces), len(new.faces)),
        same(kept, back),
        *(
            same(set(old), {repaired.source[v] for v in face}, AtFace(t))
            for t, (old, face) in enumerate(zip(given.faces, new.faces, strict=True))
        ),
    )


def _oriented(given: FaceList) -> Verdict:
    answer, fault = orient(given), first_fault(given)
    if _is_named(fault, *BEFORE_NEIGHBOURS):
        return _same_fault(fault, answer)
    if isinstance(answer, Rejected):
        return same((Reason.NON_ORIENTABLE, False), (answer.reason, is_orientable(given)))
    faces = answer.value.face_list.faces
    turned = {action.face for action in answer.value.actions if isinstance(action, Turned)}
    expected = tuple(
        (a, c, b) if t in turned else (a, b, c) for t, (a, b, c) in enumerate(given.faces)
    )
    after = first_fault(answer.value.face_list)
    lowest = {min(part) for part in _neighbourhoods(given)}
    return every(
        same(expected, faces),
        same(False, _is_named(after, Reason.EDGE_TWICE_IN_ONE_DIRECTION)),
        same(set(), turned & lowest),
        same(True, is_orientable(given)),
    )


def _same_fault(fault: Rejected | None, answer: Accepted[Repaired] | Rejected) -> Verdict:
    if fault is None or isinstance(answer, Accepted):
        return same(fault, answer)
    expected = (fault.reason, fault.clause, fault.where)
    return same(expected, (answer.reason, answer.clause, answer.where))


def _neighbourhoods(given: FaceList) -> list[set[int]]:
    """The sets of faces joined across edges, by merging until nothing merges."""
    parts: list[set[int]] = []
    for t, face in enumerate(given.faces):
        edges = [s for s in closure([face]).simplices if len(s) == 2]
        met = [p for p in parts if any(e <= set(given.faces[u]) for u in p for e in edges)]
        parts = [p for p in parts if p not in met] + [{t}.union(*met)]
    return parts


def _blamed(given: FaceList) -> Verdict:
    answer = orient(given)
    if not (isinstance(answer, Rejected) and answer.reason == Reason.NON_ORIENTABLE):
        return Holds()
    t = next(n for n in range(1, len(given.faces) + 1) if not is_orientable(_first(given, n))) - 1
    return same((Clause.CPLX_REPAIR_3, AtFace(t)), (answer.clause, answer.where))


def _first(given: FaceList, faces: int) -> FaceList:
    return FaceList(given.faces[:faces], given.vertices)


def _split(given: FaceList) -> Verdict:
    answer, fault = split_pinched(given), first_fault(given)
    if _is_named(fault, *BEFORE_NEIGHBOURS):
        return _same_fault(fault, answer)
    if isinstance(answer, Rejected):
        return same(None, answer)
    new, source = answer.value.face_list, answer.value.source
    k = closure(given.faces)
    fans = [len(pieces(link(k, frozenset([v])))) for v in range(given.vertices)]
    copies = tuple(v for v, count in enumerate(fans) for _ in range(count - 1))
    lowest = [
        min((t for t, f in enumerate(new.faces) if v in f), default=-1) for v in range(new.vertices)
    ]
    order = [(v, lowest[w]) for w, v in enumerate(source)]
    n = given.vertices
    return every(
        same(given.faces, tuple((source[a], source[b], source[c]) for a, b, c in new.faces)),
        same((*range(n), *copies), source),
        same(tuple(Copied(v, n + i) for i, v in enumerate(copies)), answer.value.actions),
        same(sorted(order[n:]), order[n:]),
        *(same(True, lowest[v] < t, AtVertex(v)) for v, t in order[n:]),
        same(False, _is_named(first_fault(new), Reason.PINCHED_VERTEX)),
    )


def _dropped(given: FaceList) -> Verdict:
    answer, fault = drop_isolated(given), first_fault(given)
    if _is_named(fault, *BEFORE_NEIGHBOURS[:4]):
        return _same_fault(fault, answer)
    if isinstance(answer, Rejected):
        return same(None, answer)
    used = tuple(v for s in of_dimension(closure(given.faces), 0) for v in s)
    new, source = answer.value.face_list, answer.value.source
    return every(
        same(used, source),
        same(given.faces, tuple((source[a], source[b], source[c]) for a, b, c in new.faces)),
        same(
            tuple(Dropped(v) for v in range(given.vertices) if v not in used),
            answer.value.actions,
        ),
        same(False, _is_named(first_fault(new), Reason.ISOLATED_VERTEX)),
    )


def _in_turn(given: FaceList, repairs: tuple[Repair, ...]) -> Accepted[Repaired] | Rejected:
    """Some repairs, one after the other, as one."""
    vertices = tuple(range(given.vertices))
    done: Accepted[Repaired] | Rejected = Accepted(Repaired(given, vertices, vertices, ()))
    for repair in repairs:
        if isinstance(done, Rejected):
            return done
        more = repair(done.value.face_list)
        done = Accepted(then(done.value, more.value)) if isinstance(more, Accepted) else more
    return done


def _all_three(given: FaceList) -> Verdict:
    answers = [_in_turn(given, order) for order in permutations(REPAIRS)]
    first = answers[0]
    if isinstance(first, Rejected):
        return every(*(same(True, isinstance(answer, Rejected)) for answer in answers))
    outcomes = [
        (answer.value.face_list, answer.value.source, answer.value.target)
        if isinstance(answer, Accepted)
        else answer.line()
        for answer in answers
    ]
    return every(
        same(True, isinstance(surface(first.value.face_list), Accepted)),
        *(same(outcomes[0], outcome) for outcome in outcomes),
        _tells_where_from(given, first.value),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "repairing-a-surface-does-nothing",
        Clause.CPLX_REPAIR_1,
        "Each repair answers a good face list with itself and with no action.",
        SURFACES,
        _nothing,
    ),
    Law(
        "repairing-again-does-nothing",
        Clause.CPLX_REPAIR_1,
        "A repair of what it has repaired acts no more; source and target agree with the faces.",
        REPAIRABLE,
        _again,
    ),
    Law(
        "orienting-turns-faces-until-neighbours-agree",
        Clause.CPLX_REPAIR_2,
        "Orienting only turns over the faces it names, never the lowest of those that hang "
        "together, and no edge is run twice afterwards.",
        REPAIRABLE,
        _oriented,
    ),
    Law(
        "orientable-exactly-if-a-rational-chain-closes",
        Clause.CPLX_ORIENT_2,
        "Orienting is refused exactly for the faults of CPLX-REJECT-1 to -6 and where homology "
        "shows fewer orientations than sets of neighbours.",
        CROSSCAPPED,
        _oriented,
    ),
    Law(
        "orienting-any-face-list",
        Clause.CPLX_ORIENT_1,
        "So it is on any face list, whatever else is wrong with it.",
        FACE_LISTS,
        _oriented,
    ),
    Law(
        "face-that-completes-a-one-sided-strip-is-blamed",
        Clause.CPLX_REPAIR_3,
        "The faces before the blamed one are orientable, and with it they are not.",
        CROSSCAPPED,
        _blamed,
    ),
    Law(
        "splitting-gives-each-fan-a-vertex",
        Clause.CPLX_REPAIR_4,
        "Each fan but the lowest gets a copy, numbered by vertices and then by lowest faces; read "
        "through the copies the faces are what they were.",
        REPAIRABLE,
        _split,
    ),
    Law(
        "splitting-any-face-list",
        Clause.CPLX_REPAIR_4,
        "So it is on any face list, or it is rejected by one of CPLX-REJECT-1 to CPLX-REJECT-6.",
        FACE_LISTS,
        _split,
    ),
    Law(
        "dropping-leaves-used-vertices-in-order",
        Clause.CPLX_REPAIR_5,
        "Dropping keeps exactly the vertices that faces name, in their order.",
        FACE_LISTS,
        _dropped,
    ),
    Law(
        "three-repairs-make-a-surface-in-any-order",
        Clause.CPLX_REPAIR_6,
        "The three repairs in each of six orders give one face list, and it is a surface; or each "
        "order ends in a rejection.",
        REPAIRABLE,
        _all_three,
    ),
)
