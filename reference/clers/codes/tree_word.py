"""From a rooted triangulation to the word of its tree: once about the tree, a bit for each step."""

from clers.complexes.surface import Surface
from clers.kernels import tree


def tree_word(sphere: Surface) -> bytes:
    """The word of a sphere rooted at corner 0: 4(V − 3) bits, one in each byte, V − 3 of them 1.

    Linear; what is no connected closed surface of genus 0 has no word and must not be given.
    Clauses: CODE-TREE-1 … CODE-TREE-4.
    """
    opposite = sphere.opposite_row.flat
    return tree.word(opposite, tree.oriented(sphere.vertex_row.flat, opposite, sphere.vertices))
