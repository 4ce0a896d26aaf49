"""From a rooted triangulation to the word of its tree: once about the tree, a bit for each step."""

from clers.codes.half_edges import half_edges
from clers.codes.orientation import orientation
from clers.complexes.surface import Surface

_UNSEEN, _CUT, _UP = 0, 1, 2


def tree_word(sphere: Surface) -> bytes:
    """The word of a sphere rooted at corner 0: 4(V − 3) bits, one in each byte, V − 3 of them 1.

    Linear; what is no connected closed surface of genus 0 has no word and must not be given.
    Clauses: CODE-TREE-1 … CODE-TREE-4.
    """
    edges = half_edges(sphere)
    out = orientation(edges)
    twin, turn = edges.twin, edges.turn
    met = bytearray(len(twin))
    word = bytearray()
    h = turn[turn[0]]
    while h != 0:
        if met[h] == _UP:
            word.append(0)
            h = twin[h]
        elif met[h] == _CUT:
            pass
        elif out[h]:
            word.append(0)
            met[h] = met[twin[h]] = _CUT
        else:
            word.append(1)
            h = twin[h]
            met[h] = _UP
        h = turn[h]
    return bytes(word)
