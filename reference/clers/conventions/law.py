"""Laws are data: a named pure function with the clause it states and the domain it ranges over."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from clers.conventions.clause import Clause
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, Where

X = TypeVar("X")


@dataclass(frozen=True, slots=True)
class Given(Generic[X]):
    """A domain that laws range over: its name, what is in it, its type. Clause: CONV-LAW-2.

    How examples are drawn is not said here: `clers.generate` has a strategy for each name.
    """

    name: str
    meaning: str
    kind: type[X]


@dataclass(frozen=True, slots=True)
class Law(Generic[X]):
    """For all `given`, `holds`. Pure; closed over nothing but its subject. Clause: CONV-LAW-1."""

    name: str
    clause: Clause
    statement: str
    given: Given[X]
    holds: Callable[[X], Verdict]

    @property
    def domain(self) -> str:
        """The name of the domain."""
        return self.given.name

    @property
    def meaning(self) -> str:
        """What the domain contains."""
        return self.given.meaning

    def check(self, example: object) -> Verdict:
        """Judge one example; one of another type fails, for it shows a broken generator."""
        if isinstance(example, self.given.kind):
            return self.holds(example)
        return Fails(self.given.kind.__name__, type(example).__name__, WHOLE)


class AnyLaw(Protocol):
    """A law of some domain: what a registry holds. Clause: CONV-LAW-3."""

    @property
    def name(self) -> str:
        """Its kebab-case name, unique in the registry."""
        ...

    @property
    def clause(self) -> Clause:
        """The clause it states."""
        ...

    @property
    def statement(self) -> str:
        """The statement in words."""
        ...

    @property
    def domain(self) -> str:
        """The name of the domain."""
        ...

    @property
    def meaning(self) -> str:
        """What the domain contains."""
        ...

    def check(self, example: object) -> Verdict:
        """Judge one example."""
        ...


def same(expected: object, got: object, where: Where = WHOLE) -> Verdict:
    """The verdict on an equation. Clause: CONV-LAW-4."""
    return Holds() if expected == got else Fails(repr(expected), repr(got), where)


def at_most(bound: float, got: float, what: str = "") -> Verdict:
    """The verdict on an upper bound. Clause: CONV-LAW-4."""
    return Holds() if got <= bound else Fails(f"{what} ≤ {bound}", repr(got), WHOLE)


def every(*verdicts: Verdict) -> Verdict:
    """The first failure of several, or their agreement. Clause: CONV-LAW-4."""
    for verdict in verdicts:
        if isinstance(verdict, Fails):
            return verdict
    return Holds()
