"""All words of spheres, from the grammar: small triangulations by enumeration, none left out."""

from collections.abc import Iterator
from math import factorial

from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.stream import Stream


def sphere_words(vertices: int) -> Iterator[str]:
    """The words of all rooted sphere triangulations with so many vertices. Clause: EB-GRAMMAR-10.

    Each is a closed component without records; in no order that matters. Exponential.
    """
    return (
        word
        for word in balanced_words(2 * vertices - 5)
        if isinstance(decode(Stream(word)), Accepted)
    )


def balanced_words(symbols: int) -> Iterator[str]:
    """The words whose loops have possible lengths, read backwards: EB-GRAMMAR-3, -5, -8 and no CL.

    Undoing symbols only changes the lengths of the loops on the stack, last one current: E pushes
    3, R and L add 1, C takes 1 from a loop of 4 at least, S makes one loop of two.
    """
    todo: list[tuple[str, tuple[int, ...], int]] = [("", (), (symbols - 1) // 2)]
    while todo:
        word, loops, creations = todo.pop()
        left = symbols - len(word)
        if left == 0:
            if loops == (3,):
                yield word
            continue
        if creations > left or len(loops) - 1 > left:
            continue
        todo.append(("E" + word, (*loops, 3), creations))
        if not loops:
            continue
        *below, last = loops
        longer = (*below, last + 1)
        todo.append(("R" + word, longer, creations))
        todo.append(("L" + word, longer, creations))
        if creations and last > 3 and word[0] not in "LE":
            todo.append(("C" + word, (*below, last - 1), creations - 1))
        if below:
            todo.append(("S" + word, (*below[:-1], below[-1] + last - 1), creations))


def rooted_triangulations(vertices: int) -> int:
    """How many rooted simple triangulations the sphere has (Tutte). Clause: EB-GRAMMAR-10."""
    m = vertices - 3
    return 2 * factorial(4 * m + 1) // (factorial(m + 1) * factorial(3 * m + 2))
