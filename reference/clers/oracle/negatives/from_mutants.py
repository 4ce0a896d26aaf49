"""Cases that mistakes asked for: each brings one to light that all others let pass.

Clause: ORCL-MUTANT-8.
"""

from collections.abc import Iterator

from clers.conformance import payloads as form
from clers.conformance.cases.edits import replaced
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.edgebreaker.examples import TETRAHEDRON
from clers.oracle.negatives import meshes, scripts, surfaces
from clers.oracle.negatives.draft import Draft, bad, good

C = Clause
R = Reason

BALL_AND_DISK = surfaces.built((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3), (4, 5, 6))
ALMOST = float((1 << 53) - 1)
"""The greatest number of a lattice. Clause: GEOM-LATTICE-1."""


def drafts() -> Iterator[Draft]:
    """Good cases, and one fault in each. Clause: ORCL-MUTANT-8."""
    yield from _faces()
    yield from _words()
    yield from _places()
    yield from _scripts()


def _faces() -> Iterator[Draft]:
    for op in surfaces.OPERATIONS:
        beside = surfaces.parent(op, "tetrahedron-and-triangle", BALL_AND_DISK)
        yield beside
        folded = (surfaces.other(4, (4, 5, 6), (4, 5, 5)), surfaces.count(7, 6))
        yield bad(
            beside, "triangle-folded", folded, R.REPEATED_INDEX, C.CPLX_REJECT_4,
            flags=("degenerate-face",),
        )  # fmt: skip
        tetrahedron = surfaces.parent(op, "tetrahedron", TETRAHEDRON)
        yield tetrahedron
        yield bad(
            tetrahedron, "first-index-is-count", (surfaces.other(0, (0, 1, 2), (4, 1, 2)),),
            R.INDEX_OUT_OF_RANGE, C.CPLX_REJECT_3, flags=("index-off-by-one",),
        )  # fmt: skip


def _words() -> Iterator[Draft]:
    stream = form.StreamForm(word="CRE", handles=(), components_with_boundary=0)
    whole = good("tetrahedron", "word.decode", stream, (C.EB_DECODE_1, C.ORCL_OP_5), size=3)
    yield whole
    yield bad(
        whole, "no-symbol", (replaced("/word", 0, "CRE", ""),), R.EMPTY_WORD, C.EB_GRAMMAR_1,
        flags=("empty-input",),
    )  # fmt: skip
    bits = form.FromWord(
        code="king-rossignac", bits=form.BitString(hex="a8", length=6), symbols=3,
        components_with_boundary=0,
    )  # fmt: skip
    third = good(
        "king-rossignac-third-code", "code.decode", bits, (C.CODE_KR_1, C.CODE_KR_2),
        requires=("code.king-rossignac",), size=3,
    )  # fmt: skip
    yield third
    yield bad(
        third, "fourth-code", (replaced("/bits/hex", 0, "a", "e"),),
        R.NOT_CANONICAL, C.CODE_KR_3, flags=("bits-not-compared",),
    )  # fmt: skip


def _places() -> Iterator[Draft]:
    corners = (ALMOST, 0.0, 0.0, ALMOST, 1.0, 0.0, ALMOST, 0.0, 1.0, ALMOST, 1.0, 1.0)
    far = meshes.parent("far-corner", form.LatticeForm(exponent=0), corners, single=False)
    yield far
    yield bad(
        far, "one-step-further", (replaced(f"{meshes.NUMBERS}/3", 0, ALMOST, ALMOST + 1),),
        R.NOT_REPRESENTABLE, C.GEOM_LATTICE_3, flags=("lattice-not-checked",),
    )  # fmt: skip
    low = tuple(-x if x == ALMOST else x for x in corners)
    below = meshes.parent("far-low-corner", form.LatticeForm(exponent=0), low, single=False)
    yield below
    yield bad(
        below, "one-step-further", (replaced(f"{meshes.NUMBERS}/6", 0, -ALMOST, -ALMOST - 1),),
        R.NOT_REPRESENTABLE, C.GEOM_LATTICE_3, flags=("lattice-not-checked",),
    )  # fmt: skip


def _scripts() -> Iterator[Draft]:
    for slug, script, requires, kind, wrong, reason, clause in SCRIPTS:
        whole = good(
            slug, "operator.apply", form.ScriptForm(script=script),
            (C.OPER_FAMILY_1, C.OPER_FAMILY_3), requires=requires,
        )  # fmt: skip
        yield whole
        edit = scripts.difference(script, wrong)
        yield bad(whole, kind, (edit,), reason, clause, flags=(scripts.APPLIED,))


TWO = "zero-handle 0 1 2; zero-handle 3 4 5; "
RING = "zero-handle-polygon 0 1 2 3 4 5 6 7; lower 0 1 4 5; "
CIRCLE = "first-vertex 0; edge-and-vertex 0 1; edge-and-vertex 1 2; edge-between-ends 0 2"
EDGE = "attach 0 1 2; attach 1 2 3 / 1 2"
STRIP = "attach 0 1 2; attach 1 2 3 / 1 2; attach 2 3 4 / 2 3"
SPHERE = (
    "attach 0 1 2; attach 0 1 3 / 0 1; attach 0 2 3 / 0 2 / 0 3; attach 1 2 3 / 1 2 / 1 3 / 2 3"
)

SCRIPTS = (
    ("two-triangles-joined", f"{TWO}join 1 0 4 3", ("boundaries.many", "components"),
     "by-upper-handle", f"{TWO}upper 1 0 4 3", R.OPERATOR_NOT_APPLICABLE, C.OPER_SURFACE_6),
    ("ring-with-handle", f"{RING}upper 1 2 5 6", ("boundaries.many", "handles"),
     "by-lower-handle", f"{RING}lower 1 2 5 6", R.OPERATOR_NOT_APPLICABLE, C.OPER_SURFACE_5),
    ("circle-of-three-edges", CIRCLE, (),
     "contracted", f"{CIRCLE}; contract 0 / 1", R.LINK_CONDITION, C.OPER_CONTRACT_1),
    ("sphere-of-four-triangles", SPHERE, (),
     "contracted", f"{SPHERE}; contract 0 / 1", R.LINK_CONDITION, C.OPER_CONTRACT_1),
    ("two-triangles-attached", EDGE, (),
     "subdivided-by-what-is-there", f"{EDGE}; subdivide 1 2 / 3",
     R.PRESENT_SIMPLEX, C.OPER_STELLAR_1),
    ("two-triangles-attached", EDGE, (),
     "subdivided-where-nothing-is", f"{EDGE}; subdivide 0 3 / 4",
     R.MISSING_SIMPLEX, C.OPER_STELLAR_1),
    ("strip-of-three-triangles", STRIP, (),
     "contracted-across", f"{STRIP}; contract 1 / 2", R.LINK_CONDITION, C.OPER_CONTRACT_1),
)  # fmt: skip
"""A script that applies, what it needs; what is wrong with another, and why."""
