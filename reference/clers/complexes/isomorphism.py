"""Are two surfaces the same but for names? With a certificate, or with the first difference."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from clers.complexes.canonical import Code, agreement, walk
from clers.complexes.difference import Difference, first_difference
from clers.complexes.profile import Kind, Profile, Profiled, corner_kinds, profiled
from clers.complexes.surface import Corner, Surface, Vertex, face_of, next_corner
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtFace


@dataclass(frozen=True, slots=True)
class Isomorphic:
    """The image of each vertex and of each corner. Clause: CPLX-ISO-2."""

    vertices: tuple[Vertex, ...]
    corners: tuple[Corner, ...]


@dataclass(frozen=True, slots=True)
class Different:
    """There is no isomorphism: the first difference, and the same in words. CPLX-ISO-7."""

    what: Difference
    detail: str


def isomorphism(first: Surface, second: Surface) -> Isomorphic | Different:
    """An isomorphism from the first surface onto the second, or the first difference.

    Components are matched greedily, which is right because isomorphism is an equivalence. Linear
    for each corner tried; only corners of the rarest kind are.
    Clauses: CPLX-ISO-1, CPLX-ISO-2, CPLX-ISO-4, CPLX-ISO-7.
    """
    kinds_1, kinds_2 = corner_kinds(first), corner_kinds(second)
    parts_1, parts_2 = profiled(first, kinds_1), profiled(second, kinds_2)
    difference = first_difference(
        [part.profile for part in parts_1], [part.profile for part in parts_2]
    )
    if difference is not None:
        return Different(*difference)

    waiting: dict[Profile, list[Profiled]] = {}
    for part in reversed(parts_2):
        waiting.setdefault(part.profile, []).append(part)
    image = [Corner(0)] * len(first.vertex)
    for part in parts_1:
        kind = _rarest(kinds_1, part)
        start = next(c for c in part.corners if kinds_1[c] == kind)
        tips: list[Corner] = []
        known = tuple(walk(first, start, tips))
        found = _match(known, second, waiting[part.profile], kinds_2, kind)
        if isinstance(found, Different):
            return found
        for tip, other in zip(tips, found, strict=True):
            for _ in range(3):
                image[tip] = other
                tip, other = next_corner(tip), next_corner(other)
    vertices = [Vertex(0)] * first.vertices
    for c, v in enumerate(first.vertex):
        vertices[v] = second.vertex[image[c]]
    return Isomorphic(tuple(vertices), tuple(image))


def _rarest(kinds: Sequence[Kind], part: Profiled) -> Kind:
    """The kind that the fewest corners have; the least of those."""
    count = Counter(kinds[c] for c in part.corners)
    return min(count, key=lambda kind: (count[kind], kind))


def _match(
    known: Code, second: Surface, waiting: list[Profiled], kinds: Sequence[Kind], kind: Kind
) -> list[Corner] | Different:
    """The tips of a walk with a known code, its component taken off the list; or how far we got."""
    longest = 0
    for i in range(len(waiting) - 1, -1, -1):
        for start in waiting[i].corners:
            if kinds[start] == kind:
                tips: list[Corner] = []
                agreed = agreement(known, walk(second, start, tips))
                if agreed == len(known):
                    del waiting[i]
                    return tips
                longest = max(longest, agreed)
    faces = f"{longest // 3} of {len(known) // 3} faces"
    return Different(Difference.WALKS, f"of walks that begin alike the best pair agrees on {faces}")


def is_isomorphism(first: Surface, second: Surface, claim: Isomorphic) -> Verdict:
    """Judge a certificate by the definition alone, whoever made it. Linear but for sorting.

    Opposites are not looked at: what carries faces to faces by a map of vertices carries edges too.
    Clauses: CPLX-ISO-1, CPLX-ISO-2.
    """
    if sorted(claim.vertices) != list(range(first.vertices)) or first.vertices != second.vertices:
        return Fails("each vertex of both surfaces once", repr(claim.vertices), WHOLE)
    corners = len(first.vertex)
    if sorted(claim.corners) != list(range(corners)) or corners != len(second.vertex):
        return Fails("each corner of both surfaces once", repr(claim.corners), WHOLE)
    for i, image in enumerate(claim.corners):
        c = Corner(i)
        turned = claim.corners[next_corner(c)]
        if turned != next_corner(image):
            return Fails(f"corner {next_corner(image)}", f"corner {turned}", AtFace(face_of(c)))
        to = claim.vertices[first.vertex[c]]
        if to != second.vertex[image]:
            return Fails(f"vertex {to}", f"vertex {second.vertex[image]}", AtFace(face_of(c)))
    return Holds()
