"""Where a word, its handle data or the order of its vertices parts. Clause: ORCL-DIVERGE-1."""

from collections.abc import Sequence

from msgspec import UNSET, UnsetType

from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import NOTHING, parting, shown
from clers.conformance.judging.steps import Walk, unknown
from clers.conformance.messages import Step
from clers.conformance.numbers import from_wire


def of_encoding(right: form.WordForm, got: form.WordForm, walk: Walk) -> Divergence | None:
    """The first of symbol, record, components with boundary and vertex. ORCL-DIVERGE-1."""
    return (
        of_word(right.word, got.word, walk)
        or of_records(right.handles, got.handles)
        or _of_components(right, got)
        or _of_order(right.vertex_order, got.vertex_order)
    )


def of_word(right: str, got: str, walk: Walk = unknown) -> Divergence | None:
    """The first symbol, and the face there if the walk is known. ORCL-DIVERGE-1, -6."""
    i = parting(right, got)
    if i is None:
        return None
    step = next((step for step in walk() if step.i == i), None)
    return Divergence(
        kind="symbol",
        place=f"symbol {i}" + ("" if step is None else _standing(step)),
        expected=shown(right, i),
        got=shown(got, i),
        symbol=i,
        face=UNSET if step is None else step.face,
    )


def _standing(step: Step) -> str:
    """Where the walk stands, as far as the step says it."""
    face = "" if isinstance(step.face, UnsetType) else f", at face {step.face}"
    gate = "" if isinstance(step.gate, UnsetType) else f", gate {step.gate[0]}→{step.gate[1]}"
    return face + gate


def _record(h: form.HandleForm) -> tuple[str, int, int, str]:
    return h.kind, from_wire(h.s), from_wire(h.at), h.side


def of_records(
    right: Sequence[form.HandleForm], got: Sequence[form.HandleForm]
) -> Divergence | None:
    """The first record of the handle data. Clause: ORCL-DIVERGE-1."""
    i = parting(list(map(_record, right)), list(map(_record, got)))
    if i is None:
        return None
    return Divergence(
        kind="record",
        place=f"handle record {i}",
        expected=_told(right, i),
        got=_told(got, i),
        record=i,
    )


def _told(records: Sequence[form.HandleForm], i: int) -> str:
    if i >= len(records):
        return NOTHING
    h = records[i]
    return f"{h.kind} of S {h.s}, closed at {h.at}, {h.side}"


def _of_components(right: form.WordForm, got: form.WordForm) -> Divergence | None:
    expected, given = (
        from_wire(right.components_with_boundary),
        from_wire(got.components_with_boundary),
    )
    if expected == given:
        return None
    return Divergence(
        kind="components with boundary",
        place="the number of components with boundary",
        expected=str(expected),
        got=str(given),
    )


def _of_order(right: Sequence[int], got: Sequence[int]) -> Divergence | None:
    k = parting(right, got)
    if k is None:
        return None
    vertex = right[k] if k < len(right) else got[k]
    return Divergence(
        kind="vertex order",
        place=f"place {k} of the vertex order",
        expected=shown(right, k),
        got=shown(got, k),
        vertex=vertex,
    )
