"""What an input requires, read off it without decoding, whether it is good or not. ORCL-CASE-4."""

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import assert_never

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.numbers import from_wire
from clers.container.file import decode as decode_file
from clers.container.file import options_of
from clers.conventions.result import Accepted, Rejected
from clers.operators.families import Growing, read, stages

Needs = tuple[tuple[str, ...], int]
"""Capabilities in alphabetical order, and the size: the most of faces and of symbols."""


def requires(operation: Operation) -> Needs:
    """What must be borne to answer. Clauses: ORCL-CASE-4, ORCL-FUZZ-2.

    Of a bad input it is what the input looks as if it required.
    """
    match operation:
        case message.Echo():
            return (), 0
        case message.Classify(input=faces) | message.WordEncode(input=faces):
            return of_faces(faces)
        case message.Roundtrip(input=mesh):
            return of_faces(mesh)
        case message.MeshEncode(input=mesh):
            return _and(f"code.{mesh.code}", of_faces(mesh))
        case message.Apply(input=given):
            return (), _most_faces(given.script)
        case message.ArithmeticEncode(input=told):
            return (f"coder.{told.coder}",), len(told.symbols)
        case message.ArithmeticDecode(input=coded):
            return (f"coder.{coded.coder}",), coded.count
        case message.WordDecode(input=stream):
            return _of_stream(stream)
        case message.CodeEncode(input=worded):
            return _and(f"code.{worded.code}", _of_stream(worded))
        case message.CodeDecode(input=bits):
            kinds = [closing.kind for closing in bits.closings]
            names = _of_kinds(kinds, bits.components_with_boundary)
            return _and(f"code.{bits.code}", (names, bits.symbols))
        case message.MeshDecode(input=file):
            return _of_file(file)
        case _:
            assert_never(operation)


def _and(name: str, more: Needs) -> Needs:
    return tuple(sorted((name, *more[0]))), more[1]


def _named(*, components: int, curves: int, handles: bool) -> tuple[str, ...]:
    needed = {
        "boundaries.many": curves > 1,
        "boundaries.one": curves == 1,
        "components": components > 1,
        "handles": handles,
    }
    return tuple(name for name, is_needed in needed.items() if is_needed)


def of_faces(given: form.Faces) -> Needs:
    """Of faces and vertices: of a surface exactly what it has. Clause: ORCL-CASE-4."""
    faces = [tuple(map(from_wire, face)) for face in given.faces]
    sides = Counter(frozenset(pair) for a, b, c in faces for pair in ((a, b), (b, c), (c, a)))
    rim = [side for side, count in sides.items() if count == 1]
    pieces, curves = _pieces(faces), _pieces(rim)
    used = {vertex for face in faces for vertex in face}
    euler = len(used) - len(sides) + len(faces)
    return _named(components=pieces, curves=curves, handles=euler < 2 * pieces - curves), len(faces)


def _pieces(groups: Iterable[Iterable[int]]) -> int:
    """How many parts hang together, of groups that do."""
    above: dict[int, int] = {}

    def top(vertex: int) -> int:
        while above.setdefault(vertex, vertex) != vertex:
            above[vertex] = above[above[vertex]]
            vertex = above[vertex]
        return vertex

    for group in groups:
        first, *others = group
        top(first)
        for other in others:
            above[top(other)] = top(first)
    return sum(vertex == parent for vertex, parent in above.items())


def _of_kinds(kinds: Sequence[str], with_boundary: int) -> tuple[str, ...]:
    return _named(
        components=with_boundary, curves=with_boundary + kinds.count("boundary"),
        handles="handle" in kinds,
    )  # fmt: skip


def _of_stream(given: form.StreamForm) -> Needs:
    """The number of components follows from EB-COUNT-3 and EB-COUNT-4: records − #S + #E."""
    kinds = [handle.kind for handle in given.handles]
    with_boundary = from_wire(given.components_with_boundary)
    components = len(kinds) - given.word.count("S") + given.word.count("E")
    names = _named(
        components=components,
        curves=with_boundary + kinds.count("boundary"),
        handles="handle" in kinds,
    )
    return names, len(given.word) + max(components, 0)


def _of_file(given: form.FileForm) -> Needs:
    """Of a good file its code, and what its mesh has; of a bad one nothing is known."""
    data = bytes.fromhex(given.hex)
    found, options = decode_file(data), options_of(data)
    if isinstance(found, Rejected) or isinstance(options, Rejected):
        return (), len(data)
    surface = found.value.surface
    mesh = form.Faces(faces=tuple(surface.triangles()), vertices=surface.vertices)
    return _and(f"code.{options.value.code}", of_faces(mesh))


def _most_faces(script: str) -> int:
    """The most faces of a stage, or, of other families, of operators."""
    read_script = read(script)
    if not isinstance(read_script, Accepted) or not isinstance(read_script.value, Growing):
        return script.count(";") + 1
    done, _ = stages(read_script.value)
    return max(dict(stage.numbers)["faces"] for stage in done)
