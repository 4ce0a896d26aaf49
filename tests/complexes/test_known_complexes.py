"""The known complexes are what the literature says, as far as this package can see."""

import re
from itertools import permutations
from pathlib import Path

import pytest

from clers.complexes import known
from clers.complexes.facets import facets
from clers.complexes.homology import Field, betti
from clers.complexes.integral import betti_modulo, homology_over_z
from clers.complexes.known import KNOWN, Known
from clers.complexes.parts import f_vector
from clers.complexes.purity import pure_boundary
from clers.complexes.simplicial import (
    Complex,
    Simplex,
    dimension,
    euler,
    is_arc,
    is_circle,
    is_pure,
    link,
    of_dimension,
    star,
)
from clers.conventions.result import Accepted, Rejected

PAGE = Path(__file__).parents[2] / "spec" / "03-every-dimension.md"
Permutation = tuple[int, ...]


@pytest.mark.parametrize("of", KNOWN, ids=lambda of: of.name)
def test_facts(of: Known) -> None:
    """Clauses: CPLX-KNOWN-1, CPLX-INTEGRAL-1, CPLX-INTEGRAL-3, CPLX-HOMOLOGY-1, CPLX-PART-2."""
    k = of.complex
    assert sorted(map(sorted, of.facets)) == list(map(list, facets(k)))
    assert f_vector(k) == of.f_vector
    assert (dimension(k), euler(k), is_pure(k)) == (of.dimension, of.euler, of.pure)
    assert betti(k, Field.GF2) == betti_modulo(2, k) == of.gf2
    assert betti(k, Field.Q) == of.q
    assert tuple((group.rank, group.torsion) for group in homology_over_z(k)) == of.z
    rim = pure_boundary(k)
    if of.boundary is None:
        assert isinstance(rim, Rejected)
    else:
        assert isinstance(rim, Accepted)
        assert f_vector(rim.value) == of.boundary


def test_table_of_the_page() -> None:
    """Clause: CPLX-KNOWN-1."""
    lines = PAGE.read_text("utf-8").split("**CPLX-KNOWN-1.**")[1].split("\n\n")[0].splitlines()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines if "|" in line][2:]
    says = {None: "no", True: "orientable", False: "not orientable"}
    assert [row[0] for row in rows] == [of.name for of in KNOWN]
    for of, (_, counts, chi, groups, pure, manifold) in zip(KNOWN, rows, strict=True):
        assert tuple(map(int, counts.split(", "))) == of.f_vector
        assert (int(chi), pure == "yes", manifold) == (of.euler, of.pure, says[of.orientable])
        assert of.manifold == (of.orientable is not None)
        assert tuple(map(_group, groups.split(", "))) == of.z


def _group(text: str) -> tuple[int, tuple[int, ...]]:
    """ℤ, ℤ^r, ℤ/t and their sums, in TeX; or the rank alone."""
    if text.isdigit():
        return int(text), ()
    torsion = tuple(int(t) for t in re.findall(r"Z/(\d+)", text))
    free = re.fullmatch(r"\$\\mathbb Z(?:\^(\d+))?\$", text.split(" ⊕ ")[0])
    return (int(free[1] or 1) if free else 0), torsion


def test_names_are_different() -> None:
    """Clause: CPLX-KNOWN-1."""
    assert len({of.name for of in KNOWN}) == len(KNOWN) == 31


def test_contractible_and_collapsible() -> None:
    """Clause: CPLX-KNOWN-1. Collapsible is contractible, which is homology of a point."""
    for of in KNOWN:
        assert of.contractible or not of.collapsible
        if of.contractible:
            assert of.z == ((1, ()),) + ((0, ()),) * of.dimension
    assert {of.name for of in KNOWN if of.contractible and not of.collapsible} == {"dunce hat"}


def walls(k: Complex) -> dict[Simplex, int]:
    """The number of top simplices at each wall."""
    n = dimension(k)
    return {s: sum(len(t) == n + 1 for t in star(k, s)) for s in of_dimension(k, n - 1)}


@pytest.mark.parametrize("of", [of for of in KNOWN if of.dimension == 2], ids=lambda of: of.name)
def test_surfaces_by_their_links(of: Known) -> None:
    """Clauses: CPLX-KNOWN-1, CPLX-SURFACE-1."""
    k = of.complex
    links = [link(k, v) for v in of_dimension(k, 0)]
    assert of.manifold == all(is_circle(around) or is_arc(around) for around in links)


