"""The families of the suite: meshes, coordinates and what is remarkable about them."""

import struct
from collections import Counter
from itertools import pairwise

import pytest
from msgspec import Raw, UnsetType
from test_suite_positives import of_op

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.generate.families import beside, bipyramid, copies, grid_sphere, nested_splits, strip
from clers.oracle.positives import placed
from clers.oracle.positives.asked import Asked, answered, needed
from clers.oracle.positives.exhaustive import sphere, sphere_words
from clers.oracle.positives.features import features
from clers.oracle.positives.literal import solids
from clers.oracle.positives.messages import drawn
from clers.oracle.positives.real import loaded, piece, pieces
from clers.oracle.positives.real import whole as whole_meshes
from clers.oracle.positives.shuffled import built, shuffled
from clers.oracle.positives.stock import grown, kind_of, stock
from clers.oracle.suite.files import DEFAULT
from clers.oracle.suite.generated import inputs_of


def surface_of(*faces: tuple[int, int, int]) -> Surface:
    return built(FaceList(faces, 1 + max(max(face) for face in faces)))


@pytest.mark.parametrize(
    ("of", "names"),
    [
        (TETRAHEDRON, ()),
        (TRIANGLE, ("boundaries.one",)),
        (ANNULUS, ("boundaries.many",)),
        (TORUS, ("handles",)),
        (built(copies(grid_sphere(1), 2)), ("components",)),
        (
            built(beside([strip(1), strip(1), FaceList(tuple(TORUS.triangles()), 9)])),
            ("boundaries.many", "components", "handles"),
        ),
    ],
)
def test_what_a_surface_needs(of: Surface, names: tuple[str, ...]) -> None:
    """ORCL-CASE-4."""
    assert needed(of) == names


@pytest.mark.parametrize(
    ("of", "flags"),
    [
        (TETRAHEDRON, ()),
        (TRIANGLE, ("lone-triangle",)),
        (ANNULUS, ("closed-by-e", "curve-right")),
        (TORUS, ("closed-by-e", "handle-right")),
        (built(nested_splits(7)), ()),
        (built(nested_splits(8)), ("deep-stack", "long-run")),
        (built(bipyramid(17)), ()),
        (built(copies(grid_sphere(1), 2)), ()),
        (built(copies(grid_sphere(1), 3)), ("many-components",)),
        (built(beside([grid_sphere(1), strip(2)])), ("boundary-first",)),
        (built(beside([strip(2), grid_sphere(1)])), ()),
    ],
)
def test_what_is_remarkable(of: Surface, flags: tuple[str, ...]) -> None:
    """ORCL-CASE-5: the annulus is SLRRLE, the torus CCCCRCSCRSSRLSEEE (CODE-HAND-1)."""
    assert features(of) == flags


def test_features_against_the_trace() -> None:
    """EB-TRACE-1: the depth of the stack and the closed records, as the walk of the cases says."""
    checked = Counter[bool]()
    for case in of_op("word.encode"):
        if case.trace and case.origin != "exhaustive" and "shuffled-numbering" in case.flags:
            stacks = [step.stack for step in case.trace if isinstance(step.stack, int)]
            deep = max(stacks) >= 8
            shared = any(
                not isinstance(step.closes, UnsetType) and len(step.closes) > 1
                for step in case.trace
            )
            assert ("deep-stack" in case.flags, "shared-closer" in case.flags) == (deep, shared)
            checked[deep] += 1
    assert checked[True] > 20
    assert checked[False] > 20


@pytest.mark.parametrize(
    ("genus", "curves", "parts", "words"),
    [
        (0, 0, 1, "sphere"),
        (0, 1, 1, "disk"),
        (0, 2, 1, "annulus"),
        (1, 0, 1, "torus"),
        (0, 3, 1, "genus-0-three-curves"),
        (2, 1, 1, "genus-2-one-curve"),
        (0, 0, 2, "two-components"),
        (3, 2, 3, "three-components-genus-3-two-curves"),
    ],
)
def test_the_words_for_a_topology(genus: int, curves: int, parts: int, words: str) -> None:
    assert kind_of(genus, curves, parts) == words


@pytest.mark.parametrize(("genus", "curves", "parts"), [(0, 0, 1), (5, 4, 1), (2, 3, 3)])
def test_what_is_grown(genus: int, curves: int, parts: int) -> None:
    """CPLX-COMPONENT-3: of this topology, and no other for another seed."""
    one, other = (grown(genus, curves, parts, 14, seed) for seed in (1, 2))
    for of in (one, other):
        found = components(of)
        assert len(found) == parts
        assert sum(part.genus for part in found) == genus
        assert sum(part.curves for part in found) == curves
    assert one != other
    assert grown(genus, curves, parts, 14, 1) == one


def test_names_of_the_stock() -> None:
    """ORCL-CASE-2: each once, and each a slug; all origins are told."""
    names = [named.slug for named in stock()]
    assert len(set(names)) == len(names) > 190
    assert {named.origin for named in stock()} == {"hand", "generated"}


def test_shuffled_is_the_same_surface() -> None:
    """EB-COMPONENT-2: begun at the same gate it has the same word; its numbers are others."""
    for of in (CUBE, TORUS, sphere(sphere_words(8)[100])):
        other = shuffled(of, 3)
        assert encode(other).stream == encode(of).stream
        assert list(other.triangles()) != list(of.triangles())
        assert shuffled(of, 3) == other != shuffled(of, 4)


