"""Libraries that know nothing of this package agree with it, on chance complexes and known ones.

GUDHI is asked for Betti numbers over five fields, of all of them. networkx sees the 1-skeleton: its
components, with their vertices, and its independent cycles. trimesh sees triangles, and counts the
vertices and edges of triangles only: it is asked for the Euler characteristic of their closure.
"""

from itertools import pairwise
from random import Random

import gudhi
import networkx as nx
import numpy as np
import pytest
import trimesh

from clers.complexes.facets import facets
from clers.complexes.homology import Field, betti
from clers.complexes.integral import betti_modulo, homology_over_z
from clers.complexes.known import KNOWN, Known
from clers.complexes.parts import f_vector, skeleton
from clers.complexes.simplicial import Complex, closure, dimension, euler, of_dimension, pieces

MANY = 1000
LARGE = 251  # GUDHI prepares p² steps for each complex


def chance_complex(draw: Random) -> Complex:
    """Up to 24 simplices on at most nine vertices, most of them of one size, at most five."""
    vertices, most = 1 + int(draw.random() * 9), 1 + int(draw.random() * 5)
    rows: list[set[int]] = []
    for _ in range(1 + int(draw.random() * 24)):
        size = most if draw.random() < 0.8 else 1 + int(draw.random() * 5)
        rows.append({int(draw.random() * vertices) for _ in range(size)})
    return closure(rows)


def chance_complexes() -> list[Complex]:
    """The same each time: `Random.random` is one sequence in every Python."""
    draw = Random(0)
    return [chance_complex(draw) for _ in range(MANY)]


def betti_of_gudhi(k: Complex, p: int) -> tuple[int, ...]:
    tree = gudhi.SimplexTree()
    for facet in facets(k):
        tree.insert(facet)
    assert tree.num_simplices() == len(k.simplices)
    tree.compute_persistence(homology_coeff_field=p, persistence_dim_max=True)
    return tuple(tree.betti_numbers())


def test_chance_reaches_enough() -> None:
    """What the witnesses are asked about: every dimension, cycles in dimensions 1 to 3, parts."""
    drawn = chance_complexes()
    assert len(drawn) == MANY
    assert {dimension(k) for k in drawn} == {0, 1, 2, 3, 4}
    numbers = [betti(k, Field.GF2) for k in drawn]
    for m, least in enumerate((100, 200, 100, 5)):
        assert sum(len(b) > m and b[m] > (m == 0) for b in numbers) >= least, m


def test_gudhi_finds_the_same_betti_numbers() -> None:
    """Clauses: CPLX-HOMOLOGY-1, CPLX-INTEGRAL-1, CPLX-INTEGRAL-3.

    Over a large prime the Betti numbers are those over the rationals, if it divides no torsion.
    """
    for k in chance_complexes():
        assert betti_of_gudhi(k, 2) == betti(k, Field.GF2) == betti_modulo(2, k)
        assert betti_of_gudhi(k, 3) == betti_modulo(3, k)
        assert betti_of_gudhi(k, 5) == betti_modulo(5, k)
        assert betti_of_gudhi(k, LARGE) == betti(k, Field.Q)
        assert betti(k, Field.Q) == tuple(group.rank for group in homology_over_z(k))


@pytest.mark.parametrize("of", KNOWN, ids=lambda of: of.name)
def test_gudhi_on_known_complexes(of: Known) -> None:
    """Clauses: CPLX-KNOWN-1, CPLX-INTEGRAL-3. Here there is torsion."""
    k = of.complex
    for p in (2, 3, 5, 7):
        divided = [0, *(sum(t % p == 0 for t in torsion) for _, torsion in of.z)]
        expected = tuple(
            rank + a + b for (rank, _), (a, b) in zip(of.z, pairwise(divided), strict=True)
        )
        assert betti_of_gudhi(k, p) == expected == betti_modulo(p, k)
    assert betti_of_gudhi(k, LARGE) == of.q


def test_networkx_finds_the_same_components() -> None:
    """Clauses: CPLX-COMPLEX-6, CPLX-PART-1, CPLX-PART-2. And the cycles of the 1-skeleton."""
    for k in chance_complexes():
        graph = nx.Graph()
        graph.add_nodes_from(v for (v,) in of_dimension(k, 0))
        graph.add_edges_from(tuple(edge) for edge in of_dimension(k, 1))
        parts = sorted(sorted(part) for part in nx.connected_components(graph))
        assert parts == sorted(sorted(set().union(*part.simplices)) for part in pieces(k))
        low = skeleton(1, k)
        assert euler(low) == graph.number_of_nodes() - graph.number_of_edges()
        cycles = len(nx.cycle_basis(graph))
        assert betti(low, Field.GF2) == (len(parts), cycles)[: dimension(low) + 1]
        assert f_vector(low) == (graph.order(), graph.size())[: dimension(low) + 1]


def test_trimesh_finds_the_same_euler_characteristic() -> None:
    """Clauses: CPLX-COMPLEX-3, CPLX-PART-2. Of the closure of the triangles, if there are any."""
    asked = 0
    for k in chance_complexes():
        triangles = [sorted(t) for t in of_dimension(k, 2)]
        if triangles:
            points = np.arange(27.0).reshape(9, 3) ** 2
            mesh = trimesh.Trimesh(points, triangles, process=False)
            assert mesh.euler_number == euler(closure(triangles))
            asked += 1
    assert asked > 600
