"""The single steps of shrinking, and what an input requires."""

from collections.abc import Iterator
from functools import cache
from itertools import islice

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.isomorphism import Isomorphic, isomorphism
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.samples import SAMPLES
from clers.conformance.serve import INTRODUCTION
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.generate.exhaustive import connected_surfaces
from clers.generate.sample import sample
from clers.generate.surfaces import closed_surfaces, surfaces
from clers.oracle.fuzz.behind import Net, behind, net_of, stream_form, surface_of_net
from clers.oracle.fuzz.inputs import drawn
from clers.oracle.fuzz.question import question
from clers.oracle.fuzz.requires import requires
from clers.oracle.fuzz.shrinking.blocks import nearer, without_blocks
from clers.oracle.fuzz.shrinking.contracting import contracted, flipped_and_contracted
from clers.oracle.fuzz.shrinking.nets import (
    numbered,
    pieces_of,
    plainer,
    without_components,
    without_faces,
    without_vertices,
)
from clers.oracle.fuzz.shrinking.sizes import measure, size_of
from clers.oracle.fuzz.shrinking.smallest import TORUS, TORUS_WITH_A_CURVE, smallest
from clers.oracle.fuzz.shrinking.steps import smaller
from clers.oracle.fuzz.shrinking.surgery import cut, filled

OPERATIONS = tuple(name for name in SAMPLES if name != "echo")


def totals(of: Surface) -> tuple[int, int, int]:
    """Components, handles, curves."""
    parts = components(of)
    return len(parts), sum(c.genus for c in parts), sum(c.curves for c in parts)


def as_surface(net: Net) -> Surface:
    built = surface_of_net(net)
    assert built is not None, net
    return built


def test_blocks() -> None:
    """ORCL-SHRINK-3: halves, quarters, single entries; of one entry nothing is left."""
    assert list(without_blocks("abcd")) == [
        ("c", "d"), ("a", "b"),
        ("b", "c", "d"), ("a", "c", "d"), ("a", "b", "d"), ("a", "b", "c"),
    ]  # fmt: skip
    assert list(without_blocks("a")) == [()]
    assert list(without_blocks("")) == []
    assert list(without_blocks("abc"))[-1] == ("a", "b")


@pytest.mark.parametrize(
    ("number", "smaller_ones"),
    [(0, []), (1, [0]), (2, [0, 1]), (9, [0, 4, 8]), (-1, [1, 0]), (-6, [6, 0, 3, 5])],
)
def test_nearer(number: int, smaller_ones: list[int]) -> None:
    """ORCL-SHRINK-3."""
    assert list(nearer(number)) == smaller_ones


@pytest.mark.parametrize("name", OPERATIONS)
def test_steps_make_requests_smaller_and_end(name: str) -> None:
    """ORCL-SHRINK-2: every candidate is of the same operation, and smaller."""
    what = drawn(name, INTRODUCTION.caps)
    assert what is not None
    for operation in sample(what, 12, 5):
        unit, count = measure(operation)
        assert count >= 0
        for number, candidate in enumerate(smaller(operation)):
            assert type(candidate) is type(operation)
            assert size_of(candidate) < size_of(operation)
            assert measure(candidate)[0] == unit
            if number > 60:
                break


def test_a_request_is_made_again_of_its_mesh() -> None:
    """ORCL-SHRINK-3: the mesh behind a request makes the same request, in creation order."""
    for name in ("word.decode", "code.encode", "code.decode", "mesh.decode", "word.encode"):
        what = drawn(name, INTRODUCTION.caps)
        assert what is not None
        good = 0
        for operation in sample(what, 20, 9):
            case = question(operation)
            about = behind(operation)
            if case is None or case.reject is not msgspec.UNSET:
                assert about is None or name in ("word.encode", "code.encode")
            elif about is not None:
                assert about.rebuild(about.net) == operation
                good += 1
        assert good > 4


@settings(max_examples=25)
@given(surfaces(30, (0, 2), (0, 3), (1, 3)))
def test_a_surface_requires_what_it_has(of: Surface) -> None:
    """ORCL-CASE-4: read off the faces, and off the stream, as the topology has it."""
    pieces, genus, curves = totals(of)
    expected = sorted(
        (["handles"] if genus else [])
        + (["components"] if pieces > 1 else [])
        + (["boundaries.one"] if curves == 1 else ["boundaries.many"] if curves else [])
    )
    faces = form.Faces(faces=tuple(of.triangles()), vertices=of.vertices)
    assert requires(message.WordEncode(id=0, input=faces)) == (tuple(expected), of.faces)
    stream = stream_form(encode(of).stream)
    names, size = requires(message.WordDecode(id=0, input=stream))
    assert list(names) == expected
    assert of.faces <= size <= of.faces + pieces


