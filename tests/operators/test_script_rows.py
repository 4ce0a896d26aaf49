"""Random scripts reach every row of the table of effects and every obstacle, and nothing else."""

from functools import cache

from clers.generate.kinds import random_script
from clers.operators.effect import Effect
from clers.operators.script import SplitEdge, SplitFace, steps
from clers.operators.script_text import name_of
from clers.operators.step import Did, Idle

ROWS = {
    ("split-face", Effect()),
    ("split-edge", Effect()),
    ("flip-edge", Effect()),
    ("relabel", Effect()),
    ("add-ear", Effect()),
    ("fill-corner", Effect()),
    ("fill-corner", Effect(curves=-1)),
    ("close-curve", Effect(curves=-1)),
    ("open-curve", Effect(curves=1)),
    ("remove-face", Effect()),
    ("remove-face", Effect(curves=1)),
    ("remove-face", Effect(components=-1, curves=-1)),
    ("remove-star", Effect(curves=1)),
    ("cut-edge", Effect()),
    ("cut-edge", Effect(curves=-1)),
    ("cut-edge", Effect(components=1, curves=1)),
    ("cut-edge", Effect(genus=-1, curves=1)),
    ("add-tetrahedron", Effect(components=1)),
    ("add-handle", Effect(genus=1)),
    ("join-components", Effect(components=-1)),
    ("bridge", Effect(components=-1, curves=-1)),
    ("bridge", Effect(curves=1)),
    ("bridge", Effect(genus=1, curves=-1)),
}
OBSTACLES = {
    ("flip-edge", "no-candidate"),
    ("flip-edge", "edge-exists"),
    ("add-ear", "no-candidate"),
    ("fill-corner", "no-candidate"),
    ("fill-corner", "edge-exists"),
    ("fill-corner", "face-exists"),
    ("close-curve", "no-candidate"),
    ("remove-face", "last-face"),
    ("remove-face", "would-pinch"),
    ("remove-star", "no-candidate"),
    ("remove-star", "would-pinch"),
    ("cut-edge", "no-candidate"),
    ("cut-edge", "inner-edge"),
    ("add-handle", "no-candidate"),
    ("join-components", "no-candidate"),
    ("bridge", "no-candidate"),
    ("bridge", "shared-vertex"),
    ("bridge", "edge-exists"),
}


@cache
def seen() -> tuple[frozenset[tuple[str, Effect]], frozenset[tuple[str, str]]]:
    """The effects and the obstacles of many scripts, by the operators' names."""
    rows: set[tuple[str, Effect]] = set()
    obstacles: set[tuple[str, str]] = set()
    for seed in range(900):
        script = random_script(seed, 5 + seed % 50)
        if seed % 2:  # leave out what grows, to come near the last face
            script = tuple(
                operator for operator in script if not isinstance(operator, SplitFace | SplitEdge)
            )
        for operator, step in zip(script, steps(script), strict=True):
            match step.outcome:
                case Did(effect):
                    rows.add((name_of(operator), effect))
                case Idle(obstacle):
                    obstacles.add((name_of(operator), str(obstacle)))
    return frozenset(rows), frozenset(obstacles)


def test_every_row() -> None:
    """OPER-SCRIPT-5."""
    assert seen()[0] == ROWS


def test_every_obstacle() -> None:
    """OPER-SCRIPT-2."""
    assert seen()[1] == OBSTACLES
