"""Handles on curves, surfaces and 3-manifolds: Figures 11 and 12, the table, and built solids."""

from pathlib import Path

import pytest

from clers.complexes.homology import Field, betti
from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import Complex, boundary, closure, dimension, euler, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex
from clers.generate.attached_manifolds import SHELL
from clers.operators.attachments.apply import NOTHING, apply, run
from clers.operators.attachments.attachment import Attachment
from clers.operators.attachments.classes import growth, handles, pinches, ways
from clers.operators.attachments.examples import (
    BALL,
    SOLID_TORUS,
    SPHERE_TIMES_CIRCLE,
    THREE_SPHERE,
    build,
    from_simplices,
    sphere,
    times_circle,
    upright,
)
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    Handle,
    Script,
    Undo,
    inverse,
)
from clers.operators.attachments.solid import (
    TABLE,
    SolidCase,
    SolidChange,
    handle,
    prism,
    solid_case,
    solid_change,
)
from clers.operators.moves.recognise import recognise

PAGE = Path(__file__).parents[3] / "spec" / "04-attachments.md"


def done(k: Complex, operator: Handle) -> Complex:
    """The complex after a handle, which can be undone."""
    after = apply(operator, k)
    assert isinstance(after, Accepted), after
    assert apply(Undo(operator), after.value) == Accepted(k)
    return after.value


def whole(script: Script) -> Complex:
    """What a script that runs to its end builds."""
    (*_, last) = run(script)
    assert isinstance(last, Accepted)
    assert len(run(script)) == len(script)
    return last.value


def test_the_28_ways_of_the_clause() -> None:
    """The table was written by hand. Clause: OPER-SOLID-3."""
    lines = PAGE.read_text("utf-8").replace("−", "-").splitlines()
    start = next(i for i, row in enumerate(lines) if row.startswith("> | $A$ |"))
    rows = [[c.strip() for c in row.split("|")[1:-1]] for row in lines[start + 2 : start + 30]]
    assert len(rows) == len(ways(3)) == 28
    assert not lines[start + 30].startswith("> |")
    words = {"one": 1, "two": 2, "three": 3}
    for row, glued in zip(rows, ways(3), strict=True):
        along = "" if row[0] == "–" else row[0]
        assert tuple(tuple(map(int, face)) for face in along.split()) == glued.along
        assert tuple(map(int, row[1:5])) == growth(glued).counts
        assert int(row[5]) == growth(glued).euler
        found = [0, 0, 0, 0]
        for phrase in row[6].split(", "):
            if phrase != "none":
                count, index = phrase.split()
                found[int(index[0])] = words[count]
        assert tuple(found) == handles(glued)
        assert (int(row[7]) if row[7] else 0) == len(pinches(glued))


def test_only_whole_triangles_keep_every_manifold() -> None:
    """Clause: OPER-SOLID-3."""
    kept = [glued.along for glued in ways(3) if not pinches(glued)]
    assert kept == [
        (),
        ((0, 1, 2),),
        ((0, 1, 2), (0, 1, 3)),
        ((0, 1, 2), (0, 1, 3), (0, 2, 3)),
        ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)),
    ]


def test_the_table_of_the_clause() -> None:
    """Clause: OPER-SOLID-5."""
    text = PAGE.read_text("utf-8").replace("−", "-")
    for case, change in TABLE.items():
        (row,) = [r for r in text.splitlines() if r.startswith(f"> | {case} |")]
        assert SolidChange(*(int(cell) for cell in row.split("|")[2:-1])) == change
        assert 2 * change.euler == 2 * change.surfaces - 2 * change.genus


def test_figure_11() -> None:
    """A strip of five triangles, closed by two to an annulus: b + 1, χ − 1. OPER-SOLID-1."""
    strip = closure([(0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 5), (4, 5, 6)])
    lower = handle(strip, prism((0, 1), (6, 5)))
    assert lower == Handle(
        Attachment((0, 1, 6), ((0, 1), (6,))), (Attachment((1, 5, 6), ((1, 6), (5, 6))),)
    )
    annulus = done(strip, lower)
    assert betti(annulus, Field.Q) == (1, 1, 0)
    assert (euler(strip), euler(annulus)) == (1, 0)
    assert betti(boundary(annulus), Field.GF2) == (2, 2)


def test_figure_11_turned_over() -> None:
    """The other way round it is a Möbius band: a handle asks for no orientation. OPER-SOLID-4."""
    strip = closure([(0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 5), (4, 5, 6)])
    band = done(strip, handle(strip, prism((0, 1), (5, 6))))
    assert betti(band, Field.Q) == (1, 1, 0)
    assert betti(boundary(band), Field.GF2) == (1, 1)


