"""The walk on small surfaces, each step worked out by hand from the faces and section 5.4.

Words of the tetrahedron, the cube and the torus are those printed in the tutorial (Figures 20, 14
and 22).
"""

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.codec import FAST_ZIP, FOLD, REFERENCE, WRAP_AND_ZIP
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.edgebreaker.fast_zip import wrap_and_fast_zip
from clers.edgebreaker.outline import outline
from clers.edgebreaker.reversi import reversi
from clers.edgebreaker.stream import SYMBOLS, Kind, Record, Side, Stream
from clers.edgebreaker.trace import Entry, trace
from clers.edgebreaker.wrap_zip import wrap_and_zip


def surface_of(*faces: tuple[int, int, int]) -> Surface:
    built = surface(FaceList(faces, 1 + max(max(face) for face in faces)))
    assert isinstance(built, Accepted)
    return built.value


def traced(of: Surface) -> tuple[Entry, ...]:
    encoding = encode(of)
    scanned = outline(encoding.stream)
    assert isinstance(scanned, Accepted)
    return trace(of, encoding, scanned.value)


def test_the_alphabet() -> None:
    """EB-WORD-1, EB-WORD-2."""
    assert SYMBOLS == "CLERS"
    assert encode(TETRAHEDRON).stream == Stream("CRE", (), 0)


def test_the_tetrahedron_step_by_step() -> None:
    """EB-GATE-1, EB-GATE-2, EB-COMPONENT-2, EB-TRAVERSE-2, EB-TRAVERSE-3, EB-TRAVERSE-5.

    EB-ORDER-1, EB-ORDER-3.

    P is face 0 = (0,1,2). Across its edge 1→2 lies face 2 = (1,3,2), entered from 2 to 1: apex 3 is
    new, C. The right gate leads from 3 to 1 into face 1 = (0,3,1): apex 0 is marked, its right edge
    1→0 meets P, R. The left gate leads from 3 to 0 into face 3 = (0,2,3): apex 2, both sides meet
    what is visited, E.
    """
    steps = [(e.symbol, e.face, e.triangle, e.new, e.stack, e.euler) for e in traced(TETRAHEDRON)]
    assert steps == [
        ("P", 0, (0, 1, 2), (0, 1, 2), 0, 1),
        ("C", 2, (3, 2, 1), (3,), 0, 1),
        ("R", 1, (0, 3, 1), (), 0, 1),
        ("E", 3, (2, 3, 0), (), 0, 2),
    ]
    assert encode(TETRAHEDRON).vertex_order == (0, 1, 2, 3)
    assert encode(TETRAHEDRON).tip_order == (0, 7, 3, 10)


