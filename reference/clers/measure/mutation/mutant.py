"""A mutant of a module: its source with one piece of text put in the place of another."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class Mutant:
    """One change of one module. Clause: TOOL-MUTATION-1.

    The piece runs from (line, column) to (end_line, end_column), lines from 1, columns in bytes
    of UTF-8 from 0, as in `ast`. `first` and `last` are the lines of the statement around it,
    or of that statement's head if it has a body.
    """

    line: int
    column: int
    end_line: int
    end_column: int
    kind: str
    before: str
    after: str
    first: int
    last: int

    @property
    def place(self) -> str:
        """Line and column, both from 1, as editors count."""
        return f"{self.line}:{self.column + 1}"


def mutated(source: str, mutant: Mutant) -> str:
    """The source with the change made. Clause: TOOL-MUTATION-1."""
    lines = source.encode().splitlines(keepends=True)
    start = sum(map(len, lines[: mutant.line - 1])) + mutant.column
    end = sum(map(len, lines[: mutant.end_line - 1])) + mutant.end_column
    whole = source.encode()
    return (whole[:start] + mutant.after.encode() + whole[end:]).decode()


def difference(source: str, mutant: Mutant) -> str:
    """The lines that the change touches, before and after. Clause: TOOL-MUTATION-5."""
    old = source.splitlines()
    new = mutated(source, mutant).splitlines()
    last = mutant.end_line + len(new) - len(old)
    removed = [f"- {line}" for line in old[mutant.line - 1 : mutant.end_line]]
    return "\n".join([*removed, *(f"+ {line}" for line in new[mutant.line - 1 : last])])
