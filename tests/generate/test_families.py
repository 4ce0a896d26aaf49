"""Families of meshes: sizes and topology by formula, the words they are made for, determinism."""

from collections import Counter
from hashlib import sha256
from typing import Final

import pytest

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.generate.families import (
    bipyramid,
    copies,
    grid_sphere,
    grid_torus,
    nested_splits,
    sphere_of,
    strip,
    torus_chain,
    with_holes,
)
from clers.generate.irregular import flip_at_random, irregular_sphere, split_at_random
from clers.generate.kinds import random_script
from clers.measure.speed.slopes import FAMILIES as SPEED_FAMILIES
from clers.operators.script import run


def accepted(mesh: FaceList) -> Surface:
    built = surface(mesh)
    assert isinstance(built, Accepted)
    return built.value


def topology(mesh: FaceList) -> list[tuple[int, int]]:
    """Genus and curves of each component."""
    return [(part.genus, part.curves) for part in components(accepted(mesh))]


def degrees(mesh: FaceList) -> Counter[int]:
    """How many vertices are in how many faces."""
    return Counter(Counter(v for face in mesh.faces for v in face).values())


@pytest.mark.parametrize("rings", [1, 2, 3, 8])
def test_grid_sphere(rings: int) -> None:
    mesh = grid_sphere(rings)
    assert topology(mesh) == [(0, 0)]
    assert len(mesh.faces) == 8 * rings**2
    assert mesh.vertices == 4 * rings**2 + 2
    assert degrees(mesh) == Counter({4: 6, 6: mesh.vertices - 6})


@pytest.mark.parametrize(("faces", "least"), [(0, 8), (8, 8), (9, 32), (32, 32), (33, 72)])
def test_sphere_of(faces: int, least: int) -> None:
    assert len(sphere_of(faces).faces) == least


@pytest.mark.parametrize(("rows", "columns"), [(3, 3), (3, 4), (7, 5)])
def test_grid_torus(rows: int, columns: int) -> None:
    mesh = grid_torus(rows, columns)
    assert topology(mesh) == [(1, 0)]
    assert len(mesh.faces) == 2 * rows * columns
    assert degrees(mesh) == Counter({6: rows * columns})


@pytest.mark.parametrize("genus", [1, 2, 3, 9])
@pytest.mark.parametrize(("rows", "columns"), [(4, 4), (5, 4), (4, 7)])
def test_torus_chain(genus: int, rows: int, columns: int) -> None:
    mesh = torus_chain(genus, rows, columns)
    assert topology(mesh) == [(genus, 0)]
    assert len(mesh.faces) == 2 * genus * rows * columns + 4 * (genus - 1)


def test_holes() -> None:
    assert topology(with_holes(grid_sphere(5), 7)) == [(0, 7)]
    assert topology(with_holes(grid_torus(6, 6), 4)) == [(1, 4)]


def test_no_room_for_holes() -> None:
    """On a tetrahedron any two faces touch."""
    tetrahedron = FaceList(((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)), 4)
    assert topology(with_holes(tetrahedron, 5)) == [(0, 1)]


def test_copies() -> None:
    assert topology(copies(grid_torus(3, 3), 5)) == [(1, 0)] * 5


@pytest.mark.parametrize("faces", [1, 2, 3, 50])
def test_strip(faces: int) -> None:
    mesh = strip(faces)
    assert topology(mesh) == [(0, 1)]
    assert components(accepted(mesh))[0].boundary_edges == faces + 2


@pytest.mark.parametrize("sides", [3, 4, 40])
def test_bipyramid(sides: int) -> None:
    mesh = bipyramid(sides)
    assert topology(mesh) == [(0, 0)]
    assert degrees(mesh) == Counter([sides, sides] + [4] * sides)


@pytest.mark.parametrize("depth", [0, 1, 2, 30])
def test_nested_splits(depth: int) -> None:
    """All its S are open before the first E."""
    mesh = nested_splits(depth)
    assert topology(mesh) == [(0, 0)]
    assert len(mesh.faces) == 4 * depth + 4
    expected = "C" * (2 * depth + 1) + "R" + "S" * depth + "E" * (depth + 1)
    assert encode(accepted(mesh)).stream.word == expected


@pytest.mark.parametrize("faces", [4, 6, 8, 10, 62, 64, 500, 3000])
def test_irregular_sphere(faces: int) -> None:
    mesh = irregular_sphere(faces, 1)
    assert topology(mesh) == [(0, 0)]
    assert len(mesh.faces) == faces


def test_irregular_spheres_are_irregular() -> None:
    """No degree is that of half of the vertices, and ten degrees occur."""
    mesh = irregular_sphere(5000, 1)
    count = degrees(mesh)
    assert max(count.values()) < mesh.vertices // 2
    assert len(count) >= 10


def test_same_seed_same_mesh() -> None:
    assert irregular_sphere(300, 5) == irregular_sphere(300, 5)
    assert irregular_sphere(300, 5) != irregular_sphere(300, 6)
    assert random_script(5, 30) == random_script(5, 30)
    assert random_script(5, 30) != random_script(6, 30)


@pytest.mark.parametrize("times", [0, 1, 8, 9, 200])
def test_split_at_random(times: int) -> None:
    """Also when there are more vertices to put in than faces."""
    mesh = split_at_random(grid_sphere(1), times, 3)
    assert topology(mesh) == [(0, 0)]
    assert mesh.vertices == 6 + times


def test_flips_keep_the_torus() -> None:
    mesh = flip_at_random(grid_torus(8, 8), 3, 1)
    assert topology(mesh) == [(1, 0)]
    assert degrees(mesh) != degrees(grid_torus(8, 8))


def test_open_meshes_are_not_flipped() -> None:
    assert flip_at_random(strip(9), 3, 1) == strip(9)


FIXED: Final = {
    "irregular sphere": "849286078a85183e",
    "irregular, shuffled": "fcc08e8e4308f683",
    "nested S": "3527d5c0dfb077e4",
    "one run of C": "b349593d52c303c7",
    "handles": "c61b565c0549e48b",
    "components": "bb25f217cef68d5b",
    "curves": "fb0e122b9fd93b31",
}
"""The first half of SHA-256 of index lists, as generators of Python tuples made them."""


@pytest.mark.parametrize("name", FIXED)
def test_meshes_stay_what_they_are(name: str) -> None:
    """TOOL-SPEED-1, TOOL-SPEED-5: numbers of one day are compared with those of another."""
    mesh = SPEED_FAMILIES[name](1000)
    assert sha256(mesh.buffer).hexdigest()[:16] == FIXED[name]


def test_random_script_grows() -> None:
    """A campaign's scripts give surfaces of some size."""
    built = run(random_script(1, 300))
    assert isinstance(built, Accepted)
    assert built.value.faces > 100
