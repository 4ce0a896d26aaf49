"""Mistakes in operators on surfaces, sheets and complexes, and in how scripts are read."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

SUBDIVIDE: Final = "clers.operators.subdivide"
BORDER: Final = "clers.operators.border"
TUBE: Final = "clers.operators.tube"
MAKE: Final = "clers.operators.sheets.make"
KILL: Final = "clers.operators.sheets.kill"

MUTANTS: Final = (
    Mutant(
        "flip-onto-edge",
        Clause.OPER_REFINE_3,
        SUBDIVIDE,
        "    if joined(of, w, x):\n",
        "    if joined(of, w, w):\n",
        "An edge is flipped though its other diagonal is an edge already.",
    ),
    Mutant(
        "split-of-one-side",
        Clause.OPER_REFINE_2,
        SUBDIVIDE,
        "for u, v in ((tail, head), (head, tail)):",
        "for u, v in ((tail, head),):",
        "Splitting an edge forgets the face across.",
    ),
    Mutant(
        "corner-of-joined-ends",
        Clause.OPER_BORDER_2,
        BORDER,
        "        if joined(of, a, c):\n",
        "        if joined(of, a, a):\n",
        "A corner is filled though its ends are joined already.",
    ),
    Mutant(
        "removal-pinches",
        Clause.OPER_BORDER_5,
        BORDER,
        "        if kept & on_border:\n",
        "        if kept > on_border:\n",
        "A face is removed though that pinches a vertex.",
    ),
    Mutant(
        "opening-at-border",
        Clause.OPER_BORDER_4,
        BORDER,
        "if not on_border.intersection(room.inner)",
        "if not on_border.issuperset(room.inner)",
        "A curve is opened where another one is.",
    ),
    Mutant(
        "cut-of-one-end",
        Clause.OPER_BORDER_7,
        BORDER,
        "    for end in ends:\n",
        "    for end in ends[:1]:\n",
        "A cut opens one end on the border and not the other.",
    ),
    Mutant(
        "star-at-border",
        Clause.OPER_BORDER_6,
        BORDER,
        "    if any(on_border.intersection(face) for face in star):\n",
        "    if all(on_border.intersection(face) for face in star):\n",
        "A star is removed though it meets the border.",
    ),
    Mutant(
        "handle-between-components",
        Clause.OPER_TUBE_3,
        TUBE,
        "(lowest == component[t]) == same_component",
        "(lowest <= component[t]) == same_component",
        "A handle is put between two components.",
    ),
    Mutant(
        "bridge-onto-edge",
        Clause.OPER_TUBE_5,
        TUBE,
        "if joined(of, a, d) or joined(of, b, d) or joined(of, b, c):",
        "if joined(of, a, d) or joined(of, b, d):",
        "A bridge is built onto an edge that is there.",
    ),
    Mutant(
        "tube-turned-over",
        Clause.OPER_TUBE_3,
        TUBE,
        "((a[i], a[j], c[j]), (a[i], c[j], c[i]))",
        "((a[j], a[i], c[j]), (a[i], c[j], c[i]))",
        "Half the faces of a tube are turned over.",
    ),
    Mutant(
        "upper-handle-joins",
        Clause.OPER_SURFACE_6,
        MAKE,
        "if (part[a] == part[c]) == isinstance(operator, Join):",
        "if (part[a] == part[c]) and isinstance(operator, Join):",
        "An upper 1-handle joins two components.",
    ),
    Mutant(
        "lower-handle-anywhere",
        Clause.OPER_SURFACE_5,
        MAKE,
        "if one_loop != isinstance(operator, Lower):",
        "if one_loop and not isinstance(operator, Lower):",
        "A lower 1-handle takes a corner of another loop.",
    ),
    Mutant(
        "complete-onto-edge",
        Clause.OPER_EULER_3,
        MAKE,
        "    bad = there_already(clause, sheet, ((a, c),))\n"
        "    return bad or changed(sheet, (a, b, c), (past_next",
        "    bad = there_already(clause, sheet, ())\n"
        "    return bad or changed(sheet, (a, b, c), (past_next",
        "A corner is completed though its ends are joined already.",
    ),
    Mutant(
        "other-side-closed",
        Clause.OPER_EULER_4,
        MAKE,
        "    if turned((c, b, a)) in sheet.triangles:\n",
        "    if turned((c, b, a)) in sheet.loops:\n",
        "A loop is closed though its other side is a triangle.",
    ),
    Mutant(
        "cut-keeps-too-much",
        Clause.OPER_SURFACE_5,
        "clers.operators.sheets.surgery",
        "(loop[at], *loop[1:at])",
        "(loop[at], *loop[2:at])",
        "A loop loses a vertex where a lower 1-handle cuts it.",
    ),
    Mutant(
        "joined-backwards",
        Clause.OPER_SURFACE_4,
        "clers.operators.sheets.surgery",
        "return (other[0], b, *rest, a, *other)",
        "return (other[0], b, *rest, a, other[0], *other[:0:-1])",
        "Two loops are joined with one of them turned over.",
    ),
    Mutant(
        "undone-elsewhere",
        Clause.OPER_SHEET_6,
        KILL,
        """\
    if turned(around) not in sheet.loops:
        return refused(clause, simplex(*triangle), "not a component by itself")
