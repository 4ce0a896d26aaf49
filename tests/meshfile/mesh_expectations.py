"""What the tests of mesh files expect, in few words."""

from clers.complexes.face_list import DEFAULT_LIMITS, Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, Where
from clers.geometry.positions import Precision
from clers.meshfile.formats import Format
from clers.meshfile.mesh import RawMesh
from clers.meshfile.reading import parse

Triangles = tuple[tuple[int, int, int], ...]
SQUARE: Triangles = ((0, 1, 2), (1, 3, 2))
PLACES = (0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, -2.0)


def mesh(known: Format, data: bytes, limits: Limits = DEFAULT_LIMITS) -> RawMesh:
    """The mesh that must be read."""
    read = parse(known, data, limits)
    assert isinstance(read, Accepted), read
    return read.value


def is_square(known: Format, data: bytes, precision: Precision) -> None:
    """The bytes must be the square of the two triangles at the four places."""
    read = mesh(known, data)
    assert read.faces.faces == SQUARE
    assert read.faces.vertices == 4
    assert read.coordinates == PLACES
    assert all(type(x) is float for x in read.coordinates)
    assert read.precision == precision


def rejected(
    known: Format,
    data: bytes,
    reason: Reason,
    clause: Clause,
    where: Where = WHOLE,
    says: str = "",
    limits: Limits = DEFAULT_LIMITS,
) -> None:
    """The bytes must be rejected for this reason, by this clause, at this element."""
    read = parse(known, data, limits)
    assert isinstance(read, Rejected), read
    assert (read.reason, read.clause, read.where) == (reason, clause, where), read.line()
    assert says in read.detail


def unreadable(known: Format, data: bytes, says: str, where: Where = WHOLE) -> None:
    """The bytes must be unreadable, with these words in the detail."""
    rejected(known, data, Reason.UNREADABLE_FILE, Clause.TOOL_READ_5, where, says)
