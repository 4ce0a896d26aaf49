"""Our own codes as contenders: from an index list to a file and back; and the steps apart."""

from itertools import islice
from typing import Final

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface_of_indices
from clers.container import file
from clers.container.options import Options
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.measure.clock import now
from clers.measure.path import timed_path
from clers.measure.speed.contender import Attempt, Contender, Given, Kind, Reading, Way

CODES: Final = (CodeName.GOLDEN, CodeName.BEST)
"""The codes that are timed. Clause: TOOL-SPEED-1."""

STEPS: Final = {
    "surface": Way.ENCODE,
    "walk": Way.ENCODE,
    "code": Way.ENCODE,
    "decode code": Way.DECODE,
    "decode walk": Way.DECODE,
}
"""The first steps of the path, in its order. Clause: TOOL-SPEED-3."""


def step_name(code: str, step: str) -> str:
    """What a step of a code's path is called."""
    return f"{code}: {step}"


def whole(code: CodeName) -> Contender:
    """From an index list to the bytes of a file, and from those to a surface. TOOL-SPEED-1."""

    def ready(given: Given) -> Accepted[Attempt] | Rejected:
        return Accepted(lambda: _there_and_back(code, given))

    return Contender(code, Kind.CODE, ready)


def _there_and_back(code: CodeName, given: Given) -> Accepted[tuple[Reading, ...]] | Rejected:
    start = now()
    data = and_then(
        surface_of_indices(given.indices), lambda s: file.encode(s, None, Options(code))
    )
    encoded = now() - start
    if isinstance(data, Rejected):
        return data
    start = now()
    mesh = file.decode(data.value)
    decoded = now() - start
    if isinstance(mesh, Rejected):
        return mesh
    if (mesh.value.surface.faces, mesh.value.surface.vertices) != (
        given.surface.faces,
        given.surface.vertices,
    ):
        return Rejected(Reason.CAME_BACK_CHANGED, Clause.TOOL_SPEED_1, detail=given.name)
    return Accepted(
        (
            Reading(code, Way.ENCODE, encoded, len(data.value)),
            Reading(code, Way.DECODE, decoded),
        )
    )


def steps(code: CodeName) -> Contender:
    """The steps of the same path, one after another. Clause: TOOL-SPEED-3."""

    def ready(given: Given) -> Accepted[Attempt] | Rejected:
        def attempt() -> Accepted[tuple[Reading, ...]]:
            timed = islice(timed_path(given.indices, code), len(STEPS))
            return Accepted(
                tuple(
                    Reading(step_name(code, each.step), STEPS[each.step], each.spent)
                    for each in timed
                )
            )

        return Accepted(attempt)

    return Contender(step_name(code, "steps"), Kind.STEP, ready)


OURS: Final = (*map(whole, CODES), *map(steps, CODES))
"""Clauses: TOOL-SPEED-1, TOOL-SPEED-3."""
