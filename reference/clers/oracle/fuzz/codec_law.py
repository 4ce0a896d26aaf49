"""The laws of every codec, with an adapter's word operations as the codec. Clause: ORCL-FUZZ-7."""

from typing import Final, assert_never

from clers.complexes.row import listed
from clers.complexes.surface import Corner, Surface, Vertex
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.needs import needs
from clers.conformance.messages import Operation, Rejection
from clers.conformance.outcome import Answered, Declined, Outcome
from clers.conformance.served.forms import faces_form, stream_of, surface_of
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.conventions.where import in_words
from clers.edgebreaker.codec import Codec
from clers.edgebreaker.laws_codec import laws_of
from clers.edgebreaker.stream import Encoding, Stream
from clers.oracle.fuzz.behind import stream_form
from clers.oracle.fuzz.checks import Asker, Check, Tried
from clers.oracle.fuzz.question import question
from clers.oracle.fuzz.relations import failed, held

CODEC: Final = "codec"
NAME: Final = "adapter"


class _NoAnswer(Exception):
    """The adapter gave no answer that a law could judge. Never seen outside."""

    def __init__(self, outcome: Outcome) -> None:
        super().__init__()
        self.outcome = outcome


def codec_of(of: Asker) -> Codec:
    """The adapter as a codec; what it does not answer ends the law that asked."""

    def encode(surface: Surface) -> Encoding:
        outcome = of.ask(of.request(message.WordEncode(id=0, input=faces_form(surface))))
        if not isinstance(outcome, Answered) or not isinstance(outcome.result, form.WordForm):
            raise _NoAnswer(outcome)
        stream = stream_of(outcome.result)
        order = tuple(map(Vertex, outcome.result.vertex_order))
        return Encoding(stream, listed(order), listed(_tips(surface, order, decode(stream))))

    def decode(stream: Stream) -> Accepted[Surface] | Rejected:
        outcome = of.ask(of.request(message.WordDecode(id=0, input=stream_form(stream))))
        match outcome:
            case Answered(form.Faces() as faces, _):
                return surface_of(faces)
            case Declined(rejection, _):
                return _rejected(rejection)
            case _:
                raise _NoAnswer(outcome)

    return Codec(NAME, encode, decode)


def _tips(
    surface: Surface, order: tuple[Vertex, ...], decoded: Accepted[Surface] | Rejected
) -> tuple[Corner, ...]:
    """The corner that begins each decoded face; corner 0 where there is no such face.

    The protocol does not say it, but the faces that come back do. Clause: EB-ORDER-3.
    """
    v = surface.vertex
    turns = ((c, c - c % 3 + (c + 1) % 3, c - c % 3 + (c + 2) % 3) for c in range(len(v)))
    corner = {(v[a], v[b], v[c]): Corner(a) for a, b, c in turns}
    if isinstance(decoded, Rejected):
        return ()
    names = dict(enumerate(order))
    return tuple(
        corner.get((names.get(a, a), names.get(b, b), names.get(c, c)), Corner(0))
        for a, b, c in decoded.value.triangles()
    )


def _rejected(rejection: Rejection) -> Rejected:
    """A rejection by a reason of its class: the class is all that the laws compare."""
    of_class = [reason for reason in Reason if reason.fault is rejection.fault]
    named = next((reason for reason in of_class if reason == rejection.reason), of_class[0])
    return Rejected(named, Clause.ORCL_FUZZ_7, detail=rejection.detail)


def codec_law(of: Asker) -> Check:
    """The laws of chapter 5, on the surface or the stream of a request. Clause: ORCL-FUZZ-7."""
    laws = laws_of(codec_of(of))

    def check(operation: Operation) -> Tried | None:
        case = question(operation)
        if case is None or needs(case, of.said) is not None:
            return None
        match operation:
            case message.WordEncode(input=faces):
                built = surface_of(faces)
                if isinstance(built, Rejected):
                    return None
                example: Surface | Stream = built.value
                judging = [law for law in laws if not law.name.startswith("valid-streams")]
            case message.WordDecode(input=given):
                example = stream_of(given)
                judging = [law for law in laws if law.name.startswith("valid-streams")]
            case _:
                return None
        request = of.request(operation)
        outcome = of.ask(request)
        try:
            verdicts = [(law.name.removesuffix(f"-{NAME}"), law.check(example)) for law in judging]
        except _NoAnswer:
            return None
        for name, verdict in verdicts:
            match verdict:
                case Fails(expected, got, where):
                    why = f"{name} {in_words(where)}: expected {expected}, got {got}"
                    judged = failed(case, CODEC, f"{name} {type(where).__name__}", why)
                    return Tried(case, request, outcome, judged, CODEC)
                case Holds():
                    continue
                case _:
                    assert_never(verdict)
        return Tried(case, request, outcome, held(case), CODEC)

    return check
