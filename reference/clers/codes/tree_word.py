"""From a rooted triangulation to the word of its tree: once about the tree, a bit for each step."""

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.surface import Surface
from clers.kernels import tree


def tree_word(sphere: Surface) -> bytes:
    """The word of a sphere rooted at corner 0: 4(V − 3) bits, one in each byte, V − 3 of them 1.

    Linear; what is no connected closed surface of genus 0 has no word and must not be given.
    Clauses: CODE-TREE-1 … CODE-TREE-4.
    """
    twin = tree.twins(vec[i64](sphere.opposite))
    return tree.word(twin, tree.oriented(vec[i64](sphere.vertex), twin, sphere.vertices))
