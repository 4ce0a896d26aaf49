"""`clers complex` and `clers structure`: TOOL-COMPLEX-1, TOOL-STRUCTURE-1, TOOL-STRUCTURE-2."""

import json
from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
RING: Final = str(MESHES / "ring.off")


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def test_a_list_of_facets(tmp_path: Path) -> None:
    """TOOL-COMPLEX-1: a triangle and a point."""
    file = tmp_path / "facets.json"
    file.write_text("[[0,1,2],[5]]")
    done = clers("complex", str(file))
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout.splitlines() == [
        "f-vector: 4 3 1",
        "χ: 2",
        "components: 2",
        "pure: no",
        "homology over Z: Z^2, 0, 0",
        "manifold: no: a maximal simplex of too low a dimension, at {5}",
        "orientable: no meaning: a maximal simplex of too low a dimension",
        "collapsible: no: the Betti numbers over GF(2) are 2, 0, 0",
    ]


def test_a_mesh_that_is_no_surface() -> None:
    """TOOL-COMPLEX-1: oriented or not, it is a complex."""
    done = clers("complex", str(MESHES / "dirty" / "moebius.off"))
    assert done.exit_code == Exit.CONFORMING
    lines = done.stdout.splitlines()
    assert lines[7].startswith("one-sided along: {")
    assert lines[8] == "surface: Möbius band"
    seen = json.loads(clers("complex", str(MESHES / "dirty" / "moebius.off"), "--json").stdout)
    assert seen["types"] == ["Möbius band"]
    assert seen["f_vector"] == [5, 10, 5]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[[0,1", "malformed: unreadable-file"),
        ("[[0,0]]", "invalid: repeated-index at face 0"),
    ],
)
def test_no_complex(tmp_path: Path, text: str, words: str) -> None:
    """TOOL-COMPLEX-1."""
    file = tmp_path / "facets.json"
    file.write_text(text)
    done = clers("complex", str(file))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert f"{file}: {words}" in done.stderr


@pytest.mark.parametrize("structure", ["half-edges", "corner-table"])
def test_what_is_exported_is_good(tmp_path: Path, structure: str) -> None:
    """TOOL-STRUCTURE-1, TOOL-STRUCTURE-2."""
    file = tmp_path / "arrays.json"
    file.write_text(clers("structure", "export", RING, "--as", structure).stdout)
    done = clers("structure", "check", str(file), "--as", structure)
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout == f"{file}: a surface, 6 vertices, 6 faces\n"
    said = json.loads(clers("structure", "check", str(file), "--as", structure, "--json").stdout)
    assert said == {"source": str(file), "vertices": 6, "faces": 6, "regular": True}


@pytest.mark.parametrize(
    ("structure", "array", "clause"),
    [("half-edges", "twin", "CPLX-HALFEDGE-4"), ("corner-table", "opposite", "CPLX-REFINE-2")],
)
def test_a_wrong_entry_is_blamed(tmp_path: Path, structure: str, array: str, clause: str) -> None:
    """TOOL-STRUCTURE-1."""
    arrays = json.loads(clers("structure", "export", RING, "--as", structure).stdout)
    arrays[array][0], arrays[array][1] = arrays[array][1], arrays[array][0]
    file = tmp_path / "arrays.json"
    file.write_text(json.dumps(arrays))
    done = clers("structure", "check", str(file), "--as", structure)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert f"broken-invariant at entry 0 of {array} [{clause}]" in done.stderr


@pytest.mark.parametrize(
    ("structure", "clause"),
    [("half-edges", "CPLX-HALFEDGE-17"), ("corner-table", "CPLX-REFINE-3")],
)
@pytest.mark.parametrize("text", ["{}", '{"vertex": [0], "next": 1}', "["])
def test_no_arrays(tmp_path: Path, structure: str, clause: str, text: str) -> None:
    """TOOL-STRUCTURE-1, CPLX-REFINE-3."""
    file = tmp_path / "arrays.json"
    file.write_text(text)
    done = clers("structure", "check", str(file), "--as", structure)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert f"unreadable-file of the whole input [{clause}]" in done.stderr


def test_a_map_that_is_no_surface(tmp_path: Path) -> None:
    """TOOL-STRUCTURE-1: two triangles back to back have two edges between the same vertices."""
    file = tmp_path / "pillow.json"
    arrays = {
        "next": [1, 2, 0, 4, 5, 3],
        "previous": [2, 0, 1, 5, 3, 4],
        "twin": [3, 5, 4, 0, 2, 1],
        "origin": [0, 1, 2, 1, 0, 2],
        "face": [0, 0, 0, 1, 1, 1],
        "of_vertex": [0, 1, 2],
        "of_face": [0, 3],
    }
    file.write_text(json.dumps(arrays))
    done = clers("structure", "check", str(file))
    assert done.exit_code == Exit.CONFORMING, done.stderr
    assert "a map that is no polygonal surface" in done.stdout
