"""Laws of isomorphism: certificates, codes, canonical forms, mirror images, differences."""

from itertools import permutations
from typing import Final

from clers.complexes.canonical import canonical_form, canonical_surface, walk
from clers.complexes.corner_table import face_list, surface
from clers.complexes.difference import Difference
from clers.complexes.difference_by_definition import first_difference_by_definition
from clers.complexes.given import PAIRS, RELABELLED, SMALL_SURFACES, SURFACES, TINY_PAIRS, Pair
from clers.complexes.isomorphism import Different, Isomorphic, is_isomorphism, isomorphism
from clers.complexes.relabel import mirror
from clers.complexes.surface import Corner, Surface, Vertex, next_corner
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtFace


def _judged(first: Surface, second: Surface) -> Verdict:
    """The answer's certificate, judged; a difference has none to judge."""
    answer = isomorphism(first, second)
    match answer:
        case Isomorphic():
            return is_isomorphism(first, second, answer)
        case Different():
            return Holds()


def _are_isomorphic(first: Surface, second: Surface) -> bool:
    return isinstance(isomorphism(first, second), Isomorphic)


def _relabelled(pair: Pair) -> Verdict:
    return every(same(True, _are_isomorphic(*pair)), _judged(*pair))


def _every_permutation(pair: Pair) -> Verdict:
    first, second = pair
    expected = first.vertices == second.vertices and any(
        _carries(first, second, images) for images in permutations(range(first.vertices))
    )
    return same(expected, _are_isomorphic(first, second))


def _carries(first: Surface, second: Surface, images: tuple[int, ...]) -> bool:
    """Does a map of vertices carry the oriented triangles of one onto those of the other?"""
    carried = [(images[a], images[b], images[c]) for a, b, c in first.triangles()]
    return sorted(map(_rotated, carried)) == sorted(map(_rotated, second.triangles()))


def _rotated(triangle: tuple[int, int, int]) -> tuple[int, int, int]:
    """The triangle begun at its lowest vertex."""
    a, b, c = triangle
    return min((a, b, c), (b, c, a), (c, a, b))


def _certificates(pair: Pair) -> Verdict:
    first, second = pair
    answer = isomorphism(first, second)
    if isinstance(answer, Different):
        return Holds()
    v, c = answer.vertices, answer.corners
    beside = next((d for d in range(3, len(c)) if first.vertex[d] == first.vertex[0]), None)
    wrong = (
        *(() if beside is None else (Isomorphic(v, _exchanged(c, beside)),)),
        Isomorphic((v[1], v[0], *v[2:]), c),
        Isomorphic((v[1], *v[1:]), c),
        Isomorphic(v, (c[1], c[2], c[0], *c[3:])),
        Isomorphic(v, (c[0], c[2], c[1], *c[3:])),
        Isomorphic(v, (*c[3:], *c[:3])) if len(c) > 3 else Isomorphic(v, c[:2]),
        Isomorphic(v, c[:-1]),
        Isomorphic(v[:-1], c),
    )
    verdicts = (is_isomorphism(first, second, claim) for claim in wrong)
    return every(
        is_isomorphism(first, second, answer),
        *(same(True, isinstance(verdict, Fails)) for verdict in verdicts),
    )


def _exchanged(corners: tuple[Corner, ...], d: int) -> tuple[Corner, ...]:
    """The first image exchanged with another."""
    return (corners[d], *corners[1:d], corners[0], *corners[d + 1 :])


