"""Codes of all numbers: the gamma code of Elias, and Golomb's codes."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import MAXIMUM_TOTAL

MOST_ONES: Final = 1 << 20
"""A Golomb code with so many ones, or more, is refused. Clause: INFO-NUMBER-3."""


@dataclass(frozen=True, slots=True)
class Read:
    """A number, and the place behind its last digit."""

    value: int
    end: int


def gamma(number: int) -> Accepted[str] | Rejected:
    """The gamma code of a number from 0 on. Clauses: INFO-NUMBER-1, INFO-NUMBER-3."""
    if number < 0:
        return _no_code(number)
    form = f"{number + 1:b}"
    return Accepted("0" * (len(form) - 1) + form)


def read_gamma(digits: str, at: int = 0) -> Accepted[Read] | Rejected:
    """The number whose gamma code begins at a place from 0 on. Clause: INFO-NUMBER-3."""
    one = at
    while one < len(digits) and digits[one] == "0":
        one += 1
    # The zeros, then as many digits and one more: the first of these is the one just met.
    return _binary(digits, one, 2 * one - at + 1, -1)


def golomb(parameter: int, number: int) -> Accepted[str] | Rejected:
    """The Golomb code of a number from 0 on. Clauses: INFO-NUMBER-2, INFO-NUMBER-3."""
    if not 1 <= parameter <= MAXIMUM_TOTAL:
        return _bad_parameter(parameter)
    ones, rest = divmod(number, parameter)
    if not 0 <= ones < MOST_ONES:
        return _no_code(number)
    return Accepted("1" * ones + "0" + _remainder(parameter, rest))


def _remainder(parameter: int, rest: int) -> str:
    """The canonical code of the remainder. Clause: INFO-NUMBER-2."""
    long = (parameter - 1).bit_length()
    short = (1 << long) - parameter
    if rest < short:
        return f"{rest:0{long - 1}b}"
    return f"{rest + short:0{long}b}" if long else ""


def read_golomb(parameter: int, digits: str, at: int = 0) -> Accepted[Read] | Rejected:
    """The number whose Golomb code begins at a place from 0 on. Clause: INFO-NUMBER-3."""
    if not 1 <= parameter <= MAXIMUM_TOTAL:
        return _bad_parameter(parameter)
    zero = at
    while zero < len(digits) and digits[zero] == "1":
        zero += 1
    head = _binary(digits, zero, zero + 1, 0)
    if isinstance(head, Rejected):
        return head
    if zero - at >= MOST_ONES:
        return _no_code((zero - at) * parameter)
    long = (parameter - 1).bit_length()
    short = (1 << long) - parameter
    tail = _binary(digits, zero + 1, zero + long, 0)
    if isinstance(tail, Accepted) and tail.value.value >= short:
        tail = _binary(digits, zero + 1, zero + 1 + long, -short)
    if isinstance(tail, Rejected):
        return tail
    return Accepted(Read((zero - at) * parameter + tail.value.value, tail.value.end))


def _binary(digits: str, at: int, end: int, more: int) -> Accepted[Read] | Rejected:
    """The digits from one place to another as a number, and some more. Clause: INFO-NUMBER-3."""
    for place in range(at, end):
        if place >= len(digits):
            detail = "the digits end within a number"
            return Rejected(Reason.TRUNCATED_BITS, Clause.INFO_NUMBER_3, AtSymbol(place), detail)
        if digits[place] not in ("0", "1"):
            detail = f"{digits[place]!r} is no digit"
            return Rejected(Reason.BAD_NUMBER, Clause.INFO_NUMBER_3, AtSymbol(place), detail)
    return Accepted(Read(int(digits[at:end] or "0", 2) + more, end))


def _no_code(number: int) -> Rejected:
    detail = f"{number} is negative or too large for this code"
    return Rejected(Reason.NOT_IN_ALPHABET, Clause.INFO_NUMBER_3, detail=detail)


def _bad_parameter(parameter: int) -> Rejected:
    detail = f"parameter {parameter}, must be 1 to {MAXIMUM_TOTAL}"
    return Rejected(Reason.BAD_TABLE, Clause.INFO_NUMBER_3, detail=detail)
