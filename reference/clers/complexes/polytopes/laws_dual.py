"""Laws of orientation, kinds, duals and graphs."""

from typing import Final

from clers.complexes import simplicial
from clers.complexes.corner_table import face_list
from clers.complexes.given import SURFACES
from clers.complexes.homology import Field, betti, coherent_chains
from clers.complexes.polytopes.cells import (
    Polytope,
    boundary,
    components,
    counts,
    dimension,
    euler,
    of_dimension,
    restricted,
    vertices_of,
)
from clers.complexes.polytopes.dual import dual, dual_graph, primal_graph
from clers.complexes.polytopes.flags import flags, is_orientable
from clers.complexes.polytopes.given import CLOSED, POLYGONAL, SOLID
from clers.complexes.polytopes.kind import kinds
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.order import order_complex
from clers.complexes.polytopes.polygons import PolygonList, cell_list
from clers.complexes.simplicial import Complex, pieces
from clers.complexes.surface import BORDER, Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict


def _flags(of: Polytope) -> Verdict:
    largest = simplicial.of_dimension(order_complex(of), dimension(of))
    return same(len(largest), len(flags(of)))


def _oriented(of: Polytope) -> Verdict:
    k = order_complex(of)
    expected = coherent_chains(k, Field.Q) == coherent_chains(k, Field.GF2)
    return same(expected, is_orientable(of))


def _whole(of: Polytope) -> Verdict:
    return every(
        same(euler(of), sum(kind.euler for kind in kinds(of))),
        *(
            every(
                same(2 - 2 * kind.genus - kind.crosscaps - kind.curves, kind.euler),
                same(True, kind.genus >= 0),
                same(True, kind.crosscaps >= 0),
                same(True, kind.orientable or kind.crosscaps > 0),
            )
            for kind in kinds(of)
        ),
    )


def _homology(of: Polytope) -> Verdict:
    verdicts: list[Verdict] = []
    for part, kind in zip(components(of), kinds(of), strict=True):
        k = order_complex(restricted(of, part))
        closed = kind.curves == 0
        rim = simplicial.boundary(k)
        verdicts += [
            same((1, 1 + closed - kind.euler, int(closed)), betti(k, Field.GF2)),
            same(closed and kind.orientable, betti(k, Field.Q)[2] == 1),
            same(kind.curves, len(pieces(rim))),
        ]
    return every(*verdicts, same(len(pieces(order_complex(of))), len(kinds(of))))


def _reversed(of: Polytope) -> Verdict:
    answer = dual(of)
    if isinstance(answer, Rejected):
        return same("a dual", answer)
    n = dimension(of)
    spans = {cell: vertices_of(answer.value, cell) for cell in of_dimension(answer.value, n)}
    around = {
        vertex: frozenset(k for m, k in _above(of, vertex[1]) if m == n)
        for vertex in of_dimension(of, 0)
    }
    return same(
        {k: cells for (_, k), cells in around.items()}, {k: s for (_, k), s in spans.items()}
    )


def _above(of: Polytope, vertex: int) -> frozenset[tuple[int, int]]:
    n = dimension(of)
    return frozenset(cell for cell in of_dimension(of, n) if vertex in vertices_of(of, cell))


def _dual_or_not(of: Polytope) -> Verdict:
    return same(not boundary(of), isinstance(dual(of), Accepted))


def _is_polytope(of: Polytope) -> Verdict:
    answer = dual(of)
    if isinstance(answer, Rejected):
        return same("a dual", answer)
    return every(same(True, is_manifold(answer.value)), same(frozenset(), boundary(answer.value)))


def _twice(of: Polytope) -> Verdict:
    once = dual(of)
    return same(Accepted(of), dual(once.value) if isinstance(once, Accepted) else once)


def _dual_counts(of: Polytope) -> Verdict:
    answer = dual(of)
    if isinstance(answer, Rejected):
        return same("a dual", answer)
    other, n = answer.value, dimension(of)
    return every(
        same(counts(of)[::-1], counts(other)),
        same((-1) ** n * euler(of), euler(other)),
        same(len(components(of)), len(components(other))),
        same(is_orientable(of), is_orientable(other)),
        same(_mirrored(of), order_complex(other)),
    )


def _mirrored(of: Polytope) -> Complex:
    """The order complex, each cell named as its dual cell is."""
    numbers = counts(of)
    first = [sum(numbers[m + 1 :]) for m in range(len(numbers))]
    names = [first[m] + k for m, number in enumerate(numbers) for k in range(number)]
    k = order_complex(of)
    return Complex(frozenset(frozenset(names[v] for v in s) for s in k.simplices))


