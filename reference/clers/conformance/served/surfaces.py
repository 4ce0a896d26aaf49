"""`surface.classify` and `operator.apply`."""

from clers.complexes.topology import Component, components
from clers.conformance import payloads as form
from clers.conformance.served.forms import surface_of
from clers.conventions.result import Accepted, Rejected, and_then
from clers.operators.families import AnyScript, read, stages


def classify(given: form.Faces) -> Accepted[form.Classified] | Rejected:
    """The counts of each component. Clause: ORCL-OP-2."""
    return and_then(
        surface_of(given),
        lambda s: Accepted(form.Classified(components=tuple(map(_component, components(s))))),
    )


def _component(c: Component) -> form.ComponentForm:
    return form.ComponentForm(
        faces=c.faces,
        vertices=c.vertices,
        edges=c.edges,
        boundary_edges=c.boundary_edges,
        curves=c.curves,
        genus=c.genus,
        euler=c.euler,
    )


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
