"""A codec of somebody else, as the oracle sees it: a mesh goes in, and a mesh comes out."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from clers.conformance import payloads as form
from clers.conformance.messages import Failure, Lacking, Rejection
from clers.conventions.reason import Fault

Precision = Literal["f32", "f64"]

Answer = form.MeshForm | Rejection | Lacking | Failure
"""The mesh that came back; or the codec refuses it, or cannot keep within the error, or fails."""


@dataclass(frozen=True, slots=True)
class Codec:
    """A name, a version, a language, the way there and back; how it is set up in words, and what

    precisions it keeps. Clauses: ORCL-CODEC-9, ORCL-CODEC-16.
    """

    name: str
    version: str
    language: str
    through: Callable[[form.ThroughForm], Answer]
    policy: Mapping[str, str] = field(default_factory=dict)
    precisions: tuple[Precision, ...] = ("f32", "f64")


@dataclass(frozen=True, slots=True)
class Missing:
    """Why a codec cannot be served, in one line. Clause: ORCL-CODEC-10."""

    why: str


def refused(detail: str, reason: str = "") -> Rejection:
    """The codec does not take this mesh. Clause: ORCL-CODEC-2."""
    return Rejection(Fault.INVALID, reason, detail=detail)
