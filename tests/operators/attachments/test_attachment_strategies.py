"""What examples of attachments shrink to when something is broken on purpose."""

from collections import Counter
from collections.abc import Callable
from random import Random
from typing import TypeVar

import pytest
from hypothesis import HealthCheck, find, given, settings
from hypothesis import strategies as st

from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails
from clers.generate.attached_manifolds import at_manifolds, manifolds
from clers.generate.attachments import attachment_scripts, complexes, gluable
from clers.operators.attachments import classes, laws
from clers.operators.attachments.apply import run
from clers.operators.attachments.attachment import Attachment, attach
from clers.operators.attachments.classes import Growth, growth, handles
from clers.operators.attachments.given import Gluable
from clers.operators.attachments.operator import Attach, Undo

X = TypeVar("X")

FINDING = settings(
    max_examples=500, database=None, deadline=None, suppress_health_check=list(HealthCheck)
)


def smallest(of: st.SearchStrategy[X], wanted: Callable[[X], bool]) -> X:
    """The example that Hypothesis shrinks to."""
    return find(of, wanted, settings=FINDING, random=Random(0))


def test_a_planted_bug_in_the_growth(monkeypatch: pytest.MonkeyPatch) -> None:
    """χ that forgets the triangles along which a simplex is glued: a tetrahedron on a triangle."""

    def forgetful(glued: Attachment) -> Growth:
        right = growth(glued)
        return Growth(right.counts, right.euler + sum(len(face) == 3 for face in glued.along))

    monkeypatch.setattr(laws, "growth", forgetful)
    (law,) = [law for law in laws.LAWS if law.name == "attachment-growth"]
    found = smallest(gluable(), lambda g: isinstance(law.check(g), Fails))
    assert found == Gluable(closure([(0, 1, 2)]), Attachment((0, 1, 2, 3), ((0, 1, 2),)))


def test_a_planted_bug_in_the_handles(monkeypatch: pytest.MonkeyPatch) -> None:
    """Handles that take two points for one: an edge between two points."""

    def forgetful(glued: Attachment) -> tuple[int, ...]:
        right = handles(glued)
        return (*right[:1], *(min(h, 0) for h in right[1:2]), *right[2:])

    monkeypatch.setattr(laws, "handles", forgetful)
    (law,) = [law for law in laws.LAWS if law.name == "attachment-relative-homology"]
    found = smallest(gluable(), lambda g: isinstance(law.check(g), Fails))
    assert found == Gluable(closure([(0,), (1,)]), Attachment((0, 1), ((0,), (1,))))


def test_a_script_with_something_undone() -> None:
    """A vertex, and away again."""
    scripts = attachment_scripts(3, 4)
    found = smallest(scripts, lambda s: any(isinstance(step, Undo) for step in s))
    assert found == (Attach(Attachment((0,))), Undo(Attach(Attachment((0,)))))


def test_a_script_of_dimension_four() -> None:
    found = smallest(attachment_scripts(), lambda s: any(len(_simplex(step)) == 5 for step in s))
    assert found == (Attach(Attachment((0, 1, 2, 3, 4))),)


def _simplex(step: object) -> tuple[int, ...]:
    return step.glued.simplex if isinstance(step, Attach) else ()


def test_a_pinch_on_a_surface() -> None:
    """A triangle at a vertex of few."""
    found = smallest(
        at_manifolds(),
        lambda g: (
            dimension(g.before) == 2
            and isinstance(attach(g.before, g.glued), Accepted)
            and classes.pinches(g.glued) != ()
        ),
    )
    assert len(of_dimension(found.before, 2)) <= 4
    assert len(classes.pinches(found.glued)) == 1


def test_scripts_run_to_their_end() -> None:
    @given(attachment_scripts())
    def holds(script: tuple[Attach, ...]) -> None:
        steps = run(script)
        assert len(steps) == len(script)
        assert all(isinstance(step, Accepted) for step in steps)

    holds()


@pytest.mark.parametrize("n", [1, 2, 3])
def test_manifolds_are_manifolds(n: int) -> None:
    @given(manifolds(n))
    def holds(k: Complex) -> None:
        found = manifold(k)
        assert isinstance(found, Manifold)
        assert found.dimension == n

    holds()


def test_kinds_of_examples() -> None:
    """Most attachments apply; some do not; complexes reach dimension 4 and the empty one."""
    seen: Counter[str] = Counter()

    @settings(max_examples=100)
    @given(gluable(), complexes())
    def look(case: Gluable, k: Complex) -> None:
        applies = isinstance(attach(case.before, case.glued), Accepted)
        seen["applies" if applies else "does not"] += 1
        seen["euler"] += applies and not any(handles(case.glued))
        seen["pinched"] += applies and classes.pinches(case.glued) != ()
        seen[f"dimension {dimension(k)}"] += 1
        seen["empty"] += not of_dimension(k, 0)

    look()
    assert seen["applies"] >= 50
    assert seen["does not"] >= 5
    assert min(seen[kind] for kind in ("euler", "pinched", "dimension 4", "empty")) >= 1
