"""The laws of the best code: the shortest of its candidates, and every guarantee at once."""

from typing import Final

from clers.codes import best
from clers.codes.closings import closings
from clers.codes.code import Shape
from clers.codes.implied import implied
from clers.codes.registry import CODES, CodeName, encode
from clers.complexes.given import SMALL_SURFACES, SPHERES, SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface


def shortest_of_all_runs(surface: Surface) -> Verdict:
    """The bits are those of the first of the shortest, every candidate run."""
    stream = encode_surface(surface).stream
    seen = closings(stream)
    if isinstance(seen, Rejected):
        return Fails("closings", seen.line(), WHOLE)
    shape = Shape(implied(stream.components_with_boundary), seen.value)
    symbols = stream.word[len(shape.head) :]
    runs = [
        candidate.selector + found.value.digits()
        for candidate in best.CANDIDATES
        for found in (candidate.code.encode(symbols, shape),)
        if isinstance(found, Accepted)
    ]
    match encode(CodeName.BEST, stream):
        case Accepted(bits):
            return same(min(runs, key=len), bits.digits())
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), WHOLE)


def every_guarantee(surface: Surface) -> Verdict:
    """At most three bits more than any code promises for such components."""
    parts = components(surface)
    promises = [code.guarantee.bits(parts) for code in CODES.values()]
    most = min(bound for bound in promises if bound is not None)
    match encode(CodeName.BEST, encode_surface(surface).stream):
        case Accepted(bits):
            return at_most(most + 3, bits.length, "bits")
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), WHOLE)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "best-is-shortest",
        Clause.CODE_BEST_1,
        "the bits are those of the first of the shortest of the five codes",
        SMALL_SURFACES,
        shortest_of_all_runs,
    ),
    *(
        Law(
            f"best-keeps-guarantees-on-{domain.name}",
            Clause.CODE_BEST_3,
            "at most three bits more than any code promises",
            domain,
            every_guarantee,
        )
        for domain in (SPHERES, SURFACES)
    ),
)
