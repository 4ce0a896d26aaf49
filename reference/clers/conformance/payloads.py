"""What operations take and give, as they stand in messages: frozen records with a schema each."""

from typing import Annotated, Final, Literal

from msgspec import UNSET, Meta, Struct, UnsetType

SAFE: Final = 1 << 53
"""Integers up to this, and down to its negative, are JSON numbers. Clause: ORCL-VALUE-1."""

Number = (
    Annotated[int, Meta(ge=-(1 << 53), le=1 << 53)]
    | Annotated[str, Meta(pattern="^-?[1-9][0-9]{15,999}$")]
)
"""An integer of any size. Clause: ORCL-VALUE-1."""

Small = Annotated[int, Meta(ge=-(1 << 53), le=1 << 53)]
"""An integer that is never a string. Clause: ORCL-VALUE-1."""

Count = Annotated[int, Meta(ge=0, le=1 << 53)]
"""An integer that counts something."""

Hex = Annotated[str, Meta(pattern="^(?:[0-9a-f]{2})*$")]
"""Bytes. Clause: ORCL-VALUE-2."""

Triple = tuple[Number, Number, Number]


class Payload(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What all inputs and results have in common: no key but the ones named. ORCL-LINE-3."""


class BitString(Payload, frozen=True, kw_only=True):
    """Bits, packed into bytes. Clause: ORCL-VALUE-2."""

    hex: Hex
    length: Count


class Places(Payload, frozen=True, kw_only=True):
    """Where vertices are: three coordinates each, flat. Clause: ORCL-VALUE-3."""

    precision: Literal["f32", "f64"]
    coordinates: tuple[float, ...]


class Faces(Payload, frozen=True, kw_only=True):
    """The connectivity of a mesh. Clauses: ORCL-OP-2, ORCL-OP-5."""

    faces: tuple[Triple, ...]
    vertices: Number


class MeshForm(Faces, frozen=True, kw_only=True):
    """A mesh, with positions or without. Clauses: ORCL-OP-7, ORCL-OP-8."""

    positions: Places | UnsetType = UNSET


Error = tuple[
    Annotated[float, Meta(ge=0)], Annotated[float, Meta(ge=0)], Annotated[float, Meta(ge=0)]
]
"""The most by which a coordinate may move along each axis. Clause: ORCL-CODEC-1."""


class ThroughForm(MeshForm, frozen=True, kw_only=True):
    """A mesh to send through a codec. Clauses: ORCL-OP-8, ORCL-CODEC-1."""

    error: Error | UnsetType = UNSET

    @staticmethod
    def of(mesh: MeshForm, error: Error | UnsetType = UNSET) -> "ThroughForm":
        """The mesh, to be sent through a codec that may move coordinates so much."""
        return ThroughForm(
            faces=mesh.faces, vertices=mesh.vertices, positions=mesh.positions, error=error
        )


class ComponentForm(Payload, frozen=True, kw_only=True):
    """The counts of a component. Clause: ORCL-OP-2."""

    faces: int
    vertices: int
    edges: int
    boundary_edges: int
    curves: int
    genus: int
    euler: int


class Classified(Payload, frozen=True, kw_only=True):
    """A surface in numbers. Clause: ORCL-OP-2."""

    components: tuple[ComponentForm, ...]


class ScriptForm(Payload, frozen=True, kw_only=True):
    """A script of operators. Clause: ORCL-OP-3."""

    script: str


class StageForm(Payload, frozen=True, kw_only=True):
    """What is there after an operator. Clause: ORCL-OP-3."""

    operator: str
    numbers: dict[str, int]
    idle: str = ""


class Stages(Payload, frozen=True, kw_only=True):
    """The stages of a script. Clause: ORCL-OP-3."""

    stages: tuple[StageForm, ...]


class StaticForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="static"):
    """The same table for every symbol. Clause: ORCL-OP-4."""

    frequencies: tuple[Number, ...]


class UniformForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="uniform"):
    """Symbols that are all alike. Clause: ORCL-OP-4."""

    size: Number


class AdaptiveForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="adaptive"):
    """A table that learns. Clause: ORCL-OP-4."""

    frequencies: tuple[Number, ...]
    increment: Number
    limit: Number


ModelForm = StaticForm | UniformForm | AdaptiveForm
CoderName = Literal["arithmetic", "range", "rans"]


class ToCode(Payload, frozen=True, kw_only=True):
    """A message to encode. Clause: ORCL-OP-4."""

    coder: CoderName
    model: ModelForm
    symbols: tuple[Number, ...]


class Coded(Payload, frozen=True, kw_only=True):
    """A message to decode. Clause: ORCL-OP-4."""

    coder: CoderName
    model: ModelForm
    bits: BitString
    count: Count


class Symbols(Payload, frozen=True, kw_only=True):
    """A message. Clause: ORCL-OP-4."""

    symbols: tuple[Number, ...]


class HandleForm(Payload, frozen=True, kw_only=True):
    """A record of the handle data. Clauses: ORCL-OP-5, EB-HANDLE-1."""

    kind: Literal["handle", "boundary"]
    s: Number
    at: Number
    side: Literal["right", "left"]


class StreamForm(Payload, frozen=True, kw_only=True):
    """A word and its handle data. Clause: ORCL-OP-5."""

    word: str
    handles: tuple[HandleForm, ...]
    components_with_boundary: Number


class WordForm(StreamForm, frozen=True, kw_only=True):
    """A stream, and the mesh's vertex that is decoded as vertex k. Clause: ORCL-OP-5."""

    vertex_order: tuple[int, ...]


class ToWord(StreamForm, frozen=True, kw_only=True):
    """A word to turn into bits. Clause: ORCL-OP-6."""

    code: str


class ClosingForm(Payload, frozen=True, kw_only=True):
    """A record of the handle data as it is seen from the end. Clauses: ORCL-OP-6, CODE-HAND-1."""

    passed: Number
    kind: Literal["handle", "boundary"]
    side: Literal["right", "left"]
    between: Number


class FromWord(Payload, frozen=True, kw_only=True):
    """Bits to turn into a word. Clause: ORCL-OP-6."""

    code: str
    bits: BitString
    symbols: Count
    components_with_boundary: Count
    closings: tuple[ClosingForm, ...] = ()


class JustWord(Payload, frozen=True, kw_only=True):
    """A word. Clause: ORCL-OP-6."""

    word: str


class ExactForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="exact"):
    """Keep every bit. Clause: ORCL-OP-7."""


class LatticeForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="lattice"):
    """Move to the lattice of step 2^exponent. Clause: ORCL-OP-7."""

    exponent: Small


class BitsForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="bits"):
    """So many bits an axis. Clause: ORCL-OP-7."""

    bits: Small


class ErrorForm(Payload, frozen=True, kw_only=True, tag_field="kind", tag="error"):
    """Move no coordinate further than this. Clause: ORCL-OP-7."""

    bound: float


AccuracyForm = ExactForm | LatticeForm | BitsForm | ErrorForm


class ToFile(MeshForm, frozen=True, kw_only=True):
    """A mesh to write into a file. Clause: ORCL-OP-7."""

    code: str
    accuracy: AccuracyForm


class FileForm(Payload, frozen=True, kw_only=True):
    """The bytes of a file. Clause: ORCL-OP-7."""

    hex: Hex
