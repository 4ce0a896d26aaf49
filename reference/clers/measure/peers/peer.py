"""A peer: a code of somebody else, asked how many bytes it needs for a surface."""

from collections.abc import Callable
from dataclasses import dataclass

from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected


@dataclass(frozen=True, slots=True)
class Peer:
    """A name, the package it comes in ("" for Python's own), and how to ask it."""

    name: str
    package: str
    bytes_for: Callable[[Surface], Accepted[int] | Rejected]


def not_installed(package: str) -> Rejected:
    """The answer of a peer whose package is missing. Clause: TOOL-BITS-6."""
    detail = f"{package} is not installed"
    return Rejected(Reason.NOT_OBTAINABLE, Clause.TOOL_BITS_6, detail=detail)
