"""Laws of what a panel shows, by sets of visited faces; nothing of the walk's stack is asked."""

from collections.abc import Iterable
from typing import Final

from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner
from clers.complexes.topology import curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import AtFace
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.edgebreaker.remainder import trees
from clers.edgebreaker.stream import Encoding
from clers.pictures.drawing import Point
from clers.pictures.options import Options
from clers.pictures.picture import Panel, Role, State
from clers.pictures.shown import edges_of, flat_picture, shapes_of

ALL_STEPS: Final = 24


def few_steps(surface: Surface) -> tuple[int, ...]:
    """All steps of a small surface; of others the beginning, the middle, the end."""
    faces = surface.faces
    if faces <= ALL_STEPS:
        return tuple(range(faces + 1))
    return tuple(sorted({0, 1, faces // 3, faces // 2, faces - 1, faces}))


def faces_are_drawn_once(surface: Surface) -> Verdict:
    """Each face once, in the state that the order of visits says, with its letter's first sign."""
    encoding = encode(surface)
    picture = flat_picture(surface, Options(steps=few_steps(surface)))
    if isinstance(picture, Fails):
        return picture
    place = {tip // 3: made for made, tip in enumerate(encoding.tip_order)}
    verdicts: list[Verdict] = []
    for panel in picture.panels:
        shapes = shapes_of(panel)
        drawn = sorted(shape.visit.face for shape in shapes)
        verdicts.append(same(list(range(surface.faces)), drawn))
        for shape in shapes:
            made = place[shape.visit.face]
            state = State.LAST if made == panel.step - 1 else State.VISITED
            expected = state if made < panel.step else State.BLANK
            verdicts.append(same(expected, shape.state, AtFace(shape.visit.face)))
    last = sorted(shapes_of(picture.panels[-1]), key=lambda shape: shape.visit.step)
    letters = "".join(shape.visit.letter[0] for shape in last)
    verdicts.append(same(encoding.stream.word, letters.replace("P", "")))
    return every(*verdicts)


def gates_lead_on(surface: Surface) -> Verdict:
    """The next face's gate is drawn thick, the left gates of visited S into faces not visited thin.

    Each has its ends at the places of its vertices in the face behind it. P is entered by no gate.
    """
    encoding = encode(surface)
    picture = flat_picture(surface, Options(steps=few_steps(surface)))
    if isinstance(picture, Fails):
        return picture
    return every(*(_gates(surface, encoding, panel) for panel in picture.panels))


def _gates(surface: Surface, encoding: Encoding, panel: Panel) -> Verdict:
    visited = {tip // 3 for tip in encoding.tip_order[: panel.step]}
    splits = [
        shape.visit.tip
        for shape in shapes_of(panel)
        if shape.visit.entry.symbol == "S" and shape.state is not State.BLANK
    ]
    left_gates = [surface.opposite[previous_corner(tip)] for tip in splits]
    entered = _entered(surface, encoding)
    now = [tip for tip in encoding.tip_order[panel.step : panel.step + 1] if tip in entered]
    later = [c for c in left_gates if c // 3 not in visited and c not in now]
    at = {
        corner: place
        for shape in shapes_of(panel)
        for corner, place in zip(turned(shape.visit.tip), shape.corners, strict=True)
    }

    def drawn(c: Corner) -> tuple[Vertex, Vertex, Point, Point]:
        tail, head = next_corner(c), previous_corner(c)
        return surface.vertex[tail], surface.vertex[head], at[tail], at[head]

    thick = [(g.tail, g.head, *g.path) for g in panel.gates if g.waiting == 0]
    thin = [(g.tail, g.head, *g.path) for g in panel.gates if g.waiting > 0]
    return every(
        same([drawn(c) for c in now], thick),
        same(sorted(drawn(c) for c in later), sorted(thin)),
        same(list(range(1, len(thin) + 1)), sorted(g.waiting for g in panel.gates if g.waiting)),
    )


def turned(tip: Corner) -> tuple[Corner, Corner, Corner]:
    """A triangle's corners from one of them on."""
    return tip, next_corner(tip), previous_corner(tip)


def _entered(surface: Surface, encoding: Encoding) -> set[Corner]:
    """The tips of all faces but P: across from them is a face visited before, or a curve."""
    seen, found = set[int](), set[Corner]()
    for tip in encoding.tip_order:
        across = surface.opposite[tip]
        if across == BORDER or across // 3 in seen:
            found.add(tip)
        seen.add(tip // 3)
    return found


def _edge(surface: Surface, corner: Corner) -> tuple[Vertex, Vertex]:
    return surface.vertex[next_corner(corner)], surface.vertex[previous_corner(corner)]


def known_vertices_are_dark(surface: Surface) -> Verdict:
    """Known are the vertices of visited faces and of the curves that these meet, and no other.

    A curve's edges are thick from then on, and each is drawn once.
    """
    encoding = encode(surface)
    picture = flat_picture(surface, Options(steps=few_steps(surface)))
    if isinstance(picture, Fails):
        return picture
    verdicts: list[Verdict] = []
    for panel in picture.panels:
        visited = {tip // 3 for tip in encoding.tip_order[: panel.step]}
        known = {v for face in visited for v in surface.vertex[3 * face : 3 * face + 3]}
        met = [curve for curve in curves(surface) if not known.isdisjoint(curve.vertices)]
        known |= {v for curve in met for v in curve.vertices}
        verdicts.append(same(set(range(surface.vertices)), {mark.vertex for mark in panel.marks}))
        verdicts.append(same(known, {mark.vertex for mark in panel.marks if mark.known}))
        thick = sorted(_edge(surface, c) for curve in met for c in curve.corners)
        thin = sorted(
            _edge(surface, c)
            for curve in curves(surface)
            if curve not in met
            for c in curve.corners
        )
        verdicts.append(same(thick, sorted(e.ends for e in edges_of(panel, Role.REACHED))))
        verdicts.append(same(thin, sorted(e.ends for e in edges_of(panel, Role.CURVE))))
    return every(*verdicts)


def overlay_is_the_tree(surface: Surface) -> Verdict:
    """At the end the overlay has the edges of `trees` of the decoded surface, under our names.

    The Morse edges are drawn with it and without it.
    """
    encoding = encode(surface)
    decoded = decode(encoding.stream)
    with_tree = flat_picture(surface, Options(steps=(surface.faces,), tree=True))
    without = flat_picture(surface, Options(steps=(surface.faces,)))
    if isinstance(decoded, Rejected):
        return Fails("a surface", decoded.line(), decoded.where)
    if isinstance(with_tree, Fails):
        return with_tree
    if isinstance(without, Fails):
        return without
    forest = trees(outlined(encoding.stream), decoded.value)

    def ends(corners: Iterable[Corner]) -> set[frozenset[int]]:
        edges = (_edge(decoded.value, c) for c in corners)
        return {frozenset(encoding.vertex_order[v] for v in edge) for edge in edges}

    morse = ends(c for tree in forest for c in tree.morse)
    rest = ends(c for tree in forest for c in tree.remainder) - morse
    links = [c for tree in forest for c in tree.crossed]
    panel = with_tree.panels[0]
    return every(
        same(ends(links), _drawn(panel, Role.TREE)),
        same(2 * len(links), len(edges_of(panel, Role.TREE))),
        same(rest, _drawn(panel, Role.REMAINDER)),
        same(morse, _drawn(panel, Role.MORSE)),
        same(morse, _drawn(without.panels[0], Role.MORSE)),
        same(0, len(edges_of(without.panels[0], Role.TREE, Role.REMAINDER))),
    )


def _drawn(panel: Panel, role: Role) -> set[frozenset[int]]:
    return {frozenset(edge.ends) for edge in edges_of(panel, role)}


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "panel-shows-each-face-once",
        Clause.TOOL_PICTURE_1,
        "each panel has each face once, with its letter and in the state of the walk",
        SURFACES,
        faces_are_drawn_once,
    ),
    Law(
        "panel-shows-gates",
        Clause.TOOL_PICTURE_1,
        "the next gate and those on the stack are drawn at the faces that they lead into",
        SURFACES,
        gates_lead_on,
    ),
    Law(
        "panel-shows-what-is-known",
        Clause.TOOL_PICTURE_1,
        "dark vertices and thick curves are those of visited faces and of curves these meet",
        SURFACES,
        known_vertices_are_dark,
    ),
    Law(
        "picture-shows-dual-tree",
        Clause.TOOL_PICTURE_4,
        "dual tree, primal remainder and Morse edges drawn are those of the decoded surface",
        SMALL_SURFACES,
        overlay_is_the_tree,
    ),
)
