"""Where counts of components, and stages of scripts, part. Clauses: ORCL-DIVERGE-7, -8."""

import msgspec

from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import parting


def of_components(right: form.Classified, got: form.Classified) -> Divergence | None:
    """The first component, and the first of its numbers. Clause: ORCL-DIVERGE-7."""
    k = parting(right.components, got.components)
    if k is None:
        return None
    if k >= min(len(right.components), len(got.components)):
        return Divergence(
            kind="component",
            place=f"component {k}",
            expected=f"{len(right.components)} in all",
            got=f"{len(got.components)} in all",
            component=k,
        )
    expected = msgspec.structs.asdict(right.components[k])
    given = msgspec.structs.asdict(got.components[k])
    name = next(name for name in expected if expected[name] != given[name])
    return Divergence(
        kind=name,
        place=f"component {k}, {name}",
        expected=str(expected[name]),
        got=str(given[name]),
        component=k,
    )


def of_stages(right: form.Stages, got: form.Stages) -> Divergence | None:
    """The first stage, and what of it: the operator, a number, idle. Clause: ORCL-DIVERGE-8."""
    k = parting(right.stages, got.stages)
    if k is None:
        return None
    if k >= min(len(right.stages), len(got.stages)):
        return Divergence(
            kind="stage",
            place=f"stage {k}",
            expected=f"{len(right.stages)} in all",
            got=f"{len(got.stages)} in all",
            stage=k,
        )
    kind, what, expected, given = _parting(right.stages[k], got.stages[k])
    return Divergence(
        kind=kind,
        place=f"stage {k} ({right.stages[k].operator or 'the start'}), {what}",
        expected=expected,
        got=given,
        stage=k,
    )


def _parting(right: form.StageForm, got: form.StageForm) -> tuple[str, str, str, str]:
    """What kind of thing differs, what it is, and the two of it."""
    if right.operator != got.operator:
        return "operator", "the operator", right.operator or NONE, got.operator or NONE
    for name in dict.fromkeys((*right.numbers, *got.numbers)):
        expected, given = right.numbers.get(name), got.numbers.get(name)
        if expected != given:
            return "number", name, _said(expected), _said(given)
    return "idle", "why nothing was done", right.idle or "it was done", got.idle or "it was done"


def _said(number: int | None) -> str:
    return NONE if number is None else str(number)


NONE = "none"
