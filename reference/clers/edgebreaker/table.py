"""Table 1 of the tutorial as data. Clause: EB-TRAVERSE-8."""

from dataclasses import dataclass
from typing import Final

from clers.edgebreaker.stream import Side


@dataclass(frozen=True, slots=True)
class Row:
    """What a symbol says: is the apex marked, which sides are closed, what the dual tree does."""

    marked: bool
    closed: tuple[Side, ...]
    valence: int
    remainder: tuple[Side, ...]


TABLE: Final = {
    "C": Row(False, (), 2, (Side.LEFT,)),
    "L": Row(True, (Side.LEFT,), 2, (Side.LEFT,)),
    "E": Row(True, (Side.LEFT, Side.RIGHT), 1, (Side.LEFT, Side.RIGHT)),
    "R": Row(True, (Side.RIGHT,), 2, (Side.RIGHT,)),
    "S": Row(True, (), 3, ()),
}

S_WITH_RECORD: Final = Row(True, (), 2, (Side.LEFT,))
