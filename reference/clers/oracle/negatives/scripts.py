"""Scripts of operators that cannot be read, or do not apply: one step wrong in each. Chapter 4."""

from collections.abc import Iterator
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.oracle.negatives.draft import Draft, bad, good

C = Clause
R = Reason

Row = tuple[str, str, Reason, Clause]
"""What kind of fault it is, the script with it, and why it is rejected."""

READ: Final = "script-read-loosely"
APPLIED: Final = "operator-not-checked"


def parent(slug: str, script: str) -> Draft:
    """The case of a script that applies. Clause: ORCL-OP-3."""
    return good(
        slug, "operator.apply", form.ScriptForm(script=script),
        (C.OPER_FAMILY_1, C.OPER_FAMILY_3), requires=NEEDS.get(slug, ()),
    )  # fmt: skip


def difference(old: str, new: str) -> Edit:
    """The edit that makes one text of another: all between what both begin and end with."""
    most = min(len(old), len(new))
    start = next((i for i in range(most) if old[i] != new[i]), most)
    tail = 0
    while tail < most - start and old[-1 - tail] == new[-1 - tail]:
        tail += 1
    return replaced("/script", start, old[start : len(old) - tail], new[start : len(new) - tail])


def drafts() -> Iterator[Draft]:
    """Good scripts, and scripts with a fault. Clause: ORCL-OP-3."""
    for slug, script, rows in SCRIPTS:
        draft = parent(slug, script)
        yield draft
        for kind, wrong, reason, clause in rows:
            flag = READ if reason in (R.UNKNOWN_OPERATOR, R.BAD_OPERAND) else APPLIED
            yield bad(draft, kind, (difference(script, wrong),), reason, clause, flags=(flag,))


NEEDS: Final = {
    "loop-in-two": ("boundaries.many",),
    "strips-between": ("boundaries.many", "components"),
    "strip-around": ("boundaries.many",),
    "strip-undone": ("boundaries.many",),
}

NA, BO, UO = R.OPERATOR_NOT_APPLICABLE, R.BAD_OPERAND, R.UNKNOWN_OPERATOR
GROW, SHEET, MOVE, ATTACH = C.OPER_SCRIPT_6, C.OPER_BUILD_5, C.OPER_MOVE_8, C.OPER_ATTACH_8

FAN: Final = "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4"
SHELL: Final = "zero-handle 0 1 2; glue 1 0 3; complete 2 1 3"
AROUND: Final = "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4; glue 4 0 5; lower-strip 2 1 4 5"
EDGE: Final = "attach 0 1 2; attach 1 2 3 / 1 2"
CURVE: Final = "first-vertex 0; edge-and-vertex 0 1; edge-and-vertex 1 2; edge-and-vertex 2 3"