@pytest.mark.parametrize("of", [of for of in KNOWN if of.dimension == 3], ids=lambda of: of.name)
def test_three_manifolds_by_their_links(of: Known) -> None:
    """Clause: CPLX-KNOWN-1. Links of vertices are surfaces; spheres and discs by χ and walls."""
    k = of.complex
    links = [link(k, v) for v in of_dimension(k, 0)]
    good = [
        all(is_circle(link(around, w)) or is_arc(link(around, w)) for w in of_dimension(around, 0))
        and betti(around, Field.GF2) in {(1, 0, 1), (1, 0, 0)}
        for around in links
    ]
    assert of.manifold == all(good)


def test_links_of_the_complex_projective_plane() -> None:
    """Clause: CPLX-KNOWN-1. All links of vertices are closed and have a 3-sphere's homology."""
    k = known.COMPLEX_PROJECTIVE.complex
    for v in of_dimension(k, 0):
        around = link(k, v)
        assert set(walls(around).values()) == {2}
        assert betti(around, Field.GF2) == (1, 0, 0, 1)


def test_the_dunce_hat_has_no_free_face() -> None:
    """Clause: CPLX-KNOWN-1. Its three sides, glued to one, are the circle 0, 1, 2."""
    at = walls(known.DUNCE.complex)
    assert {tuple(sorted(s)) for s in at if at[s] == 3} == {(0, 1), (0, 2), (1, 2)}
    assert sorted(at.values()) == [2] * 21 + [3] * 3


def _product(a: Permutation, b: Permutation) -> Permutation:
    return tuple(a[i] for i in b)


def _inverse(a: Permutation) -> Permutation:
    return tuple(a.index(i) for i in range(len(a)))


def even_permutations() -> list[Permutation]:
    """A_5, the unit first."""
    return [
        p
        for p in permutations(range(5))
        if sum(a > b for j, b in enumerate(p) for a in p[:j]) % 2 == 0
    ]


def has_a_map_to_a5(k: Complex) -> bool:
    """Is there a map of edge paths to A_5, constant on homotopy classes, that is not trivial?

    Edges of a spanning tree go to the unit, and around each triangle the product is the unit. Two
    edges of a triangle determine the third, so only few edges are chosen freely.
    """
    unit = tuple(range(5))
    triangles = [tuple(sorted(t)) for t in of_dimension(k, 2)]
    value: dict[tuple[int, int], Permutation] = {}
    reached = {min(min(s) for s in k.simplices)}
    edges = [tuple(sorted(e)) for e in of_dimension(k, 1)]
    while new := next(((a, b) for a, b in edges if (a in reached) != (b in reached)), None):
        value[new] = unit
        reached |= set(new)
    group = even_permutations()

    def grown(
        start: dict[tuple[int, int], Permutation],
    ) -> dict[tuple[int, int], Permutation] | None:
        known_values, before = dict(start), -1
        while len(known_values) > before:
            before = len(known_values)
            for a, b, c in triangles:
                x, y, z = (known_values.get(e) for e in ((a, b), (b, c), (a, c)))
                if x and y and z:
                    if _product(x, y) != z:
                        return None
                elif x and y:
                    known_values[a, c] = _product(x, y)
                elif x and z:
                    known_values[b, c] = _product(_inverse(x), z)
                elif y and z:
                    known_values[a, b] = _product(z, _inverse(y))
        return known_values

    waiting = [value]
    while waiting:
        grown_value = grown(waiting.pop())
        if grown_value is None:
            continue
        left = next((e for e in edges if e not in grown_value), None)
        if left is not None:
            waiting += [{**grown_value, (left[0], left[1]): g} for g in group]
        elif any(g != unit for g in grown_value.values()):
            return True
    return False


def test_the_poincare_sphere_is_not_simply_connected() -> None:
    """Clause: CPLX-KNOWN-1. Its group of order 120 has A_5 as a quotient; spheres have none."""
    assert has_a_map_to_a5(known.POINCARE.complex)
    assert not has_a_map_to_a5(known.SPHERES[3].complex)
    assert not has_a_map_to_a5(known.SIXTEEN_CELL.complex)
    assert not has_a_map_to_a5(known.DUNCE.complex)
