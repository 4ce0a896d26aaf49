"""Tree words there and back take linear time: executed lines are counted, not seconds."""

from collections.abc import Callable
from functools import partial

import pytest

from clers.codes.closure import sphere_of
from clers.codes.tree_word import tree_word
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.generate.families import bipyramid
from clers.generate.uniform import uniform_sphere
from counted import lines

pytestmark = pytest.mark.interpreted


def hubs(vertices: int) -> Surface:
    """Two vertices that all others are joined to, from a face at a hub."""
    return built(bipyramid(vertices - 2))


def from_the_rim(vertices: int) -> Surface:
    """The same from a corner on the rim: a hub is on the path from beginning to end."""
    mesh = bipyramid(vertices - 2)
    (a, b, c), *rest = mesh.faces
    return built(FaceList(((b, c, a), *rest), mesh.vertices))


def built(mesh: FaceList) -> Surface:
    made = surface(mesh)
    assert isinstance(made, Accepted)
    return made.value


@pytest.mark.parametrize("family", [hubs, from_the_rim, lambda n: uniform_sphere(n, 1)])
def test_lines_grow_with_the_sphere(family: Callable[[int], Surface]) -> None:
    """CODE-TREE-3, CODE-TREE-4, CODE-TREE-8: eight times the vertices, eight times the lines."""
    spheres = [family(200), family(1600)]
    words = [tree_word(sphere) for sphere in spheres]
    assert [len(word) // 4 + 3 for word in words] == [200, 1600]
    there = [lines(partial(tree_word, sphere), "clers/") for sphere in spheres]
    back = [lines(partial(sphere_of, word), "clers/") for word in words]
    for few, many in (there, back):
        assert many < 8.5 * few
