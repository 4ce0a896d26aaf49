"""Each law of complexes of every dimension fails when what it judges is broken on purpose."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from types import ModuleType

import pytest

from clers.complexes import laws_geometric, laws_integral, laws_parts, laws_vocabulary
from clers.complexes.affine import Point
from clers.complexes.complex_text import write_complex
from clers.complexes.facets import Row, facets, from_facets
from clers.complexes.geometric import Geometric, Pair, geometric, missing_face, overlap
from clers.complexes.integral import Group, Prime, betti_modulo, boundary_matrices, homology_over_z
from clers.complexes.known import BOOK, PROJECTIVE, TORUS
from clers.complexes.laws_every_dimension import LAWS
from clers.complexes.parts import f_vector, join, skeleton
from clers.complexes.simplicial import Complex, Simplex, boundary, closure, link, of_dimension, star
from clers.complexes.smith import Matrix, Smith, factors_by_minors, smith
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds

PLANE = PROJECTIVE.complex
X = closure([(0, 1, 2, 3), (3, 4, 5), (5, 6), (7,)])
TWO = (closure([(0, 1), (2,)]), closure([(10, 11), (11, 12), (10, 12)]))
ROWS: tuple[Row, ...] = ((0, 1), (), (-1,))
MATRIX: Matrix = ((2, 4, 4), (-6, 6, 12), (10, -4, -16))
GRID = tuple((Fraction(x), Fraction(y)) for x, y in [(0, 0), (2, 0), (2, 2), (0, 2), (1, 1)])
CROSSED = (GRID, closure([(0, 1), (0, 2), (1, 3)]))
FLAT = (GRID, closure([(0, 2, 4), (1,)]))
SQUARE = (GRID, closure([(0, 1, 2), (0, 2, 3)]))


def faces_of_a_subset(simplex: Simplex, m: int | None = None) -> frozenset[Simplex]:
    """Forgets the whole."""
    return frozenset(frozenset({v}) for v in simplex if m in (None, 0))


def incident_to_itself(simplex: Simplex, face: Simplex) -> bool:
    return bool(face) and face <= simplex


def adjacent_to_itself(one: Simplex, other: Simplex) -> bool:
    return bool(one & other)


def joined_anyway(one: Simplex, other: Simplex) -> Accepted[Simplex] | Rejected:
    return Accepted(one | other)


def facets_and_a_face(k: Complex) -> tuple[Row, ...]:
    return tuple(sorted((*facets(k), (0,))))


def top_facets(k: Complex) -> tuple[Row, ...]:
    """Takes the tutorial's maximal faces for all facets."""
    most = max(map(len, facets(k)), default=0)
    return tuple(row for row in facets(k) if len(row) == most)


def reading_backwards(rows: Sequence[Sequence[int]]) -> Accepted[Complex] | Rejected:
    return from_facets(rows[::-1])


def text_of_edges(k: Complex) -> str:
    return write_complex(skeleton(1, k))


def star_for_closed_star(k: Complex, simplex: Simplex) -> Complex:
    return Complex(star(k, simplex))


def valence_in_triangles(k: Complex, simplex: Simplex) -> int:
    return sum(len(s) == 3 for s in star(k, simplex))


def link_with_centre(k: Complex, simplex: Simplex) -> Complex:
    return Complex(link(k, simplex).simplices | {simplex})


def star_of_lower(k: Complex, simplex: Simplex) -> frozenset[Simplex]:
    return frozenset(s for s in k.simplices if max(s) < max(simplex))


def lower_skeleton(m: int, k: Complex) -> Complex:
    return skeleton(m - 1, k)


def f_vector_with_one_more(k: Complex) -> tuple[int, ...]:
    return (1, *f_vector(k))


def one_piece(k: Complex) -> tuple[Complex, ...]:
    return (k,)


def no_piece(_: Complex) -> tuple[Complex, ...]:
    return ()


def union_for_join(one: Complex, other: Complex) -> Accepted[Complex] | Rejected:
    return Accepted(Complex(one.simplices | other.simplices))