def test_faces_that_are_no_surface() -> None:
    """CPLX-INPUT-2: are a slip of who wrote them."""
    with pytest.raises(AssertionError, match="repeated-index"):
        built(FaceList(((0, 1, 1),), 2))
    with pytest.raises(AssertionError, match="unknown-symbol"):
        sphere("CRX")


def test_a_request_that_is_rejected() -> None:
    """ORCL-CASE-1: is none of the positives."""
    asked = Asked(
        "bad",
        "surface.classify",
        message.Classify(id=0, input=form.Faces(faces=((0, 1, 1),), vertices=2)),
        (Clause.CPLX_INPUT_2,),
        "hand",
    )
    with pytest.raises(AssertionError, match="classify bad"):
        answered(asked)


def test_an_answer_with_all_that_is_said() -> None:
    """ORCL-CASE-1."""
    asked = Asked(
        "said", "echo", message.Echo(id=0, input={"b": 1, "a": 2}), (Clause.ORCL_OP_1,), "real",
        ("handles",), 7, ("b", "a", "b"), "why", "isomorphic",
    )  # fmt: skip
    case = answered(asked)
    assert (bytes(case.input), case.ok) == (b'{"b":1,"a":2}', Raw(b'{"b":1,"a":2}'))
    assert case.clauses == ("ORCL-OP-1",)
    assert (case.origin, case.requires, case.size) == ("real", ("handles",), 7)
    assert (case.flags, case.comment, case.compare) == (("a", "b"), "why", "isomorphic")
    assert case.id.startswith("said-")
    assert case.trace == ()


def test_drawn_symbols() -> None:
    """By weights, and the same again."""
    symbols = drawn((0, 1, 3), 400, 5)
    assert symbols == drawn((0, 1, 3), 400, 5)
    counts = Counter(symbols)
    assert counts[0] == 0
    assert 2 * counts[1] < counts[2] < 5 * counts[1]


def test_coordinates() -> None:
    """GEOM-POSITION-1: of the precision that they say; smooth ones are near their neighbours."""
    coarse, fine = placed.coarse(50, 1), placed.fine(50, 1)
    assert (coarse.precision, fine.precision) == ("f32", "f64")
    assert len(coarse.coordinates) == len(fine.coordinates) == 150
    assert all(struct.unpack("f", struct.pack("f", x))[0] == x for x in coarse.coordinates)
    assert all(-8 <= x < 8 and x * 256 == int(x * 256) for x in coarse.coordinates)
    assert any(struct.unpack("f", struct.pack("f", x))[0] != x for x in fine.coordinates)
    assert all(-1 <= x < 1 for x in fine.coordinates)
    smooth = placed.smooth(built(grid_sphere(3))).coordinates
    jumps = [abs(x - y) for x, y in pairwise(smooth[0::3])]
    assert max(smooth[0::3]) - min(smooth[0::3]) > 1
    assert sum(jumps) / len(jumps) < 10


@pytest.mark.parametrize("name", list(placed.EDGES))
def test_coordinates_at_the_edges(name: str) -> None:
    """GEOM-POSITION-1: values of their precision, all of them used."""
    kind, values, _ = placed.EDGES[name]
    numbers = placed.repeated(kind, values, 4)
    assert numbers.precision == kind
    assert len(numbers.coordinates) == 12
    assert set(map(str, numbers.coordinates)) == set(map(str, values))
    if kind == "f32":
        assert all(struct.unpack("f", struct.pack("f", x))[0] == x for x in values)


def test_solids() -> None:
    """ORCL-SUITE-5: stored literally; what each is, its words say."""
    inputs = inputs_of(DEFAULT)
    assert isinstance(inputs, Accepted)
    found = {of.slug: of for of in solids(inputs.value)}
    genus = {slug: sum(p.genus for p in components(of.surface)) for slug, of in found.items()}
    assert genus["box-with-a-hole"] == 1
    assert genus["box-with-three-holes"] == genus["ball-with-two-tunnels"] == 3
    assert len(components(found["hollow-box"].surface)) == 2
    assert all("manifold3d" in of.comment for of in found.values())
    assert all(
        of.positions is not None and len(of.positions.coordinates) == 3 * of.surface.vertices
        for of in found.values()
    )
    assert list(solids({})) == []


def test_pieces_of_real_meshes() -> None:
    """CPLX-INPUT-2: surfaces, with the places that their vertices have in the whole."""
    cut = {of.slug: of for of in pieces()}
    assert len(cut) == 10
    bunny = cut["bunny-piece-63"]
    assert bunny.surface.faces == 63
    assert bunny.positions is not None
    mesh = loaded("bunny.obj")
    assert mesh.positions is not None
    whole_places = {mesh.positions.point(v) for v in range(mesh.surface.vertices)}
    numbers = bunny.positions.coordinates
    assert set(zip(numbers[0::3], numbers[1::3], numbers[2::3], strict=True)) <= whole_places
    assert all(of.origin == "real" for of in (*cut.values(), *whole_meshes()))


def test_a_piece_of_a_small_component() -> None:
    """Ends where the component does."""
    mesh = loaded("tetrahedron-and-triangle.off")
    found = piece(mesh, 0, 100)
    assert found is not None
    assert found.surface.faces in (1, 4)


def test_a_mesh_that_cannot_be_read() -> None:
    with pytest.raises(AssertionError, match=r"none\.off"):
        loaded("none.off")


def test_surfaces_can_be_built_here() -> None:
    """CPLX-INPUT-2."""
    assert surface_of((0, 1, 2)) == TRIANGLE
    assert isinstance(surface(FaceList(((0, 1, 2),), 3)), Accepted)
