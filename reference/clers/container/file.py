"""Meshes to files and back: what most callers want of this chapter."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import assert_never

from clers.complexes.surface import Surface
from clers.container.contents import (
    VERSION,
    Contents,
    Opened,
    Stored,
    compose,
    open_file,
    parse,
)
from clers.container.head import Head
from clers.container.limits import DEFAULT_FILE_LIMITS, FileLimits
from clers.container.options import Exact, OnLattice, Options, chosen
from clers.container.section import Section
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker import decode as edgebreaker_decode
from clers.edgebreaker.encode import encode as edgebreaker_encode
from clers.geometry import quantised
from clers.geometry.lattice import Quantised, restore
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.order import in_creation_order, in_order, into_order
from clers.geometry.positions import Positions
from clers.geometry.quantised import Coded

DEFAULT_OPTIONS = Options()


def encode(
    surface: Surface, positions: Positions | None = None, options: Options = DEFAULT_OPTIONS
) -> Accepted[bytes] | Rejected:
    """The file of a mesh. Clauses: FILE-OPTION-1, FILE-ROUND-1, GEOM-MESH-1, GEOM-ORDER-1."""
    encoding = edgebreaker_encode(surface)

    def store(whole: Mesh) -> Accepted[Stored] | Rejected:
        if whole.positions is None:
            return Accepted(None)
        renumbered = in_creation_order(surface, encoding)
        # First the choice, so that what it blames is a vertex of the mesh that was given.
        found = chosen(options.accuracy, whole.positions)
        return and_then(found, lambda p: _stored(renumbered, _ordered(p, encoding.vertex_order)))

    def write(stored: Stored) -> Accepted[bytes] | Rejected:
        faces, vertices = surface.faces, surface.vertices
        return compose(Contents(options.code, faces, vertices, encoding.stream, stored))

    return and_then(and_then(mesh(surface, positions), store), write)


def _ordered(given: Positions | Quantised, order: Sequence[int]) -> Positions | Quantised:
    """In the order of creation. Clause: GEOM-ORDER-1."""
    match given:
        case Positions():
            return into_order(given, order)
        case Quantised(exponent, numbers):
            return Quantised(exponent, in_order(numbers, order))
        case _:
            assert_never(given)


def _stored(surface: Surface, given: Positions | Quantised) -> Accepted[Stored] | Rejected:
    match given:
        case Positions():
            return Accepted(given)
        case Quantised():
            return and_then(quantised.encode(surface, given), lambda coded: Accepted(coded))
        case _:
            assert_never(given)


def decode(data: bytes, limits: FileLimits = DEFAULT_FILE_LIMITS) -> Accepted[Mesh] | Rejected:
    """The mesh of a file, faces and vertices in the order of creation. Total.

    Time and memory are linear in the length of the file.
    Clauses: FILE-PARSE-1, FILE-PARSE-2, FILE-COUNT-3, FILE-ROUND-1 … FILE-ROUND-3.
    """
    return and_then(parse(data, limits), lambda contents: _decode(contents, limits))


def _decode(contents: Contents, limits: FileLimits) -> Accepted[Mesh] | Rejected:
    built = edgebreaker_decode.decode(contents.stream, limits.mesh)
    if isinstance(built, Rejected):
        return built
    surface = built.value
    if (surface.faces, surface.vertices) != (contents.faces, contents.vertices):
        got = f"{surface.faces} faces and {surface.vertices} vertices"
        detail = f"{got}, the HEAD says {contents.faces} and {contents.vertices}"
        return Rejected(Reason.COUNT_MISMATCH, Clause.FILE_COUNT_3, detail=detail)
    placed = _placed(surface, contents.stored)
    return and_then(placed, lambda found: mesh(surface, found))


def _placed(surface: Surface, stored: Stored) -> Accepted[Positions | None] | Rejected:
    """Clauses: FILE-POSN-1, FILE-POSN-2."""
    match stored:
        case None:
            return Accepted(None)
        case Positions():
            return Accepted(stored)
        case Coded():
            return and_then(quantised.decode(surface, stored), lambda q: Accepted(restore(q)))
        case _:
            assert_never(stored)


@dataclass(frozen=True, slots=True)
class Description:
    """What can be said of a file without decoding it. Clause: FILE-INSPECT-1."""

    version: int
    head: Head
    sections: tuple[Section, ...]


def inspect(
    data: bytes, limits: FileLimits = DEFAULT_FILE_LIMITS
) -> Accepted[Description] | Rejected:
    """The header and the table of sections; seals are checked, contents are not.

    Clause: FILE-INSPECT-1.
    """

    def describe(opened: Opened) -> Accepted[Description] | Rejected:
        return Accepted(Description(VERSION, opened.head, opened.sections))

    return and_then(open_file(data, limits), describe)


def options_of(
    data: bytes, limits: FileLimits = DEFAULT_FILE_LIMITS
) -> Accepted[Options] | Rejected:
    """The options that make the same file of the decoded mesh. Clause: FILE-ROUND-3."""

    def describe(contents: Contents) -> Accepted[Options] | Rejected:
        match contents.stored:
            case Coded(exponent, _, _):
                return Accepted(Options(contents.code, OnLattice(exponent)))
            case _:
                return Accepted(Options(contents.code, Exact()))

    return and_then(parse(data, limits), describe)
