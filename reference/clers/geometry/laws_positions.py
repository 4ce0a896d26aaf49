"""Laws of what positions are, their order, and their exact bytes."""

from math import isfinite
from struct import error as struct_error
from struct import pack, unpack
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtVertex, Whole
from clers.edgebreaker.decode import decode as decode_surface
from clers.edgebreaker.encode import encode as encode_surface
from clers.geometry import exact
from clers.geometry.given import COORDINATE_LISTS, MESHES, POSITIONS, CoordinateList
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.order import in_creation_order, into_order, out_of_order
from clers.geometry.positions import Positions, Precision, narrowest, positions


def _is_single(x: float) -> bool:
    """Does a value survive a binary32?"""
    try:
        (back,) = unpack("<f", pack("<f", x))
    except (OverflowError, struct_error):
        return False
    return isinstance(back, float) and back == x


def _first_fault(of: CoordinateList) -> Clause | None:
    """The clause that refuses, found one number at a time."""
    if len(of.coordinates) != 3 * of.vertices:
        return Clause.GEOM_POSITION_2
    if not all(isfinite(x) for x in of.coordinates):
        return Clause.GEOM_POSITION_3
    if of.precision is Precision.F32 and not all(_is_single(x) for x in of.coordinates):
        return Clause.GEOM_POSITION_4
    return None


def accepts_the_right_ones(of: CoordinateList) -> Verdict:
    """Accepted exactly if no clause refuses; otherwise refused by the first, at the first."""
    expected = _first_fault(of)
    match positions(of.precision, of.coordinates, of.vertices):
        case Accepted(found):
            return every(same(expected, None), same(of.coordinates, found.coordinates))
        case Rejected(_, clause, where, _):
            bad = [i // 3 for i, x in enumerate(of.coordinates) if not isfinite(x)] or [
                i // 3 for i, x in enumerate(of.coordinates) if not _is_single(x)
            ]
            whole = clause is Clause.GEOM_POSITION_2
            return every(
                same(expected, clause), same(Whole() if whole else AtVertex(min(bad)), where)
            )


def narrowest_fits(given: Positions) -> Verdict:
    """`f32` exactly if every number is a binary32 value."""
    single = all(_is_single(x) for x in given.coordinates)
    return same(Precision.F32 if single else Precision.F64, narrowest(given.coordinates))


def one_position_each(given: Mesh) -> Verdict:
    """A mesh with a position too few is refused."""
    if given.positions is None:
        return same(Accepted(given), mesh(given.surface))
    flat = given.positions.coordinates
    fewer = Positions(given.positions.precision, flat[:-3])
    refused = mesh(given.surface, fewer)
    return every(
        same(Accepted(given), mesh(given.surface, given.positions)),
        same(
            Clause.GEOM_MESH_1, refused.clause if isinstance(refused, Rejected) else "a rejection"
        ),
    )


def moved_with_vertices(given: Mesh) -> Verdict:
    """Stored position k is that of vertex order[k]."""
    if given.positions is None:
        return Holds()
    order = encode_surface(given.surface).vertex_order
    moved = into_order(given.positions, order)
    expected = [_bits(given.positions.point(v)) for v in order]
    return same(expected, [_bits(moved.point(k)) for k in range(moved.vertices)])


def moved_and_back(given: Mesh) -> Verdict:
    """Into the order of creation and out of it changes no bit."""
    if given.positions is None:
        return Holds()
    order = encode_surface(given.surface).vertex_order
    back = out_of_order(into_order(given.positions, order), order)
    return same(exact.encode(given.positions), exact.encode(back))


def creation_order_is_decoded(given: Mesh) -> Verdict:
    """Renumbering by the orders gives what decoding the stream gives."""
    encoding = encode_surface(given.surface)
    return same(
        decode_surface(encoding.stream), Accepted(in_creation_order(given.surface, encoding))
    )


def _bits(values: tuple[float, ...]) -> bytes:
    return b"".join(pack(">d", x) for x in values)


def exact_bytes(given: Positions) -> Verdict:
    """Each number alone, written with the highest byte first, then turned round."""
    letter = "f" if given.precision is Precision.F32 else "d"
    expected = b"".join(pack(f">{letter}", x)[::-1] for x in given.coordinates)
    return same(expected.hex(), exact.encode(given).hex())


def exact_comes_back(given: Positions) -> Verdict:
    """Every bit comes back; one byte more is refused."""
    data = exact.encode(given)
    longer = exact.decode(given.precision, data + b"\0", given.vertices)
    if isinstance(longer, Accepted):
        return Fails("a rejection", repr(longer.value), Whole())
    match exact.decode(given.precision, data, given.vertices):
        case Accepted(back):
            return every(
                same(given.precision, back.precision),
                same(_bits(given.coordinates), _bits(back.coordinates)),
                same(Clause.GEOM_EXACT_2, longer.clause),
            )
        case Rejected() as rejected:
            return Fails("positions", rejected.line(), rejected.where)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "positions-checked",
        Clause.GEOM_POSITION_1,
        "numbers are accepted exactly if no clause refuses them, or refused by the first",
        COORDINATE_LISTS,
        accepts_the_right_ones,
    ),
    Law(
        "positions-narrowest-precision",
        Clause.GEOM_POSITION_5,
        "the precision found is f32 exactly if every number is a binary32 value",
        POSITIONS,
        narrowest_fits,
    ),
    Law(
        "mesh-one-position-each",
        Clause.GEOM_MESH_1,
        "a mesh has as many positions as vertices, or none at all",
        MESHES,
        one_position_each,
    ),
    Law(
        "positions-move-with-vertices",
        Clause.GEOM_ORDER_1,
        "stored position k is the position of vertex order[k]",
        MESHES,
        moved_with_vertices,
    ),
    Law(
        "positions-move-back",
        Clause.GEOM_ORDER_2,
        "out_of_order (into_order p) is p, bit for bit",
        MESHES,
        moved_and_back,
    ),
    Law(
        "creation-order-is-decoded-order",
        Clause.GEOM_ORDER_3,
        "the surface renumbered by the orders is the decoded surface, opposite corners included",
        MESHES,
        creation_order_is_decoded,
    ),
    Law(
        "exact-positions-bytes",
        Clause.GEOM_EXACT_1,
        "the bytes are those of each number alone, lowest byte first",
        POSITIONS,
        exact_bytes,
    ),
    Law(
        "exact-positions-round-trip",
        Clause.GEOM_EXACT_2,
        "decode (encode p) is p, bit for bit",
        POSITIONS,
        exact_comes_back,
    ),
)