def test_figure_12() -> None:
    """The annulus again, its two curves joined by two triangles: g + 1, b − 1. OPER-SOLID-1."""
    levels = [closure(s for i in range(3) for s in _quad(i, t)) for t in range(2)]
    annulus = Complex(levels[0].simplices | levels[1].simplices)
    upper = handle(annulus, prism((0, 1), (6, 7)))
    torus = done(annulus, upper)
    assert (euler(annulus), euler(torus)) == (0, -1)
    assert betti(boundary(annulus), Field.GF2) == (2, 2)
    assert betti(boundary(torus), Field.GF2) == (1, 1)
    assert isinstance(manifold(torus), Manifold)


def _quad(i: int, t: int) -> tuple[tuple[int, ...], ...]:
    a, b = 3 * t + i, 3 * t + (i + 1) % 3
    return ((a, b, a + 3), (b, a + 3, b + 3))


def test_the_handles_of_curves() -> None:
    """An edge between two ends is a handle of one attachment. OPER-SOLID-1, OPER-SOLID-4."""
    arc = closure([(0, 1), (1, 2)])
    assert handle(arc, prism((0,), (2,))) == Handle(Attachment((0, 2), ((0,), (2,))))
    assert done(arc, handle(arc, prism((0,), (2,)))) == closure([(0, 1), (1, 2), (0, 2)])
    then = (Attachment((3, 4), ((3,),)),)
    refused = apply(Handle(Attachment((0, 3), ((0,),)), then), arc)
    assert isinstance(refused, Rejected)
    assert (refused.clause, refused.where) == (Clause.OPER_SOLID_1, AtSimplex((0, 3)))
    assert done(NOTHING, Handle(Attachment((5,)))) == closure([(5,)])
    assert done(closure([(5,)]), Handle(Attachment((6,)))) == closure([(5,), (6,)])


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_a_prism_is_a_one_handle(n: int) -> None:
    """Between two simplices apart: n simplices, and one of them alone pinches. OPER-SOLID-4."""
    apart = closure([range(n + 1), range(n + 1, 2 * n + 2)])
    joined = handle(apart, prism(tuple(range(n)), tuple(range(n + 1, 2 * n + 1))))
    assert 1 + len(joined.then) == n
    assert handles(joined.first) == (0, 1, *[0] * (n - 1))
    after = done(apart, joined)
    assert betti(after, Field.Q) == (1, *[0] * n)
    assert isinstance(manifold(after, recognise), Manifold)
    assert len(of_dimension(after, n)) == n + 2
    alone = apply(Handle(joined.first), apart)
    assert isinstance(alone, Accepted) == (n == 1)


def test_the_prism_of_three_dimensions() -> None:
    """Its tetrahedra by hand; the second is glued along a triangle and an edge. OPER-SOLID-4."""
    assert prism((0, 1, 2), (4, 5, 6)) == ((0, 1, 2, 4), (1, 2, 4, 5), (2, 4, 5, 6))
    apart = closure([(0, 1, 2, 3), (4, 5, 6, 7)])
    assert handle(apart, prism((0, 1, 2), (4, 5, 6))).then == (
        Attachment((1, 2, 4, 5), ((1, 2, 4), (4, 5))),
        Attachment((2, 4, 5, 6), ((2, 4, 5), (4, 5, 6))),
    )


def test_a_handle_that_stays_pinched() -> None:
    """Two of the three tetrahedra of a prism. Clause: OPER-SOLID-2."""
    apart = closure([(0, 1, 2, 3), (4, 5, 6, 7)])
    two = handle(apart, prism((0, 1, 2), (4, 5, 6))[:2])
    refused = apply(two, apart)
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.clause, refused.where) == (
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.OPER_SOLID_2,
        AtSimplex((4,)),
    )


TWO_TETRAHEDRA = closure([(0, 1, 2, 3), (4, 5, 6, 7)])
TORUS = closure(s for t in range(3) for s in upright((0, 1, 2), t))
OTHERS = ((0, 1, 3), (0, 2, 3))
ALL_BUT_ONE = closure(s for f in ((0, 1, 2), *OTHERS) for t in range(3) for s in upright(f, t))
OPENED = closure(
    s
    for part in (
        upright((0, 1, 2), 3, 4),
        *(upright(f, t, 4) for f in (*OTHERS, (1, 2, 3)) for t in range(4)),
    )
    for s in part
)
LONG = closure((i, i + 1, i + 2, i + 3) for i in range(6))
HOLLOW = closure(s for s in of_dimension(whole(THREE_SPHERE), 3) if 0 in s)

