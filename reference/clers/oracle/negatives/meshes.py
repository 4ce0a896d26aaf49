"""Meshes that no file can hold as they are asked for. Chapters 3 and 7."""

from collections.abc import Iterator
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.edgebreaker.examples import TETRAHEDRON, TORUS
from clers.oracle.negatives.by_hand import CORNER
from clers.oracle.negatives.draft import Draft, bad, good
from clers.oracle.negatives.surfaces import count, other

C = Clause
R = Reason

Row = tuple[str, Edit, Reason, Clause, str]

NUMBERS: Final = "/positions/coordinates"
TETRAHEDRAL: Final = tuple(TETRAHEDRON.triangles())


def parent(
    slug: str,
    accuracy: form.AccuracyForm,
    coordinates: tuple[float, ...] = CORNER,
    *,
    single: bool = True,
) -> Draft:
    """The case of a tetrahedron with positions. Clause: ORCL-OP-7."""
    places = form.Places(precision="f32" if single else "f64", coordinates=coordinates)
    given = form.ToFile(
        faces=TETRAHEDRAL, vertices=4, positions=places, code="plain", accuracy=accuracy
    )
    return good(
        slug, "mesh.encode", given, (C.FILE_OPTION_1, C.GEOM_MESH_1), requires=("code.plain",),
        size=4,
    )  # fmt: skip


def drafts() -> Iterator[Draft]:
    """Good meshes, and what is wrong with them. Clause: ORCL-OP-7."""
    groups = (
        (parent("corner-exact", form.ExactForm()), of_exact()),
        (parent("corner-exact-double", form.ExactForm(), single=False), of_double()),
        (parent("corner-on-lattice", form.LatticeForm(exponent=-1), single=False), of_lattice()),
        (parent("corner-in-bits", form.BitsForm(bits=2), single=False), of_bits()),
        (parent("corner-within-error", form.ErrorForm(bound=0.25), single=False), of_error()),
    )
    for draft, rows in groups:
        yield draft
        for kind, edit, reason, clause, flag in rows:
            yield bad(draft, kind, (edit,), reason, clause, flags=(flag,))
    yield from of_border()
    torus = form.ToFile(
        faces=tuple(TORUS.triangles()), vertices=9, code="plain", accuracy=form.ExactForm()
    )
    draft = good(
        "torus-in-plain", "mesh.encode", torus, (C.FILE_OPTION_1,),
        requires=("code.plain", "handles"), size=18,
    )  # fmt: skip
    yield draft
    yield bad(
        draft, "as-enumerative", (replaced("/code", 0, "plain", "enumerative"),),
        R.NOT_REPRESENTABLE, C.CODE_ENUM_1, requires=("code.enumerative",),
        flags=("code-not-for-all",),
    )  # fmt: skip


def of_exact() -> Iterator[Row]:
    """Single precision and faces. Clauses: GEOM-POSITION-2, GEOM-POSITION-4, CPLX-REJECT-4 … -9."""
    counted = R.COUNT_MISMATCH, C.GEOM_POSITION_2, "positions-not-counted"
    single = R.NOT_REPRESENTABLE, C.GEOM_POSITION_4, "precision-lost"
    last = [CORNER[-1]]
    yield "coordinate-missing", replaced(NUMBERS, 11, last, []), *counted
    yield "coordinate-more", replaced(NUMBERS, 12, [], last), *counted
    yield "position-missing", replaced(NUMBERS, 9, list(CORNER[9:]), []), *counted
    yield "no-positions", replaced(NUMBERS, 0, list(CORNER), []), *counted
    for kind, value in (
        ("tenth", 0.1),
        ("one-bit-too-fine", 1.0 + 2.0**-24),
        ("over-the-greatest", 2.0**128),
        ("half-over-the-greatest", 3.4028235677973366e38),
        ("under-the-least", 2.0**-150),
    ):
        yield f"{kind}-in-single-precision", replaced(NUMBERS, 11, last, [value]), *single
    turned = other(3, (0, 2, 3), (0, 3, 2))
    yield (
        "face-turned-over",
        turned,
        R.EDGE_TWICE_IN_ONE_DIRECTION,
        C.CPLX_REJECT_7,
        ("orientation-ignored"),
    )
    double = other(1, (0, 3, 1), (0, 3, 3))
    yield "vertex-twice-in-a-face", double, R.REPEATED_INDEX, C.CPLX_REJECT_4, "degenerate-face"
    yield "vertex-not-named", count(4, 5), R.ISOLATED_VERTEX, C.CPLX_REJECT_9, "isolated-vertex"