def join_of_facets(one: Complex, other: Complex) -> Accepted[Complex] | Rejected:
    """Forgets the simplices of the first alone."""
    whole = join(one, other)
    if isinstance(whole, Rejected):
        return whole
    return Accepted(Complex(whole.value.simplices - one.simplices))


def never_impure(_: Complex) -> Simplex | None:
    return None


def last_low_facet(k: Complex) -> Simplex | None:
    return next((frozenset(row) for row in reversed(facets(k)) if len(row) < 4), None)


def open_interior(k: Complex) -> Accepted[frozenset[Simplex]] | Rejected:
    return Accepted(frozenset(of_dimension(k, 2)))


def all_walls(k: Complex) -> Complex:
    """As if each wall counted."""
    return skeleton(1, k) if len(boundary(k).simplices) < 1 else closure([(0, 1)])


def unsorted_smith(matrix: Matrix) -> Smith:
    form = smith(matrix)
    return replace(form, factors=form.factors[::-1])


def untransformed(matrix: Matrix) -> Smith:
    return replace(smith(matrix), left=smith(()).left + tuple(smith(matrix).right))


def products(matrix: Matrix) -> tuple[int, ...]:
    return (*factors_by_minors(matrix)[:-1], 144)


def without_signs(k: Complex) -> list[list[dict[int, int]]]:
    return [[{j: abs(x) for j, x in row.items()} for row in rows] for rows in boundary_matrices(k)]


def without_torsion(k: Complex) -> tuple[Group, ...]:
    return tuple(Group(group.rank, ()) for group in homology_over_z(k))


def torsion_of_one(k: Complex) -> tuple[Group, ...]:
    return tuple(Group(group.rank, (1,)) for group in homology_over_z(k))


def shifted(k: Complex) -> tuple[Group, ...]:
    return homology_over_z(k)[::-1]


def always_over_q(_: Prime, k: Complex) -> tuple[int, ...]:
    return betti_modulo(7, k)


def never_overlapping(_: Sequence[Point], __: Complex) -> Pair | None:
    return None


def other_way_round(points: Sequence[Point], k: Complex) -> Pair | None:
    found = overlap(points, k)
    return found and (found[1], found[0])


def never_independent(_: Sequence[Point]) -> bool:
    return False


def any_place(points: Sequence[Point], rows: Sequence[Sequence[int]]) -> Accepted[Geometric]:
    return Accepted(Geometric(tuple(points), closure(rows)))


def only_at_the_origin(
    points: Sequence[Point], rows: Sequence[Sequence[int]]
) -> Accepted[Geometric] | Rejected:
    return geometric(points, rows if min(min(point) for point in points) == 0 else [()])


def none_missing(_: frozenset[Simplex]) -> Pair | None:
    return None


def last_missing(simplices: frozenset[Simplex]) -> Pair | None:
    found = missing_face(simplices)
    return found and (max(tuple(sorted(s)) for s in simplices if s > set(found[1])), found[1])


def whole_triangles_only(
    points: Sequence[Point], rows: Sequence[Sequence[int]]
) -> Accepted[Geometric] | Rejected:
    return geometric(points, rows if max(map(len, rows)) == 3 else [()])


