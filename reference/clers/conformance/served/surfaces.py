"""`surface.classify`."""

from clers.complexes.topology import Component, components
from clers.conformance import payloads as form
from clers.conformance.served.forms import surface_of
from clers.conventions.result import Accepted, Rejected, and_then


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
