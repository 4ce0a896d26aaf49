"""Where meshes part whose labels and orders are free. Clauses: ORCL-JUDGE-3, ORCL-DIVERGE-12."""

from dataclasses import dataclass
from typing import assert_never

from msgspec import UNSET

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Difference, Of
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.meshes import Differs, Same, Undecided, compare, error_of
from clers.conformance.messages import Operation, Roundtrip
from clers.conventions.where import WHOLE, AtFace, AtVertex, in_words


@dataclass(frozen=True, slots=True)
class Undecidable:
    """The comparison was given up, and why. Clause: ORCL-CODEC-8."""

    why: str


def of_isomorphic(
    right: form.Faces, got: form.Faces, request: Operation
) -> Divergence | Undecidable | None:
    """The first difference by name, or None where the mesh is the same within the input's error.

    Clauses: ORCL-JUDGE-3, ORCL-DIVERGE-12, ORCL-CODEC-3.
    """
    expected, given = _mesh(right), _mesh(got)
    allowed = error_of(request.input if isinstance(request, Roundtrip) else expected)
    found = compare(expected, given, allowed)
    match found:
        case Same():
            return None
        case Differs(differences):
            return _divergence(differences, expected, given)
        case Undecided(why):
            return Undecidable(why)
        case _:
            assert_never(found)


def _divergence(
    differences: tuple[Difference, ...], right: form.MeshForm, got: form.MeshForm
) -> Divergence:
    first = differences[0]
    rest = "".join(f"; also {_named(other)}" for other in differences[1:])
    detail = f", {first.detail}" if first.detail else ""
    at = first.at if first.of is Of.SENT else WHOLE
    where = "" if first.at == WHOLE else f", {in_words(first.at)} of the one {first.of}"
    return Divergence(
        kind=str(first.kind),
        place=f"the mesh{where}",
        expected=_counted(right),
        got=f"{_counted(got)}: {_named(first)}{detail}{rest}",
        face=at.face if isinstance(at, AtFace) else UNSET,
        vertex=at.vertex if isinstance(at, AtVertex) else UNSET,
    )


def _named(difference: Difference) -> str:
    """A difference, and how often it is there."""
    return f"{difference.kind} ({difference.count})"


def _counted(of: form.MeshForm) -> str:
    return f"{len(of.faces)} faces on {of.vertices} vertices"


def _mesh(of: form.Faces) -> form.MeshForm:
    """The mesh; without positions where the result has none to say."""
    if isinstance(of, form.MeshForm):
        return of
    return form.MeshForm(faces=of.faces, vertices=of.vertices)
