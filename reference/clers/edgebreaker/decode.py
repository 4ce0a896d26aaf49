"""Decompression with every check: what a reader of untrusted streams calls."""

from clers.complexes.face_list import DEFAULT_LIMITS, Limits
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import WHOLE
from clers.edgebreaker.label import labelled
from clers.edgebreaker.reversi import gluing
from clers.edgebreaker.scanning import scanned
from clers.edgebreaker.stream import Stream
from clers.kernels.scan import Scan


def decode(stream: Stream, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The surface a stream describes, faces and vertices in the order of creation.

    Accepts exactly the streams that `encode` gives for some surface. Linear.
    Clauses: EB-DECODE-1, EB-DECODE-2, EB-GRAMMAR-1 … EB-GRAMMAR-9.
    """
    if len(stream.word) > limits.faces:
        detail = f"{len(stream.word)} symbols, the limit is {limits.faces} faces"
        return Rejected(Reason.TOO_MANY_FACES, Clause.EB_DECODE_2, WHOLE, detail)
    return and_then(scanned(stream), _glue_and_label)


def _glue_and_label(scan: Scan) -> Accepted[Surface] | Rejected:
    return and_then(gluing(scan), lambda opposite: labelled(scan, opposite))
