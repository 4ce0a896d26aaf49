"""What one mesh costs: in each code, with each peer, and by each measure."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from clers.codes.registry import CodeName
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.container.contents import Contents, compose
from clers.container.file import inspect
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Encoding
from clers.measure.bits.entropies import ORDERS, limit, order_entropy, valence_entropy
from clers.measure.peers.draco import DRACO
from clers.measure.peers.index_list import INDEX_LISTS

PEERS: Final = (*DRACO, *INDEX_LISTS)
BEST: Final = str(CodeName.BEST)
"""The code that is compared with Draco. Clause: TOOL-BITS-7."""


class Kind(StrEnum):
    """Whose number it is."""

    CODE = "code"
    PEER = "peer"
    MEASURE = "measure"


@dataclass(frozen=True, slots=True)
class Cost:
    """A name and its bits for all of a mesh's connectivity; or none, and why."""

    name: str
    kind: Kind
    bits: float | None
    bits_per_vertex: float | None
    bits_per_triangle: float | None
    why_not: str


@dataclass(frozen=True, slots=True)
class Measured:
    """A mesh, its counts, its costs, and `best` divided by Draco's lesser. Clause: TOOL-BITS-8."""

    mesh: str
    vertices: int
    faces: int
    components: int
    genus: int
    curves: int
    costs: tuple[Cost, ...]
    ratio: float | None

    def bits(self, name: str) -> float | None:
        """The bits under a name, if there are any."""
        return next((cost.bits for cost in self.costs if cost.name == name), None)


NAMES: Final = (
    *((str(code), Kind.CODE) for code in CodeName),
    *((peer.name, Kind.PEER) for peer in PEERS),
    ("valence-entropy", Kind.MEASURE),
    *((f"order-{k}", Kind.MEASURE) for k in ORDERS),
    ("limit", Kind.MEASURE),
)
"""All that is compared, in the order of the columns."""


def code_bytes(surface: Surface, encoding: Encoding, code: CodeName) -> Accepted[int] | Rejected:
    """The payloads of the file without positions. Clause: TOOL-BITS-1."""
    contents = Contents(code, surface.faces, surface.vertices, encoding.stream, None)
    described = and_then(compose(contents), inspect)
    return and_then(
        described, lambda found: Accepted(sum(s.stop - s.start for s in found.sections))
    )


def measured(mesh: str, surface: Surface, step: Callable[[str], None]) -> Measured:
    """Code a surface in every way there is; `step` is told the name of each.

    Clauses: TOOL-BITS-1, TOOL-BITS-2, TOOL-BITS-4 … TOOL-BITS-7.
    """
    parts = components(surface)
    costs = tuple(_costs(surface, step))
    return Measured(
        mesh,
        surface.vertices,
        surface.faces,
        len(parts),
        sum(part.genus for part in parts),
        sum(part.curves for part in parts),
        costs,
        _ratio({cost.name: cost.bits for cost in costs}),
    )


def _costs(surface: Surface, step: Callable[[str], None]) -> Iterator[Cost]:
    encoding = encode(surface)

    def cost(name: str, kind: Kind, bits: float) -> Cost:
        return Cost(name, kind, bits, bits / surface.vertices, bits / surface.faces, "")

    def answer(name: str, kind: Kind, weight: Accepted[int] | Rejected) -> Cost:
        match weight:
            case Accepted(count):
                return cost(name, kind, 8 * count)
            case Rejected() as rejected:
                return Cost(name, kind, None, None, None, rejected.line())

    for code in CodeName:
        step(code)
        yield answer(code, Kind.CODE, code_bytes(surface, encoding, code))
    for peer in PEERS:
        step(peer.name)
        yield answer(peer.name, Kind.PEER, peer.bytes_for(surface))
    yield cost("valence-entropy", Kind.MEASURE, valence_entropy(surface))
    for order in ORDERS:
        bits = order_entropy(encoding.stream.word, order)
        yield cost(f"order-{order}", Kind.MEASURE, bits)
    yield cost("limit", Kind.MEASURE, limit(surface))


def least_of_draco(bits: dict[str, float | None]) -> float | None:
    """The lesser of Draco's two numbers. Clause: TOOL-BITS-7."""
    found = [bits.get(peer.name) for peer in DRACO]
    return min((b for b in found if b is not None), default=None)


def _ratio(bits: dict[str, float | None]) -> float | None:
    """Clause: TOOL-BITS-7."""
    ours, theirs = bits.get(BEST), least_of_draco(bits)
    return None if ours is None or theirs is None else ours / theirs
