"""Meshes with positions, to files and back: all accuracies, all codes, the edges of numbers."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import cycle
from typing import Final

from msgspec import UNSET

from clers.codes.registry import PARTIAL, CodeName
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.served import meshes as served
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.oracle.positives import placed as numbers
from clers.oracle.positives.asked import Asked, needed
from clers.oracle.positives.literal import solids
from clers.oracle.positives.placed import Placed, bare, coarse, fine, mesh_form, placed, smooth
from clers.oracle.positives.real import pieces, whole
from clers.oracle.positives.stock import Named, by_hand, by_rule, by_scripts

EXACT: Final = form.ExactForm()

_FILE: Final = (
    Clause.FILE_MAGIC_1,
    Clause.FILE_MAGIC_2,
    Clause.FILE_SECTION_1,
    Clause.FILE_SECTION_2,
    Clause.FILE_HEAD_1,
    Clause.FILE_HEAD_2,
    Clause.FILE_HEAD_3,
    Clause.FILE_WORD_1,
    Clause.FILE_LAYOUT_4,
    Clause.FILE_NUMBER_2,
    Clause.FILE_NUMBER_3,
    Clause.FILE_BITS_1,
)
_KEPT: Final = (
    Clause.GEOM_EXACT_1,
    Clause.GEOM_EXACT_2,
    Clause.GEOM_ORDER_1,
    Clause.FILE_POSN_1,
)
_QUANTISED: Final = (
    Clause.GEOM_LATTICE_2,
    Clause.GEOM_LATTICE_4,
    Clause.GEOM_BOX_1,
    Clause.GEOM_PREDICT_1,
    Clause.GEOM_PREDICT_2,
    Clause.GEOM_RESIDUAL_1,
    Clause.GEOM_CODE_1,
    Clause.GEOM_CODE_2,
    Clause.GEOM_CODE_3,
    Clause.GEOM_CODE_4,
    Clause.FILE_POSN_2,
    Clause.FILE_NUMBER_4,
)


def accuracy_words(accuracy: form.AccuracyForm) -> tuple[str, tuple[Clause, ...]]:
    """An accuracy as a word of a slug, and the clauses that it goes by."""
    match accuracy:
        case form.ExactForm():
            return "exact", _KEPT
        case form.LatticeForm(exponent=exponent):
            sign = "minus-" if exponent < 0 else ""
            return f"step-{sign}{abs(exponent)}", _QUANTISED
        case form.BitsForm(bits=bits):
            return f"{bits}-bits", (Clause.GEOM_CHOICE_1, *_QUANTISED)
        case form.ErrorForm():
            return "within-error", (Clause.GEOM_CHOICE_2, *_QUANTISED)


def filed(
    of: Placed, code: CodeName = CodeName.GOLDEN, accuracy: form.AccuracyForm = EXACT
) -> Iterator[Asked]:
    """A mesh to its file, and the file to its mesh; nothing where the code refuses it."""
    mesh = mesh_form(of.surface, of.positions)
    given = form.ToFile(
        faces=mesh.faces,
        vertices=mesh.vertices,
        positions=mesh.positions,
        code=code,
        accuracy=accuracy,
    )
    file = served.encode(code, given)
    if not isinstance(file, Accepted):
        if code in PARTIAL:
            return
        raise AssertionError(f"{of.slug}: {file.line()}")
    word, of_positions = accuracy_words(accuracy)
    stream = encode(of.surface).stream
    clauses = (
        *_FILE,
        *([Clause.FILE_HAND_1, Clause.CODE_HAND_4] if stream.records else []),
        *(of_positions if of.positions is not None else ()),
    )
    slug = f"{of.slug}-{code}" if of.positions is None else f"{of.slug}-{code}-{word}"
    requires = (*needed(of.surface), f"code.{code}")
    size = of.surface.faces
    yield Asked(
        slug, "mesh.encode", message.MeshEncode(id=0, input=given),
        (*clauses, Clause.FILE_OPTION_1), of.origin, requires, size, of.flags, of.comment,
    )  # fmt: skip
    yield Asked(
        slug, "mesh.decode", message.MeshDecode(id=0, input=file.value),
        (*clauses, Clause.FILE_PARSE_1, Clause.FILE_ROUND_1, Clause.GEOM_ORDER_3), of.origin,
        requires, size, of.flags, of.comment,
    )  # fmt: skip


def roundtrip(of: Placed, error: float | None = None) -> Asked:
    """A mesh through any codec; with an error that moves no coordinate further. ORCL-CODEC-1."""
    mesh = mesh_form(of.surface, of.positions)
    given = form.ThroughForm(
        faces=mesh.faces,
        vertices=mesh.vertices,
        positions=mesh.positions,
        error=UNSET if error is None else (error, error, error),
    )
    return Asked(
        of.slug if error is None else f"{of.slug}-rough",
        "codec.roundtrip",
        message.Roundtrip(id=0, input=given),
        (
            Clause.ORCL_OP_8,
            Clause.ORCL_JUDGE_3,
            *([Clause.ORCL_CODEC_1] if error is not None else []),
        ),
        of.origin,
        needed(of.surface),
        of.surface.faces,
        of.flags,
        of.comment,
        "isomorphic",
    )


def small() -> tuple[Named, ...]:
    """What is made by hand, and a few of the regular meshes."""
    kept = {"octahedron", "grid-torus-3-by-3", "strip-10", "torus-with-one-hole", "bipyramid-20"}
    return (*by_hand(), *(named for named in by_rule() if named.slug in kept))


LATTICES: Final[tuple[form.AccuracyForm, ...]] = (
    form.LatticeForm(exponent=-4),
    form.LatticeForm(exponent=0),
    form.LatticeForm(exponent=3),
    form.BitsForm(bits=1),
    form.BitsForm(bits=8),
    form.BitsForm(bits=30),
    form.ErrorForm(bound=0.01),
)
"""Accuracies that move coordinates."""


def every_way() -> Iterator[Asked]:
    """Small meshes without positions, exactly in both precisions, and with each accuracy."""
    turns = cycle(LATTICES)
    for number, named in enumerate(small()):
        count = named.surface.vertices
        yield from filed(bare(named))
        yield from filed(placed(named, coarse(count, number), "f32"))
        yield from filed(placed(named, fine(count, number), "f64"))
        for _ in range(3):
            yield from filed(placed(named, fine(count, number), "fine"), accuracy=next(turns))


def every_code() -> Iterator[Asked]:
    """Some meshes of each kind in each code."""
    chosen = {"cube", "octahedron", "torus", "annulus", "cube-triangle-tetrahedron"}
    for named in small():
        if named.slug in chosen:
            for code in CodeName:
                if code is not CodeName.GOLDEN:
                    yield from filed(bare(named), code)


_MOVABLE: Final = ("negative-zero", "negative-zero-f32", "tenths", "one-place", "one-line")
"""The edges that a lattice of step 1/64 takes."""


def edges_of_numbers() -> Iterator[Asked]:
    """Zeros with a sign, the smallest and the greatest numbers, ties, boxes without extent."""
    chosen = {"tetrahedron", "octahedron", "grid-torus-3-by-3"}
    for named in small():
        if named.slug not in chosen:
            continue
        count = named.surface.vertices
        for word, (kind, values, flags) in numbers.EDGES.items():
            of = placed(named, numbers.repeated(kind, values, count), word, *flags)
            yield from filed(of)
            if word in _MOVABLE:
                yield from filed(of, accuracy=form.LatticeForm(exponent=-6))
        halves = placed(named, numbers.repeated("f64", numbers.HALVES, count), "halves", "ties")
        yield from filed(halves, accuracy=form.LatticeForm(exponent=0))
        yield from filed(halves, accuracy=form.LatticeForm(exponent=1))
        tiny = numbers.EDGES["subnormal"]
        of = placed(named, numbers.repeated(tiny[0], tiny[1][:4], count), "tiny", *tiny[2])
        yield from filed(of, accuracy=form.LatticeForm(exponent=-1074))
        wide = numbers.repeated("f64", (0.0, float((1 << 30) - 1), 5.0, -3.0, 1.0), count)
        of = placed(named, wide, "wide", "wide-box")
        yield from filed(of, accuracy=form.BitsForm(bits=30))
        far = numbers.repeated("f64", (1e300, 1.5e300, -1e299, 0.0), count)
        yield from filed(placed(named, far, "far"), accuracy=form.BitsForm(bits=28))
        yield from filed(placed(named, far, "far"), accuracy=form.LatticeForm(exponent=971))


def larger() -> Iterator[Asked]:
    """Grown meshes, each in one code and one accuracy by turns; smooth ones on a lattice."""
    codes, lattices = cycle(CodeName), cycle((EXACT, *LATTICES))
    for number, named in enumerate(by_scripts()):
        count = named.surface.vertices
        of = placed(named, coarse(count, number), "coarse")
        yield from filed(of, next(codes), next(lattices))
    for named in by_rule():
        of = placed(named, smooth(named.surface), "smooth")
        yield from filed(of, accuracy=form.BitsForm(bits=10))


def of_people(inputs: Mapping[str, bytes]) -> Iterator[Asked]:
    """Solids and real meshes: exactly, and in 10 to 14 bits."""
    for of in solids(inputs):
        yield from filed(of, CodeName.BEST)
        yield from filed(of, accuracy=form.BitsForm(bits=12))
    for of in pieces():
        yield from filed(of, CodeName.CONTEXT)
        yield from filed(of, accuracy=form.BitsForm(bits=14))
    for of in whole():
        yield from filed(of, CodeName.BEST, form.BitsForm(bits=11))


def files(inputs: Mapping[str, bytes]) -> Iterator[Asked]:
    """All cases of `mesh.encode` and `mesh.decode`."""
    yield from every_way()
    yield from every_code()
    yield from edges_of_numbers()
    yield from larger()
    yield from of_people(inputs)


def roundtrips(inputs: Mapping[str, bytes]) -> Iterator[Asked]:
    """Clean meshes through any codec."""
    for number, named in enumerate(small()):
        yield roundtrip(bare(named))
        yield roundtrip(placed(named, coarse(named.surface.vertices, number), "f32"))
        yield roundtrip(placed(named, fine(named.surface.vertices, number), "f64"))
        yield roundtrip(placed(named, fine(named.surface.vertices, number), "f64"), 0.05)
    for number, named in enumerate(_some(by_scripts(), 5)):
        yield roundtrip(placed(named, coarse(named.surface.vertices, 1000 + number), "coarse"))
    for of in (*solids(inputs), *pieces()):
        yield roundtrip(of)
        yield roundtrip(of, 0.01)


def _some(given: Iterable[Named], every: int) -> Iterator[Named]:
    return (named for number, named in enumerate(given) if number % every == 0)
