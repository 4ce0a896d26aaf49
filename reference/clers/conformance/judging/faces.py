"""Where decoded meshes part: faces, vertices, coordinates. Clauses: ORCL-DIVERGE-2, -5."""

from collections.abc import Sequence

from msgspec import UNSET, UnsetType

from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import NOTHING, listed, parting
from clers.conformance.judging.steps import Walk
from clers.conformance.messages import Step
from clers.conformance.numbers import from_wire
from clers.conformance.payloads import SAFE

Triangle = tuple[int, int, int]
AXES = "xyz"


def of_faces(right: form.Faces, got: form.Faces, walk: Walk) -> Divergence | None:
    """The first face in the order of creation, with the symbol that made it; then the vertices.

    Clauses: ORCL-DIVERGE-2, EB-ORDER-1.
    """
    expected, given = triangles(right), triangles(got)
    f = parting(expected, given)
    if f is not None:
        maker = next((step for step in walk() if step.face == f), None)
        return Divergence(
            kind="face",
            place=f"face {f}" + (f", made by {_maker(maker)}" if maker is not None else ""),
            expected=listed(expected[f]) if f < len(expected) else NOTHING,
            got=listed(given[f]) if f < len(given) else NOTHING,
            symbol=UNSET if maker is None or maker.i < 0 else maker.i,
            face=f,
            triangle=_instead(given[f]) if f < len(given) else UNSET,
        )
    if from_wire(right.vertices) != from_wire(got.vertices):
        return Divergence(
            kind="number of vertices",
            place="the number of vertices",
            expected=str(right.vertices),
            got=str(got.vertices),
        )
    return None


def _instead(got: Triangle) -> Triangle | UnsetType:
    """A triangle that has a chance to be of this mesh; integers may be of any size."""
    return got if all(0 <= v <= SAFE for v in got) else UNSET


def _maker(step: Step) -> str:
    return "P" if step.i < 0 else f"symbol {step.i} ({step.symbol})"


def triangles(of: form.Faces) -> list[Triangle]:
    """The faces as integers. Clause: ORCL-VALUE-1."""
    return [(from_wire(a), from_wire(b), from_wire(c)) for a, b, c in of.faces]


def of_mesh(right: form.Faces, got: form.Faces, walk: Walk) -> Divergence | None:
    """The first face, the vertices, then the first coordinate. Clause: ORCL-DIVERGE-5."""
    return of_faces(right, got, walk) or _of_places(_places(right), _places(got))


def _places(of: form.Faces) -> form.Places | UnsetType:
    return of.positions if isinstance(of, form.MeshForm) else UNSET


def _of_places(right: form.Places | UnsetType, got: form.Places | UnsetType) -> Divergence | None:
    """Whether there are positions, their precision, the first coordinate. ORCL-DIVERGE-5."""
    if isinstance(right, UnsetType) or isinstance(got, UnsetType):
        if type(right) is type(got):
            return None
        return Divergence(
            kind="positions", place="the positions", expected=_said(right), got=_said(got)
        )
    if right.precision != got.precision:
        return Divergence(
            kind="precision",
            place="the precision of positions",
            expected=right.precision,
            got=got.precision,
        )
    k = parting(right.coordinates, got.coordinates)
    if k is None:
        return None
    return Divergence(
        kind="coordinate",
        place=f"vertex {k // 3}, axis {AXES[k % 3]}",
        expected=_coordinate(right.coordinates, k),
        got=_coordinate(got.coordinates, k),
        vertex=k // 3,
    )


def _said(places: form.Places | UnsetType) -> str:
    return "none" if isinstance(places, UnsetType) else f"{len(places.coordinates)} coordinates"


def _coordinate(of: Sequence[float], k: int) -> str:
    """The shortest digits that read as this value, and the value bit by bit."""
    return f"{of[k]!r} ({of[k].hex()})" if k < len(of) else NOTHING
