"""Triangulations of polygons: by a centre in each, or by a fan from its lowest vertex.

What they keep: CPLX-POLYGON-7.
"""

from itertools import pairwise

from clers.complexes.face_list import FaceList
from clers.complexes.polytopes.polygons import Polygon, PolygonList, sides


def starred(of: PolygonList) -> FaceList:
    """A centre for each polygon, joined to its sides: CPLX-POLYGON-5."""
    faces = tuple((side.tail, side.head, of.vertices + side.face) for side in sides(of))
    return FaceList(faces, of.vertices + len(of.faces))


def fanned(of: PolygonList) -> FaceList:
    """Diagonals from the lowest vertex of each polygon: CPLX-POLYGON-6."""
    turned = map(_from_lowest, of.faces)
    faces = tuple((first, b, c) for first, *others in turned for b, c in pairwise(others))
    return FaceList(faces, of.vertices)


def _from_lowest(polygon: Polygon) -> Polygon:
    at = polygon.index(min(polygon))
    return polygon[at:] + polygon[:at]
