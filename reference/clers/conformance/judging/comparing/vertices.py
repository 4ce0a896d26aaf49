"""Vertices at common sites: merged, split, lost and added. Clause: ORCL-CODEC-6."""

from collections.abc import Iterator, Sequence

from clers.conformance.judging.comparing.difference import Difference, Kind, Of
from clers.conformance.judging.comparing.soup import Soup
from clers.conventions.where import AtVertex


def of_vertices(
    sent: Soup, came: Soup, sites: Sequence[int], others: Sequence[int]
) -> Iterator[Difference]:
    """The differences of vertices, when a site of each is known for both meshes.

    Clauses: ORCL-CODEC-6, ORCL-CODEC-7.
    """
    here: dict[int, tuple[list[int], list[int]]] = {}
    for side, names in enumerate((sites, others)):
        for v, site in enumerate(names):
            here.setdefault(site, ([], []))[side].append(v)
    lonely, alone = sent.isolated, came.isolated
    lost: dict[Kind, list[int]] = {Kind.MERGED: [], Kind.ISOLATED_LOST: [], Kind.VERTICES_LOST: []}
    added: dict[Kind, list[int]] = {Kind.SPLIT: [], Kind.VERTICES_ADDED: []}
    for these, those in here.values():
        single, used = _missing(these, those, lonely, alone)
        lost[Kind.ISOLATED_LOST] += single
        lost[Kind.MERGED if those else Kind.VERTICES_LOST] += used
        single, used = _missing(those, these, alone, lonely)
        added[Kind.VERTICES_ADDED] += single
        added[Kind.SPLIT if these else Kind.VERTICES_ADDED] += used
    for kind, some in lost.items():
        if some:
            yield Difference(kind, len(some), Of.SENT, AtVertex(min(some)))
    for kind, some in added.items():
        if some:
            yield Difference(kind, len(some), Of.CAME, AtVertex(min(some)))


def _missing(
    these: Sequence[int], those: Sequence[int], lonely: Sequence[bool], alone: Sequence[bool]
) -> tuple[list[int], list[int]]:
    """Of the vertices at a site those that the other mesh has no more: isolated ones, used ones.

    As many isolated ones are missing as the other mesh has fewer, if so many are missing at all.
    """
    missing = max(0, len(these) - len(those))
    single = [v for v in these if lonely[v]]
    used = [v for v in these if not lonely[v]]
    fewer = len(single) - sum(alone[v] for v in those)
    gone = min(missing, max(0, fewer))
    return single[len(single) - gone :], used[len(used) - (missing - gone) :]
