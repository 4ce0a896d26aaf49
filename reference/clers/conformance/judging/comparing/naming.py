"""The differences of two meshes that are not the same, by name. Clauses: ORCL-CODEC-6, -7."""

from collections.abc import Iterator
from typing import Final

from clers.conformance.judging.comparing.common import anywhere, by_place, common
from clers.conformance.judging.comparing.difference import Difference, Kind, Of
from clers.conformance.judging.comparing.embedding import Budget
from clers.conformance.judging.comparing.faces import of_faces
from clers.conformance.judging.comparing.same import searched
from clers.conformance.judging.comparing.sites import Bound, near
from clers.conformance.judging.comparing.soup import Soup
from clers.conformance.judging.comparing.vertices import of_vertices
from clers.conventions.where import AtFace, AtVertex

ORDER: Final = tuple(Kind)


def broken(sent: Soup, came: Soup) -> tuple[Difference, ...]:
    """Why the two cannot be compared at all, if they cannot. Clause: ORCL-CODEC-6."""
    return tuple(
        fault
        for mesh, of in ((sent, Of.SENT), (came, Of.CAME))
        for fault in (*_stray(mesh, of), *_miscounted(mesh, of))
    )


def _stray(mesh: Soup, of: Of) -> Iterator[Difference]:
    high = mesh.vertices
    bad = [t for t, face in enumerate(mesh.faces) if not all(0 <= v < high for v in face)]
    if bad:
        detail = f"face {mesh.faces[bad[0]]} with {high} vertices"
        yield Difference(Kind.STRAY_INDEX, len(bad), of, AtFace(bad[0]), detail)


def _miscounted(mesh: Soup, of: Of) -> Iterator[Difference]:
    if mesh.places is not None and mesh.coordinates != 3 * mesh.vertices:
        detail = f"{mesh.coordinates} coordinates for {mesh.vertices} vertices"
        yield Difference(Kind.COORDINATE_COUNT, 1, of, detail=detail)


def differences(sent: Soup, came: Soup, bound: Bound, budget: Budget) -> tuple[Difference, ...]:
    """What is different, in the order of `Kind`; never nothing. ORCL-CODEC-6, ORCL-CODEC-7."""
    named = common(sent, came, bound, budget)
    found = [*_of_positions(sent, came)]
    if named.strangers:
        found += _of_numbers(sent, came)
    else:
        found += of_faces(sent, came, named.sent, named.came)
        found += of_vertices(sent, came, named.sent, named.came)
        found += _moved(sent, came, named.paired, bound)
    if not found:
        found = _within_sites(sent, came, bound, budget)
    return tuple(sorted(found, key=lambda d: ORDER.index(d.kind)))


def _of_positions(sent: Soup, came: Soup) -> Iterator[Difference]:
    if sent.places is not None and came.places is None:
        yield Difference(Kind.POSITIONS_LOST, sent.vertices)
    if sent.places is None and came.places is not None:
        yield Difference(Kind.POSITIONS_ADDED, came.vertices, Of.CAME)


def _of_numbers(sent: Soup, came: Soup) -> Iterator[Difference]:
    """All that can be said of meshes without places of which no part is known in the other."""
    faces = len(came.faces) - len(sent.faces)
    vertices = came.vertices - sent.vertices
    numbers = ((Kind.FACES_LOST, -faces), (Kind.FACES_ADDED, faces))
    more = ((Kind.VERTICES_LOST, -vertices), (Kind.VERTICES_ADDED, vertices))
    for kind, count in (*numbers, *more):
        if count > 0:
            yield Difference(kind, count, detail="by number alone")
    if not faces:
        yield Difference(Kind.REJOINED, len(sent.faces), detail="as many faces, joined otherwise")


def _moved(
    sent: Soup, came: Soup, pairs: tuple[tuple[int, int], ...], bound: Bound
) -> Iterator[Difference]:
    """The pairs whose places are not near; by how much, along which axis. Clause: ORCL-CODEC-7."""
    here, there = sent.places, came.places
    if here is None or there is None:
        return
    far = [(v, w) for v, w in pairs if not near(here[v], there[w], bound)]
    if far:
        v, w, k = max(
            ((v, w, k) for v, w in far for k in range(3)),
            key=lambda m: abs(here[m[0]][m[2]] - there[m[1]][m[2]]),
        )
        by = abs(here[v][k] - there[w][k])
        detail = f"vertex {v} has become vertex {w}: {here[v]} to {there[w]}"
        yield Difference(Kind.MOVED, len(far), Of.SENT, AtVertex(far[0][0]), detail, by, "xyz"[k])


def _within_sites(sent: Soup, came: Soup, bound: Bound, budget: Budget) -> list[Difference]:
    """Sites agree in all numbers, and still there is no isomorphism that keeps near."""
    placed = by_place(sent, came, bound)
    found = searched(sent, came, placed, anywhere, budget)
    if isinstance(found, tuple):
        return list(_moved(sent, came, tuple(enumerate(found)), bound))
    detail = "vertices at one place have exchanged faces"
    return [Difference(Kind.REJOINED, len(sent.faces), detail=detail)]
