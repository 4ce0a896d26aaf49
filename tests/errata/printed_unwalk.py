"""Section 8(e) of the tutorial as printed: what Algorithms 7, 8 and 10 do with stacks and numbers.

Nothing is glued here: the faults shown are those of numbers, and of the order of reading.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field


@dataclass(slots=True)
class Unwrapped:
    """What Algorithm 8 leaves: the numbers it gives to triangles, and its C stack."""

    numbers: list[int] = field(default_factory=list)
    c_stack: list[int] = field(default_factory=list)
    ran_out: bool = False  # a symbol was asked for after the last


def wrap(word: str, with_boundary: int, pushes: Sequence[bool]) -> Unwrapped:
    """Algorithm 8. `pushes`: for each S, whether its left triangle is pushed (lines 26 to 29).

    A boundary's triangle is pushed with a minus sign, as Algorithm 10 wants it.
    """
    made, number, at, splits, s_stack = Unwrapped(), 0, 0, 0, list[int]()
    while at < len(word):
        if with_boundary > 0:
            with_boundary -= 1
            made.c_stack.append(-number)
        else:
            made.c_stack.append(number)
            made.numbers.append(number)
            number += 1
        while True:
            if at == len(word):
                made.ran_out = True
                return made
            symbol, at = word[at], at + 1
            made.numbers.append(number)
            if symbol == "C":
                made.c_stack.append(number)
            elif symbol == "S":
                if pushes[splits]:
                    s_stack.append(number)
                splits += 1
            elif symbol == "E":
                if not s_stack:
                    break  # line 34: and line 36, which counts the triangle, is passed over
                s_stack.pop()
            number += 1
    return made


def read_handles(written: Sequence[int]) -> list[tuple[str, int]]:
    """Algorithm 7, lines 1 to 7: what is glued, and for which S.

    `written` is what Algorithms 4 and 5 write: two numbers for each record, and one at the end.
    """
    glued: list[tuple[str, int]] = []
    for at in range(0, len(written), 2):  # `until end of file` is asked after the gluing
        s = written[at]
        glued.append(("handle" if s > 0 else "boundary", s))
    return glued


def geometry_in_turn(components: Sequence[Sequence[int]]) -> list[int]:
    """Algorithms 8 and 10: the triangles for which a vertex is read, in the order of reading.

    `components`: the C stack of each closed component, P first. The vertices of every P are read
    in the first pass, lines 10 and 11; the third pass reads one for each triangle on the stack.
    """
    first_pass = [stack[0] for stack in components for _ in range(3)]
    return [*first_pass, *(triangle for stack in components for triangle in stack)]