def test_the_cube_visits_the_triangles_of_figure_14() -> None:
    """EB-TRAVERSE-1: P 012, then 132, 143, 154, 105, 065, 026, 236, 376, 347, 457, 567."""
    assert encode(CUBE).stream.word == "CCCRCRRCRRE"
    assert [set(e.triangle) for e in traced(CUBE)] == [
        {0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {1, 5, 4}, {1, 0, 5}, {0, 6, 5},
        {0, 2, 6}, {2, 3, 6}, {3, 7, 6}, {3, 4, 7}, {4, 5, 7}, {5, 6, 7},
    ]  # fmt: skip
    assert encode(CUBE).vertex_order == tuple(range(8))


def test_the_torus_of_figure_22() -> None:
    """EB-TRAVERSE-6, EB-HANDLE-1 … EB-HANDLE-5: both handles close on the right edge of an E.

    The first S is closed by the last E, before which stand six of R, L, E; the second by the E
    before it. The other two S have no record.
    """
    stream = encode(TORUS).stream
    assert stream.word == "CCCCRCSCRSSRLSEEE"
    assert stream.records == (
        Record(Kind.HANDLE, 0, 6, Side.RIGHT),
        Record(Kind.HANDLE, 1, 5, Side.RIGHT),
    )


def test_the_stack_of_the_torus() -> None:
    """EB-TRAVERSE-5, EB-TRAVERSE-6: gates are pushed at each S; the last E passes over two.

    P, then CCCCRC S CR S S RL S E E E: the first two E find the left gates of the fourth and the
    third S; those of the second and the first have been visited, so that the last E empties it.
    """
    assert [e.stack for e in traced(TORUS)] == [
        0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 3, 3, 3, 4, 3, 2, 0
    ]  # fmt: skip
    assert [e.euler for e in traced(TORUS)][-4:] == [-3, -2, -1, 0]


def test_each_way_to_glue_finds_the_same_edges_by_itself() -> None:
    """EB-WRAP-1, EB-FAST-1, EB-DECODE-3: on the torus, before any vertex is named."""
    scanned = outline(encode(TORUS).stream)
    assert isinstance(scanned, Accepted)
    backwards = reversi(scanned.value)
    assert isinstance(backwards, Accepted)
    assert wrap_and_zip(scanned.value) == backwards.value
    assert wrap_and_fast_zip(scanned.value) == backwards.value


def test_the_annulus_step_by_step() -> None:
    """EB-COMPONENT-1, EB-COMPONENT-4, EB-TRAVERSE-4, EB-TRAVERSE-7, EB-HANDLE-2 …
    EB-HANDLE-4, EB-ORDER-2.

    Faces (2,5,4) (1,2,0) (3,0,2) (2,4,3) (0,5,1) (0,4,5). The edges opposite to corners 0 and 1 of
    face 0 lie in faces 5 and 3 too; that of corner 2, from 2 to 5, lies in no other face. So that
    is the first gate, and the first curve is 2, 5, 1: its edges 5→1 and 1→2 are run by faces 4 and
    1. The apex 4 lies on the other curve, which the faces run 4→3→0→4: S reaches it. The walk goes
    right, from 4 to 5, into face 5, and so on; face 3 comes last, entered from 3 to 2, and its
    right edge 2→4 is the left edge of the S.
    """
    steps = [(e.symbol, e.face, e.gate, e.triangle[0], e.new, e.closes) for e in traced(ANNULUS)]
    assert steps == [
        ("S", 0, (2, 5), 4, (2, 5, 1, 4, 3, 0), ()),
        ("L", 5, (4, 5), 0, (), ()),
        ("R", 4, (0, 5), 1, (), ()),
        ("R", 1, (0, 1), 2, (), ()),
        ("L", 2, (0, 2), 3, (), ()),
        ("E", 3, (3, 2), 4, (), (0,)),
    ]
    assert encode(ANNULUS).vertex_order == (2, 5, 1, 4, 3, 0)
    record = Record(Kind.BOUNDARY, 0, 4, Side.RIGHT)
    assert encode(ANNULUS).stream == Stream("SLRRLE", (record,), 1)


def test_components_with_boundary_come_first() -> None:
    """EB-COMPONENT-1, EB-COMPONENT-2, EB-COMPONENT-3: words stand one after another."""
    closed = [(a + 3, b + 3, c + 3) for a, b, c in TETRAHEDRON.triangles()]
    both = surface_of(*closed, (0, 1, 2))
    assert encode(both).stream == Stream("E" + "CRE", (), 1)
    assert encode(both).vertex_order == (1, 2, 0, 3, 4, 5, 6)
    assert encode(both).tip_order[0] == 3 * 4
    assert encode(TRIANGLE).stream == Stream("E", (), 1)


def test_all_four_decoders_rebuild_the_examples() -> None:
    """EB-DECODE-3, EB-FOLD-1, EB-FOLD-2, EB-WRAP-1, EB-WRAP-2, EB-FAST-1.

    EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3.
    """
    for example in (TETRAHEDRON, CUBE, TORUS, ANNULUS, TRIANGLE):
        encoding = encode(example)
        decoded = [
            codec.decode(encoding.stream) for codec in (FOLD, WRAP_AND_ZIP, FAST_ZIP, REFERENCE)
        ]
        assert all(isinstance(one, Accepted) for one in decoded)
        assert decoded.count(decoded[0]) == 4


def test_the_decoded_tetrahedron_by_hand() -> None:
    """EB-DECODE-1, EB-ORDER-3: tips first, as in the trace above, with its vertex names."""
    decoded = REFERENCE.decode(Stream("CRE"))
    assert isinstance(decoded, Accepted)
    assert list(decoded.value.triangles()) == [(0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0)]


def test_the_trace_of_two_components_numbers_them() -> None:
    """EB-TRACE-1."""
    closed = [(a + 3, b + 3, c + 3) for a, b, c in TETRAHEDRON.triangles()]
    entries = traced(surface_of(*closed, (0, 1, 2)))
    assert [(e.component, e.index, e.symbol) for e in entries] == [
        (0, 0, "E"), (1, -1, "P"), (1, 1, "C"), (1, 2, "R"), (1, 3, "E"),
    ]  # fmt: skip
    assert [e.euler for e in entries] == [2, 1, 1, 1, 2]
    assert entries[0].new == (1, 2, 0)
