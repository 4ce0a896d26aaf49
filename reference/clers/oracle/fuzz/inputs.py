"""What is drawn for an operation, within an adapter's capabilities. Clause: ORCL-FUZZ-1.

Good inputs come from meshes, so that they shrink as their operators' scripts do; bad ones are good
ones with one change.
"""

from dataclasses import dataclass
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.codes import registry
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Caps, Operation
from clers.conformance.numbers import to_wire
from clers.container.options import Options
from clers.edgebreaker.encode import encode
from clers.generate.face_lists import BREAKAGES
from clers.generate.files import ACCURACIES
from clers.generate.meshes import positions_for
from clers.generate.solids import solids
from clers.generate.surfaces import spheres, surfaces
from clers.generate.tamper import TAMPERINGS, damaged
from clers.geometry.mesh import Mesh
from clers.oracle.fuzz.arithmetic_inputs import arithmetic
from clers.oracle.fuzz.behind import (
    Net,
    file_of,
    from_word,
    net_of,
    places_form,
    stream_form,
    to_word,
)
from clers.oracle.fuzz.changes import STREAM_CHANGES, bits_changed
from clers.oracle.fuzz.script_inputs import scripts
from clers.oracle.fuzz.weighted import weighted

NUMBERS: Final = st.integers(0, 9999)
LARGEST: Final = 200
"""The most faces that are drawn."""

Drawn = st.SearchStrategy[Operation]


@dataclass(frozen=True, slots=True)
class Space:
    """The surfaces that an adapter bears, as ranges. Clause: ORCL-FUZZ-2."""

    faces: int
    genus: int
    curves: int
    components: int


def space_of(caps: Caps) -> Space:
    """The ranges of the surfaces that are drawn. Clause: ORCL-FUZZ-2."""
    return Space(
        faces=min(LARGEST, caps.max_faces),
        genus=3 if caps.handles else 0,
        curves={"none": 0, "one": 1, "many": 4}[caps.boundaries],
        components=3 if caps.components else 1,
    )


def drawn_surfaces(space: Space) -> st.SearchStrategy[Surface]:
    """Surfaces within a space, small ones and large ones. Clause: ORCL-FUZZ-1."""
    genus, curves, components = (0, space.genus), (0, space.curves), (1, space.components)
    sizes = (min(12, space.faces), min(40, space.faces), space.faces, space.faces)
    grown = [surfaces(size, genus, curves, components) for size in sizes]
    return weighted(*grown, spheres(min(60, space.faces)))


def _placed(of: Surface) -> st.SearchStrategy[Net]:
    bare = st.just(net_of(of))
    return weighted(bare, positions_for(of.vertices).map(lambda placed: net_of(of, placed)))


def drawn_nets(space: Space) -> st.SearchStrategy[Net]:
    """Meshes with and without positions, solids among them. Clause: ORCL-FUZZ-1."""
    grown = drawn_surfaces(space).flatmap(_placed)
    built = solids(min(120, space.faces)).map(_of_mesh)
    return weighted(grown, grown, grown, built) if space.faces >= 4 else grown


def _of_mesh(mesh: Mesh) -> Net:
    return net_of(mesh.surface, mesh.positions)


def _broken(net: Net, name: str, i: int, j: int) -> Net:
    """A breakage of the faces; positions are kept where their number is still right."""
    mesh: FaceList = BREAKAGES[name](net.mesh, i, j)
    places = net.places if mesh.vertices == net.vertices else None
    return Net(mesh.faces, mesh.vertices, net.precision, places)


def _perhaps_broken(nets: st.SearchStrategy[Net]) -> st.SearchStrategy[Net]:
    broken = st.builds(_broken, nets, st.sampled_from(list(BREAKAGES)), NUMBERS, NUMBERS)
    return weighted(nets, nets, broken)


def _streams(space: Space) -> st.SearchStrategy[form.StreamForm]:
    return drawn_surfaces(space).map(lambda of: stream_form(encode(of).stream))


def _changed(stream: form.StreamForm, kind: int, i: int, j: int) -> form.StreamForm:
    return STREAM_CHANGES[kind % len(STREAM_CHANGES)](stream, i, j)


def _perhaps_changed(
    streams: st.SearchStrategy[form.StreamForm],
) -> st.SearchStrategy[form.StreamForm]:
    kinds = st.integers(0, len(STREAM_CHANGES) - 1)
    return weighted(streams, st.builds(_changed, streams, kinds, NUMBERS, NUMBERS))


def _as_faces(net: Net) -> form.Faces:
    return form.Faces(
        faces=tuple((to_wire(a), to_wire(b), to_wire(c)) for a, b, c in net.faces),
        vertices=to_wire(net.vertices),
    )


