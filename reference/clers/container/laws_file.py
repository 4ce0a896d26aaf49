"""Laws of whole files: round trips, one file for each content, damage, and any bytes whatever."""

from fractions import Fraction
from typing import Final

from clers.container.contents import MAGIC, compose, parse, tags_of
from clers.container.file import decode, encode, inspect, options_of
from clers.container.given import FILES, TO_DAMAGE, TO_WRITE, ToDamage, ToWrite
from clers.container.options import Accuracy, Exact, InBits, OnLattice, WithinError
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtByte, AtVertex
from clers.edgebreaker.encode import encode as encode_surface
from clers.geometry import exact
from clers.geometry.lattice import exponent_for_bits
from clers.geometry.mesh import Mesh
from clers.geometry.order import in_creation_order, into_order
from clers.geometry.positions import Positions


def written(given: ToWrite) -> bytes:
    """The file of a mesh of the domain, which can all be written."""
    match encode(given.mesh.surface, given.mesh.positions, given.options):
        case Accepted(data):
            return data
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def comes_back(given: ToWrite) -> Verdict:
    """The surface in the order of creation, and positions as good as asked."""
    encoding = encode_surface(given.mesh.surface)
    match decode(written(given)):
        case Accepted(Mesh(surface, None)):
            return every(
                same(in_creation_order(given.mesh.surface, encoding), surface),
                same(given.mesh.positions, None),
            )
        case Accepted(Mesh(surface, Positions() as found)):
            if given.mesh.positions is None:
                return Fails("no positions", repr(found), WHOLE)
            ordered = into_order(given.mesh.positions, encoding.vertex_order)
            return every(
                same(in_creation_order(given.mesh.surface, encoding), surface),
                _as_asked(given.options.accuracy, ordered, found),
            )
        case Rejected() as rejected:
            return Fails("a mesh", rejected.line(), rejected.where)
        case _:
            return Fails("a mesh", "something else", WHOLE)


def _as_asked(accuracy: Accuracy, given: Positions, found: Positions) -> Verdict:
    """Bit for bit, or within the error that the option allows."""
    match accuracy:
        case Exact():
            return same(exact.encode(given), exact.encode(found))
        case OnLattice(exponent):
            return _within(Fraction(2) ** (exponent - 1), given, found)
        case WithinError(bound):
            return _within(Fraction(bound), given, found)
        case InBits(bits):
            match exponent_for_bits(given, bits):
                case Accepted(exponent):
                    return _within(Fraction(2) ** (exponent - 1), given, found)
                case Rejected() as rejected:
                    return Fails("an exponent", rejected.line(), rejected.where)


def _within(bound: Fraction, given: Positions, found: Positions) -> Verdict:
    pairs = zip(given.coordinates, found.coordinates, strict=True)
    for i, (x, y) in enumerate(pairs):
        if abs(Fraction(x) - Fraction(y)) > bound:
            return Fails(f"within {bound} of {x}", repr(y), AtVertex(i // 3))
    return Holds()


def contents_again(given: ToWrite) -> Verdict:
    """compose (parse file) is file."""
    data = written(given)
    return same(Accepted(data), and_then(parse(data), compose))


def file_again(data: bytes) -> Verdict:
    """A file that is accepted is what encoding its mesh gives; nothing else happens."""
    match decode(data):
        case Accepted(mesh):
            options = options_of(data)
            again = and_then(options, lambda o: encode(mesh.surface, mesh.positions, o))
            return same(Accepted(data), again)
        case Rejected():
            return Holds()


def written_again(given: ToWrite) -> Verdict:
    """The same, of files that are known to be good."""
    data = written(given)
    found = decode(data)
    return file_again(data) if isinstance(found, Accepted) else Fails("a mesh", "none", WHOLE)


def damage_is_seen(given: ToDamage) -> Verdict:
    """One byte changed: refused, as unknown version at the ninth byte, as malformed elsewhere."""
    data = bytearray(written(given.file))
    place = given.place % len(data)
    data[place] ^= given.change
    match decode(bytes(data)):
        case Accepted(_):
            return Fails("a rejection", "accepted", AtByte(place))
        case Rejected(reason, _, _, _):
            if place == len(MAGIC):
                return same(Reason.UNKNOWN_VERSION, reason)
            return same(Fault.MALFORMED, reason.fault)


def truncation_is_seen(given: ToDamage) -> Verdict:
    """Refused as malformed without its end, and with a byte more."""
    data = written(given.file)
    shorter = decode(data[: given.place % len(data)])
    longer = decode(data + bytes((given.change,)))
    faults = [r.fault if isinstance(r, Rejected) else None for r in (shorter, longer)]
    return same([Fault.MALFORMED, Fault.MALFORMED], faults)


def inspected(given: ToWrite) -> Verdict:
    """The sections are those HEAD asks for, without gap or rest; the counts are the surface's."""
    data = written(given)
    match inspect(data):
        case Accepted(found):
            surface = given.mesh.surface
            ends = [len(MAGIC) + 1, *(s.stop + 4 for s in found.sections)]
            return every(
                same(1, found.version),
                same(tags_of(found.head), tuple(s.tag for s in found.sections)),
                same([end + 12 for end in ends[:-1]], [s.start for s in found.sections]),
                same(len(data), ends[-1]),
                same(
                    (surface.faces, surface.vertices),
                    (found.head.faces, found.head.vertices),
                ),
            )
        case Rejected() as rejected:
            return Fails("a description", rejected.line(), rejected.where)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "file-round-trip",
        Clause.FILE_ROUND_1,
        "decode (encode mesh) is the mesh in the order of creation, as exact as asked",
        TO_WRITE,
        comes_back,
    ),
    Law(
        "file-contents-once",
        Clause.FILE_ROUND_2,
        "compose (parse file) is the file",
        TO_WRITE,
        contents_again,
    ),
    Law(
        "file-written-again",
        Clause.FILE_ROUND_3,
        "encode (decode file), with the file's own options, is the file",
        TO_WRITE,
        written_again,
    ),
    Law(
        "file-any-bytes",
        Clause.FILE_PARSE_2,
        "any bytes are answered; those accepted are what encoding their mesh gives",
        FILES,
        file_again,
    ),
    Law(
        "file-damage-is-seen",
        Clause.FILE_DAMAGE_1,
        "a file with one byte changed is rejected, with the class stated",
        TO_DAMAGE,
        damage_is_seen,
    ),
    Law(
        "file-truncation-is-seen",
        Clause.FILE_DAMAGE_2,
        "a file cut short, or with a byte more, is malformed",
        TO_DAMAGE,
        truncation_is_seen,
    ),
    Law(
        "file-inspected",
        Clause.FILE_INSPECT_1,
        "inspection shows the sections that HEAD asks for and the surface's counts",
        TO_WRITE,
        inspected,
    ),
)