CASES: tuple[tuple[Complex, Handle, SolidCase], ...] = (
    (TORUS, handle(TORUS, ((20, 21, 22, 23),)), SolidCase.ZERO),
    (TORUS, handle(TORUS, ((0, 1, 4, 23),)), SolidCase.EULER),
    (TWO_TETRAHEDRA, handle(TWO_TETRAHEDRA, prism((0, 1, 2), (4, 5, 6))), SolidCase.ONE_OF_TWO),
    (LONG, handle(LONG, prism((0, 1, 2), (6, 7, 8))), SolidCase.ONE_AT),
    (SHELL, handle(SHELL, prism((0, 1, 2), (8, 9, 10))), SolidCase.ONE_BETWEEN),
    (ALL_BUT_ONE, handle(ALL_BUT_ONE, upright((1, 2, 3), 0)), SolidCase.TWO_OPENS),
    (OPENED, handle(OPENED, upright((0, 1, 2), 1, 4)), SolidCase.TWO_SPLITS),
    (HOLLOW, handle(HOLLOW, ((1, 2, 3, 4),)), SolidCase.THREE),
)


@pytest.mark.parametrize(("k", "operator", "case"), CASES, ids=[case for *_, case in CASES])
def test_case(k: Complex, operator: Handle, case: SolidCase) -> None:
    """One solid for each row; what it is was seen beforehand. Clause: OPER-SOLID-5."""
    assert isinstance(manifold(k), Manifold)
    after = done(k, operator)
    assert isinstance(manifold(after), Manifold)
    assert solid_case(k, operator) is case
    assert solid_change(k, after) == TABLE[case]


def test_several_handles_at_once_have_no_row() -> None:
    """Clause: OPER-SOLID-5."""
    glued = Attachment((0, 4, 8, 12), ((0,), (4,), (8,)))
    assert solid_case(TWO_TETRAHEDRA, Handle(glued)) is None


# Homology from the literature: ball, 3-sphere, solid torus, S² × S¹; indices of the handles by
# the usual decompositions.
BUILT: tuple[tuple[str, Script, tuple[int, ...], tuple[int, ...], list[int], int], ...] = (
    ("ball", BALL, (4, 6, 4, 1), (1, 0, 0, 0), [0], 1),
    ("3-sphere", THREE_SPHERE, (5, 10, 10, 5), (1, 0, 0, 1), [0, 3], 0),
    ("solid torus", SOLID_TORUS, (9, 27, 27, 9), (1, 1, 0, 0), [0, 1], 1),
    ("S² × S¹", SPHERE_TIMES_CIRCLE, (12, 48, 72, 36), (1, 1, 1, 1), [0, 1, 2, 3], 0),
)


@pytest.mark.parametrize(
    ("name", "script", "counts", "numbers", "indices", "surfaces"), BUILT, ids=[b[0] for b in BUILT]
)
def test_built(
    name: str,
    script: Script,
    counts: tuple[int, ...],
    numbers: tuple[int, ...],
    indices: list[int],
    surfaces: int,
) -> None:
    """Clause: OPER-SOLID-6."""
    k = whole(script)
    assert tuple(len(of_dimension(k, m)) for m in range(4)) == counts, name
    assert betti(k, Field.Q) == betti(k, Field.GF2) == numbers
    assert isinstance(manifold(k), Manifold)
    rim = boundary(k)
    assert (sum(betti(rim, Field.GF2)[:1])) == surfaces
    found = [handles(step.first).index(1) for step in script if isinstance(step, Handle)]
    assert found == indices
    assert all(isinstance(step, Handle | BoundaryAttach) for step in script)
    (*_, nothing) = run(tuple(map(inverse, reversed(script))), k)
    assert nothing == Accepted(NOTHING)


def test_the_boundary_of_the_solid_torus() -> None:
    """A torus. Clause: OPER-SOLID-6."""
    assert betti(boundary(whole(SOLID_TORUS)), Field.Q) == (1, 2, 1)


def test_the_simplices_of_the_scripts() -> None:
    """Each script adds what it was asked to, and leaves out what fits nowhere. OPER-SOLID-6."""
    assert whole(SOLID_TORUS) == TORUS
    assert whole(sphere(2)) == closure([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])
    assert [type(step) for step in sphere(2)] == [Handle, BoundaryAttach, BoundaryAttach, Handle]
    longer = whole(times_circle([(0, 1, 2)], 4))
    assert (dimension(longer), len(of_dimension(longer, 3))) == (3, 12)
    pinched = from_simplices([[(0, 1, 2)], [(2, 3, 4)], [(0, 1, 3)]])
    assert whole(pinched) == closure([(0, 1, 2), (0, 1, 3)])
    assert upright((0, 1), 2) == ((8, 9, 0), (9, 0, 1))


def test_build_glues_maximal_simplices() -> None:
    """Clause: OPER-ATTACH-7."""
    k = closure([(1, 2, 3), (0, 1), (5,)])
    assert build(k) == (
        Attach(Attachment((0, 1))),
        Attach(Attachment((1, 2, 3), ((1,),))),
        Attach(Attachment((5,))),
    )
