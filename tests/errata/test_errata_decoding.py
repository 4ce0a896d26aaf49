"""ERRATUM-10, 11 and 20 to 23: the decoder as printed loses count."""

import pytest
from every_small_surface import from_every_gate
from printed_unwalk import geometry_in_turn, read_handles, wrap

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, TETRAHEDRON, TORUS, TRIANGLE
from clers.edgebreaker.given import outlined
from clers.edgebreaker.remainder import trees
from clers.edgebreaker.stream import Stream
from clers.generate.exhaustive import as_surface, sphere_triangulations


def _pushes(stream: Stream) -> list[bool]:
    recorded = {record.s for record in stream.records}
    return [s not in recorded for s in range(stream.word.count("S"))]


def test_the_right_side_of_an_s_tells_nothing() -> None:
    """ERRATUM-10: with `not t.right.mark`, never false at an S, every S pushes. EB-WRAP-1.

    The annulus, a smallest surface with a record (ERRATUM-5), then asks for a seventh symbol.
    """
    for stream in (encode(ANNULUS).stream, encode(TORUS).stream):
        with_boundary, always = stream.components_with_boundary, [True] * stream.word.count("S")
        assert wrap(stream.word, with_boundary, always).ran_out
        assert not wrap(stream.word, with_boundary, _pushes(stream)).ran_out


def test_pushing_by_records_works() -> None:
    """ERRATUM-10: on all small surfaces, an S pushes exactly if it has no record."""
    for begun in from_every_gate(6):
        stream = encode(begun).stream
        assert not wrap(stream.word, stream.components_with_boundary, _pushes(stream)).ran_out


def test_a_boundary_at_triangle_0_is_read_as_a_vertex() -> None:
    """ERRATUM-11: Algorithm 10 asks for t < 0; one triangle is number 0. EB-ORDER-1."""
    stream = encode(TRIANGLE).stream
    made = wrap(stream.word, stream.components_with_boundary, [])
    assert ["vertex" if t >= 0 else "boundary" for t in made.c_stack] == ["vertex"]


def test_the_last_datum_is_glued_too() -> None:
    """ERRATUM-20: of the tetrahedron Algorithm 4 writes one number, 0; Algorithm 7 glues S 0.

    EB-WORD-2: the number of components with boundary is no record.
    """
    stream = encode(TETRAHEDRON).stream
    assert (stream.word.count("S"), stream.components_with_boundary) == (0, 0)
    assert read_handles([stream.components_with_boundary]) == [("boundary", 0)]


def test_the_last_triangle_of_a_component_is_not_counted() -> None:
    """ERRATUM-21: two triangles apart have one number. EB-ORDER-3. One component shows nothing."""
    apart = surface(FaceList(((0, 1, 2), (3, 4, 5)), 6))
    assert isinstance(apart, Accepted)
    stream = encode(apart.value).stream
    assert stream == Stream("EE", (), 2)
    assert wrap(stream.word, stream.components_with_boundary, []).numbers == [0, 0]
    whole = encode(TETRAHEDRON).stream
    assert wrap(whole.word, 0, []).numbers == [0, 1, 2, 3]


def test_the_vertices_of_p_are_read_early_and_again() -> None:
    """ERRATUM-22: of a tetrahedron four vertices are written and five read. EB-ORDER-1.

    Of two, the fourth vertex written belongs to the C of the first, the fourth read to the other P.
    """
    word = encode(TETRAHEDRON).stream.word
    stack = wrap(word, 0, []).c_stack
    assert (len(geometry_in_turn([stack])), TETRAHEDRON.vertices) == (5, 4)
    written = [0, 0, 0, 1, 4, 4, 4, 5]  # by triangle: P, P, P, C of each
    assert geometry_in_turn([[0, 1], [4, 5]])[:4] == [0, 0, 0, 4] != written[:4]


@pytest.mark.parametrize("vertices", range(4, 8))
def test_zipping_at_c_alone_leaves_two_edges(vertices: int) -> None:
    """ERRATUM-23: V − 1 edges are to be zipped, and V − 3 of them are the left edge of a C.

    EB-WRAP-2, EB-REMAINDER-2. The tetrahedron is the smallest: three edges, one C.
    """
    for faces in sphere_triangulations(vertices):
        begun = as_surface(faces)
        assert begun is not None
        stream = encode(begun).stream
        decoded = decode(stream)
        assert isinstance(decoded, Accepted)
        (tree,) = trees(outlined(stream), decoded.value)
        left_of_c = {3 * (i + 1) + 2 for i, x in enumerate(stream.word) if x == "C"}
        at_c = [c for c in tree.remainder if {c, decoded.value.opposite[c]} & left_of_c]
        assert (len(tree.remainder), len(at_c)) == (vertices - 1, vertices - 3)
