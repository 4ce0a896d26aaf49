"""`clers repair`: named, explicit repairs of a mesh file, each told. Clause: TOOL-REPAIR-1."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import taken
from clers.cli.output import json, line

if TYPE_CHECKING:
    from clers.complexes.repair import Repaired
    from clers.meshfile.mesh import RawMesh


def repair(
    mesh: Annotated[Path, typer.Argument(help="A PLY, OFF, OBJ or STL file.")],
    out: Annotated[Path, typer.Option("--out", "-o", help="The mesh file to write.")],
    orient: Annotated[
        bool, typer.Option("--orient", help="Turn faces over so that neighbours agree.")
    ] = False,
    split_pinched: Annotated[
        bool, typer.Option("--split-pinched", help="Give each fan of a pinched vertex its own.")
    ] = False,
    drop_isolated: Annotated[
        bool, typer.Option("--drop-isolated", help="Leave out vertices that no face names.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Repair a mesh file: what is asked for and no more, in the order of these options."""
    from clers.complexes import repair as repairs
    from clers.meshfile.reading import read
    from clers.meshfile.writing import write

    asked = [
        (orient, "orient", repairs.orient),
        (split_pinched, "split-pinched", repairs.split_pinched),
        (drop_isolated, "drop-isolated", repairs.drop_isolated),
    ]
    if not any(wanted for wanted, _, _ in asked):
        raise typer.BadParameter("nothing asked: --orient, --split-pinched, --drop-isolated")
    raw = taken(read(mesh), mesh, as_json=as_json)
    done: list[dict[str, object]] = []
    for wanted, name, mend in asked:
        if wanted:
            repaired = taken(mend(raw.faces), mesh, as_json=as_json)
            raw = _moved(raw, repaired)
            done.append(
                {"repair": name, "actions": len(repaired.actions), "did": repaired.sentence()}
            )
    taken(write(out, raw), out, as_json=as_json)
    if as_json:
        json(done)
    else:
        for one in done:
            line(f"{out}: {one['repair']}: {one['did']}")


def _moved(raw: "RawMesh", repaired: "Repaired") -> "RawMesh":
    """The positions of a repaired mesh: each vertex has that of the one it stands for."""
    from clers.meshfile.mesh import RawMesh

    places = tuple(x for v in repaired.source for x in raw.coordinates[3 * v : 3 * v + 3])
    return RawMesh(repaired.face_list, places, raw.precision)
