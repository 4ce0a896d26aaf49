"""Laws of Table 1, of the dual tree and of what it leaves."""

from typing import Final

from clers.complexes.given import SURFACES
from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import AtSymbol
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.remainder import Tree, trees
from clers.edgebreaker.stream import Side
from clers.edgebreaker.table import S_WITH_RECORD, TABLE
from clers.edgebreaker.trace import trace


def sides_keep_table(surface: Surface) -> Verdict:
    """Each symbol's apex and sides are as Table 1 says, read off sets of visited things."""
    encoding = encode(surface)
    on_curve = {
        surface.vertex[next_corner(Corner(c))]
        for c, across in enumerate(surface.opposite)
        if across == BORDER
    }
    known, visited = set(on_curve), set[int]()
    verdicts: list[Verdict] = []
    for entry, tip in zip(
        trace(surface, encoding, outlined(encoding.stream)), encoding.tip_order, strict=True
    ):
        if entry.symbol in TABLE:
            row = S_WITH_RECORD if entry.opens >= 0 else TABLE[entry.symbol]
            closed = tuple(
                side
                for side, corner in (
                    (Side.LEFT, previous_corner(tip)),
                    (Side.RIGHT, next_corner(tip)),
                )
                if surface.opposite[corner] == BORDER or surface.opposite[corner] // 3 in visited
            )
            here = AtSymbol(entry.index)
            verdicts.append(
                same((row.marked, row.closed), (entry.triangle[0] in known, closed), here)
            )
        known.update(entry.new)
        visited.add(entry.face)
    return every(*verdicts)


def trees_of(surface: Surface) -> tuple[Surface, Outline, tuple[Tree, ...]] | Fails:
    """The decoded surface of a surface's stream, with its dual trees."""
    plan = outlined(encode(surface).stream)
    match decode(plan.stream):
        case Accepted(decoded):
            return decoded, plan, trees(plan, decoded)
        case Rejected() as rejected:
            return Fails("a surface", rejected.line(), rejected.where)


def _connected_parts(edges: list[tuple[int, int]], nodes: set[int]) -> list[set[int]]:
    """The node sets of a graph's components."""
    neighbours: dict[int, list[int]] = {v: [] for v in nodes}
    for a, b in edges:
        neighbours[a].append(b)
        neighbours[b].append(a)
    parts: list[set[int]] = []
    left = set(nodes)
    while left:
        part, frontier = set[int](), [left.pop()]
        while frontier:
            v = frontier.pop()
            part.add(v)
            frontier += [w for w in neighbours[v] if w not in part]
        left -= part
        parts.append(part)
    return parts


def _ends(surface: Surface, corner: Corner) -> tuple[int, int]:
    return surface.vertex[next_corner(corner)], surface.vertex[previous_corner(corner)]


def dual_tree_spans(surface: Surface) -> Verdict:
    """The gates join all triangles of a component, and are one fewer."""
    found = trees_of(surface)
    if isinstance(found, Fails):
        return found
    decoded, _, forest = found
    verdicts: list[Verdict] = []
    for tree in forest:
        links = [(c // 3, decoded.opposite[c] // 3) for c in tree.crossed]
        verdicts.append(same(len(tree.faces) - 1, len(links)))
        verdicts.append(same(1, len(_connected_parts(links, set(tree.faces)))))
    return every(*verdicts)


def remainder_is_connected(surface: Surface) -> Verdict:
    """χ(remainder) = 1 − 2g − b, and it is connected on all vertices of its component."""
    found = trees_of(surface)
    if isinstance(found, Fails):
        return found
    decoded, _, forest = found
    parts = components(decoded)
    verdicts: list[Verdict] = [same(len(parts), len(forest))]
    for tree, part in zip(forest, parts, strict=False):
        nodes = {decoded.vertex[c] for f in tree.faces for c in range(3 * f, 3 * f + 3)}
        edges = [_ends(decoded, c) for c in tree.remainder]
        verdicts.append(same(1 - 2 * part.genus - part.curves, len(nodes) - len(edges)))
        verdicts.append(same(1, len(_connected_parts(edges, set(nodes)))))
    return every(*verdicts)


def morse_edges_cut(surface: Surface) -> Verdict:
    """Without its Morse edges the remainder is a tree, or falls apart into one part per curve."""
    found = trees_of(surface)
    if isinstance(found, Fails):
        return found
    decoded, _, forest = found
    verdicts: list[Verdict] = []
    for tree, part in zip(forest, components(decoded), strict=True):
        nodes = {decoded.vertex[c] for f in tree.faces for c in range(3 * f, 3 * f + 3)}
        kept = [_ends(decoded, c) for c in tree.remainder if c not in tree.morse]
        pieces = _connected_parts(kept, set(nodes))
        verdicts.append(same(max(1, part.curves), len(pieces)))
        verdicts.append(same(2 * part.genus + max(0, part.curves - 1), len(tree.morse)))
        for piece in pieces:
            inside = sum(1 for a, _ in kept if a in piece)
            verdicts.append(same(len(piece) - (0 if part.curves else 1), inside))
    return every(*verdicts)


def valence_and_remainder_keep_table(surface: Surface) -> Verdict:
    """Table 1's valence and the position of the remainder, for each symbol."""
    found = trees_of(surface)
    if isinstance(found, Fails):
        return found
    decoded, plan, forest = found
    crossed = {d for tree in forest for c in tree.crossed for d in (c, decoded.opposite[c])}
    verdicts: list[Verdict] = []
    for part in plan.parts:
        for i in range(part.start, part.stop):
            tip = Corner(3 * plan.face[i])
            x = plan.stream.word[i]
            row = S_WITH_RECORD if plan.record_of[i] >= 0 else TABLE[x]
            from_infinite_face = i == part.start and not part.closed
            valence = sum(Corner(tip + k) in crossed for k in range(3)) + from_infinite_face
            sides = tuple(
                side
                for side, corner in ((Side.LEFT, tip + 2), (Side.RIGHT, tip + 1))
                if corner not in crossed
            )
            verdicts.append(same(row.valence, valence, AtSymbol(i)))
            verdicts.append(same(row.remainder, sides, AtSymbol(i)))
    return every(*verdicts)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "table-1-sides",
        Clause.EB_TRAVERSE_8,
        "apex and sides of each symbol are those of Table 1",
        SURFACES,
        sides_keep_table,
    ),
    Law(
        "table-1-tree",
        Clause.EB_TRAVERSE_8,
        "valence in the dual tree and edges in the remainder are those of Table 1",
        SURFACES,
        valence_and_remainder_keep_table,
    ),
    Law(
        "dual-tree-spans",
        Clause.EB_REMAINDER_1,
        "the gates walked through are a spanning tree of the triangles",
        SURFACES,
        dual_tree_spans,
    ),
    Law(
        "remainder-euler",
        Clause.EB_REMAINDER_2,
        "the primal remainder is connected and has χ = 1−2g−b",
        SURFACES,
        remainder_is_connected,
    ),
    Law(
        "morse-edges",
        Clause.EB_REMAINDER_3,
        "without Morse edges the remainder is a tree, or one cycle with trees for each curve",
        SURFACES,
        morse_edges_cut,
    ),
)
