"""Numbers that pages print, each computed here by its name. Clause: CONV-PROSE-3.

A page writes the number, then its name in an HTML comment; `clers spec check` compares.
"""

from fractions import Fraction
from math import log2, sqrt
from types import MappingProxyType
from typing import Final

from clers.specification.numbers import Values

_PHI: Final = (1 + sqrt(5)) / 2

VALUES: Final[Values] = MappingProxyType(
    {
        "golden.unit": lambda: log2(_PHI),
        "golden.bits-per-triangle": lambda: 2.5 * log2(_PHI),
        "golden.bits-per-vertex": lambda: 5 * log2(_PHI),
        "rossignac.bits-per-triangle": lambda: 2,
        "tutte.bits-per-triangle": lambda: log2(Fraction(256, 27)) / 2,
        "tutte.bits-per-vertex": lambda: log2(Fraction(256, 27)),
    }
)
