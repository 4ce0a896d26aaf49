"""A request of each operation that every implementation of it answers, and some that none does."""

from collections.abc import Mapping
from typing import Final

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation

FACES: Final[tuple[form.Triple, ...]] = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
"""A tetrahedron, as the word CRE describes it."""

_SURFACE: Final = form.Faces(faces=FACES, vertices=4)
_MESH: Final = form.MeshForm(
    faces=FACES,
    vertices=4,
    positions=form.Places(
        precision="f32", coordinates=(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    ),
)
_MODEL: Final = form.StaticForm(frequencies=(1, 2, 1))
_FILE: Final = (
    "89434c4552530d0a0148454144070000001643c97d010104040003003b6588a1574f524402000000d8bfbece06bc"
    "de4a54d5"
)
_NONE: Final = form.BitString(hex="", length=0)

SAMPLES: Final[Mapping[str, Operation]] = {
    "echo": message.Echo(id=0, input={}),
    "surface.classify": message.Classify(id=0, input=_SURFACE),
    "operator.apply": message.Apply(id=0, input=form.ScriptForm(script="split-face 0")),
    "arithmetic.encode": message.ArithmeticEncode(
        id=0, input=form.ToCode(coder="arithmetic", model=_MODEL, symbols=(1, 0, 2))
    ),
    "arithmetic.decode": message.ArithmeticDecode(
        id=0,
        input=form.Coded(
            coder="arithmetic", model=_MODEL, bits=form.BitString(hex="5a", length=7), count=3
        ),
    ),
    "word.encode": message.WordEncode(id=0, input=_SURFACE, trace="full"),
    "word.decode": message.WordDecode(
        id=0,
        input=form.StreamForm(word="CRE", handles=(), components_with_boundary=0),
        trace="full",
    ),
    "code.encode": message.CodeEncode(
        id=0,
        input=form.ToWord(code="plain", word="CRE", handles=(), components_with_boundary=0),
    ),
    "code.decode": message.CodeDecode(
        id=0,
        input=form.FromWord(
            code="plain",
            bits=form.BitString(hex="bc", length=6),
            symbols=3,
            components_with_boundary=0,
        ),
    ),
    "mesh.encode": message.MeshEncode(
        id=0,
        input=form.ToFile(faces=FACES, vertices=4, code="plain", accuracy=form.ExactForm()),
    ),
    "mesh.decode": message.MeshDecode(id=0, input=form.FileForm(hex=_FILE)),
    "codec.roundtrip": message.Roundtrip(id=0, input=form.ThroughForm.of(_MESH)),
}
"""Clause: ORCL-DOCTOR-2."""

GARBAGE: Final[Mapping[str, tuple[Operation, ...]]] = {
    "surface.classify": (
        message.Classify(id=0, input=form.Faces(faces=((0, 1, 1),), vertices=2)),
        message.Classify(id=0, input=form.Faces(faces=((0, 1, "9007199254740993"),), vertices=3)),
    ),
    "operator.apply": (message.Apply(id=0, input=form.ScriptForm(script="no-such-thing 1")),),
    "arithmetic.decode": (
        message.ArithmeticDecode(
            id=0, input=form.Coded(coder="arithmetic", model=_MODEL, bits=_NONE, count=1)
        ),
    ),
    "word.encode": (message.WordEncode(id=0, input=form.Faces(faces=((0, 1, 1),), vertices=2)),),
    "word.decode": (
        message.WordDecode(
            id=0, input=form.StreamForm(word="XYZ", handles=(), components_with_boundary=0)
        ),
        message.WordDecode(
            id=0, input=form.StreamForm(word="", handles=(), components_with_boundary=0)
        ),
    ),
    "code.decode": (
        message.CodeDecode(
            id=0,
            input=form.FromWord(code="plain", bits=_NONE, symbols=3, components_with_boundary=0),
        ),
    ),
    "mesh.decode": (
        message.MeshDecode(id=0, input=form.FileForm(hex="")),
        message.MeshDecode(id=0, input=form.FileForm(hex="00ff" * 8)),
    ),
    "codec.roundtrip": (
        message.Roundtrip(id=0, input=form.ThroughForm(faces=((0, 1, 5),), vertices=3)),
    ),
}
"""Inputs of the right form that are no mesh, no word and no file. Clause: ORCL-DOCTOR-2."""
