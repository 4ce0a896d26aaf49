"""`clers complex` and `clers structure`: what a complex is, and whether arrays are a surface.

Clauses: TOOL-COMPLEX-1, TOOL-STRUCTURE-1, TOOL-STRUCTURE-2.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from clers.cli.loading import load, taken
from clers.cli.meshes import AsJson, Mesh
from clers.cli.output import json, line, note, progress

if TYPE_CHECKING:
    from clers.complexes.simplicial import Complex
    from clers.operators.portrait import Portrait

structure_app = typer.Typer(
    no_args_is_help=True, help="Half-edges and corner tables of other programs."
)

LARGE = 10_000
"""Of more simplices than this a portrait takes more than seconds."""

As = Annotated[
    Literal["half-edges", "corner-table"], typer.Option("--as", help="Which data structure.")
]


def complex_of(
    file: Annotated[
        Path, typer.Argument(help="Facets as JSON (.json), or a PLY, OFF, OBJ or STL file.")
    ],
    as_json: AsJson = False,
) -> None:
    """Say what a complex is: homology, manifold or not, type; of meshes that are no surface too."""
    from clers.operators.portrait import portrait

    with progress("complex", 2) as step:
        step("reading")
        k = _read(file, as_json=as_json)
        if len(k.simplices) > LARGE:
            note(f"clers: definitions are quadratic; {len(k.simplices)} simplices take long")
        step("looking")
        seen = portrait(k)
    if as_json:
        json(seen)
        return
    for name, value in _lines(seen):
        line(f"{name}: {value}")


def _read(file: Path, *, as_json: bool) -> "Complex":
    """The complex of a list of facets, or the closure of a mesh's faces as they are."""
    from clers.complexes.complex_text import read_complex
    from clers.complexes.facets import from_facets
    from clers.conventions.result import and_then
    from clers.meshfile.reading import contents, read

    if file.suffix.lower() == ".json":
        text = and_then(contents(file), lambda data: read_complex(data.decode(errors="replace")))
        return taken(text, file, as_json=as_json)
    faces = and_then(read(file), lambda raw: from_facets(raw.faces.faces))
    return taken(faces, file, as_json=as_json)


def _lines(seen: "Portrait") -> list[tuple[str, str]]:
    found = [
        ("f-vector", " ".join(map(str, seen.f_vector))),
        ("χ", str(seen.euler)),
        ("components", str(seen.components)),
        ("pure", "yes" if seen.pure else "no"),
        ("homology over Z", ", ".join(seen.homology)),
        ("manifold", seen.manifold + (f", at {_listed(seen.simplex)}" if seen.simplex else "")),
        ("orientable", seen.orientable),
    ]
    if seen.one_sided:
        found.append(("one-sided along", " ".join(map(_listed, seen.one_sided))))
    if seen.types:
        found.append(("surface", ", ".join(seen.types)))
    return [*found, ("collapsible", seen.collapsible)]


def _listed(simplex: tuple[int, ...]) -> str:
    return "{" + ", ".join(map(str, simplex)) + "}"


@structure_app.command()
def export(mesh: Mesh, structure: As = "half-edges") -> None:
    """Print the right arrays for a mesh, as JSON."""
    from clers.complexes.corner_table import face_list
    from clers.complexes.polytopes.polygons import PolygonList
    from clers.complexes.structures.arrays import write_corner_table, write_half_edges
    from clers.complexes.structures.half_edge_polygons import from_polygons

    surface = load(mesh).surface
    if structure == "corner-table":
        line(write_corner_table(surface).decode())
        return
    faces = face_list(surface).faces
    polygons = PolygonList(faces, surface.vertices)
    line(write_half_edges(taken(from_polygons(polygons), mesh)).decode())


@structure_app.command()
def check(
    file: Annotated[Path, typer.Argument(help="Arrays as JSON.")],
    structure: As = "half-edges",
    as_json: AsJson = False,
) -> None:
    """Judge the arrays of another program: the first entry that is wrong, or the surface."""
    from clers.complexes.structures.arrays import read_corner_table, read_half_edges
    from clers.complexes.structures.half_edge_polygons import is_regular
    from clers.conventions.result import and_then
    from clers.meshfile.reading import contents

    if structure == "corner-table":
        table = taken(and_then(contents(file), read_corner_table), file, as_json=as_json)
        vertices, faces, regular = table.vertices, table.faces, True
    else:
        found = taken(and_then(contents(file), read_half_edges), file, as_json=as_json)
        vertices, faces, regular = found.vertices, found.faces, is_regular(found)
    if as_json:
        json({"source": str(file), "vertices": vertices, "faces": faces, "regular": regular})
        return
    what = "a surface" if regular else "a map that is no polygonal surface, but consistent"
    line(f"{file}: {what}, {vertices} vertices, {faces} faces")
