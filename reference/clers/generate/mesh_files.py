"""Strategies for the domains of chapter 10: raw meshes, and bytes of mesh files."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.face_list import FaceList
from clers.conventions.result import Accepted
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format
from clers.meshfile.laws import FILE_BYTES, RAW_MESH, FileBytes
from clers.meshfile.mesh import RawMesh
from clers.meshfile.rendering import render

_SINGLES: Final = st.floats(width=32)
_DOUBLES: Final = st.floats()
_FEW: Final = st.sampled_from((0.0, -0.0, 1.0, 0.1, 1e300, 5e-324, float("inf"), float("nan")))
_PALETTES: Final = tuple(st.lists(of, min_size=1, max_size=6) for of in (_SINGLES, _DOUBLES, _FEW))


@st.composite
def raw_meshes(draw: st.DrawFn) -> RawMesh:
    """Any triangles over a few vertices; each coordinate is one of a few numbers."""
    vertices = draw(st.integers(0, 7))
    number = st.integers(0, max(vertices - 1, 0))
    faces = draw(st.lists(st.tuples(number, number, number), max_size=6)) if vertices else []
    palette = draw(st.one_of(_PALETTES))
    size = 3 * vertices
    coordinates = draw(st.lists(st.sampled_from(palette), min_size=size, max_size=size))
    precision = draw(st.sampled_from(Precision))
    return RawMesh(FaceList(tuple(faces), vertices), tuple(coordinates), precision)


@st.composite
def stl_meshes(draw: st.DrawFn) -> RawMesh:
    """Meshes that STL gives back: each vertex is used, and at a place of its own in binary32."""
    vertices = draw(st.integers(3, 7))
    fan = [(v, (v + 1) % vertices, (v + 2) % vertices) for v in range(vertices)]
    faces = draw(st.permutations(fan))
    places = draw(
        st.lists(
            st.tuples(_SINGLES, _SINGLES, _SINGLES),
            min_size=vertices,
            max_size=vertices,
            unique_by=lambda point: tuple(str(x + 0.0) for x in point),
        )
    )
    coordinates = tuple(x for place in places for x in place)
    precision = draw(st.sampled_from(Precision))
    return RawMesh(FaceList(tuple(faces), vertices), coordinates, precision)


def _rendered(known: Format, mesh: RawMesh) -> bytes:
    """The file of a mesh; of one that is refused, nothing."""
    data = render(known, mesh)
    return data.value if isinstance(data, Accepted) else b""


def _damaged(data: bytes) -> st.SearchStrategy[bytes]:
    """A file whole, cut off, with a stretch replaced, or doubled."""
    at = st.integers(0, len(data))
    words = st.sampled_from((b"", b"\n", b"-1", b" 4 ", b"nan", b"#", b"1e999", b"99999999999"))
    return st.one_of(
        st.just(data),
        at.map(lambda i: data[:i]),
        st.tuples(at, at, st.binary(max_size=4) | words).map(
            lambda cut: data[: min(cut[:2])] + cut[2] + data[max(cut[:2]) :]
        ),
        st.tuples(at, st.integers(1, 4), st.binary(max_size=4) | words).map(
            lambda cut: data[: cut[0]] + cut[2] + data[cut[0] + cut[1] :]
        ),
        st.just(data + data),
    )


@st.composite
def file_bytes(draw: st.DrawFn) -> FileBytes:
    """Mesh files, whole and damaged, and bytes of no origin."""
    known = draw(st.sampled_from(Format))
    mesh = draw(stl_meshes() if known is Format.STL else raw_meshes())
    data = draw(st.one_of(_damaged(_rendered(known, mesh)), st.binary(max_size=200)))
    return FileBytes(known, data)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    RAW_MESH.name: raw_meshes() | stl_meshes(),
    FILE_BYTES.name: file_bytes(),
}
