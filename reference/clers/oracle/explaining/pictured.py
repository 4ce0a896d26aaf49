"""Where an answer diverges, as a picture. Clause: ORCL-EXPLAIN-5."""

from dataclasses import dataclass
from typing import Final

from msgspec import UNSET, UnsetType

from clers.complexes.topology import components
from clers.conformance.cases.case import Case, operation_of, right_result
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.rejections import element_of
from clers.conformance.lines import NoMessage
from clers.conformance.outcome import Answered, Outcome
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.oracle.explaining.subject import Subject, got_by, subject_of
from clers.pictures.beside import beside
from clers.pictures.draw import draw
from clers.pictures.options import NOWHERE, Options, Pointer
from clers.pictures.scene import Scene
from clers.pictures.sheet import scene


@dataclass(frozen=True, slots=True)
class Bounds:
    """How large a picture may be: faces of the surface, and pixels of a panel."""

    faces: int = 10_000
    pixels: int = 620


FREE: Final = Bounds()

WIDE: Final = 46
"""Characters of a heading."""


def picture(
    case: Case,
    divergence: Divergence | None = None,
    outcome: Outcome | None = None,
    *,
    parent: Case | None = None,
    bounds: Bounds = FREE,
) -> Accepted[Scene] | Rejected:
    """The surface of a case; where an answer diverges; beside what the answer describes.

    Of a case that is about no surface because of its fault, the surface of its `parent`, and there
    the element to blame. Rejects with `not-drawable` what is about no surface, and too many faces.
    Clause: ORCL-EXPLAIN-5.
    """
    stage = None if divergence is None else _number(divergence.stage)
    right = _subject(case, stage)
    if isinstance(right, Rejected) and parent is not None:
        right = _subject(parent, None)
        divergence = _blamed(case, divergence)
    if isinstance(right, Rejected):
        return right
    known = _drawn(right.value, divergence, bounds)
    if divergence is None:
        return known
    title = f"{case.id}: {divergence.place}"
    got = _got(case, divergence, outcome, bounds)
    if isinstance(got, Rejected):
        heading = headed(divergence)
        return and_then(known, lambda one: Accepted(beside(title, ((heading, one),))))
    sides = (cut(f"expected {divergence.expected}"), cut(f"got {divergence.got}"))
    return and_then(
        known,
        lambda one: Accepted(beside(title, ((sides[0], one), (sides[1], got.value)))),
    )


def headed(divergence: Divergence) -> str:
    """What was expected and got, as far as it has room over a picture."""
    if not divergence.expected:
        return cut(f"the parent; to blame: {divergence.place}")
    return cut(f"expected {divergence.expected}, got {divergence.got}")


def cut(text: str) -> str:
    """The text, or its beginning, where it has more characters than a picture has room for."""
    return text if len(text) <= WIDE else f"{text[: WIDE - 1]}…"


def _got(
    case: Case, divergence: Divergence, outcome: Outcome | None, bounds: Bounds
) -> Accepted[Scene] | Rejected:
    """The surface that an answer describes, drawn at the same place."""
    request = operation_of(case)
    if isinstance(request, NoMessage) or not isinstance(outcome, Answered):
        return _refused("there is no answer")
    return and_then(got_by(request, outcome.result), lambda it: _drawn(it, divergence, bounds))


def _subject(case: Case, stage: int | None) -> Accepted[Subject] | Rejected:
    request, result = operation_of(case), right_result(case)
    if isinstance(request, NoMessage):
        return _refused(request.why)
    return subject_of(request, None if isinstance(result, NoMessage) else result, stage)


def _blamed(case: Case, divergence: Divergence | None) -> Divergence | None:
    """What a rejection blames as the place, with what was got instead. Clause: ORCL-EXPLAIN-5."""
    if isinstance(case.reject, UnsetType):
        return divergence
    at = case.reject.at
    face, symbol, record, vertex = (at.get(key) for key in ("face", "symbol", "record", "vertex"))
    return Divergence(
        kind="blamed",
        place=element_of(case.reject) or "the whole input",
        expected="" if divergence is None else divergence.expected,
        got="" if divergence is None else divergence.got,
        face=face if isinstance(face, int) else UNSET,
        symbol=symbol if isinstance(symbol, int) else UNSET,
        record=record if isinstance(record, int) else UNSET,
        vertex=vertex if isinstance(vertex, int) else UNSET,
    )


def _drawn(
    of: Subject, divergence: Divergence | None, bounds: Bounds
) -> Accepted[Scene] | Rejected:
    """The walk at the place of the divergence; the whole walk where there is none."""
    surface = of.mesh.surface
    if surface.faces > bounds.faces:
        return _refused(f"{surface.faces} faces, pictures are of at most {bounds.faces}")
    options = Options(pointer=NOWHERE)
    if divergence is not None:
        at = pointer(of, divergence)
        step = of.step_of(at.faces[0]) if at.faces else surface.faces
        options = Options(steps=(step,), pointer=at, size=bounds.pixels)
    drawn = draw(surface, of.encoding, of.mesh.positions, options)
    return and_then(drawn, lambda found: Accepted(scene(found)))


def pointer(of: Subject, divergence: Divergence) -> Pointer:
    """What to point at: a face by its number or its symbol, a vertex, the triangle got instead.

    Clause: ORCL-EXPLAIN-5.
    """
    face = _number(divergence.face)
    symbol = _number(divergence.symbol)
    record = _number(divergence.record)
    if face is None and record is not None:
        symbol = _split(of, record)
    if face is None and symbol is not None:
        face = of.face_of_symbol(symbol)
    component = _number(divergence.component)
    if face is None and component is not None:
        parts = components(of.mesh.surface)
        face = parts[component].lowest if component < len(parts) else None
    vertex = _number(divergence.vertex)
    return Pointer(
        () if face is None else (face,),
        () if vertex is None else (vertex,),
        _instead(of, face, divergence.triangle),
    )


def _instead(
    of: Subject, face: int | None, triangle: tuple[int, int, int] | UnsetType
) -> tuple[int, int, int] | None:
    """The triangle got, unless it is the face itself, turned or turned over."""
    if isinstance(triangle, UnsetType):
        return None
    vertex = of.mesh.surface.vertex
    same = face is not None and sorted(vertex[3 * face : 3 * face + 3]) == sorted(triangle)
    return None if same else triangle


def _split(of: Subject, record: int) -> int | None:
    """The place in the word of a record's S. Clause: EB-HANDLE-1."""
    stream = of.encoding.stream
    if not 0 <= record < len(stream.records):
        return None
    splits = [i for i, x in enumerate(stream.word) if x == "S"]
    return splits[stream.records[record].s]


def _number(given: int | UnsetType) -> int | None:
    return None if isinstance(given, UnsetType) else given


def _refused(detail: str) -> Rejected:
    return Rejected(Reason.NOT_DRAWABLE, Clause.ORCL_EXPLAIN_5, detail=detail)
