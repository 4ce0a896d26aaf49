"""Scripts held within bounds: so many faces, components, handles and boundary curves."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from clers.complexes.face_list import FaceList
from clers.operators.effect import Effect
from clers.operators.script import START, Operator, Script, apply
from clers.operators.step import Did, Idle

Range = tuple[int, int]
"""The lowest and the highest number allowed, both included."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """What a generated surface may be; genus and curves are summed over its components."""

    faces: int
    components: Range
    genus: Range
    curves: Range

    def allow(self, totals: Effect) -> bool:
        """Are these numbers of components, handles and curves within the ranges?"""
        return (
            self.components[0] <= totals.components <= self.components[1]
            and self.genus[0] <= totals.genus <= self.genus[1]
            and self.curves[0] <= totals.curves <= self.curves[1]
        )


@dataclass(frozen=True, slots=True)
class Grown:
    """A script with the mesh it ends with and that mesh's components, genus and curves."""

    script: Script
    mesh: FaceList
    totals: Effect


FIRST = Grown((), START, Effect(components=1))
"""The empty script's."""


def go_on(grown: Grown, operators: Iterable[Operator]) -> Grown:
    """Append operators, whatever they do."""
    script = list(grown.script)
    mesh, totals = grown.mesh, grown.totals
    for operator in operators:
        step = apply(operator, mesh)
        script.append(operator)
        mesh = step.mesh
        match step.outcome:
            case Did(effect):
                totals += effect
            case Idle():
                pass
    return Grown(tuple(script), mesh, totals)


def go_on_within(grown: Grown, operators: Sequence[Operator], bounds: Bounds) -> Grown:
    """Append those operators that do something and stay within the bounds."""
    script = list(grown.script)
    mesh, totals = grown.mesh, grown.totals
    for operator in operators:
        step = apply(operator, mesh)
        match step.outcome:
            case Did(effect):
                if len(step.mesh.faces) <= bounds.faces and bounds.allow(totals + effect):
                    script.append(operator)
                    mesh, totals = step.mesh, totals + effect
            case Idle():
                pass
    return Grown(tuple(script), mesh, totals)