def of_double() -> Iterator[Row]:
    """Doubles that are called singles. Clause: GEOM-POSITION-4."""
    edit = replaced(NUMBERS, 3, [1.0, 0.0, 0.0], [1.0, 0.0])
    yield "coordinate-missing", edit, R.COUNT_MISMATCH, C.GEOM_POSITION_2, "positions-not-counted"


def of_lattice() -> Iterator[Row]:
    """Exponents, numbers and boxes. Clauses: GEOM-LATTICE-1, GEOM-LATTICE-3, GEOM-BOX-2."""
    where, flag = "/accuracy/exponent", "lattice-not-checked"
    exponent = R.BAD_LATTICE, C.GEOM_LATTICE_1, flag
    yield "exponent-too-high", replaced(where, 0, -1, 972), *exponent
    yield "exponent-too-low", replaced(where, 0, -1, -1075), *exponent
    yield "exponent-wraps-at-16-bits", replaced(where, 0, -1, (1 << 16) - 1), *exponent
    yield (
        "number-over-53-bits",
        replaced(where, 0, -1, -53),
        R.NOT_REPRESENTABLE,
        (C.GEOM_LATTICE_3),
        flag,
    )
    yield "box-of-31-bits", replaced(where, 0, -1, -30), R.BAD_LATTICE, C.GEOM_BOX_2, flag
    yield (
        "number-as-great-as-a-double",
        replaced(NUMBERS, 3, [1.0], [1e308]),
        (R.NOT_REPRESENTABLE),
        C.GEOM_LATTICE_3,
        flag,
    )


def of_border() -> Iterator[Draft]:
    """A triangle whose vertex 0 is created last; its number is blamed. Clause: GEOM-LATTICE-3."""
    places = form.Places(precision="f64", coordinates=(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
    given = form.ToFile(
        faces=((0, 1, 2),), vertices=3, positions=places, code="plain",
        accuracy=form.LatticeForm(exponent=0),
    )  # fmt: skip
    draft = good(
        "triangle-on-lattice", "mesh.encode", given, (C.GEOM_ORDER_1, C.GEOM_LATTICE_1),
        requires=("boundaries.one", "code.plain"), size=1,
    )  # fmt: skip
    yield draft
    for vertex in (0, 1):
        edit = replaced(NUMBERS, 3 * vertex, [0.0], [float(1 << 53)])
        yield bad(
            draft, f"vertex-{vertex}-too-far", (edit,), R.NOT_REPRESENTABLE, C.GEOM_LATTICE_3,
            flags=("lattice-not-checked",),
        )  # fmt: skip


def of_bits() -> Iterator[Row]:
    """Clause: GEOM-CHOICE-1."""
    where = "/accuracy/bits"
    for bits in (0, -1, 31, 1 << 32):
        yield (
            f"{bits}-bits".replace("-1-bits", "minus-one-bits"),
            replaced(where, 0, 2, bits),
            (R.BAD_LATTICE),
            C.GEOM_CHOICE_1,
            "lattice-not-checked",
        )


def of_error() -> Iterator[Row]:
    """Clause: GEOM-CHOICE-2."""
    for kind, bound in (("zero", 0.0), ("minus-zero", -0.0), ("negative", -0.25)):
        edit = replaced("/accuracy/bound", 0, 0.25, bound)
        yield f"bound-{kind}", edit, R.BAD_LATTICE, C.GEOM_CHOICE_2, "lattice-not-checked"