def _codes(of: Surface) -> Verdict:
    if len(components(of)) > 1:
        return Holds()
    tips: list[Corner] = []
    known = tuple(walk(of, Corner(0), tips))
    for c in range(len(of.vertex)):
        others: list[Corner] = []
        equal = tuple(walk(of, Corner(c), others)) == known
        symmetry = is_isomorphism(of, of, _along(of, tips, others))
        if equal != isinstance(symmetry, Holds):
            return Fails(f"corner {c}: equal codes {equal}", repr(symmetry), AtFace(c // 3))
    return Holds()


def _along(of: Surface, tips: list[Corner], others: list[Corner]) -> Isomorphic:
    """The map that takes the k-th tip of one walk to the k-th tip of another."""
    image = [Corner(0)] * len(of.vertex)
    for tip, other in zip(tips, others, strict=True):
        for _ in range(3):
            image[tip] = other
            tip, other = next_corner(tip), next_corner(other)
    vertices = {of.vertex[c]: of.vertex[image[c]] for c in range(len(image))}
    return Isomorphic(tuple(vertices[Vertex(v)] for v in range(of.vertices)), tuple(image))


def _same_form(pair: Pair) -> Verdict:
    first, second = pair
    equal = canonical_form(first) == canonical_form(second)
    return every(same(equal, _are_isomorphic(*pair)), same(equal, _are_isomorphic(second, first)))


def _forgets(pair: Pair) -> Verdict:
    first, second = pair
    return same(canonical_surface(first), canonical_surface(second))


def _canonical(of: Surface) -> Verdict:
    named = canonical_surface(of)
    flat = tuple(d for code in _shifted(canonical_form(of)) for d in code)
    return every(
        same(Accepted(named), surface(face_list(named))),
        same(flat, named.opposite),
        same(tuple(sorted(set(named.vertex))), tuple(dict.fromkeys(named.vertex))),
        same(True, _are_isomorphic(of, named)),
        same(named, canonical_surface(named)),
    )


def _shifted(form: tuple[tuple[int, ...], ...]) -> list[tuple[int, ...]]:
    """Codes with their corners numbered on from one component to the next."""
    done = 0
    codes: list[tuple[int, ...]] = []
    for code in form:
        codes.append(tuple(d if d < 0 else d + done for d in code))
        done += len(code)
    return codes


def _mirror(of: Surface) -> Verdict:
    image = mirror(of)
    turned = tuple((a, c, b) for a, b, c in of.triangles())
    achiral = canonical_form(of) == canonical_form(image)
    return every(
        same(Accepted(image), surface(face_list(image))),
        same(turned, tuple(image.triangles())),
        same(of, mirror(image)),
        same(achiral, _are_isomorphic(of, image)),
    )


def _difference(pair: Pair) -> Verdict:
    first, second = pair
    answer = isomorphism(first, second)
    by_sets = first_difference_by_definition(face_list(first), face_list(second))
    match answer:
        case Different(what, _):
            return same(Difference.WALKS if by_sets is None else by_sets, what)
        case Isomorphic():
            return same(None, by_sets)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "relabelled-surfaces-are-isomorphic",
        Clause.CPLX_ISO_1,
        "Permuting vertices and faces and rotating faces gives an isomorphic surface, with a good "
        "certificate.",
        RELABELLED,
        _relabelled,
    ),
    Law(
        "isomorphism-is-what-some-permutation-does",
        Clause.CPLX_ISO_1,
        "There is an isomorphism exactly if one of all permutations of the vertices carries the "
        "oriented triangles onto those of the other.",
        TINY_PAIRS,
        _every_permutation,
    ),
    Law(
        "certificates-are-judged",
        Clause.CPLX_ISO_2,
        "The certificate that is found is good; with two vertices exchanged, two corners of one "
        "vertex, a face rotated or turned over, faces moved on, or a part missing, it is not.",
        PAIRS,
        _certificates,
    ),
    Law(
        "equal-codes-are-symmetries",
        Clause.CPLX_ISO_4,
        "In a connected surface two corners have the same code exactly if taking tips to tips is "
        "an isomorphism.",
        SMALL_SURFACES,
        _codes,
    ),
    Law(
        "canonical-form-decides-isomorphism",
        Clause.CPLX_ISO_5,
        "Two surfaces have the same canonical form exactly if an isomorphism is found, either way.",
        PAIRS,
        _same_form,
    ),
    Law(
        "canonical-surface-forgets-names",
        Clause.CPLX_ISO_6,
        "A surface under other names has the same canonical surface.",
        RELABELLED,
        _forgets,
    ),
    Law(
        "canonical-surface-is-the-surface",
        Clause.CPLX_ISO_6,
        "The canonical surface is isomorphic to the surface, is its own canonical surface, has "
        "the canonical form for its opposites, and names vertices in order.",
        SURFACES,
        _canonical,
    ),
    Law(
        "difference-is-the-first-by-definition",
        Clause.CPLX_ISO_7,
        "The difference that is named is the first of those that sets and counting show; if they "
        "show none, it is the walks.",
        PAIRS,
        _difference,
    ),
    Law(
        "mirror-twice-is-nothing",
        Clause.CPLX_ISO_8,
        "The mirror image is the surface with its faces turned over; its mirror image is the "
        "surface; and the canonical form tells whether the surface is chiral.",
        SMALL_SURFACES,
        _mirror,
    ),
)
