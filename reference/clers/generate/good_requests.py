"""Strategies for requests that every right implementation answers with a result."""

from typing import Final

from hypothesis import strategies as st

from clers.codes import registry
from clers.codes.closings import closings
from clers.codes.registry import CodeName
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.samples import SAMPLES
from clers.conformance.served.forms import bits_form, faces_form, handle_forms, mesh_form
from clers.container import file
from clers.container.options import Exact, InBits, Options
from clers.conventions.result import Rejected
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.generate.meshes import meshes
from clers.generate.surfaces import scripts, surfaces
from clers.geometry.mesh import Mesh
from clers.operators.script_text import write

FACES: Final = 40
SURFACES: Final = surfaces(max_faces=FACES)
STREAMS: Final = SURFACES.map(lambda surface: encode(surface).stream)
NAMES: Final = st.sampled_from(
    (CodeName.PLAIN, CodeName.GOLDEN, CodeName.HUFFMAN, CodeName.ADAPTIVE_3, CodeName.BEST)
)


def stream_form(stream: Stream) -> form.StreamForm:
    """A stream as a message has it."""
    return form.StreamForm(
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=stream.components_with_boundary,
    )


def _to_bits(stream: Stream, code: CodeName) -> Operation:
    given = stream_form(stream)
    return message.CodeEncode(
        id=0,
        input=form.ToWord(
            code=code,
            word=given.word,
            handles=given.handles,
            components_with_boundary=given.components_with_boundary,
        ),
    )


def _from_bits(stream: Stream, code: CodeName) -> Operation:
    bits, seen = registry.encode(code, stream), closings(stream)
    if isinstance(bits, Rejected) or isinstance(seen, Rejected):
        raise AssertionError("a surface's own word has no bits")
    return message.CodeDecode(
        id=0,
        input=form.FromWord(
            code=code,
            bits=bits_form(bits.value),
            symbols=len(stream.word),
            components_with_boundary=stream.components_with_boundary,
            closings=tuple(
                form.ClosingForm(
                    passed=c.passed,
                    kind="boundary" if c.kind == "boundary" else "handle",
                    side="left" if c.side == "left" else "right",
                    between=c.between,
                )
                for c in seen.value
            ),
        ),
    )


def _to_file(mesh: Mesh, bits: int) -> Operation:
    given = mesh_form(mesh)
    return message.MeshEncode(
        id=0,
        input=form.ToFile(
            faces=given.faces,
            vertices=given.vertices,
            positions=given.positions,
            code="golden",
            accuracy=form.BitsForm(bits=bits) if bits else form.ExactForm(),
        ),
    )


def _from_file(mesh: Mesh, bits: int) -> Operation:
    options = Options(CodeName.GOLDEN, InBits(bits) if bits else Exact())
    data = file.encode(mesh.surface, mesh.positions, options)
    if isinstance(data, Rejected):
        return SAMPLES["mesh.decode"]
    return message.MeshDecode(id=0, input=form.FileForm(hex=data.value.hex()))


@st.composite
def _coding(draw: st.DrawFn) -> Operation:
    """A few symbols under a model of a few, none of which is impossible."""
    table = draw(st.lists(st.integers(1, 9), min_size=1, max_size=5))
    models: tuple[form.ModelForm, ...] = (
        form.StaticForm(frequencies=tuple(table)),
        form.UniformForm(size=len(table)),
        form.AdaptiveForm(frequencies=tuple(table), increment=3, limit=64),
    )
    model = draw(st.sampled_from(models))
    symbols = draw(st.lists(st.integers(0, len(table) - 1), max_size=40))
    coder: form.CoderName = draw(st.sampled_from(("arithmetic", "range", "rans")))
    return message.ArithmeticEncode(
        id=0, input=form.ToCode(coder=coder, model=model, symbols=tuple(symbols))
    )


MESHES: Final = st.one_of(meshes(SURFACES), SURFACES.map(Mesh))
LATTICES: Final = st.sampled_from((0, 0, 9))

GOOD: Final[st.SearchStrategy[Operation]] = st.one_of(
    st.sampled_from(tuple(SAMPLES.values())),
    SURFACES.map(lambda s: message.Classify(id=0, input=faces_form(s))),
    SURFACES.map(lambda s: message.WordEncode(id=0, input=faces_form(s), trace="full")),
    STREAMS.map(lambda s: message.WordDecode(id=0, input=stream_form(s), trace="full")),
    scripts(max_faces=FACES).map(
        lambda s: message.Apply(id=0, input=form.ScriptForm(script=write(s)))
    ),
    _coding(),
    st.builds(_to_bits, STREAMS, NAMES),
    st.builds(_from_bits, STREAMS, NAMES),
    st.builds(_to_file, MESHES, LATTICES),
    st.builds(_from_file, MESHES, LATTICES),
    MESHES.map(lambda m: message.Roundtrip(id=0, input=form.ThroughForm.of(mesh_form(m)))),
)
"""Requests of every operation. A rare mesh has positions that a lattice cannot hold."""
