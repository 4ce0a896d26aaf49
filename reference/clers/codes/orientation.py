"""The orientation of a rooted triangulation in which every inner vertex has three edges going out.

There is one without a clockwise cycle. It is found by shelling: a path from v2 to v1 bounds what is
left; a vertex on it that has no chords is taken away, always the one nearest to v1 that can be. Its
edges to its neighbours on the path go out of it, and its other edges come in.
"""

from librt.vecs import vec
from mypy_extensions import i64

from clers.codes.half_edges import HalfEdges
from clers.kernels import tree


def orientation(edges: HalfEdges) -> bytearray:
    """For each half-edge 1 if its edge is directed so, else 0; of a sphere rooted at corner 0.

    The edges of the root face have no direction. Linear. Clauses: CODE-TREE-2, CODE-TREE-3.
    """
    source = vec[i64](edges.source)
    beside = (edges.twin[h - 2 if h % 3 == 2 else h + 1] for h in range(len(edges.twin)))
    opposite = vec[i64](h - 1 if h % 3 else h + 2 for h in beside)
    return bytearray(iter(tree.oriented(source, opposite, edges.vertices)))
