"""Total functions answer `Accepted` or `Rejected`: bad input is a value, not an exception."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.where import WHOLE, Where, in_words

A_co = TypeVar("A_co", covariant=True)
A = TypeVar("A")
B = TypeVar("B")


@dataclass(frozen=True, slots=True)
class Accepted(Generic[A_co]):
    """The input is good and this is its meaning. Clause: CONV-RESULT-1."""

    value: A_co


@dataclass(frozen=True, slots=True)
class Rejected:
    """The input is bad: why, by which clause, where. Clauses: CONV-RESULT-1, CONV-RESULT-2."""

    reason: Reason
    clause: Clause
    where: Where = WHOLE
    detail: str = ""

    @property
    def fault(self) -> Fault:
        """The class of the rejection. Clause: CONV-RESULT-3."""
        return self.reason.fault

    def line(self) -> str:
        """Say it in one line: class, reason, element, clause. Clause: CONV-RESULT-4."""
        words = " ".join(self.detail.split())
        tail = f": {words}" if words else ""
        return f"{self.fault}: {self.reason} {in_words(self.where)} [{self.clause}]{tail}"


def and_then(
    result: Accepted[A] | Rejected, step: Callable[[A], Accepted[B] | Rejected]
) -> Accepted[B] | Rejected:
    """Go on with an accepted value, or hand on the rejection (`>>=`). Clause: CONV-RESULT-5."""
    match result:
        case Accepted(value):
            return step(value)
        case Rejected():
            return result
        case _:
            assert_never(result)
