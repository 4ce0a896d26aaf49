"""Repairs of face lists: separate, explicit, and each says what it did."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, assert_never

from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.fans import fans
from clers.complexes.matching import bad_counts, bad_range, edges_of, mates
from clers.complexes.parity import Parity
from clers.complexes.surface import BORDER
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtFace

GONE: Final = -1
"""The new number of a vertex that is no more."""


@dataclass(frozen=True, slots=True)
class Turned:
    """Face (a, b, c) became (a, c, b). Clause: CPLX-REPAIR-2."""

    face: int


@dataclass(frozen=True, slots=True)
class Copied:
    """New vertex `copy` stands for old vertex `vertex` in one of its fans. CPLX-REPAIR-4."""

    vertex: int
    copy: int


@dataclass(frozen=True, slots=True)
class Dropped:
    """Old vertex `vertex` is no more. Clause: CPLX-REPAIR-5."""

    vertex: int


Action = Turned | Copied | Dropped


@dataclass(frozen=True, slots=True)
class Repaired:
    """A new face list and how it came from the old. Clause: CPLX-REPAIR-1.

    `source[w]` is the old vertex that new vertex w stands for; `target[v]` the new number of old
    vertex v, or GONE.
    """

    face_list: FaceList
    source: tuple[int, ...]
    target: tuple[int, ...]
    actions: tuple[Action, ...]

    def sentence(self) -> str:
        """What was done, in one sentence; the elements by their numbers before this repair."""
        if not self.actions:
            return "Nothing to repair."
        shown = "; ".join(_in_words(action) for action in self.actions[:SHOWN])
        more = len(self.actions) - SHOWN
        return f"{shown}; and {more} more." if more > 0 else f"{shown}."


SHOWN: Final = 8
"""How many actions a sentence names."""


def _in_words(action: Action) -> str:
    match action:
        case Turned(face):
            return f"face {face} turned over"
        case Copied(vertex, copy):
            return f"vertex {vertex} copied as {copy}"
        case Dropped(vertex):
            return f"vertex {vertex} dropped"
        case _:
            assert_never(action)


def orient(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Accepted[Repaired] | Rejected:
    """Turn faces over so that neighbours agree, keeping the lowest of those that hang together.

    Almost linear. Clauses: CPLX-REPAIR-1, CPLX-REPAIR-2, CPLX-REPAIR-3.
    """
    matched = mates(given, limits)
    if isinstance(matched, Rejected):
        return matched
    tails, _ = edges_of([v for face in given.faces for v in face])
    parity = Parity(len(given.faces))
    for c, d in enumerate(matched.value):
        # Each edge at the later of its faces, so that the first contradiction is the lowest.
        if BORDER < d < c and not parity.unite(c // 3, d // 3, differ=tails[c] == tails[d]):
            detail = (
                f"whichever way it is turned, it disagrees with face {d // 3} or an earlier one"
            )
            where = AtFace(c // 3)
            return Rejected(Reason.NON_ORIENTABLE, Clause.CPLX_REPAIR_3, where, detail)
    turned = [parity.find(t)[1] for t in range(len(given.faces))]
    faces = tuple(
        (a, c, b) if turn else (a, b, c)
        for (a, b, c), turn in zip(given.faces, turned, strict=True)
    )
    same = tuple(range(given.vertices))
    actions = tuple(Turned(t) for t, turn in enumerate(turned) if turn)
    return Accepted(Repaired(FaceList(faces, given.vertices), same, same, actions))


def split_pinched(
    given: FaceList, limits: Limits = DEFAULT_LIMITS
) -> Accepted[Repaired] | Rejected:
    """Give each fan of a vertex but the first a copy of the vertex; linear but for sorting copies.

    Clauses: CPLX-REPAIR-1, CPLX-REPAIR-4.
    """
    matched = mates(given, limits)
    if isinstance(matched, Rejected):
        return matched
    vertex = [v for face in given.faces for v in face]
    fan = fans(vertex, matched.value)
    has_fan = bytearray(given.vertices)
    extra: list[tuple[int, int]] = []  # (vertex, lowest corner of the fan), for fans to be copied
    for c, lowest in enumerate(fan):
        if c == lowest:
            if has_fan[vertex[c]]:
                extra.append((vertex[c], c))
            has_fan[vertex[c]] = 1
    extra.sort()
    copy_of_fan = {c: given.vertices + i for i, (_, c) in enumerate(extra)}
    named = [copy_of_fan.get(lowest, v) for lowest, v in zip(fan, vertex, strict=True)]
    old = tuple(range(given.vertices))
    return Accepted(
        Repaired(
            FaceList(_triples(named), given.vertices + len(extra)),
            (*old, *(v for v, _ in extra)),
            old,
            tuple(Copied(v, copy_of_fan[c]) for v, c in extra),
        )
    )


def drop_isolated(
    given: FaceList, limits: Limits = DEFAULT_LIMITS
) -> Accepted[Repaired] | Rejected:
    """Remove the vertices that no face names. Linear. Clauses: CPLX-REPAIR-1, CPLX-REPAIR-5."""
    fault = bad_counts(given, limits) or bad_range(given)
    if fault is not None:
        return fault
    named = bytearray(given.vertices)
    for face in given.faces:
        for v in face:
            named[v] = 1
    source = tuple(v for v in range(given.vertices) if named[v])
    target = [GONE] * given.vertices
    for w, v in enumerate(source):
        target[v] = w
    faces = tuple((target[a], target[b], target[c]) for a, b, c in given.faces)
    dropped = tuple(Dropped(v) for v in range(given.vertices) if not named[v])
    return Accepted(Repaired(FaceList(faces, len(source)), source, tuple(target), dropped))


def _triples(corners: Sequence[int]) -> tuple[tuple[int, int, int], ...]:
    return tuple(zip(corners[0::3], corners[1::3], corners[2::3], strict=True))


def then(first: Repaired, second: Repaired) -> Repaired:
    """Two repairs, the second of what the first has made, as one.

    The actions of the second keep the numbers it was given. Clauses: CPLX-REPAIR-1, CPLX-REPAIR-6.
    """
    return Repaired(
        second.face_list,
        tuple(first.source[v] for v in second.source),
        tuple(GONE if w == GONE else second.target[w] for w in first.target),
        first.actions + second.actions,
    )
