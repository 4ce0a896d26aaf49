"""From the word of a tree back to the rooted triangulation: leaves are joined to what they reach.

About the tree goes a string of leaves and edges. A leaf and the two edges after it make a triangle,
and its third side takes their place. A stack does all of this in one pass.
"""

from clers.complexes.corner_table import of_corners
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSymbol
from clers.kernels import tree as kernel
from clers.kernels.tree import Closure


def sphere_of(word: bytes) -> Accepted[Surface] | Rejected:
    """The triangulation of which this is the word, one bit in each byte; its root is corner 0.

    Vertices: 0 is v0, then those of the tree as the word reaches them, then v1 and v2. Linear.
    Clauses: CODE-TREE-5 … CODE-TREE-9.
    """
    closure = Closure()
    if not closure.run(word):
        return _fault(closure)
    return of_corners(closure.faces, len(word) // 4 + 3)


def _fault(found: Closure) -> Rejected:
    """What is wrong with a word, and where. Clause: CODE-TREE-6."""
    match found.fault:
        case kernel.AT_ROOT:
            where, detail = AtSymbol(found.where), "the root has its two leaves already"
            return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, where, detail)
        case kernel.UNFINISHED:
            detail = f"the tree has {found.vertices} vertices, {found.open} of them not finished"
            return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, WHOLE, detail)
        case _:
            detail = "the first leaf of the root is closed"
            return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, WHOLE, detail)
