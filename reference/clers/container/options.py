"""What a writer of files may choose, and how a file says what was chosen."""

from dataclasses import dataclass
from typing import assert_never

from clers.codes.registry import CodeName
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry.lattice import Quantised, exponent_for_bits, exponent_for_error, quantise
from clers.geometry.positions import Positions


@dataclass(frozen=True, slots=True)
class Exact:
    """Keep every bit. Clause: GEOM-EXACT-1."""


@dataclass(frozen=True, slots=True)
class OnLattice:
    """Move to the lattice of step 2^exponent. Clause: GEOM-LATTICE-1."""

    exponent: int


@dataclass(frozen=True, slots=True)
class InBits:
    """Spend at most so many bits an axis before prediction. Clause: GEOM-CHOICE-1."""

    bits: int


@dataclass(frozen=True, slots=True)
class WithinError:
    """Move no coordinate further than this. Clause: GEOM-CHOICE-2."""

    bound: float


Accuracy = Exact | OnLattice | InBits | WithinError


@dataclass(frozen=True, slots=True)
class Options:
    """The code of the word, and how positions are stored. Clause: FILE-OPTION-1."""

    code: CodeName = CodeName.GOLDEN
    accuracy: Accuracy = Exact()


def chosen(accuracy: Accuracy, given: Positions) -> Accepted[Positions | Quantised] | Rejected:
    """Positions as they will be stored. Clauses: FILE-OPTION-1, GEOM-CHOICE-1, GEOM-CHOICE-2."""
    match accuracy:
        case Exact():
            return Accepted(given)
        case OnLattice(exponent):
            return quantise(given, exponent)
        case InBits(bits):
            return and_then(exponent_for_bits(given, bits), lambda e: quantise(given, e))
        case WithinError(bound):
            return and_then(exponent_for_error(bound), lambda e: quantise(given, e))
        case _:
            assert_never(accuracy)