def _graph_links(of: Polytope) -> Verdict:
    n = dimension(of)
    edges = tuple(tuple(sorted(vertices_of(of, edge))) for edge in of_dimension(of, 1))
    inner = [wall for wall in of_dimension(of, n - 1) if wall not in boundary(of)]
    largest = of_dimension(of, n)
    across = tuple(tuple(k for _, k in largest if wall[1] in of.cells[n - 1][k]) for wall in inner)
    return every(same(edges, primal_graph(of)), same(across, dual_graph(of)))


def _graph_parts(of: Polytope) -> Verdict:
    n = dimension(of)
    parts = len(components(of))
    other = dual(of)
    walls = sum(1 for wall in boundary(of) if wall[0] == n - 1)
    return every(
        same(parts, _parts(of.vertices, primal_graph(of))),
        same(parts, _parts(counts(of)[n], dual_graph(of))),
        same(counts(of)[n - 1] - walls, len(dual_graph(of))),
        same(dual_graph(of), primal_graph(other.value))
        if isinstance(other, Accepted)
        else same(False, walls == 0),
    )


def _parts(nodes: int, graph: tuple[tuple[int, int], ...]) -> int:
    return len(pieces(simplicial.closure([*([v] for v in range(nodes)), *graph])))


def _corners(of: Surface) -> Verdict:
    mesh = face_list(of)
    pairs = sorted(
        (c // 3, d // 3) for c, d in enumerate(of.opposite) if d != BORDER and c // 3 < d // 3
    )
    return same(pairs, sorted(dual_graph(cell_list(PolygonList(mesh.faces, mesh.vertices)))))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "flags-are-the-largest-simplices",
        Clause.CPLX_POLYMANIFOLD_3,
        "A polytope has as many flags as its order complex has largest simplices.",
        SOLID,
        _flags,
    ),
    Law(
        "coloured-flags-are-coherent-chains",
        Clause.CPLX_POLYMANIFOLD_4,
        "The flags of a manifold have two colours exactly if the order complex is orientable.",
        SOLID,
        _oriented,
    ),
    Law(
        "kinds-are-whole-numbers",
        Clause.CPLX_POLYMANIFOLD_5,
        "χ = 2 − 2g − b, or 2 − k − b with k > 0 cross-caps, for each component; none is negative.",
        POLYGONAL,
        _whole,
    ),
    Law(
        "kinds-agree-with-homology",
        Clause.CPLX_POLYMANIFOLD_6,
        "The Betti numbers of the order complex are those of the kind, over both fields.",
        POLYGONAL,
        _homology,
    ),
    Law(
        "dual-cells-span-stars",
        Clause.CPLX_DUAL_1,
        "The dual cell of a vertex spans the vertices that stand for the n-cells at that vertex.",
        CLOSED,
        _reversed,
    ),
    Law(
        "only-closed-manifolds-have-duals",
        Clause.CPLX_DUAL_1,
        "A manifold has a dual exactly if its boundary is empty.",
        SOLID,
        _dual_or_not,
    ),
    Law(
        "dual-is-a-closed-manifold",
        Clause.CPLX_DUAL_2,
        "The dual of a closed manifold is a polytope and a closed manifold.",
        CLOSED,
        _is_polytope,
    ),
    Law(
        "dual-of-the-dual-is-the-original",
        Clause.CPLX_DUAL_3,
        "Taking the dual twice gives the same cells with the same numbers.",
        CLOSED,
        _twice,
    ),
    Law(
        "dual-turns-the-counts-around",
        Clause.CPLX_DUAL_4,
        "The f-vector is reversed, χ multiplied by (−1)^n, components and orientability stay, and "
        "the order complex is the same.",
        CLOSED,
        _dual_counts,
    ),
    Law(
        "graphs-are-edges-and-walls",
        Clause.CPLX_GRAPH_1,
        "The primal graph has the edges' ends, the dual graph the two n-cells at each inner wall.",
        SOLID,
        _graph_links,
    ),
    Law(
        "graphs-hang-together-as-the-manifold",
        Clause.CPLX_GRAPH_2,
        "Primal and dual graph have the manifold's components; the dual's primal is the dual.",
        SOLID,
        _graph_parts,
    ),
    Law(
        "dual-graph-is-that-of-opposite-corners",
        Clause.CPLX_GRAPH_3,
        "The dual graph of a triangulated surface links the faces of opposite corners.",
        SURFACES,
        _corners,
    ),
)
