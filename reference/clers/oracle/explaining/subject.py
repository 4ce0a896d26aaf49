"""The surface that a case is about, or that an answer describes. Clause: ORCL-EXPLAIN-5."""

from dataclasses import dataclass

from clers.codes.closings import records
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.results import Result
from clers.conformance.served.codes import closings_of
from clers.conformance.served.forms import mesh_of, stream_of, surface_of
from clers.container import file
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.outline import outline
from clers.edgebreaker.stream import Encoding, Stream
from clers.geometry.mesh import Mesh
from clers.operators.families import AnyScript, read, stages


@dataclass(frozen=True, slots=True)
class Subject:
    """A mesh, and the walk over it. Clause: ORCL-EXPLAIN-5."""

    mesh: Mesh
    encoding: Encoding

    def face_of_symbol(self, symbol: int) -> int | None:
        """The face of the mesh that a symbol of the word stands for. Clause: EB-ORDER-1."""
        outlined = outline(self.encoding.stream)
        if isinstance(outlined, Rejected) or not 0 <= symbol < len(outlined.value.face):
            return None
        return self.encoding.tip_order[outlined.value.face[symbol]] // 3

    def step_of(self, face: int) -> int:
        """After how many faces this one is visited; all of them if it is not there."""
        tips = self.encoding.tip_order
        return next((k for k, tip in enumerate(tips, 1) if tip // 3 == face), len(tips))


def subject_of(
    request: Operation, result: Result | None, stage: int | None = None
) -> Accepted[Subject] | Rejected:
    """The surface of a request whose result is known, or None for it; of a script at a stage.

    Rejects with `not-drawable` what is about no surface, and with the reference's own reason what
    it does not accept. Clause: ORCL-EXPLAIN-5.
    """
    match request, result:
        case ((message.Classify(input=given) | message.WordEncode(input=given)), _):
            return and_then(surface_of(given), lambda s: _walked(Mesh(s)))
        case ((message.MeshEncode(input=through) | message.Roundtrip(input=through)), _):
            return and_then(mesh_of(through), _walked)
        case message.WordDecode(input=stream), _:
            return _of_stream(stream_of(stream))
        case message.CodeEncode(input=word), _:
            return _of_stream(stream_of(word))
        case message.CodeDecode(input=bits), form.JustWord(word=letters):
            return _of_word(bits, letters)
        case message.MeshDecode(input=data), _:
            return and_then(file.decode(bytes.fromhex(data.hex)), _walked)
        case message.Apply(input=script), _:
            return and_then(read(script.script), lambda s: _of_script(s, stage))
        case _:
            return _none("it is about no surface")


def got_by(request: Operation, result: Result) -> Accepted[Subject] | Rejected:
    """The surface that an answer describes. Clause: ORCL-EXPLAIN-5."""
    match request, result:
        case message.CodeDecode(input=bits), form.JustWord(word=letters):
            return _of_word(bits, letters)
        case _, form.WordForm():
            return _of_stream(stream_of(result))
        case _, form.FileForm(hex=data):
            return and_then(file.decode(bytes.fromhex(data)), _walked)
        case _, form.MeshForm():
            return and_then(mesh_of(result), _walked)
        case _, form.Faces():
            return and_then(surface_of(result), lambda s: _walked(Mesh(s)))
        case _:
            return _none("the answer describes no surface")


def _walked(mesh: Mesh) -> Accepted[Subject] | Rejected:
    return Accepted(Subject(mesh, encode(mesh.surface)))


def _of_stream(stream: Stream) -> Accepted[Subject] | Rejected:
    return and_then(decode(stream), lambda s: _walked(Mesh(s)))


def _of_word(given: form.FromWord, word: str) -> Accepted[Subject] | Rejected:
    """A word with what is known of its handle data from the end. Clause: CODE-HAND-3."""
    if not set(word) <= set("CLERS"):
        return _none("the answer is no word")
    known = records(word, closings_of(given))
    return and_then(
        known, lambda found: _of_stream(Stream(word, found, given.components_with_boundary))
    )


def _of_script(script: AnyScript, stage: int | None) -> Accepted[Subject] | Rejected:
    """Of a growing surface the last stage, or the one asked for."""
    done, _ = stages(script)
    at = len(done) - 1 if stage is None else min(stage, len(done) - 1)
    shape = done[at].shape if done else None
    if not isinstance(shape, FaceList):
        return _none("the script grows no surface; clers operators draws it")
    return and_then(_surface(shape), lambda s: _walked(Mesh(s)))


def _surface(faces: FaceList) -> Accepted[Surface] | Rejected:
    return surface(faces)


def _none(detail: str) -> Rejected:
    return Rejected(Reason.NOT_DRAWABLE, Clause.ORCL_EXPLAIN_5, detail=detail)
