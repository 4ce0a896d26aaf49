"""From a polygonal surface to a polygon list with one orientation."""

from clers.complexes.parity import Parity
from clers.complexes.polytopes.cells import (
    Cell,
    Polytope,
    cofacets,
    dimension,
    facets,
    of_dimension,
)
from clers.complexes.polytopes.manifold import first_singular
from clers.complexes.polytopes.polygons import Polygon, PolygonList
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtCell, Where


def polygon_list(of: Polytope) -> Accepted[PolygonList] | Rejected:
    """The polygons from their lowest vertices, in one orientation. Clause: CPLX-POLYGON-4."""
    singular = first_singular(of)
    if singular is not None or dimension(of) != 2:
        where: Where = WHOLE if singular is None else AtCell(*singular)
        return Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_POLYGON_4, where)
    polygons = [_around(of, cell) for cell in of_dimension(of, 2)]
    turned = _turned(of, polygons)
    if isinstance(turned, Rejected):
        return turned
    faces = (p[:1] + p[:0:-1] if turn else p for p, turn in zip(polygons, turned, strict=True))
    return Accepted(PolygonList(tuple(faces), of.vertices))


def _around(of: Polytope, polygon: Cell) -> Polygon:
    """The vertices of a polygon, from the lowest towards the lower of its neighbours."""
    beside: dict[int, list[int]] = {}
    for edge in facets(of, polygon):
        (_, a), (_, b) = facets(of, edge)
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    first = min(beside)
    path = [first, min(beside[first])]
    while (after := sum(beside[path[-1]]) - path[-2]) != first:
        path.append(after)
    return tuple(path)


def _turned(of: Polytope, polygons: list[Polygon]) -> list[bool] | Rejected:
    """Which polygons to turn over, never the lowest of a component. Clause: CPLX-POLYGON-4."""
    run = [set(zip(p, (*p[1:], p[0]), strict=True)) for p in polygons]
    sets = Parity(len(polygons))
    links: list[tuple[int, int, bool]] = []
    for edge, above in cofacets(of).items():
        if edge[0] == 1 and len(above) == 2:
            a, b = (k for _, k in facets(of, edge))
            (_, s), (_, t) = above
            links.append((t, s, ((a, b) in run[s]) == ((a, b) in run[t])))
    for t, s, differ in sorted(links):
        if not sets.unite(s, t, differ=differ):
            return Rejected(Reason.NON_ORIENTABLE, Clause.CPLX_POLYGON_4, AtCell(2, t))
    return [sets.find(t)[1] for t in range(len(polygons))]