""",
        "",
        "A first triangle is undone though more is glued to it.",
    ),
    Mutant(
        "genus-of-one-component",
        Clause.OPER_SHEET_3,
        "clers.operators.sheets.numbers",
        "(2 * parts - euler - loops) // 2",
        "(2 - euler - loops) // 2",
        "The genus of a sheet does not know of components.",
    ),
    Mutant(
        "collapse-of-any-face",
        Clause.OPER_COLLAPSE_1,
        "clers.operators.moves.collapse",
        "    if other is not None:\n",
        "    if other is None:\n        return missing(k, [pair[0]], Clause.OPER_COLLAPSE_1)"
        " or Accepted(Complex(k.simplices - set(pair)))\n    if len(other) > len(pair[1]):\n",
        "A simplex is collapsed that has two cofaces.",
    ),
    Mutant(
        "link-condition-forgotten",
        Clause.OPER_CONTRACT_1,
        "clers.operators.moves.contract",
        "    if not odd:\n",
        "    if all(top not in simplex for simplex in odd):\n",
        "The link condition is asked at the boundary only.",
    ),
    Mutant(
        "pinched-contraction",
        Clause.OPER_CONTRACT_1,
        "clers.operators.moves.contract",
        "    whole, top = coned(k)\n",
        "    whole, top = k, coned(k)[1]\n",
        "The link condition does not know of the boundary.",
    ),
    Mutant(
        "any-link-welded",
        Clause.OPER_STELLAR_2,
        "clers.operators.moves.stellar",
        "    if odd is not None:\n",
        "    if odd == frozenset():\n",
        "A vertex is welded whatever its link is.",
    ),
    Mutant(
        "attached-over",
        Clause.OPER_ATTACH_2,
        "clers.operators.attachments.attachment",
        "    if there:\n",
        "    if len(there) > len(new):\n",
        "What is attached may be there already.",
    ),
    Mutant(
        "detached-from-below",
        Clause.OPER_ATTACH_3,
        "clers.operators.attachments.attachment",
        "    if held:\n",
        "    if held > gone:\n",
        "A simplex is taken off from under another.",
    ),
    Mutant(
        "number-with-leading-zero",
        Clause.OPER_SCRIPT_6,
        "clers.operators.script_text",
        'r"0|-?[1-9][0-9]{0,999}"',
        'r"-?[0-9]{1,1000}"',
        "Numbers with zeros in front are accepted.",
    ),
    Mutant(
        "lines-not-ended",
        Clause.OPER_SCRIPT_6,
        "clers.operators.lines",
        'r"[;\\r\\n]"',
        'r"[;]"',
        "A line end does not end an operator.",
    ),
)
