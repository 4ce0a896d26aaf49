"""`operator.apply`."""

from clers.conformance import payloads as form
from clers.conventions.result import Accepted, Rejected, and_then
from clers.operators.families import AnyScript, read, stages


def apply(given: form.ScriptForm) -> Accepted[form.Stages] | Rejected:
    """The stages of a script, or why it does not apply. Clause: ORCL-OP-3."""
    return and_then(read(given.script), _stages)


def _stages(script: AnyScript) -> Accepted[form.Stages] | Rejected:
    done, fault = stages(script)
    if fault is not None:
        return fault
    return Accepted(
        form.Stages(
            stages=tuple(
                form.StageForm(operator=s.operator, numbers=dict(s.numbers), idle=s.idle)
                for s in done
            )
        )
    )
