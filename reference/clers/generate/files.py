"""Strategies for the domains of chapter 8, and the pool of files that tampering starts from."""

from collections.abc import Iterator, Mapping
from functools import cache
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface
from clers.complexes.surface import Surface
from clers.container.file import encode
from clers.container.given import ToDamage, ToWrite
from clers.container.options import Accuracy, Exact, InBits, OnLattice, Options, WithinError
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.generate.bounds import FIRST, go_on
from clers.generate.families import bipyramid, copies, grid_sphere, grid_torus, strip, with_holes
from clers.generate.kinds import EVERY
from clers.generate.meshes import meshes
from clers.generate.surfaces import surfaces
from clers.generate.tamper import tampered
from clers.geometry.mesh import Mesh
from clers.geometry.positions import Positions, Precision

ACCURACIES: Final[st.SearchStrategy[Accuracy]] = st.one_of(
    st.just(Exact()),
    st.builds(InBits, st.integers(1, 30)),
    st.builds(OnLattice, st.integers(-12, 3)),
    st.builds(WithinError, st.floats(1e-3, 10.0)),
)

OPTIONS: Final = st.builds(Options, st.sampled_from(CodeName), ACCURACIES)


def _writable(mesh: Mesh, options: Options) -> ToWrite:
    """With exact positions where the accuracy asked for cannot be had; and the default code."""
    choices = (options, Options(options.code, Exact()), Options(accuracy=options.accuracy))
    for choice in choices:
        if isinstance(encode(mesh.surface, mesh.positions, choice), Accepted):
            return ToWrite(mesh, choice)
    return ToWrite(mesh, Options(accuracy=Exact()))


def to_write(of: st.SearchStrategy[Surface]) -> st.SearchStrategy[ToWrite]:
    """Meshes, one in four without positions, and options that their file can have."""
    bare = of.map(Mesh)
    return st.builds(_writable, st.one_of(bare, meshes(of), meshes(of), meshes(of)), OPTIONS)


def _grown(random: Random) -> Surface:
    """A random surface: a script of up to forty operators."""
    script = [
        random.choice(EVERY)(random.randrange(1000), random.randrange(1000))
        for _ in range(random.randrange(40))
    ]
    built = surface(go_on(FIRST, script).mesh)
    assert isinstance(built, Accepted), built
    return built.value


def _regular() -> Iterator[Surface]:
    """The spec's examples, and small surfaces of every kind."""
    yield from (TETRAHEDRON, CUBE, TORUS, ANNULUS, TRIANGLE)
    torus = grid_torus(3, 4)
    solids = (grid_sphere(2), bipyramid(9), torus, strip(7))
    for mesh in (*solids, with_holes(torus, 2), copies(torus, 2), with_holes(grid_sphere(3), 3)):
        built = surface(mesh)
        assert isinstance(built, Accepted), built
        yield built.value


def _positions(vertices: int, random: Random) -> Positions:
    """Small multiples of an eighth: values of binary32."""
    flat = tuple(random.randrange(-80, 80) / 8 for _ in range(3 * vertices))
    return Positions(random.choice(tuple(Precision)), flat)


@cache
def pool(seed: int, size: int = 60) -> tuple[bytes, ...]:
    """Sound files of many kinds; the same seed gives the same files."""
    random = Random(seed)
    found = [*_regular(), *(_grown(random) for _ in range(size))]
    accuracies: tuple[Accuracy, ...] = (Exact(), InBits(5), InBits(11), WithinError(0.25))
    files: list[bytes] = []
    for one in found:
        options = Options(random.choice(tuple(CodeName)), random.choice(accuracies))
        placed = _positions(one.vertices, random) if random.randrange(4) else None
        written = encode(one, placed, options)
        if isinstance(written, Rejected):  # a code for spheres alone
            written = encode(one, placed, Options(accuracy=options.accuracy))
        assert isinstance(written, Accepted), written
        files.append(written.value)
    return tuple(files)


def _tampered(seed: int) -> bytes:
    return tampered(pool(0), Random(seed))[1]


SMALL: Final = surfaces(max_faces=30, genus=(0, 2), curves=(0, 3), components=(1, 3))

TO_WRITE: Final = to_write(SMALL)

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "meshes-to-write": TO_WRITE,
    "files-to-damage": st.builds(ToDamage, TO_WRITE, st.integers(0, 9999), st.integers(1, 255)),
    "files": st.one_of(st.integers(0, 1 << 32).map(_tampered), st.binary(max_size=60)),
    "stored-numbers": st.one_of(st.integers(0, 300), st.integers(0, (1 << 64) - 1)),
    "raw-bytes": st.binary(max_size=24),
}
"""The domains of this module, by name."""
