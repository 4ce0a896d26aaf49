"""The laws of subdivisions, welds and bistellar moves: each held against another."""

from typing import Final

from clers.complexes.corner_table import face_list
from clers.complexes.given import SMALL_SURFACES
from clers.complexes.simplicial import Complex, closure, dimension, link, star
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.operators.moves.augmented import around, in_order, joined
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.candidates import new_vertex
from clers.operators.moves.contract import contract
from clers.operators.moves.effect import effect
from clers.operators.moves.given import FEW, FLIPS, WELDS
from clers.operators.moves.laws_collapse import is_complex
from clers.operators.moves.move import Bistellar, Contract, Subdivide, Weld
from clers.operators.moves.stellar import subdivide, weld
from clers.operators.net import apex, inner_edges, sides
from clers.operators.step import Did
from clers.operators.subdivide import flip_edge

TABLE: Final = {
    (1, 2): (1, 1),
    (2, 3): (1, 3, 2),
    (2, 2): (),
    (3, 4): (1, 4, 6, 3),
    (3, 3): (0, 1, 2, 1),
    (4, 5): (1, 5, 10, 10, 4),
    (4, 4): (0, 1, 4, 5, 2),
    (4, 3): (),
}
"""The changes of #0, #1, … by dimension and the vertices of A. Clause: OPER-BISTELLAR-4."""


def _subdivision(k: Complex) -> Verdict:
    """Each simplex: the others stay, the vertex's link is ∂A * lk A, and χ says the rest."""
    v = new_vertex(k)
    verdicts: list[Verdict] = []
    for a in k.simplices:
        after = subdivide(k, Subdivide(in_order(a), v))
        if isinstance(after, Rejected):
            return Fails("a subdivision", after.line(), after.where)
        kept = frozenset(s for s in after.value.simplices if v not in s)
        new = frozenset(
            face | rest for face in _proper(a) for rest in (*link(k, a).simplices, frozenset())
        )
        verdicts.append(same(k.simplices - star(k, a), kept))
        verdicts.append(same(new, around(after.value, frozenset([v]))))
    return every(*verdicts)


def _proper(a: frozenset[int]) -> frozenset[frozenset[int]]:
    """The empty simplex and the proper faces: a simplex's closure without itself."""
    return closure([a]).simplices - {a} | {frozenset[int]()}


def _weld(given: tuple[Complex, Weld]) -> Verdict:
    """By definition: it applies if a subdivision leads back from the only possible result."""
    k, move = given
    a, v = frozenset(move.simplex), frozenset([move.vertex])
    rest = frozenset(s for s in around(k, v) if not s & a)
    before = Complex(k.simplices - star(k, v) | joined([a], rest))
    possible = (
        v in k.simplices
        and a not in k.simplices
        and is_complex(before.simplices)
        and subdivide(before, Subdivide(move.simplex, move.vertex)) == Accepted(k)
    )
    result = weld(k, move)
    return same(Accepted(before), result) if possible else same(True, isinstance(result, Rejected))


def _subdivided_and_contracted(k: Complex) -> Verdict:
    v = new_vertex(k)
    verdicts: list[Verdict] = []
    for a in k.simplices:
        middle = subdivide(k, Subdivide(in_order(a), v))
        if isinstance(middle, Rejected) or len(a) == 1:
            continue
        for end in a:
            back = contract(middle.value, Contract(end, v))
            verdicts.append(same(Accepted(k), back))
    return every(*verdicts)


def _flip_by_weld(given: tuple[Complex, Bistellar]) -> Verdict:
    """A → B for B with two vertices or more, by a new vertex that comes and goes."""
    k, move = given
    v = 1 + max(new_vertex(k), *move.come)
    direct = bistellar(k, move)
    if isinstance(direct, Rejected):
        return Holds()
    if len(move.come) == 1:
        return same(subdivide(k, Subdivide(move.gone, *move.come)), direct)
    middle = subdivide(k, Subdivide(move.gone, v))
    return same(direct, and_then(middle, lambda m: weld(m, Weld(move.come, v))))


def _table(given: tuple[Complex, Bistellar]) -> Verdict:
    k, move = given
    if isinstance(bistellar(k, move), Rejected):
        return Holds()
    n = len(move.gone) + len(move.come) - 2
    row = TABLE.get((n, len(move.gone)))
    if row is None:
        upward = TABLE.get((n, len(move.come)), ())
        row = tuple(-change for change in upward)
    return every(same(True, n <= dimension(k)), same(row, effect(move, k)))


def _edge_flips(of: Surface) -> Verdict:
    """Each edge inside, by the operator of scripts and by the move."""
    mesh = face_list(of)
    k = closure(mesh.faces)
    runs = sides(mesh.faces)
    verdicts: list[Verdict] = []
    for i, (a, b) in enumerate(inner_edges(runs)):
        c, d = apex(mesh.faces, runs, (a, b)), apex(mesh.faces, runs, (b, a))
        move = Bistellar((min(a, b), max(a, b)), (min(c, d), max(c, d)))
        by_move, step = bistellar(k, move), flip_edge(mesh, i)
        if isinstance(step.outcome, Did):
            verdicts.append(same(Accepted(closure(step.mesh.faces)), by_move))
        else:
            verdicts.append(same(True, isinstance(by_move, Rejected)))
    return every(*verdicts)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "subdivision-is-a-cone-in-place-of-a-star",
        Clause.OPER_STELLAR_1,
        "Outside the star nothing changes; the new vertex has the link ∂A * lk A.",
        FEW,
        _subdivision,
    ),
    Law(
        "weld-applies-exactly",
        Clause.OPER_STELLAR_2,
        "A weld applies exactly where a subdivision of some complex leads to this one.",
        WELDS,
        _weld,
    ),
    Law(
        "subdivision-is-undone-by-contraction",
        Clause.OPER_STELLAR_3,
        "Contracting the new vertex into a vertex of the subdivided simplex leads back.",
        FEW,
        _subdivided_and_contracted,
    ),
    Law(
        "flip-is-a-subdivision-and-a-weld",
        Clause.OPER_BISTELLAR_2,
        "A → B is the subdivision of A and the weld of B, with one new vertex for both.",
        FLIPS,
        _flip_by_weld,
    ),
    Law(
        "flip-is-the-edge-flip-of-scripts",
        Clause.OPER_BISTELLAR_3,
        "On surfaces the bistellar move of an edge is OPER-REFINE-3, and applies where it does.",
        SMALL_SURFACES,
        _edge_flips,
    ),
    Law(
        "flips-change-numbers-by-the-table",
        Clause.OPER_BISTELLAR_4,
        "In dimensions 1 to 4 bistellar moves change the numbers of simplices as the table says.",
        FLIPS,
        _table,
    ),
)
