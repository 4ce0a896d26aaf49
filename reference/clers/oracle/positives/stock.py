"""Named meshes to ask about: by hand, regular ones, grown by scripts, and at random."""

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random
from typing import Final

from clers.complexes.corner_table import face_list
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance.cases.case import Origin
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.generate import families as regular
from clers.generate.bounds import FIRST, Bounds, go_on, go_on_within
from clers.generate.irregular import irregular_sphere
from clers.generate.kinds import ACT, GROW
from clers.generate.uniform import uniform_sphere
from clers.operators.script import AddHandle, AddTetrahedron, OpenCurve, Operator
from clers.oracle.positives.shuffled import built, in_disorder, shuffled

NUMBERS: Final = ("no", "one", "two", "three", "four", "five", "six")


@dataclass(frozen=True, slots=True)
class Named:
    """A surface with the words of its name, and where it comes from. Clause: ORCL-CASE-6."""

    slug: str
    surface: Surface
    origin: Origin
    comment: str = ""


def by_hand() -> Iterator[Named]:
    """The tutorial's examples, and the smallest surface of each kind."""
    cube_beside = regular.beside([face_list(CUBE), face_list(TRIANGLE), face_list(TETRAHEDRON)])
    annuli = regular.beside([face_list(ANNULUS), face_list(ANNULUS)])
    torus_beside = regular.beside([face_list(TORUS), face_list(ANNULUS), face_list(TORUS)])
    yield Named("tetrahedron", TETRAHEDRON, "hand", "Figure 20 of the tutorial")
    yield Named("cube", CUBE, "hand", "Figures 14 and 15 of the tutorial")
    yield Named("torus", TORUS, "hand", "Figure 22 of the tutorial")
    yield Named("annulus", ANNULUS, "hand")
    yield Named("triangle", TRIANGLE, "hand", "the smallest surface there is")
    two = regular.copies(face_list(TETRAHEDRON), 2)
    yield Named("two-tetrahedra", built(two), "hand")
    yield Named("two-triangles", built(regular.copies(face_list(TRIANGLE), 2)), "hand")
    yield Named("cube-triangle-tetrahedron", built(cube_beside), "hand")
    yield Named("two-annuli", built(annuli), "hand")
    yield Named("torus-annulus-torus", built(torus_beside), "hand")
    seven = tuple(
        face
        for i in range(7)
        for face in ((i, (i + 1) % 7, (i + 3) % 7), (i, (i + 3) % 7, (i + 2) % 7))
    )
    yield Named("moebius-torus", built(FaceList(seven, 7)), "hand", "seven vertices, all joined")
    strip = built(FaceList(((0, 1, 2), (0, 2, 3)), 4))
    yield Named("square", strip, "hand")


def by_rule() -> Iterator[Named]:
    """Regular meshes: long runs, deep stacks, many handles, many curves, many components."""
    holed = regular.with_holes
    for slug, mesh in (
        ("octahedron", regular.grid_sphere(1)),
        ("grid-sphere-32", regular.grid_sphere(2)),
        ("grid-sphere-128", regular.grid_sphere(4)),
        ("grid-torus-3-by-3", regular.grid_torus(3, 3)),
        ("grid-torus-4-by-7", regular.grid_torus(4, 7)),
        *((f"chain-of-{NUMBERS[g]}-tori", regular.torus_chain(g, 4, 4)) for g in range(2, 6)),
        ("bipyramid-3", regular.bipyramid(3)),
        ("bipyramid-20", regular.bipyramid(20)),
        ("bipyramid-100", regular.bipyramid(100)),
        *((f"nested-splits-{depth}", regular.nested_splits(depth)) for depth in (1, 2, 5, 10, 40)),
        *((f"strip-{count}", regular.strip(count)) for count in (2, 3, 10, 101)),
        ("sphere-with-two-holes", holed(regular.grid_sphere(2), 2)),
        ("sphere-with-many-holes", holed(regular.grid_sphere(5), 12)),
        *((f"sphere-open-at-both-ends-{r}", open_at_both_ends(r)) for r in (2, 3, 5)),
        ("torus-with-one-hole", holed(regular.grid_torus(4, 5), 1)),
        ("torus-with-three-holes", holed(regular.grid_torus(6, 6), 3)),
        ("two-tori-with-holes", holed(regular.copies(regular.grid_torus(4, 4), 2), 4)),
        ("ten-octahedra", regular.copies(regular.grid_sphere(1), 10)),
        ("ten-triangles", regular.copies(regular.strip(1), 10)),
        (
            "sphere-torus-strip",
            regular.beside([regular.grid_sphere(1), regular.grid_torus(3, 4), regular.strip(4)]),
        ),
    ):
        yield Named(slug, built(mesh), "generated")


