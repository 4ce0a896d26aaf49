"""What every connectivity codec must satisfy; the codec is the laws' subject."""

from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, AtFace
from clers.edgebreaker.codec import FOLD, Codec
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import STREAMS, renumbered
from clers.edgebreaker.stream import Stream


def laws_of(codec: Codec) -> tuple[AnyLaw, ...]:
    """What every connectivity codec must satisfy, this one among them."""

    def comes_back(surface: Surface) -> Verdict:
        encoding = codec.encode(surface)
        match codec.decode(encoding.stream):
            case Accepted(decoded):
                expected = renumbered(surface, encoding)
                for c, (want, got) in enumerate(zip(expected, decoded.vertex, strict=False)):
                    if want != got:
                        return Fails(str(want), str(got), AtFace(c // 3))
                return same(len(expected), len(decoded.vertex))
            case Rejected() as rejected:
                return Fails("a surface", rejected.line(), rejected.where)

    def encodes_again(surface: Surface) -> Verdict:
        stream = codec.encode(surface).stream
        match codec.decode(stream):
            case Accepted(decoded):
                again = codec.encode(decoded)
                return every(
                    same(stream, again.stream),
                    same(tuple(range(decoded.vertices)), again.vertex_order),
                    same(tuple(range(0, 3 * decoded.faces, 3)), again.tip_order),
                )
            case Rejected() as rejected:
                return Fails("a surface", rejected.line(), rejected.where)

    def accepts_the_right_ones(stream: Stream) -> Verdict:
        expected, got = FOLD.decode(stream), codec.decode(stream)
        match expected, got:
            case Accepted(want), Accepted(have):
                return every(same(want, have), same(stream, encode(have).stream))
            case Rejected() as want, Rejected() as have:
                return same(want.fault, have.fault)
            case _:
                return Fails(_outcome(expected), _outcome(got), WHOLE)

    domain = SMALL_SURFACES if codec is FOLD else SURFACES
    return (
        Law(
            f"round-trip-{codec.name}",
            Clause.EB_DECODE_1,
            "decode (encode s) is s, renumbered by the orders of creation",
            domain,
            comes_back,
        ),
        Law(
            f"encode-again-{codec.name}",
            Clause.EB_DECODE_1,
            "encode (decode (encode s)) is encode s, and the orders are the identity",
            domain,
            encodes_again,
        ),
        Law(
            f"valid-streams-{codec.name}",
            Clause.EB_DECODE_2,
            "a stream is accepted exactly if it is the stream of a surface, and as that surface",
            STREAMS,
            accepts_the_right_ones,
        ),
    )


def _outcome(result: Accepted[Surface] | Rejected) -> str:
    return "accepted" if isinstance(result, Accepted) else result.line()
