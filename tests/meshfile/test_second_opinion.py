"""trimesh as a second opinion, on files that it reads without changing them."""

from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
import trimesh

import clers
from clers.conventions.result import Accepted
from clers.meshfile import RawMesh, read

MESHES = Path(clers.__file__).parents[2] / "corpus" / "meshes"
ALIKE = sorted(
    path.name
    for path in MESHES.iterdir()
    if path.suffix in (".off", ".ply", ".obj", ".stl") and path.name != "assimp-regr01.obj"
)
"""All but the one that trimesh splits by material."""


def ours(path: Path) -> RawMesh:
    result = read(path)
    assert isinstance(result, Accepted), result
    return result.value


def corners(
    places: npt.NDArray[np.float64], faces: npt.NDArray[np.int64]
) -> npt.NDArray[np.float64]:
    """Where the corners of all faces are: what is left to compare where vertices are welded."""
    return places[faces.reshape(-1)]


@pytest.mark.parametrize("name", ALIKE)
def test_the_corpus_reads_alike(name: str) -> None:
    """Clauses: TOOL-READ-2, TOOL-READ-7: the same faces and the same bits; STL by corners."""
    mesh = ours(MESHES / name)
    theirs = trimesh.load_mesh(MESHES / name, process=False, maintain_order=True)
    places = np.array(mesh.coordinates).reshape(-1, 3)
    faces = np.array(mesh.faces.faces)
    if name.endswith(".stl"):
        assert np.array_equal(corners(places, faces), corners(theirs.vertices, theirs.faces))
    else:
        assert theirs.faces.tolist() == faces.tolist()
        assert theirs.vertices.tolist() == places.tolist()


@pytest.mark.parametrize(
    ("suffix", "options"),
    [
        ("ply", {"encoding": "ascii"}),
        ("ply", {"encoding": "binary", "vertex_normal": True}),
        ("off", {"digits": 17}),
        ("obj", {"digits": 17, "include_normals": True}),
        ("stl", {}),
        ("stl_ascii", {}),
    ],
)
def test_what_trimesh_writes(
    suffix: str, options: dict[str, bool | int | str], tmp_path: Path
) -> None:
    """Clause: TOOL-READ-2: normals and headers of another writer are stepped over."""
    torus = trimesh.creation.torus(major_radius=3.0, minor_radius=1.0)
    path = tmp_path / f"torus.{suffix.removesuffix('_ascii')}"
    torus.export(path, file_type=suffix, **options)
    mesh = ours(path)
    places = np.array(mesh.coordinates).reshape(-1, 3)
    faces = np.array(mesh.faces.faces)
    assert len(faces) == len(torus.faces)
    assert len(places) == len(torus.vertices)
    if not suffix.startswith("stl"):
        assert faces.tolist() == torus.faces.tolist()
    got, expected = corners(places, faces), corners(torus.vertices, torus.faces)
    assert np.allclose(got, expected, rtol=0, atol=1e-6)
