"""Laws of the walk: it is the definition's, and its symbols count the topology."""

from collections import Counter
from typing import Final

from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.surface import Surface, next_corner, previous_corner
from clers.complexes.topology import Component, components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtSymbol
from clers.edgebreaker.definition import fold, steps
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.edgebreaker.stream import Kind
from clers.edgebreaker.trace import trace
from clers.edgebreaker.walk import encode_by_definition


def walk_agrees(surface: Surface) -> Verdict:
    """The linear walk and the definition write the same."""
    fast, slow = encode(surface), encode_by_definition(surface)
    v = surface.vertex
    tips = tuple((v[c], v[next_corner(c)], v[previous_corner(c)]) for c in fast.tip_order)
    return every(same(slow[0], fast.stream), same(slow[1], fast.vertex_order), same(slow[2], tips))


def _per_component(surface: Surface) -> list[tuple[Component, str, list[Kind]]]:
    """Each component with its own word and the kinds of its records."""
    encoding = encode(surface)
    plan = outlined(encoding.stream)
    by_lowest = {c.lowest: c for c in components(surface)}
    found: list[tuple[Component, str, list[Kind]]] = []
    for part in plan.parts:
        last = part.first + part.stop - part.start
        lowest = min(encoding.tip_order[f] // 3 for f in range(part.face, last))
        numbers = (plan.record_of[i] for i in range(part.start, part.stop))
        kinds = [encoding.stream.records[r].kind for r in numbers if r >= 0]
        word = encoding.stream.word[part.start : part.stop]
        found.append((next(c for low, c in by_lowest.items() if low == lowest), word, kinds))
    return found


def no_cl_no_ce(surface: Surface) -> Verdict:
    """A C is followed by neither L nor E."""
    for _, word, _ in _per_component(surface):
        for pair in ("CL", "CE"):
            if pair in word:
                return Fails(f"no {pair}", word, AtSymbol(word.index(pair)))
    return Holds()


def counts_of_c(surface: Surface) -> Verdict:
    """#C = V − 3, or the interior vertices."""
    return every(
        *(
            same(c.vertices - (c.boundary_edges if c.curves else 3), word.count("C"))
            for c, word, _ in _per_component(surface)
        )
    )


def counts_of_s_and_e(surface: Surface) -> Verdict:
    """#S − #E = 2g − 1, or 2g + b − 2."""
    return every(
        *(
            same(
                2 * c.genus + (c.curves - 2 if c.curves else -1), word.count("S") - word.count("E")
            )
            for c, word, _ in _per_component(surface)
        )
    )


def counts_of_records(surface: Surface) -> Verdict:
    """#Sh = 2g and #Sb = b − 1 per component; Σ Sb + components with boundary = curves."""
    parts = _per_component(surface)
    kinds = Counter(kind for _, _, found in parts for kind in found)
    with_boundary = sum(1 for c, _, _ in parts if c.curves)
    return every(
        *(
            every(
                same(2 * c.genus, found.count(Kind.HANDLE)),
                same(max(0, c.curves - 1), found.count(Kind.BOUNDARY)),
            )
            for c, _, found in parts
        ),
        same(sum(c.curves for c, _, _ in parts), kinds[Kind.BOUNDARY] + with_boundary),
        same(with_boundary, encode(surface).stream.components_with_boundary),
    )


def fold_keeps_count(surface: Surface) -> Verdict:
    """χ, genus, loops by effects are those of the final surface, component by component."""
    match and_then(steps(encode(surface).stream), fold):
        case Rejected() as rejected:
            return Fails("a fold", rejected.line(), rejected.where)
        case Accepted(grown):
            last, parts = grown[-1], components(surface)
            return every(
                same(sum(c.euler + c.curves for c in parts), last.euler),
                same(sum(c.genus for c in parts), last.genus),
                same(len(parts), last.components),
                same((), last.loops),
                same(sum(c.curves for c in parts), len(last.polygons)),
            )


def trace_keeps_euler(surface: Surface) -> Verdict:
    """χ in the trace is χ in the fold, less that of the components before."""
    encoding = encode(surface)
    match and_then(steps(encoding.stream), fold):
        case Rejected() as rejected:
            return Fails("a fold", rejected.line(), rejected.where)
        case Accepted(states):
            entries = trace(surface, encoding, outlined(encoding.stream))
            before, found = 0, list[int]()
            for k, entry in enumerate(entries):
                if k and entry.component != entries[k - 1].component:
                    before += entries[k - 1].euler
                found.append(before + entry.euler)
            return same([state.euler for state in states], found)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "walk-by-definition",
        Clause.EB_TRAVERSE_1,
        "the linear walk writes what the rules on sets write",
        SMALL_SURFACES,
        walk_agrees,
    ),
    Law("no-cl-no-ce", Clause.EB_COUNT_1, "no word contains CL or CE", SURFACES, no_cl_no_ce),
    Law(
        "count-c",
        Clause.EB_COUNT_2,
        "#C is V−3 if closed, else the interior vertices",
        SURFACES,
        counts_of_c,
    ),
    Law(
        "count-s-minus-e",
        Clause.EB_COUNT_3,
        "#S−#E is 2g−1 if closed, else 2g+b−2",
        SURFACES,
        counts_of_s_and_e,
    ),
    Law(
        "count-records",
        Clause.EB_COUNT_4,
        "#Sh = 2g; #Sb = b−1 with boundary; Σ Sb + components with boundary = curves",
        SURFACES,
        counts_of_records,
    ),
    Law(
        "fold-keeps-count",
        Clause.EB_FOLD_3,
        "the operators' effects add up to the surface's χ, genus, curves and components",
        SMALL_SURFACES,
        fold_keeps_count,
    ),
    Law(
        "trace-euler",
        Clause.EB_TRACE_1,
        "χ after each face of the trace is that of the fold of operators",
        SMALL_SURFACES,
        trace_keeps_euler,
    ),
)