V, P, Z, G = laws_vocabulary, laws_parts, laws_integral, laws_geometric
FAULTS: list[tuple[str, ModuleType, str, object, object]] = [
    ("faces-are-counted-by-binomials", V, "faces", faces_of_a_subset, X),
    ("incidence-is-being-in-the-frontier", V, "is_incident", incident_to_itself, X),
    ("incidence-is-being-in-the-frontier", V, "are_adjacent", adjacent_to_itself, X),
    ("join-of-simplices-adds-vertices", V, "join_simplices", joined_anyway, X),
    ("facets-are-the-least-list", V, "facets", facets_and_a_face, X),
    ("facets-are-the-least-list", V, "facets", top_facets, X),
    ("rows-are-read-one-by-one", V, "from_facets", reading_backwards, ROWS),
    ("text-is-read-back", V, "write_complex", text_of_edges, X),
    ("closed-star-is-a-join", V, "closed_star", star_for_closed_star, X),
    ("closed-star-is-a-join", V, "link", link_with_centre, X),
    ("nothing-is-around-an-absent-simplex", V, "star", star_of_lower, X),
    ("valences-count-faces-of-facets", V, "valence", valence_in_triangles, X),
    ("link-in-a-link-is-the-link-of-the-union", V, "link", link_with_centre, X),
    ("skeleton-is-the-largest-subcomplex-of-its-dimension", P, "skeleton", lower_skeleton, X),
    ("f-vector-counts-every-simplex", P, "f_vector", f_vector_with_one_more, X),
    ("connected-is-what-no-two-subcomplexes-part", P, "pieces", one_piece, X),
    ("connected-is-what-no-two-subcomplexes-part", P, "pieces", no_piece, BOOK.complex),
    ("join-has-each-pair-once", P, "join", union_for_join, TWO),
    ("joins-are-an-algebra", P, "join", join_of_facets, TWO),
    ("homology-of-a-join-is-the-product", P, "join", union_for_join, TWO),
    ("purity-has-a-witness", P, "impure_at", never_impure, X),
    ("purity-has-a-witness", P, "impure_at", last_low_facet, X),
    ("interior-is-all-but-the-boundary", P, "interior", open_interior, BOOK.complex),
    ("boundary-of-a-boundary-is-empty", P, "boundary", all_walls, TORUS.complex),
    ("invariant-factors-are-quotients-of-minors", Z, "smith", unsorted_smith, MATRIX),
    ("invariant-factors-are-quotients-of-minors", Z, "factors_by_minors", products, MATRIX),
    ("smith-form-has-a-certificate", Z, "smith", unsorted_smith, MATRIX),
    ("smith-form-has-a-certificate", Z, "smith", untransformed, MATRIX),
    ("boundary-matrices-compose-to-zero", Z, "boundary_matrices", without_signs, X),
    ("rank-over-z-is-the-betti-number-over-q", Z, "homology_over_z", torsion_of_one, PLANE),
    ("rank-over-z-is-the-betti-number-over-q", Z, "homology_over_z", shifted, X),
    ("homology-has-no-torsion-at-its-ends", Z, "homology_over_z", torsion_of_one, PLANE),
    ("homology-has-no-torsion-at-its-ends", Z, "homology_over_z", shifted, X),
    ("universal-coefficients", Z, "homology_over_z", without_torsion, PLANE),
    ("universal-coefficients", Z, "betti_modulo", always_over_q, PLANE),
    ("overlaps-are-found-among-circuits", G, "overlap", never_overlapping, CROSSED),
    ("overlaps-are-found-among-circuits", G, "overlap", other_way_round, CROSSED),
    ("degenerate-is-what-has-no-volume", G, "in_general_position", never_independent, SQUARE),
    ("degenerate-is-what-has-no-volume", G, "geometric", any_place, FLAT),
    ("missing-faces-are-missed", G, "missing_face", none_missing, SQUARE),
    ("missing-faces-are-missed", G, "missing_face", last_missing, SQUARE),
    ("affine-maps-change-nothing", G, "geometric", only_at_the_origin, SQUARE),
    ("parts-of-complexes-in-space-are-such", G, "geometric", whole_triangles_only, SQUARE),
]


@pytest.mark.parametrize(
    ("name", "module", "attribute", "fault", "example"),
    FAULTS,
    ids=[f"{number}: {case[0]}" for number, case in enumerate(FAULTS)],
)
def test_law_fails(
    name: str,
    module: ModuleType,
    attribute: str,
    fault: object,
    example: object,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (law,) = [law for law in LAWS if law.name == name]
    assert law.check(example) == Holds()
    monkeypatch.setattr(module, attribute, fault)
    assert isinstance(law.check(example), Fails)


def test_every_law_was_seen_to_fail() -> None:
    assert {case[0] for case in FAULTS} == {law.name for law in LAWS}