def test_codes_and_coders_are_required() -> None:
    """ORCL-CASE-4."""
    for name, expected in {
        "code.encode": ("code.plain",),
        "code.decode": ("code.plain",),
        "mesh.encode": ("code.plain",),
        "mesh.decode": ("code.plain",),
        "arithmetic.encode": ("coder.arithmetic",),
        "arithmetic.decode": ("coder.arithmetic",),
        "operator.apply": (),
        "echo": (),
    }.items():
        assert requires(SAMPLES[name])[0] == expected, name
    grown = message.Apply(id=0, input=form.ScriptForm(script="split-face 0; split-face 1"))
    assert requires(grown)[1] == 8
    assert requires(SAMPLES["arithmetic.encode"])[1] == 3


def test_a_broken_mesh_requires_what_it_looks_like() -> None:
    """ORCL-CASE-4: two faces that share a vertex, and a vertex of its own."""
    faces = form.Faces(faces=((0, 1, 2), (2, 3, 4), (5, 6, 7)), vertices=9)
    assert requires(message.Classify(id=0, input=faces))[0] == ("boundaries.many", "components")


def test_the_smallest_surfaces() -> None:
    """ORCL-SHRINK-7: each a surface, by size, and all connected ones of at most 6 faces."""
    nets = smallest()
    assert [len(net.faces) for net in nets] == sorted(len(net.faces) for net in nets)
    built = [as_surface(net) for net in nets]
    known = connected_surfaces(6)
    assert sum(totals(of)[0] == 1 for of in built) == len(known) + 2
    assert totals(as_surface(Net(TORUS, 7))) == (1, 1, 0)
    assert totals(as_surface(Net(TORUS_WITH_A_CURVE, 6))) == (1, 1, 1)
    assert (len(TORUS), len(TORUS_WITH_A_CURVE)) == (14, 8)
    pairs = {of.faces: totals(of) for of in built if totals(of)[0] == 2}
    assert pairs == {2: (2, 0, 2), 3: (2, 0, 2), 4: (2, 0, 2), 5: (2, 0, 1), 8: (2, 0, 0)}


@cache
def _closed() -> tuple[Surface, ...]:
    return sample(closed_surfaces(40, (0, 2), (1, 1)), 12, 3)


@cache
def _open() -> tuple[Surface, ...]:
    return sample(surfaces(30, (0, 1), (1, 3), (1, 1)), 12, 3)


def test_contractions_keep_the_topology() -> None:
    """ORCL-SHRINK-3, OPER-CONTRACT-1: with curves and without, many at once or one."""
    for of in (*_closed(), *_open()):
        for number, net in enumerate(contracted(net_of(of))):
            assert totals(as_surface(net)) == totals(of)
            assert len(net.faces) < of.faces
            if number > 20:
                break


def test_flips_then_contractions_keep_the_topology() -> None:
    """ORCL-SHRINK-3."""
    done = 0
    for of in (*_closed(), *_open()):
        for net in islice(flipped_and_contracted(net_of(of)), 10):
            assert totals(as_surface(net)) == totals(of)
            done += 1
    assert done > 20


def test_contraction_of_no_surface_merges_any_edge() -> None:
    """ORCL-SHRINK-3: degenerate faces go."""
    bow = Net(((0, 1, 2), (2, 3, 4)), 5)
    nets = list(contracted(bow))
    assert len(nets) == 6
    assert all((len(net.faces), net.vertices) == (1, 4) for net in nets)
    strange = Net(((0, 1, 7), (0, 1, 2)), 3)
    assert {net.vertices for net in contracted(strange)} == {2}


def test_cuts_take_a_handle_or_cut_in_two() -> None:
    """ORCL-SHRINK-3: along an empty triangle of the torus; between two spheres joined at one."""
    torus = net_of(as_surface(Net(TORUS, 7)))
    cuts = [totals(as_surface(net)) for net in cut(torus)]
    assert cuts
    assert set(cuts) == {(1, 0, 0)}
    joined = Net(
        ((0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)), 5
    )  # two tetrahedra with the face 0 1 2 in common, which is none
    alone = list(cut(joined))
    assert [len(net.faces) for net in alone] == [4, 4, 4, 4]
    assert {totals(as_surface(net)) for net in alone} == {(1, 0, 0)}