def open_at_both_ends(rings: int) -> FaceList:
    """A sphere without its first face and its last: the walk reaches the other curve late."""
    of = regular.grid_sphere(rings)
    return FaceList(of.faces[1:-1], of.vertices)


def kind_of(genus: int, curves: int, parts: int) -> str:
    """The words for a topology; genus and curves are summed over the components."""
    one = {(0, 0): "sphere", (0, 1): "disk", (0, 2): "annulus", (1, 0): "torus"}
    if parts == 1 and (genus, curves) in one:
        return one[genus, curves]
    words = [f"{NUMBERS[parts]}-components"] if parts > 1 else []
    words += [f"genus-{genus}"] if genus or parts == 1 else []
    words += [f"{NUMBERS[curves]}-curve{'s' if curves > 1 else ''}"] if curves else []
    return "-".join(words)


def grown(genus: int, curves: int, parts: int, faces: int, seed: int) -> Surface:
    """A surface of this topology by operators at random, its numbers shuffled.

    About `faces` faces, more if the topology takes more. Only `Random.random` is used.
    """
    draw = Random(seed).random

    def number() -> int:
        return int(draw() * 10**6)

    def some(count: int, acting: bool) -> list[Operator]:
        table = ACT if acting else GROW
        return [table[int(draw() * len(table))](number(), number()) for _ in range(count)]

    start = go_on(FIRST, [AddTetrahedron()] * (parts - 1))
    roomy = Bounds(faces, (parts, parts), (0, 0), (0, 0))
    sized = go_on_within(start, some(faces // 2, False), roomy)
    handles: list[Operator] = [AddHandle(number(), number()) for _ in range(genus)]
    holes: list[Operator] = [OpenCurve(number()) for _ in range(curves)]
    full = go_on(sized, handles + holes)
    exact = Bounds(len(full.mesh.faces) + faces, (parts, parts), (genus, genus), (curves, curves))
    acted = go_on_within(full, some(faces // 2, curves > 0), exact)
    made = acted.totals
    if (made.components, made.genus, made.curves) != (parts, genus, curves):
        raise AssertionError(f"{made} is not {genus}, {curves}, {parts}")
    return built(in_disorder(acted.mesh, seed + 1))


def by_scripts() -> Iterator[Named]:
    """Genus up to 5 with up to 4 curves, in three sizes; up to 3 components, with less of each."""
    seed = 0
    for parts, most, curved, sizes in (
        (1, 5, 4, (6, 14, 30)),
        (2, 2, 3, (6, 14)),
        (3, 3, 2, (6, 14)),
    ):
        for genus in range(most + 1):
            for curves in range(curved + 1):
                for number, faces in enumerate(sizes, 1):
                    seed += 1
                    slug = f"{kind_of(genus, curves, parts)}-{number}"
                    yield Named(slug, grown(genus, curves, parts, faces, seed), "generated")


def at_random() -> Iterator[Named]:
    """Spheres that are each as likely as any other, and irregular ones; some are larger."""
    for vertices in (*range(10, 40, 3), 60, 100, 200):
        of = uniform_sphere(vertices, vertices)
        yield Named(f"random-sphere-{vertices}", shuffled(of, vertices), "generated")
    for faces in (20, 50, 120, 400):
        of = built(irregular_sphere(faces, faces))
        yield Named(f"irregular-sphere-{faces}", shuffled(of, faces), "generated")


def stock() -> Iterator[Named]:
    """All of them, each name once."""
    yield from by_hand()
    yield from by_rule()
    yield from by_scripts()
    yield from at_random()
