"""Laws of cells: closures and stars, what a polytope is, its order complex, its graphs."""

from typing import Final

from clers.complexes import simplicial
from clers.complexes.definition import is_surface
from clers.complexes.polytopes.cells import (
    CellList,
    Polytope,
    all_cells,
    boundary,
    closure,
    cofacets,
    components,
    counts,
    dimension,
    euler,
    facets,
    figure,
    interior,
    is_pure,
    of_dimension,
    restricted,
    star,
)
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.definition import is_polytope
from clers.complexes.polytopes.given import (
    CELL_LISTS,
    POLYTOPES,
    PRODUCTS,
    SMALL_COMPLEXES,
    SOLID,
)
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.order import from_complex, order_complex, to_complex
from clers.complexes.polytopes.products import times
from clers.complexes.simplicial import Complex, is_arc, is_circle, link, pieces
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtCell


def _counts(of: Polytope) -> Verdict:
    numbers = [len(of_dimension(of, m)) for m in range(4)]
    parts = [restricted(of, part) for part in components(of)]
    return every(
        same(sum(numbers), len(tuple(all_cells(of)))),
        same(numbers[0] - numbers[1] + numbers[2] - numbers[3], euler(of)),
        same(euler(of), sum(map(euler, parts))),
        same(max((m for m in range(4) if numbers[m]), default=-1), dimension(of)),
    )


def _closure(of: Polytope) -> Verdict:
    whole = {cell: closure(of, [cell]) for cell in all_cells(of)}
    return every(
        *(
            every(
                same(frozenset(c for c in whole if cell in whole[c]), star(of, cell), at),
                same(True, all(facets(of, face) <= closed for face in closed), at),
                same(closed, frozenset([cell]).union(*(whole[f] for f in facets(of, cell))), at),
            )
            for cell, closed in whole.items()
            for at in [AtCell(*cell)]
        )
    )


def _boundary(of: Polytope) -> Verdict:
    rim = restricted(of, boundary(of))
    parts = components(of)
    return every(
        same(True, is_pure(of)),
        same(True, is_pure(rim)),
        same(True, dimension(rim) in (-1, dimension(of) - 1)),
        same(frozenset(), boundary(rim) if rim.vertices and dimension(rim) else frozenset()),
        same(frozenset(all_cells(of)), interior(of) | boundary(of)),
        same(frozenset(), interior(of) & boundary(of)),
        same(sum(counts(of)), sum(map(len, parts))),
        same(frozenset(all_cells(of)), frozenset[tuple[int, int]]().union(*parts)),
        same(True, all(closure(of, part) == part for part in parts)),
    )


def _figure(of: Complex) -> Verdict:
    cells = from_complex(of)
    return every(
        *(
            same(from_complex(link(of, simplex)), figure(cells, (m, k)), AtCell(m, k))
            for m in range(dimension(cells) + 1)
            for k, simplex in enumerate(simplicial.of_dimension(of, m))
        )
    )


def _accepted(of: CellList) -> Verdict:
    return same(is_polytope(of), isinstance(polytope(of), Accepted))


def _kept(of: CellList) -> Verdict:
    answer = polytope(of)
    if not isinstance(answer, Accepted):
        return every()
    made = answer.value
    return every(
        same(tuple(layer for layer in of.cells if layer), made.cells),
        same(of.vertices, made.vertices),
        same(answer, polytope(made)),
    )


def _subdivided(of: Polytope) -> Verdict:
    k = order_complex(of)
    return every(
        same(dimension(of), simplicial.dimension(k)),
        same(sum(counts(of)), len(simplicial.of_dimension(k, 0))),
        same(euler(of), simplicial.euler(k)),
        same(is_pure(of), simplicial.is_pure(k)),
        same(len(components(of)), len(pieces(k))),
    )


def _chains(of: Polytope) -> Verdict:
    number = {cell: i for i, cell in enumerate(all_cells(of))}
    above = {number[c]: frozenset(number[d] for d in star(of, c)) for c in number}
    k = order_complex(of)
    edges = frozenset(
        frozenset([low, high]) for low, over in above.items() for high in over if high != low
    )
    points = frozenset(frozenset([v]) for v in above)
    beside: dict[int, set[int]] = {v: set() for v in above}
    for u, v in map(tuple, edges):
        beside[u].add(v)
        beside[v].add(u)
    larger: dict[frozenset[int], set[int]] = {s: set() for s in k.simplices}
    for s in k.simplices:
        for v in s if len(s) > 1 else ():
            larger[s - {v}].add(v)
    return every(
        same(points | edges, frozenset(s for s in k.simplices if len(s) < 3)),
        *(same(set.intersection(*(beside[v] for v in s)), more) for s, more in larger.items()),
    )


def _simplices(of: Complex) -> Verdict:
    cells = from_complex(of)
    answer = polytope(cells)
    if not isinstance(answer, Accepted):
        return same("a polytope", answer)
    name = sorted(v for (v,) in simplicial.of_dimension(of, 0))
    number = {v: i for i, v in enumerate(name)}
    renamed = Complex(frozenset(frozenset(number[v] for v in s) for s in of.simplices))
    return every(
        same(
            tuple(len(simplicial.of_dimension(of, m)) for m in range(dimension(cells) + 1)),
            counts(cells),
        ),
        same(renamed, to_complex(answer.value)),
    )


