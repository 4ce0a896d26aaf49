"""Certificates of codes whose costs are whole numbers: what each symbol is charged, exactly."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from clers.codes.golden import UNITS_AFTER_C, UNITS_ELSEWHERE
from clers.codes.king_rossignac import AFTER_C, OTHERWISE

Costs = Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Charges:
    """What a symbol is charged: each, a C more, an S after a C less; and the potential after a C.

    An S is charged one more and an E one less. Clause: CODE-CERTIFICATE-5.
    """

    each: int
    creation: int
    pair: int
    potential: int

    def total(self, symbols: int, created: int, split: int, pairs: int) -> int:
        """The charges of a word with these counts, whose last symbol is no C."""
        return self.each * symbols + self.creation * created + split - self.pair * pairs


def mischarged(of: Charges, after_c: Costs, otherwise: Costs) -> Iterator[tuple[str, str]]:
    """The pairs of context (C or nothing) and symbol whose cost is not their charge."""
    for before, costs in (("C", after_c), ("", otherwise)):
        for x, cost in costs.items():
            charge = of.each + {"C": of.creation, "S": 1, "E": -1}.get(x, 0)
            charge -= of.pair * (before + x == "CS")
            charge += of.potential * ((x == "C") - (before == "C"))
            if charge != cost:
                yield before, x


def golden_costs() -> tuple[Costs, Costs]:
    """The units of `golden` after a C and otherwise. Clause: CODE-CERTIFICATE-5."""
    return UNITS_AFTER_C, UNITS_ELSEWHERE


def king_rossignac_costs() -> tuple[Costs, Costs]:
    """The bits of the three codes together, after a C and otherwise. CODE-CERTIFICATE-5."""
    after_c = {x: len(OTHERWISE) * len(word) for x, word in AFTER_C.items()}
    return after_c, {x: sum(len(table[x]) for table in OTHERWISE) for x in OTHERWISE[0]}
