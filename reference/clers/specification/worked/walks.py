"""Tables of meshes and walks: faces, corners, the walk, its records, what is created."""

from collections.abc import Iterator

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import (
    BORDER,
    Corner,
    Surface,
    next_corner,
    previous_corner,
)
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.edgebreaker.stream import Encoding
from clers.edgebreaker.trace import Entry, trace
from clers.geometry.mesh import Mesh
from clers.specification.worked.table import NONE, Fault, Meshes, Worked, compared, listed


def named(table: Worked) -> Mesh | str:
    """The mesh of a table of faces, or what is wrong with it."""
    try:
        faces = [tuple(map(int, cell.split())) for cell in table.column("vertices")]
    except ValueError:
        return "a face has something else than vertex numbers"
    if table.column("face") != tuple(map(str, range(len(faces)))):
        return "faces are not numbered from 0"
    triples = [(face[0], face[1], face[2]) for face in faces if len(face) == 3]
    if len(triples) != len(faces):
        return "a face has not three vertices"
    count = 1 + max((max(face) for face in triples), default=-1)
    match surface(FaceList(tuple(triples), count)):
        case Accepted(value):
            return Mesh(value)
        case rejected:
            return rejected.line()


def corners(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The corner table. Clauses: CPLX-CORNER-1, CPLX-CORNER-2."""
    of = meshes[table.words[0]].surface
    yield from compared(
        table,
        [
            {
                "corner": str(c),
                "vertex": str(of.vertex[c]),
                "edge": f"{of.vertex[next_corner(c)]}→{of.vertex[previous_corner(c)]}",
                "opposite": NONE if of.opposite[c] == BORDER else str(of.opposite[c]),
            }
            for c in map(Corner, range(3 * of.faces))
        ],
    )


def walk(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The walk, face by face. Clauses: EB-TRACE-1, EB-GATE-2."""
    of = meshes[table.words[0]].surface
    encoding = encode(of)
    entries = trace(of, encoding, outlined(encoding.stream))
    rows = (_row(of, encoding, made, entry) for made, entry in enumerate(entries))
    yield from compared(table, list(rows))


def _row(of: Surface, encoding: Encoding, made: int, entry: Entry) -> dict[str, str]:
    visited = {tip // 3 for tip in encoding.tip_order[:made]}
    first = entry.symbol == "P"

    def state(corner: Corner) -> str:
        other = of.opposite[corner]
        return "closed" if other == BORDER or other // 3 in visited else "open"

    tip = encoding.tip_order[made]
    return {
        "step": NONE if first else str(entry.index),
        "symbol": entry.symbol,
        "face": str(entry.face),
        "gate": f"{entry.gate[0]}→{entry.gate[1]}",
        "apex": NONE if first else str(entry.triangle[0]),
        "left": NONE if first else state(previous_corner(tip)),
        "right": NONE if first else state(next_corner(tip)),
        "stack": str(entry.stack),
        "new": listed(entry.new),
        "opens": NONE if entry.opens < 0 else str(entry.opens),
        "closes": listed(entry.closes),
        "χ": str(entry.euler).replace("-", "−"),
    }


def records(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """The handle data. Clauses: EB-HANDLE-1 … EB-HANDLE-5."""
    found = encode(meshes[table.words[0]].surface).stream.records
    rows = [
        {"record": str(k), "kind": r.kind.value, "s": str(r.s), "at": str(r.at), "side": r.side}
        for k, r in enumerate(found)
    ]
    yield from compared(table, rows)


def created(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Faces and vertices in the order of creation. Clauses: EB-ORDER-1, EB-ORDER-3."""
    of = meshes[table.words[0]].surface
    encoding = encode(of)
    number = {v: k for k, v in enumerate(encoding.vertex_order)}
    rows: list[dict[str, str]] = []
    for made, tip in enumerate(encoding.tip_order):
        own = [of.vertex[c] for c in (tip, next_corner(tip), previous_corner(tip))]
        rows.append(
            {
                "face": str(made),
                "vertices": listed([number[v] for v in own]),
                "face of the mesh": str(tip // 3),
                "its vertices": listed(own),
            }
        )
    yield from compared(table, rows)
