"""Cases that are wrong on purpose: who passes one has not compared. ORCL-CANARY-1, ORCL-SUITE-7."""

from collections.abc import Callable, Iterator
from typing import TypeVar

import msgspec
from msgspec import UNSET, Raw, UnsetType

from clers.conformance import payloads as form
from clers.conformance.cases.case import Case, Comparison
from clers.conformance.cases.identity import named
from clers.conformance.messages import Rejection
from clers.conformance.payloads import Payload
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TORUS
from clers.edgebreaker.stream import Stream
from clers.oracle.negatives import by_hand, surfaces
from clers.oracle.negatives.codes import asked_of
from clers.oracle.negatives.draft import Draft, Slip, good
from clers.oracle.negatives.in_files import parent
from clers.oracle.negatives.meshes import TETRAHEDRAL
from clers.oracle.negatives.messages import digits_of, string
from clers.oracle.negatives.scripts import FAN
from clers.oracle.negatives.scripts import parent as of_script
from clers.oracle.negatives.words import accepted

P = TypeVar("P", bound=Payload)

replace = msgspec.structs.replace


def _result(draft: Draft, kind: type[P]) -> P:
    if isinstance(draft.case.ok, UnsetType):
        raise Slip(draft.slug)
    return msgspec.json.decode(draft.case.ok, type=kind)


def _wrong(
    draft: Draft, how: str, kind: type[P], change: Callable[[P], P], compare: Comparison = "exact"
) -> Case:
    """The case with a wrong result."""
    ok = Raw(msgspec.json.encode(change(_result(draft, kind))))
    return _canary(how, replace(draft.case, ok=ok, compare=compare))


def _canary(how: str, case: Case) -> Case:
    bare = replace(case, clauses=(str(Clause.ORCL_CANARY_1),), flags=(), trace=())
    return named(f"canary-{how}", bare)


def _decoded(slug: str, stream: Stream) -> Draft:
    found = accepted(slug, stream)
    if found is None:
        raise Slip(slug)
    return found


def _mirrored(of: P) -> P:
    if not isinstance(of, form.Faces):
        raise Slip(f"{of}")
    return replace(of, faces=tuple((a, c, b) for a, b, c in of.faces))


def canaries() -> tuple[Case, ...]:
    """All canaries. Clause: ORCL-CANARY-1."""
    return (*_of_words(), *_of_numbers(), *_of_files(), *_of_rejections())


def _of_words() -> Iterator[Case]:
    annulus = _decoded("annulus", encode(ANNULUS).stream)
    yield _wrong(annulus, "mirrored", form.Faces, _mirrored)
    yield _wrong(annulus, "vertices-exchanged", form.Faces, _exchanged)
    yield _wrong(
        annulus, "faces-in-another-order", form.Faces,
        lambda of: replace(of, faces=(*of.faces[:-2], of.faces[-1], of.faces[-2])),
    )  # fmt: skip
    yield _wrong(
        annulus, "face-turned", form.Faces,
        lambda of: replace(of, faces=((*of.faces[0][1:], of.faces[0][0]), *of.faces[1:])),
    )  # fmt: skip
    yield _wrong(annulus, "face-missing", form.Faces, lambda of: replace(of, faces=of.faces[:-1]))
    cube = surfaces.parent("word.encode", "cube", CUBE)
    yield _wrong(
        cube, "symbol-exchanged", form.WordForm,
        lambda of: replace(of, word=of.word[:-3] + "L" + of.word[-2:]),
    )  # fmt: skip
    yield _wrong(
        cube, "order-of-vertices", form.WordForm,
        lambda of: replace(of, vertex_order=of.vertex_order[::-1]),
    )  # fmt: skip
    torus = surfaces.parent("word.encode", "torus", TORUS)
    yield _wrong(
        torus, "record-missing", form.WordForm, lambda of: replace(of, handles=of.handles[:1])
    )
    yield _wrong(
        torus, "side-of-a-record", form.WordForm,
        lambda of: replace(of, handles=(replace(of.handles[0], side="left"), of.handles[1])),
    )  # fmt: skip


