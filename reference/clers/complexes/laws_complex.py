"""Laws of complexes as sets: that the definition's own words fit together."""

from typing import Final

from clers.complexes.face_list import FaceList
from clers.complexes.given import FACE_LISTS, SMALL_SURFACES
from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import (
    Complex,
    boundary,
    closure,
    dimension,
    euler,
    is_pure,
    link,
    of_dimension,
    pieces,
    star,
)
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Verdict


def _closure(given: FaceList) -> Verdict:
    k = closure(given.faces)
    smaller = (s - {v} for s in k.simplices for v in s)
    maximal = {s for s in k.simplices if not any(s < other for other in k.simplices)}
    return every(
        same(True, all(s in k.simplices for s in smaller if s)),
        same(k, closure(k.simplices)),
        same(True, maximal <= set(map(frozenset, given.faces))),
    )


def _dimension(given: FaceList) -> Verdict:
    k = closure(given.faces)
    sizes = [len(of_dimension(k, m)) for m in range(4)]
    top = max((len(set(face)) for face in given.faces), default=0) - 1
    return every(same(len(k.simplices), sum(sizes)), same(top, dimension(k)))


def _euler(given: FaceList) -> Verdict:
    k = closure(given.faces)
    points, edges, triangles = (len(of_dimension(k, m)) for m in range(3))
    return same(points - edges + triangles, euler(k))


def _link(given: FaceList) -> Verdict:
    k = closure(given.faces)
    return every(
        *(
            same(frozenset(s - centre for s in star(k, centre)) - {frozenset()}, around)
            for centre in k.simplices
            for around in [link(k, centre).simplices]
        )
    )


def _boundary(of: Surface) -> Verdict:
    rim = boundary(closure(of.triangles()))
    return every(same(True, is_pure(rim)), same(frozenset(), boundary(rim).simplices))


def _pieces(given: FaceList) -> Verdict:
    k = closure(given.faces)
    parts = pieces(k)
    points = [v for part in parts for v in of_dimension(part, 0)]
    return every(
        same(k, Complex(frozenset().union(*(part.simplices for part in parts)))),
        same(len(set(points)), len(points)),
        same(euler(k), sum(map(euler, parts))),
        same(len(parts), betti(k, Field.GF2)[0] if parts else 0),
    )


def _betti(field: Field) -> Law[FaceList]:
    def holds(given: FaceList) -> Verdict:
        k = closure(given.faces)
        return same(euler(k), sum((-1) ** m * b for m, b in enumerate(betti(k, field))))

    return Law(
        f"euler-is-the-alternating-sum-of-betti-numbers-{field.name.lower()}",
        Clause.CPLX_HOMOLOGY_3,
        f"χ is the alternating sum of the Betti numbers over {field.value}, of any complex.",
        FACE_LISTS,
        holds,
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "closure-is-the-least-complex",
        Clause.CPLX_COMPLEX_1,
        "A closure contains the non-empty subsets of its simplices, and is its own closure.",
        FACE_LISTS,
        _closure,
    ),
    Law(
        "dimension-counts-vertices",
        Clause.CPLX_COMPLEX_2,
        "Every simplex of a face list's closure has dimension 0, 1 or 2, the largest its faces'.",
        FACE_LISTS,
        _dimension,
    ),
    Law(
        "euler-is-vertices-less-edges-and-faces",
        Clause.CPLX_COMPLEX_3,
        "χ of a complex of dimension 2 is its vertices less its edges and its triangles.",
        FACE_LISTS,
        _euler,
    ),
    Law(
        "link-is-the-star-without-its-centre",
        Clause.CPLX_COMPLEX_4,
        "The link of a simplex is what its star leaves when the simplex is taken out of each.",
        FACE_LISTS,
        _link,
    ),
    Law(
        "boundary-has-no-boundary",
        Clause.CPLX_COMPLEX_5,
        "The boundary of a surface is pure, and its own boundary is empty.",
        SMALL_SURFACES,
        _boundary,
    ),
    Law(
        "complex-is-the-union-of-its-components",
        Clause.CPLX_COMPLEX_6,
        "Components share no vertex, their χ add up, and b_0 counts them.",
        FACE_LISTS,
        _pieces,
    ),
    _betti(Field.GF2),
    _betti(Field.Q),
)
