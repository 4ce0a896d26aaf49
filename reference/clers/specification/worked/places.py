"""Tables of positions: on the lattice, predicted, and what is left."""

from collections.abc import Iterator, Sequence

from clers.complexes.surface import Corner, Surface, next_corner, previous_corner
from clers.conventions.result import Accepted, and_then
from clers.edgebreaker.encode import encode
from clers.geometry.box import Boxed, boxed
from clers.geometry.lattice import exponent_for_bits, quantise
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.order import in_creation_order, into_order
from clers.geometry.positions import narrowest, positions
from clers.geometry.predict import NONE as NO_CORNER
from clers.geometry.predict import parallelogram_corners, prediction
from clers.geometry.residual import fold
from clers.specification.worked.table import NONE, Fault, Meshes, Worked, compared, listed


def placed(table: Worked, of: Mesh) -> Mesh | str:
    """The mesh with the positions of a table, or what is wrong with them."""
    if table.column("vertex") != tuple(map(str, range(of.surface.vertices))):
        return "the vertices are not those of the mesh, from 0 on"
    try:
        flat = tuple(float(row[axis]) for _, row in table.rows for axis in "xyz")
    except (KeyError, ValueError):
        return "a coordinate is no number"
    count = of.surface.vertices
    match and_then(positions(narrowest(flat), flat, count), lambda p: mesh(of.surface, p)):
        case Accepted(value):
            return value
        case rejected:
            return rejected.line()


def on_lattice(of: Mesh, bits: str) -> tuple[Surface, Boxed] | str:
    """Surface and lattice points in the order of creation, in their box, for so many bits.

    Clauses: GEOM-ORDER-3, GEOM-CHOICE-1, GEOM-LATTICE-2, GEOM-BOX-1.
    """
    if of.positions is None or not bits.isdecimal():
        return "positions, and a number of bits, are needed"
    encoding = encode(of.surface)
    ordered = into_order(of.positions, encoding.vertex_order)
    exponent = exponent_for_bits(ordered, int(bits))
    match and_then(and_then(exponent, lambda e: quantise(ordered, e)), boxed):
        case Accepted(found):
            return in_creation_order(of.surface, encoding), found
        case rejected:
            return rejected.line()


def lattice(table: Worked, meshes: Meshes) -> Iterator[Fault]:
    """Each vertex on the lattice, where it is expected, and the residuals.

    Clauses: GEOM-LATTICE-2, GEOM-PREDICT-1, GEOM-PREDICT-2, GEOM-RESIDUAL-1, GEOM-CODE-1.
    """
    of = meshes[table.words[0]]
    stored = on_lattice(of, table.words[1] if len(table.words) > 1 else "")
    if isinstance(stored, str):
        yield table.line, stored
        return
    surface, given = stored
    order = encode(of.surface).vertex_order
    rows = (_row(surface, given, k) | {"vertex": str(v)} for k, v in enumerate(order))
    yield from compared(table, list(rows))


def _row(surface: Surface, given: Boxed, k: int) -> dict[str, str]:
    """What is to be said of the vertex of stored position k."""
    index = given.indices[3 * k : 3 * k + 3]
    corner = parallelogram_corners(surface)[k]
    expected = [
        prediction(surface, corner, k, axis, given.indices, given.box.extent[axis])
        for axis in range(3)
    ]
    left = [q - p for q, p in zip(index, expected, strict=True)]
    folded = [fold(r) for r in left]
    return {
        "position": str(k),
        "vertex": "",
        "numbers": _signed([q + low for q, low in zip(index, given.box.low, strict=True)]),
        "index": listed(index),
        "corner": NONE if corner == NO_CORNER else str(corner),
        "a b o": NONE if corner == NO_CORNER else listed(_around(surface, corner)),
        "expected": listed(expected),
        "residual": _signed(left),
        "class": listed([z.bit_length() for z in folded]),
        "rest": " ".join(f"{z:b}"[1:] or NONE for z in folded),
    }


def _around(surface: Surface, corner: Corner) -> tuple[int, int, int]:
    """The vertices a, b and o of GEOM-PREDICT-1."""
    v = surface.vertex
    across = surface.opposite[corner]
    return v[next_corner(corner)], v[previous_corner(corner)], v[across]


def _signed(values: Sequence[int]) -> str:
    return listed(values).replace("-", "−")