SCRIPTS: Final[tuple[tuple[str, str, tuple[Row, ...]], ...]] = (
    ("grown", "split-face 0; flip-edge 1", (
        ("name-unknown", "split-face 0; twist-edge 1", UO, GROW),
        ("name-in-capitals", "split-face 0; Flip-edge 1", UO, GROW),
        ("name-of-another-family", "split-face 0; glue 1 0 3", UO, GROW),
        ("number-missing", "split-face; flip-edge 1", BO, GROW),
        ("number-left-over", "split-face 0; flip-edge 1 2", BO, GROW),
        ("number-with-a-point", "split-face 0.0; flip-edge 1", BO, GROW),
        ("number-with-plus", "split-face +0; flip-edge 1", BO, GROW),
        ("number-with-leading-zero", "split-face 0; flip-edge 01", BO, GROW),
        ("number-in-hexadecimal", "split-face 0; flip-edge 0x1", BO, GROW),
        ("minus-zero", "split-face -0; flip-edge 1", BO, GROW),
        ("minus-alone", "split-face -; flip-edge 1", BO, GROW),
        ("other-digits", "split-face 0; flip-edge \u0661", BO, GROW),
        ("comma-between", "split-face 0, flip-edge 1", BO, GROW),
        ("number-of-1001-digits", f"split-face 0; flip-edge 1{'0' * 1000}", BO, GROW),
    )),
    ("sheet", FAN, (
        ("name-unknown", FAN.replace("glue 3", "sew 3"), UO, SHEET),
        ("name-of-another-family", FAN.replace("glue 3 0 4", "split-face 0"), UO, SHEET),
        ("number-missing", FAN.replace("glue 3 0 4", "glue 3 0"), BO, SHEET),
        ("number-left-over", FAN.replace("glue 3 0 4", "glue 3 0 4 5"), BO, SHEET),
        ("vertex-negative", FAN.replace("glue 3 0 4", "glue 3 0 -4"), BO, SHEET),
        ("vertex-with-leading-zero", FAN.replace("glue 3 0 4", "glue 3 0 04"), BO, SHEET),
        ("side-turned", FAN.replace("glue 1 0", "glue 0 1"), NA, C.OPER_SURFACE_3),
        ("vertex-is-there", FAN.replace("glue 3 0 4", "glue 3 0 2"), NA, C.OPER_SURFACE_3),
        ("vertex-twice", FAN.replace("glue 3 0 4", "glue 3 0 3"), R.REPEATED_VERTEX,
         C.OPER_SURFACE_3),
        ("first-vertex-twice", FAN.replace("0 1 2;", "0 1 0;"), R.REPEATED_VERTEX,
         C.OPER_SURFACE_1),
        ("side-used-up", FAN.replace("glue 3 0", "glue 1 0"), NA, C.OPER_SURFACE_3),
    )),
    ("sheet-completed", f"{FAN}; complete 4 0 2", (
        ("edge-is-there", f"{FAN}; complete 0 2 1", R.DOUBLE_EDGE, C.OPER_SURFACE_2),
        ("sides-do-not-follow", f"{FAN}; complete 4 0 1", NA, C.OPER_SURFACE_2),
    )),
    ("two-sides", "zero-handle-polygon 0 1 2; two-handle 0 1 2", (
        ("polygon-of-two", "zero-handle-polygon 0 1; two-handle 0 1 2", NA, C.OPER_SURFACE_1),
        ("polygon-with-a-vertex-twice", "zero-handle-polygon 0 1 1; two-handle 0 1 2",
         R.REPEATED_VERTEX, C.OPER_SURFACE_1),
        ("other-side-is-there", "zero-handle 0 2 1; two-handle 0 1 2",
         R.DUPLICATE_FACE, C.OPER_SURFACE_7),
        ("loop-turned", "zero-handle-polygon 0 1 2; two-handle 0 2 1", NA, C.OPER_SURFACE_7),
        ("loop-of-four", "zero-handle-polygon 0 1 2 3; two-handle 0 1 2", NA, C.OPER_SURFACE_7),
    )),
    ("closed-by-euler", f"{SHELL}; make-sg 0 2 3", (
        ("loop-turned", f"{SHELL}; make-sg 0 3 2", NA, C.OPER_EULER_4),
    )),
    ("strip-undone", f"{AROUND}; undo-lower-strip 2 1 4 5", (
        ("turned", f"{AROUND}; undo-lower-strip 2 1 5 4", NA, C.OPER_EULER_3),
    )),
    ("loop-in-two", f"{FAN}; lower 2 1 4 0", (
        ("as-upper", f"{FAN}; upper 2 1 4 0", NA, C.OPER_SURFACE_6),
        ("as-join", f"{FAN}; join 2 1 4 0", NA, C.OPER_SURFACE_4),
        ("corner-turned", f"{FAN}; lower 2 1 4 3", NA, C.OPER_SURFACE_5),
        ("edge-is-there", f"{FAN}; lower 2 1 3 4", R.DOUBLE_EDGE, C.OPER_SURFACE_5),
    )),
    ("strips-between", "zero-handle 0 1 2; zero-handle 3 4 5; join-strip 1 0 4 3", (
        ("as-lower", "zero-handle 0 1 2; zero-handle 3 4 5; lower-strip 1 0 4 3", NA,
         C.OPER_SURFACE_5),
        ("side-turned", "zero-handle 0 1 2; zero-handle 3 4 5; join-strip 1 0 3 4", NA,
         C.OPER_SURFACE_4),
        ("vertex-is-there", "zero-handle 0 1 2; zero-handle 2 4 5; join-strip 1 0 4 3", NA,
         C.OPER_SURFACE_1),
    )),
    ("strip-around", "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4; glue 4 0 5; lower-strip 2 1 4 5", (
        ("ends-at-a-neighbour",
         "zero-handle 0 1 2; glue 1 0 3; glue 3 0 4; glue 4 0 5; lower-strip 2 1 3 4",
         R.DOUBLE_EDGE, C.OPER_SURFACE_5),
    )),
    ("undone", "zero-handle 0 1 2; glue 1 0 3; undo-glue 1 0 3", (
        ("another-triangle", "zero-handle 0 1 2; glue 1 0 3; undo-glue 1 0 4", NA,
         C.OPER_SURFACE_3),
        ("no-component-by-itself", "zero-handle 0 1 2; glue 1 0 3; undo-zero-handle 0 1 2", NA,
         C.OPER_SURFACE_1),
    )),
    ("euler", "make-stv 0 1 2; make-ev 1 0 3; make-te 3 1 0", (
        ("edge-is-there", "make-stv 0 1 2; make-ev 1 0 3; make-te 0 2 1", R.DOUBLE_EDGE,
         C.OPER_EULER_3),
        ("vertex-is-its-own-neighbour", "make-stv 0 1 2; make-ev 1 0 1; make-te 3 1 0",
         R.REPEATED_VERTEX, C.OPER_EULER_2),
        ("vertex-is-there", "make-stv 0 1 2; make-ev 1 0 2; make-te 3 1 0", NA, C.OPER_EULER_2),
        ("kill-before-make", "kill-stv 0 1 2; make-ev 1 0 3; make-te 3 1 0", NA, C.OPER_EULER_1),
    )),
    ("two-loops-joined", "make-stv 0 1 2; make-stv 3 4 5; make-ekl 1 0 4 3", (
        ("on-one-loop", "make-stv 0 1 2; make-stv 3 4 5; make-ekl 1 0 2 1", NA, C.OPER_EULER_5),
        ("side-turned", "make-stv 0 1 2; make-stv 3 4 5; make-ekl 0 1 4 3", NA, C.OPER_EULER_5),
    )),
    ("attached", EDGE, (
        ("name-unknown", "attach 0 1 2; append 1 2 3 / 1 2", UO, ATTACH),
        ("leading-zero", "attach 0 1 2; attach 1 2 03 / 1 2", BO, ATTACH),
        ("commas", "attach 0 1 2; attach 1,2,3 / 1 2", BO, ATTACH),
        ("slash-at-the-name", "attach 0 1 2; attach/ 1 2 3 / 1 2", UO, ATTACH),
        ("undo-alone", "attach 0 1 2; undo", UO, ATTACH),
        ("undo-twice", "attach 0 1 2; undo undo attach 0 1 2", UO, ATTACH),
        ("undo-before-a-move", "attach 0 1 2; undo collapse 0 1 / 0 1 2", UO, ATTACH),
        ("empty-after-slash", "attach 0 1 2; attach 1 2 3 / ", BO, C.OPER_ATTACH_1),
        ("vertices-not-increasing", "attach 0 1 2; attach 1 3 2 / 1 2", BO, C.OPER_ATTACH_1),
        ("vertex-negative", "attach 0 1 2; attach -1 2 3 / 1 2", BO, C.OPER_ATTACH_1),
        ("no-face-of-it", "attach 0 1 2; attach 1 2 3 / 1 4", BO, C.OPER_ATTACH_1),
        ("all-of-it", "attach 0 1 2; attach 1 2 3 / 1 2 3", BO, C.OPER_ATTACH_1),
        ("face-missing", "attach 0 1 2; attach 1 2 3 / 1 2 / 1 3", R.MISSING_SIMPLEX,
         C.OPER_ATTACH_2),
        ("face-not-told", "attach 0 1 2; attach 1 2 3 / 1", R.PRESENT_SIMPLEX, C.OPER_ATTACH_2),
        ("attached-again", "attach 0 1 2; attach 0 1 2 / 1 2", R.PRESENT_SIMPLEX,
         C.OPER_ATTACH_2),
        ("eleven-vertices", "attach 0 1 2; attach 1 2 3 4 5 6 7 8 9 10 11 / 1 2",
         R.TOO_MANY_VERTICES, C.OPER_ATTACH_1),
    )),
    ("attached-without-blanks", "attach 0 1 2;attach 1 2 3/1 2", ()),
    ("bounded", f"{EDGE}; boundary-attach 2 3 4 / 2 3", (
        ("inside", f"{EDGE}; boundary-attach 1 2 4 / 1 2", NA, C.OPER_SIMPLEX_5),
        ("of-another-dimension", f"{EDGE}; boundary-attach 2 3 4 5 / 2 3", NA, C.OPER_SIMPLEX_5),
        ("no-expansion", f"{EDGE}; euler-attach 0 3 / 0 / 3", NA, C.OPER_SIMPLEX_1),
    )),
    ("curve", f"{CURVE}; edge-between-ends 0 3", (
        ("end-is-inside", f"{CURVE}; edge-between-ends 1 3", NA, C.OPER_CURVE_4),
        ("inside-is-an-end", f"{CURVE}; edge-at-interior 0 3", NA, C.OPER_CURVE_5),
        ("edge-is-there", f"{CURVE}; edge-between-ends 2 3", R.PRESENT_SIMPLEX, C.OPER_ATTACH_2),
        ("from-a-vertex-that-is-not", f"{CURVE}; edge-and-vertex 7 4", R.MISSING_SIMPLEX,
         C.OPER_ATTACH_2),
        ("edge-to-itself", f"{CURVE}; edge-between-ends 0 0", BO, C.OPER_ATTACH_1),
        ("a-triangle-there", f"{CURVE}; attach 0 1 4 / 0 1; first-vertex 7", NA, C.OPER_CURVE_1),
    )),
    ("handles", "handle 0 1 2; handle 1 2 3 / 1 2", (
        ("inside", "handle 0 1 2; handle 1 2 3 / 1 2; handle 1 2 4 / 1 2", NA, C.OPER_SOLID_1),
        ("of-another-dimension", "handle 0 1 2; handle 1 2 3 4 / 1 2", NA, C.OPER_SOLID_1),
        ("at-a-vertex", "handle 0 1 2; handle 1 3 4 / 1", NA, C.OPER_SOLID_2),
    )),
    ("attachment-undone", f"{EDGE}; undo attach 1 2 3 / 1 2", (
        ("not-the-last", f"{EDGE}; undo attach 0 1 2", NA, C.OPER_ATTACH_3),
        ("not-there", f"{EDGE}; undo attach 2 3 4 / 2 3", R.MISSING_SIMPLEX, C.OPER_ATTACH_3),
    )),
    ("handle-undone", "handle 0 1 2; undo handle 0 1 2", (
        ("not-there", "handle 0 1 2; undo handle 0 1 3", R.MISSING_SIMPLEX, C.OPER_ATTACH_3),
        ("vertices-not-increasing", "handle 0 1 2; undo handle 0 2 1", BO, C.OPER_ATTACH_1),
        ("of-another-kind", "handle 0 1 2; undo boundary-attach 0 1 2", NA, C.OPER_SIMPLEX_5),
    )),
    ("collapsed", f"{EDGE}; collapse 0 1 / 0 1 2", (
        ("vertices-not-increasing", f"{EDGE}; collapse 1 0 / 0 1 2", BO, C.OPER_MOVE_2),
        ("vertex-negative", f"{EDGE}; collapse 0 1 / 0 1 -2", BO, MOVE),
        ("not-free", f"{EDGE}; collapse 1 2 / 0 1 2", R.NOT_FREE, C.OPER_COLLAPSE_1),
        ("not-there", f"{EDGE}; collapse 0 3 / 0 1 3", R.MISSING_SIMPLEX, C.OPER_COLLAPSE_1),
        ("two-dimensions-apart", f"{EDGE}; collapse 0 / 0 1 2", BO, C.OPER_MOVE_2),
        ("no-second-simplex", f"{EDGE}; collapse 0 1", BO, MOVE),
        ("empty-simplex", f"{EDGE}; collapse / 0 1 2", BO, MOVE),
    )),
    ("expanded", f"{EDGE}; expand 4 / 3 4", (
        ("other-end-missing", f"{EDGE}; expand 4 / 4 5", R.MISSING_SIMPLEX, C.OPER_COLLAPSE_3),
        ("is-there", f"{EDGE}; expand 2 / 2 3", R.PRESENT_SIMPLEX, C.OPER_COLLAPSE_3),
    )),
    ("subdivided", f"{EDGE}; subdivide 1 2 / 4; weld 1 2 / 4", (
        ("vertex-is-there", f"{EDGE}; subdivide 1 2 / 3; weld 1 2 / 4", R.PRESENT_SIMPLEX,
         C.OPER_STELLAR_1),
        ("simplex-is-not", f"{EDGE}; subdivide 0 3 / 4; weld 1 2 / 4", R.MISSING_SIMPLEX,
         C.OPER_STELLAR_1),
        ("weld-is-there", f"{EDGE}; subdivide 1 2 / 4; weld 1 3 / 4", R.PRESENT_SIMPLEX,
         C.OPER_STELLAR_2),
        ("weld-of-another-link", f"{EDGE}; subdivide 1 2 / 4; weld 1 5 / 4", R.WRONG_LINK,
         C.OPER_STELLAR_2),
    )),
    ("flipped", f"{EDGE}; bistellar 1 2 / 0 3", (
        ("other-link", f"{EDGE}; bistellar 1 2 / 0 4", R.WRONG_LINK, C.OPER_BISTELLAR_1),
        ("at-the-boundary", f"{EDGE}; bistellar 0 1 / 3 4", R.WRONG_LINK, C.OPER_BISTELLAR_1),
        ("edge-is-there", f"{EDGE}; bistellar 1 2 / 0 1", R.PRESENT_SIMPLEX, C.OPER_BISTELLAR_1),
        ("edge-is-not", f"{EDGE}; bistellar 0 3 / 1 2", R.MISSING_SIMPLEX, C.OPER_BISTELLAR_1),
    )),
    ("contracted", f"{EDGE}; contract 0 / 1", (
        ("pinches", f"{EDGE}; contract 1 / 2", R.LINK_CONDITION, C.OPER_CONTRACT_1),
        ("no-edge", f"{EDGE}; contract 0 / 3", R.MISSING_SIMPLEX, C.OPER_CONTRACT_1),
        ("to-itself", f"{EDGE}; contract 0 / 0", BO, C.OPER_MOVE_2),
    )),
    ("whisker", "attach 0 1 2; attach 2 3 / 2; collapse 3 / 2 3", (
        ("drawn-in", "attach 0 1 2; attach 2 3 / 2; contract 2 / 3", R.WRONG_LINK,
         C.OPER_CONTRACT_5),
    )),
    ("path-split", "attach 0 1; attach 0 2 / 0; split 0 / 3 / 1 /", (
        ("shared-as-well", "attach 0 1; attach 0 2 / 0; split 0 / 3 / 1 / 1", R.LINK_CONDITION,
         C.OPER_CONTRACT_1),
        ("nothing-moved", "attach 0 1; attach 0 2 / 0; split 0 / 3 / /", R.WRONG_LINK,
         C.OPER_CONTRACT_5),
    )),
    ("split", f"{EDGE}; split 0 / 4 / 1, 1 2 / 1", (
        ("empty-simplex-in-a-list", f"{EDGE}; split 0 / 4 / 1, / 1", BO, MOVE),
        ("around-itself", f"{EDGE}; split 0 / 4 / 0 1, 1 2 / 1", BO, C.OPER_MOVE_2),
        ("vertex-is-there", f"{EDGE}; split 0 / 3 / 1, 1 2 / 1", R.PRESENT_SIMPLEX,
         C.OPER_CONTRACT_4),
        ("vertex-is-not", f"{EDGE}; split 5 / 4 / 1, 1 2 / 1", R.MISSING_SIMPLEX,
         C.OPER_CONTRACT_4),
        ("shared-and-not-moved", f"{EDGE}; split 0 / 4 / 1 / 2", R.WRONG_LINK, C.OPER_CONTRACT_4),
        ("not-in-the-link", f"{EDGE}; split 0 / 4 / 1, 1 3 / 1", R.MISSING_SIMPLEX,
         C.OPER_CONTRACT_4),
    )),
)  # fmt: skip
"""Scripts that apply, and each with one step made wrong. Clauses: ORCL-FAULT-1, OPER-FAMILY-2."""