def _products(both: tuple[CellList, CellList]) -> Verdict:
    a, b = both
    made = times(a, b)
    expected = [0] * (dimension(a) + dimension(b) + 1)
    for i, x in enumerate(counts(a)):
        for j, y in enumerate(counts(b)):
            expected[i + j] += x * y
    return every(
        same(tuple(expected), counts(made)),
        same(euler(a) * euler(b), euler(made)),
        same(True, is_polytope(made)),
    )


def _manifold(of: Polytope) -> Verdict:
    k = order_complex(of)
    around = [link(k, v) for v in simplicial.of_dimension(k, 0)]
    match dimension(of):
        case 1:
            expected = all(len(near.simplices) in (1, 2) for near in around)
        case 2:
            expected = is_surface(k)
        case 3:
            expected = all(map(_is_sphere_or_disc, around))
        case _:
            expected = True
    return same(expected, is_manifold(of))


def _is_sphere_or_disc(k: Complex) -> bool:
    rim = simplicial.boundary(k)
    connected = simplicial.dimension(k) == 2 and is_surface(k) and len(pieces(k)) == 1
    return connected and simplicial.euler(k) == (1 if rim.simplices else 2)


def _figures(of: Polytope) -> Verdict:
    inside = boundary(of)
    n = dimension(of)
    verdicts: list[Verdict] = [same(True, is_manifold(of))]
    for vertex in of_dimension(of, 0):
        around = figure(of, vertex)
        at_rim = vertex in inside
        chi = 1 if at_rim else 1 + (-1) ** (n - 1)
        verdicts.append(same((n - 1, chi), (dimension(around), euler(around)), AtCell(*vertex)))
        if n == 2:
            k = to_complex(Polytope(around.vertices, around.cells))
            good = k is not None and (is_arc(k) if at_rim else is_circle(k))
            verdicts.append(same(True, good, AtCell(*vertex)))
    most = max((len(above) for c, above in cofacets(of).items() if c[0] == n - 1), default=0)
    return every(*verdicts, same(True, most in (1, 2)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "cells-are-counted-by-dimension",
        Clause.CPLX_CELL_1,
        "χ is #0 − #1 + #2 − #3, the sum of the components' χ, and the dimension the largest.",
        POLYTOPES,
        _counts,
    ),
    Law(
        "star-is-the-closure-backwards",
        Clause.CPLX_CELL_2,
        "A cell is in the star of another exactly if that is in its closure; closures are closed.",
        POLYTOPES,
        _closure,
    ),
    Law(
        "cells-are-boundary-or-interior",
        Clause.CPLX_CELL_3,
        "The boundary of a manifold is pure, has no boundary, and the interior is the rest; "
        "components are closed and share no cell.",
        SOLID,
        _boundary,
    ),
    Law(
        "figure-of-a-simplex-is-its-link",
        Clause.CPLX_CELL_4,
        "In a simplicial complex the figure of a simplex is its link, cell for cell.",
        SMALL_COMPLEXES,
        _figure,
    ),
    Law(
        "polytopes-are-accepted-as-defined",
        Clause.CPLX_POLYTOPE_8,
        "A cell list is accepted exactly if its frontiers are circles and spheres as complexes and "
        "its closed cells meet in closed cells.",
        CELL_LISTS,
        _accepted,
    ),
    Law(
        "accepted-cells-keep-their-numbers",
        Clause.CPLX_POLYTOPE_1,
        "An accepted cell list is the polytope, without empty dimensions, and accepted again.",
        CELL_LISTS,
        _kept,
    ),
    Law(
        "order-complex-is-made-of-chains",
        Clause.CPLX_POLYTOPE_9,
        "Its edges join a cell and a face of it, and any two vertices of a simplex are so joined.",
        POLYTOPES,
        _chains,
    ),
    Law(
        "simplicial-complexes-are-polytopes",
        Clause.CPLX_POLYTOPE_10,
        "A simplicial complex is accepted as a polytope, and comes back from it.",
        SMALL_COMPLEXES,
        _simplices,
    ),
    Law(
        "subdividing-keeps-euler-and-components",
        Clause.CPLX_POLYTOPE_11,
        "The order complex has the polytope's dimension, χ, purity and number of components.",
        POLYTOPES,
        _subdivided,
    ),
    Law(
        "products-of-polytopes-are-polytopes",
        Clause.CPLX_POLYTOPE_12,
        "A product has as many cells as there are pairs, its χ is the product, and it is coherent.",
        PRODUCTS,
        _products,
    ),
    Law(
        "vertex-figures-are-spheres-and-balls",
        Clause.CPLX_POLYMANIFOLD_1,
        "In an n-manifold a vertex has a figure of dimension n − 1, with the χ of a sphere inside "
        "and of a ball on the boundary, and each (n−1)-cell is a facet of one n-cell or two.",
        SOLID,
        _figures,
    ),
    Law(
        "manifolds-are-those-of-the-order-complex",
        Clause.CPLX_POLYMANIFOLD_2,
        "A polytope is a manifold by its vertex figures exactly if its order complex is, by links.",
        POLYTOPES,
        _manifold,
    ),
)
