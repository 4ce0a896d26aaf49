"""Where the steps of a walk part, as far as an adapter tells them. Clause: ORCL-DIVERGE-9."""

from collections.abc import Callable, Sequence

import msgspec

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import NOTHING, listed
from clers.conformance.messages import Operation, Step
from clers.conformance.served import words
from clers.conformance.served.forms import handle_forms
from clers.container.contents import Contents, parse
from clers.conventions.result import Accepted, Rejected, and_then

Walk = Callable[[], Sequence[Step]]
"""A walk that is walked only where something diverges."""


def unknown() -> tuple[Step, ...]:
    """A walk of which nothing is known."""
    return ()


def walk_of(case: Case, request: Operation) -> tuple[Step, ...]:
    """The walk on the way to the right answer: the case's own, else the reference's, if any.

    Clauses: ORCL-CASE-1, ORCL-EVENT-1, ORCL-DIVERGE-9.
    """
    if case.trace:
        return case.trace
    match request:
        case message.WordEncode(input=given):
            found = words.steps_of_encoding(given)
        case message.WordDecode(input=given):
            found = words.steps_of_decoding(given)
        case message.MeshDecode(input=given):
            found = and_then(parse(bytes.fromhex(given.hex)), _walk_over)
        case _:
            return ()
    return found.value if isinstance(found, Accepted) else ()


def _walk_over(contents: Contents) -> Accepted[tuple[Step, ...]] | Rejected:
    """The walk over what a file contains. Clause: ORCL-DIVERGE-5."""
    stream = contents.stream
    return words.steps_of_decoding(
        form.StreamForm(
            word=stream.word,
            handles=handle_forms(stream.records),
            components_with_boundary=stream.components_with_boundary,
        )
    )


def of_steps(right: Sequence[Step], got: Sequence[Step]) -> Divergence | None:
    """The first step, and the first of the keys that the adapter gave of it; of no steps nothing.

    Clauses: ORCL-DIVERGE-9, ORCL-JUDGE-9.
    """
    for k, step in enumerate(got):
        if k >= len(right):
            return _at(k, step, "step", NOTHING, f"symbol {step.symbol}")
        expected = msgspec.structs.asdict(right[k])
        for key, value in msgspec.structs.asdict(step).items():
            if value is not msgspec.UNSET and value != expected[key]:
                return _at(k, right[k], f"step, {key}", _said(expected[key]), _said(value))
    if got and len(got) < len(right):
        missing = right[len(got)]
        return _at(len(got), missing, "step", f"symbol {missing.symbol}", NOTHING)
    return None


def _at(k: int, step: Step, kind: str, expected: str, given: str) -> Divergence:
    return Divergence(
        kind=kind,
        place=f"step {k}",
        expected=expected,
        got=given,
        symbol=step.i if step.i >= 0 else msgspec.UNSET,
        face=step.face,
    )


def _said(value: object) -> str:
    return listed(value) if isinstance(value, tuple) else str(value)
