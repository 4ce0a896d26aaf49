"""Moves as data: what is done to a complex, each a line of text, each with its inverse.

Simplices are tuples of vertices in increasing order. What a move means, and when it applies, is
said where it is applied: `collapse`, `stellar`, `bistellar`, `contract`, `split`.
"""

from dataclasses import dataclass

Vertices = tuple[int, ...]
"""A simplex as an operand: its vertices in increasing order."""


@dataclass(frozen=True, slots=True)
class Collapse:
    """Remove a simplex and the only one that contains it. Clause: OPER-COLLAPSE-1."""

    free: Vertices
    coface: Vertices


@dataclass(frozen=True, slots=True)
class Expand:
    """Add a simplex and the coface that will be its only one. Clause: OPER-COLLAPSE-3."""

    free: Vertices
    coface: Vertices


@dataclass(frozen=True, slots=True)
class Subdivide:
    """Put a new vertex into a simplex. Clause: OPER-STELLAR-1."""

    simplex: Vertices
    vertex: int


@dataclass(frozen=True, slots=True)
class Weld:
    """Take a vertex out again, so that the simplex is whole. Clause: OPER-STELLAR-2."""

    simplex: Vertices
    vertex: int


@dataclass(frozen=True, slots=True)
class Bistellar:
    """Exchange a simplex with the one its link is the frontier of. Clause: OPER-BISTELLAR-1."""

    gone: Vertices
    come: Vertices


@dataclass(frozen=True, slots=True)
class Contract:
    """Make the two ends of an edge one vertex, named `keep`. Clause: OPER-CONTRACT-1."""

    keep: int
    gone: int


@dataclass(frozen=True, slots=True)
class Split:
    """Make two vertices of one and an edge between them. Clause: OPER-CONTRACT-4.

    `moved` spans the link of the new vertex, less its star at the old one; `shared` the part of it
    that the old vertex keeps too, which is the link of the new edge.
    """

    vertex: int
    new: int
    moved: tuple[Vertices, ...]
    shared: tuple[Vertices, ...]


Move = Collapse | Expand | Subdivide | Weld | Bistellar | Contract | Split
"""Any move of this package."""