def test_filling_closes_a_curve() -> None:
    """ORCL-SHRINK-3: with a face, or with a cone; and it is smaller than it was."""
    done = 0
    for of in _open():
        for net in filled(net_of(of)):
            pieces, genus, curves = totals(of)
            assert totals(as_surface(net)) == (pieces, genus, curves - 1)
            assert len(net.faces) < of.faces
            done += 1
    assert done > 4


PLACED = Net(
    ((0, 1, 2), (4, 5, 6)), 7,
    places=tuple((float(v), 0.0, 1.0) for v in range(7)),
)  # fmt: skip


def test_positions_stay_with_their_vertices() -> None:
    """ORCL-SHRINK-3: a face goes with its vertices; a vertex that no face used stays."""
    first = next(without_components(PLACED))
    assert first.faces == ((0, 1, 2),)
    assert first.places is not None
    assert [place[0] for place in first.places] == [0.0, 1.0, 2.0, 3.0]
    alone = [net for net in without_vertices(PLACED) if len(net.faces) == 2]
    assert alone[0].vertices == 6
    assert alone[0].faces == ((0, 1, 2), (3, 4, 5))
    turned = numbered(Net(((2, 0, 1),), 3, places=((0.0, 0.0, 0.0), (1.0, 0, 0), (2.0, 0, 0))))
    assert turned.faces == ((0, 1, 2),)
    assert turned.places == ((2.0, 0, 0), (0.0, 0.0, 0.0), (1.0, 0, 0))


def test_plainer_meshes() -> None:
    """ORCL-SHRINK-3: without positions, all 0, one 0."""
    nets = list(plainer(PLACED))
    assert nets[0].places is None
    assert nets[1].places == ((0.0, 0.0, 0.0),) * 7
    assert nets[2].places is not None
    assert nets[2].places[0] == (0.0, 0.0, 0.0)
    assert len(nets) == 2 + 7 + 6 + 1


def test_faces_with_numbers_of_no_vertex_are_kept() -> None:
    """ORCL-SHRINK-3: nothing is mended on the way."""
    bad = Net(((0, 1, 9), (0, 1, 2)), 3)
    assert list(without_faces(bad)) == [Net(((0, 1, 2),), 3), Net(((0, 1, 8),), 2)]
    assert numbered(bad) == bad


def test_pieces() -> None:
    """ORCL-SHRINK-3: what hangs together at a vertex is one piece."""
    assert pieces_of(((0, 1, 2), (5, 6, 7), (2, 3, 4))) == [{0, 2}, {1}]


def candidates(operation: Operation) -> Iterator[str]:
    for candidate in smaller(operation):
        yield msgspec.json.encode(candidate.input).decode()


def test_records_follow_their_symbols() -> None:
    """ORCL-SHRINK-3: of a part of a word, its records with their numbers moved."""
    bad = form.StreamForm(
        word="ESLRRLEX",
        handles=(form.HandleForm(kind="boundary", s=0, at=4, side="left"),),
        components_with_boundary=1,
    )
    found = set(candidates(message.WordDecode(id=0, input=bad)))
    moved = form.StreamForm(
        word="SLRRLEX",
        handles=(form.HandleForm(kind="boundary", s=0, at=3, side="left"),),
        components_with_boundary=1,
    )
    assert msgspec.json.encode(moved).decode() in found


def test_scripts_lose_operators_and_get_smaller_numbers() -> None:
    """ORCL-SHRINK-3."""
    script = message.Apply(id=0, input=form.ScriptForm(script="split-face 4; flip-edge 1"))
    found = [msgspec.json.decode(text)["script"] for text in candidates(script)]
    assert found[:2] == ["flip-edge 1", "split-face 4"]
    assert "split-face 0; flip-edge 1" in found
    assert "split-face 2; flip-edge 1" in found


def test_what_is_isomorphic_is_renumbered_only() -> None:
    """ORCL-SHRINK-2: numbering makes the faces' list least, and keeps the surface."""
    for of in _open():
        net = numbered(net_of(of))
        built = surface(FaceList(net.faces, net.vertices))
        assert isinstance(built, Accepted)
        assert isinstance(isomorphism(of, built.value), Isomorphic)
        flat = list(dict.fromkeys(v for face in net.faces for v in face))
        assert flat == list(range(of.vertices))


@given(st.integers(-20, 20))
def test_smaller_numbers_are_smaller(number: int) -> None:
    """ORCL-SHRINK-2."""
    sizes = [(abs(n), n < 0) for n in nearer(number)]
    assert all(size < (abs(number), number < 0) for size in sizes)