def _exchanged(of: form.Faces) -> form.Faces:
    """The first two vertices under each other's name."""
    name: dict[int | str, int | str] = {0: 1, 1: 0}
    faces = tuple((name.get(a, a), name.get(b, b), name.get(c, c)) for a, b, c in of.faces)
    return replace(of, faces=faces)


def _of_numbers() -> Iterator[Case]:
    torus = surfaces.parent("surface.classify", "torus", TORUS)
    yield _wrong(
        torus, "genus-off-by-one", form.Classified,
        lambda of: replace(of, components=(replace(of.components[0], genus=2),)),
    )  # fmt: skip
    yield _wrong(
        of_script("sheet", FAN), "number-of-a-stage", form.Stages,
        lambda of: replace(
            of,
            stages=(
                *of.stages[:-1],
                replace(of.stages[-1], numbers={**of.stages[-1].numbers, "loops": 2}),
            ),
        ),
    )  # fmt: skip
    asked, given = asked_of("golden", "cube", encode(CUBE).stream)
    digits = digits_of(asked)
    turned = digits[:8] + str(1 - int(digits[8])) + digits[9:]
    yield _wrong(asked, "bit-turned", form.BitString, lambda _: string(turned))
    yield _wrong(asked, "bit-more", form.BitString, lambda _: string(digits + "0"))
    yield _wrong(
        given, "symbol-of-a-code", form.JustWord, lambda of: replace(of, word=of.word[:-1] + "R")
    )


def _of_files() -> Iterator[Case]:
    corner = parent("file-single-precision-plain", by_hand.F32)
    yield _wrong(corner, "coordinate-moved", form.MeshForm, _moved)
    places = form.Places(precision="f64", coordinates=by_hand.CORNER)
    mesh = form.MeshForm(faces=TETRAHEDRAL, vertices=4, positions=places)
    written = form.ToFile(
        faces=TETRAHEDRAL, vertices=4, positions=places, code="plain", accuracy=form.ExactForm()
    )
    to_file = good("corner", "mesh.encode", written, (), requires=("code.plain",), size=4)
    yield _wrong(to_file, "byte-missing", form.FileForm, lambda of: replace(of, hex=of.hex[:-2]))
    there_and_back = good("corner", "codec.roundtrip", mesh, (), size=4)
    yield _wrong(there_and_back, "mirrored-mesh", form.MeshForm, _mirrored, "isomorphic")
    yield _wrong(there_and_back, "corner-moved", form.MeshForm, _moved, "isomorphic")


def _moved(of: form.MeshForm) -> form.MeshForm:
    """The last coordinate twice as far away."""
    if isinstance(of.positions, UnsetType):
        raise Slip("no positions")
    numbers = (*of.positions.coordinates[:-1], 2.0)
    return replace(of, positions=replace(of.positions, coordinates=numbers))


def _of_rejections() -> Iterator[Case]:
    ball = _decoded("tetrahedron", Stream("CRE"))
    garbage = form.StreamForm(word="ERC", handles=(), components_with_boundary=0)
    yield _canary("garbage-accepted", replace(ball.case, input=Raw(msgspec.json.encode(garbage))))
    yield _canary("good-rejected", replace(ball.case, ok=UNSET, reject=Rejection(Fault.INVALID)))
    file = parent("file-ball-plain", by_hand.BALL)
    yield _canary(
        "good-file-rejected", replace(file.case, ok=UNSET, reject=Rejection(Fault.MALFORMED))
    )
    data = bytearray(by_hand.BALL.data)
    data[-1] ^= 1
    damaged = Raw(msgspec.json.encode(form.FileForm(hex=data.hex())))
    other = Rejection(Fault.UNSUPPORTED)
    yield _canary("another-class", replace(file.case, input=damaged, ok=UNSET, reject=other))
