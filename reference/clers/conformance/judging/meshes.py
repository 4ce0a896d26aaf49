"""A mesh that was sent beside the mesh that came back: the same but for names, or how not.

    match compare(case_input, result, error_of(case_input)):
        case Same(): ...
        case Differs(differences): print(differences[0].line())
        case Undecided(why): ...

Any two lists of triples can be compared, surfaces or not. Total and pure. ORCL-CODEC-3 … -8.
"""

from dataclasses import dataclass
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.common import by_place
from clers.conformance.judging.comparing.difference import Difference
from clers.conformance.judging.comparing.embedding import Budget, No
from clers.conformance.judging.comparing.naming import broken, differences
from clers.conformance.judging.comparing.same import image
from clers.conformance.judging.comparing.sites import Bound
from clers.conformance.judging.comparing.soup import MOST, soup

EXACT: Final[Bound] = (0.0, 0.0, 0.0)
"""No coordinate may move. Clause: ORCL-CODEC-1."""

STEPS: Final = 4_000_000
"""Clause: ORCL-CODEC-8."""


@dataclass(frozen=True, slots=True)
class Same:
    """The vertex of the mesh that came back that each vertex sent has become.

    Clause: ORCL-CODEC-3.
    """

    vertices: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Differs:
    """The differences, at least one, in the order of `Kind`. Clauses: ORCL-CODEC-6, -7."""

    differences: tuple[Difference, ...]


@dataclass(frozen=True, slots=True)
class Undecided:
    """The search was given up, and why. Clause: ORCL-CODEC-8."""

    why: str


def error_of(given: form.MeshForm) -> Bound:
    """The error that an input of codec.roundtrip allows; none for any other. ORCL-CODEC-1."""
    allowed = given.error if isinstance(given, form.ThroughForm) else EXACT
    return allowed if isinstance(allowed, tuple) else EXACT


Compared = Same | Differs | Undecided


def compare(
    sent: form.MeshForm, came: form.MeshForm, error: Bound = EXACT, steps: int = STEPS
) -> Compared:
    """Whether a mesh has come back, each coordinate within the error of its axis.

    Clauses: ORCL-CODEC-3 … ORCL-CODEC-8.
    """
    one, other = soup(sent), soup(came)
    faults = broken(one, other)
    if faults:
        return Differs(faults)
    if max(one.vertices, other.vertices) > MOST:
        return Undecided(f"more than {MOST} vertices")
    budget = Budget(steps)
    found = image(one, other, by_place(one, other, error), error, budget)
    if found is No.GIVEN_UP:
        return Undecided(f"no isomorphism was found or excluded in {steps} steps")
    if found is not No.THERE_IS_NONE and (one.places is None) == (other.places is None):
        return Same(found)
    return Differs(differences(one, other, error, budget))
