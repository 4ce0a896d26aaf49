"""Laws of curves, components, Euler characteristic, genus and homology."""

from typing import Final

from clers.complexes.border import curve_from
from clers.complexes.corner_table import face_list
from clers.complexes.definition import components_by_definition, curves_by_definition
from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import closure
from clers.complexes.surface import BORDER, Face, Surface, next_corner, previous_corner
from clers.complexes.topology import component_of_faces, components, curve_at, curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtFace


def _chained(of: Surface) -> Verdict:
    found = [c for curve in curves(of) for c in curve.corners]
    border = [c for c, d in enumerate(of.opposite) if d == BORDER]
    ends = [
        (of.vertex[previous_corner(c)], of.vertex[next_corner(following)])
        for curve in curves(of)
        for c, following in zip(
            curve.corners, (*curve.corners[1:], *curve.corners[:1]), strict=True
        )
    ]
    return every(same(border, sorted(found)), *(same(head, tail) for head, tail in ends))


def _begun_elsewhere(of: Surface) -> Verdict:
    for curve in curves(of):
        for i, c in enumerate(curve.corners):
            rotated = curve.vertices[i:] + curve.vertices[:i]
            verdict = every(
                same(rotated, curve_at(of, c).vertices),
                same(rotated, tuple(curve_from(of, next_corner(c)))),
                same(of.vertex[next_corner(c)], rotated[0]),
            )
            if isinstance(verdict, Fails):
                return verdict
    return Holds()


def _curves(of: Surface) -> Verdict:
    expected = curves_by_definition(face_list(of))
    return same(expected, tuple(curve.vertices for curve in curves(of)))


def _walks(of: Surface) -> Verdict:
    number = component_of_faces(of)
    first = [k for t, k in enumerate(number) if k not in number[:t]]
    neighbours = (
        same(number[c // 3], number[d // 3], AtFace(c // 3))
        for c, d in enumerate(of.opposite)
        if d != BORDER
    )
    lowest = tuple(component.lowest for component in components(of))
    return every(
        same(list(range(len(first))), first),
        same(tuple(number.index(k) for k in first), lowest),
        *neighbours,
    )


def _counted(of: Surface) -> Verdict:
    return same(components_by_definition(face_list(of)), components(of))


def _genus(of: Surface) -> Verdict:
    return every(
        *(
            every(
                same(c.vertices - c.edges + c.faces, c.euler, AtFace(c.lowest)),
                same(2 - 2 * c.genus - c.curves, c.euler, AtFace(c.lowest)),
                same(True, c.genus >= 0, AtFace(c.lowest)),
            )
            for c in components(of)
        )
    )


def _homology(field: Field) -> Law[Surface]:
    def holds(of: Surface) -> Verdict:
        number = component_of_faces(of)
        verdicts: list[Verdict] = []
        for k, component in enumerate(components(of)):
            faces = [of.triangle(Face(t)) for t, part in enumerate(number) if part == k]
            loops = 2 * component.genus + max(component.curves - 1, 0)
            expected = (1, loops, 1 if component.curves == 0 else 0)
            at = AtFace(component.lowest)
            verdicts.append(same(expected, betti(closure(faces), field), at))
        return every(*verdicts)

    return Law(
        f"homology-is-that-of-the-genus-{field.name.lower()}",
        Clause.CPLX_HOMOLOGY_2,
        f"The Betti numbers of a component over {field.value} are 1, 2g, 1, or 1, 2g + b − 1, 0.",
        SMALL_SURFACES,
        holds,
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "border-corners-form-cycles",
        Clause.CPLX_CURVE_1,
        "Each border corner is on one curve, once, and each edge of a curve begins where the one "
        "before it ends.",
        SURFACES,
        _chained,
    ),
    Law(
        "curve-begun-elsewhere-is-rotated",
        Clause.CPLX_CURVE_2,
        "A curve begun at another of its corners is the same list, rotated to that corner's tail.",
        SURFACES,
        _begun_elsewhere,
    ),
    Law(
        "curves-are-listed-as-defined",
        Clause.CPLX_CURVE_3,
        "The curves found by swinging are those of the directed edges without a counterpart, in "
        "the same order, each begun at the same vertex.",
        SURFACES,
        _curves,
    ),
    Law(
        "components-hang-together",
        Clause.CPLX_COMPONENT_1,
        "Faces across an edge are in one component, and components are numbered by lowest faces.",
        SURFACES,
        _walks,
    ),
    Law(
        "components-are-counted-as-defined",
        Clause.CPLX_COMPONENT_2,
        "The counts by corners are the counts of the components of the complex.",
        SMALL_SURFACES,
        _counted,
    ),
    Law(
        "euler-is-two-less-handles-and-curves",
        Clause.CPLX_COMPONENT_3,
        "χ = 2 − 2g − b for each component, and g is an integer that is not negative.",
        SURFACES,
        _genus,
    ),
    _homology(Field.GF2),
    _homology(Field.Q),
)
