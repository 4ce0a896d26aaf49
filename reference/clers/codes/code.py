"""What a code is: four functions, so that each code is a small module and the registry a table."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from clers.arithmetic.bits import Bits
from clers.codes.closings import Closing
from clers.complexes.topology import Component
from clers.conventions.result import Accepted, Rejected


@dataclass(frozen=True, slots=True)
class Shape:
    """What a coder of words knows beside the word. Clause: CODE-NAME-1.

    `head`: the symbols that are implied; `closings`: the handle data, as it is met from the end.
    """

    head: str = ""
    closings: tuple[Closing, ...] = ()


@dataclass(frozen=True, slots=True)
class Guarantee:
    """What a code promises before a bit is written. Clause: CODE-NAME-4.

    `text` says it; `bits` is the most bits that a surface of these components can take, None where
    nothing is promised.
    """

    text: str
    bits: Callable[[tuple[Component, ...]], int | None]


NOTHING: Final = Guarantee("no bound for the worst case", lambda parts: None)
"""The promise of the codes that learn. Clause: CODE-NAME-4."""


@dataclass(frozen=True, slots=True)
class Code:
    """A code of words. Clauses: CODE-NAME-1 … CODE-NAME-4.

    `encode` takes the symbols after the implied ones, `decode` their number; `most_symbols` is
    what a reader may believe of so many bits.
    """

    encode: Callable[[str, Shape], Accepted[Bits] | Rejected]
    decode: Callable[[Bits, int, Shape], Accepted[str] | Rejected]
    most_symbols: Callable[[int], int]
    guarantee: Guarantee