def _as_through(net: Net) -> form.ThroughForm:
    bare = _as_faces(net)
    return form.ThroughForm(faces=bare.faces, vertices=bare.vertices, positions=places_form(net))


def _as_file(net: Net, code: str, accuracy: form.AccuracyForm) -> form.ToFile:
    bare = _as_faces(net)
    return form.ToFile(
        faces=bare.faces,
        vertices=bare.vertices,
        positions=places_form(net),
        code=code,
        accuracy=accuracy,
    )


ACCURACY_FORMS: Final[st.SearchStrategy[form.AccuracyForm]] = st.one_of(
    st.just(form.ExactForm()),
    st.builds(form.BitsForm, bits=st.integers(1, 24)),
    st.builds(form.LatticeForm, exponent=st.integers(-12, 3)),
    st.builds(form.ErrorForm, bound=st.floats(1e-3, 10.0)),
)


def _from_word(net_surface: Surface, code: str) -> form.FromWord:
    """The bits in this code, or where the code does not take the word in the plain one."""
    stream = encode(net_surface).stream
    given = from_word(code, stream) or from_word("plain", stream)
    assert given is not None, stream
    return given


def _bits_changed(given: form.FromWord, i: int, j: int) -> form.FromWord:
    fields = (given.symbols, given.components_with_boundary)
    symbols, boundary = fields
    match i % 6:
        case 0:
            symbols = max(0, symbols + (1, -1)[j % 2])
        case 1:
            boundary = max(0, boundary + (1, -1)[j % 2])
        case _:
            pass
    bits = given.bits if (symbols, boundary) != fields else bits_changed(given.bits, i // 6, j)
    return form.FromWord(
        code=given.code,
        bits=bits,
        symbols=symbols,
        components_with_boundary=boundary,
        closings=given.closings,
    )


def _file(net: Net, options: Options) -> bytes:
    """The net's file, or where the options do not fit it the one with every bit."""
    found = file_of(net, options) or file_of(net, Options())
    assert found is not None, net
    return bytes.fromhex(found.hex)


WAYS: Final = (*TAMPERINGS, damaged, damaged)
"""A file that is merely damaged is the commonest of all."""


def _tampered(data: bytes, way: int, number: int) -> bytes:
    return WAYS[way](data, Random(number))


def drawn(operation: str, caps: Caps) -> Drawn | None:
    """Requests for an operation; none where the adapter declares nothing to ask it with.

    Clauses: ORCL-FUZZ-1, ORCL-FUZZ-2.
    """
    space = space_of(caps)
    known = [code for code in registry.CodeName if code in caps.codes]
    codes = st.sampled_from(known or [registry.CodeName.PLAIN])
    needs_code = operation.startswith("code.") or operation == "mesh.encode"
    if needs_code and not known:
        return None
    match operation:
        case "surface.classify":
            nets = _perhaps_broken(drawn_nets(space))
            return nets.map(lambda n: message.Classify(id=0, input=_as_faces(n)))
        case "operator.apply":
            return scripts().map(
                lambda text: message.Apply(id=0, input=form.ScriptForm(script=text))
            )
        case "arithmetic.encode" | "arithmetic.decode":
            return arithmetic(operation, caps.coders)
        case "word.encode":
            nets = _perhaps_broken(drawn_nets(space))
            return nets.map(lambda n: message.WordEncode(id=0, input=_as_faces(n)))
        case "word.decode":
            words = _perhaps_changed(_streams(space))
            return words.map(lambda s: message.WordDecode(id=0, input=s))
        case "code.encode":
            return st.builds(_code_encode, codes, drawn_surfaces(space))
        case "code.decode":
            good = st.builds(_from_word, drawn_surfaces(space), codes)
            bad = st.builds(_bits_changed, good, NUMBERS, NUMBERS)
            return weighted(good, bad).map(lambda g: message.CodeDecode(id=0, input=g))
        case "mesh.encode":
            nets = _perhaps_broken(drawn_nets(space))
            files = st.builds(_as_file, nets, codes, ACCURACY_FORMS)
            return files.map(lambda given: message.MeshEncode(id=0, input=given))
        case "mesh.decode":
            options = st.builds(Options, codes, ACCURACIES)
            whole = st.builds(_file, drawn_nets(space), options)
            changed = st.builds(_tampered, whole, st.integers(0, len(WAYS) - 1), NUMBERS)
            return weighted(whole, changed).map(
                lambda data: message.MeshDecode(id=0, input=form.FileForm(hex=data.hex()))
            )
        case "codec.roundtrip":
            return drawn_nets(space).map(lambda n: message.Roundtrip(id=0, input=_as_through(n)))
        case _:
            return None


def _code_encode(code: str, of: Surface) -> Operation:
    return message.CodeEncode(id=0, input=to_word(code, encode(of).stream))
