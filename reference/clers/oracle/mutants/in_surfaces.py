"""Mistakes in what is a surface, and in what is counted of one."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

TABLE: Final = "clers.complexes.corner_table"
MATCHING: Final = "clers.complexes.matching"
TOPOLOGY: Final = "clers.complexes.topology"

MUTANTS: Final = (
    Mutant(
        "isolated-vertex-accepted",
        Clause.CPLX_REJECT_9,
        TABLE,
        "if fans_at == 0:",
        "if fans_at < 0:",
        "A vertex that no face names is accepted.",
    ),
    Mutant(
        "pinched-vertex-accepted",
        Clause.CPLX_REJECT_8,
        TABLE,
        "if fans_at > 1:",
        "if fans_at > 2:",
        "A vertex with two fans is accepted.",
    ),
    Mutant(
        "orientation-conflict-accepted",
        Clause.CPLX_REJECT_7,
        TABLE,
        "if BORDER < d < c and tails[c] == tails[d]:",
        "if BORDER < d < c and tails[c] == heads[c]:",
        "Faces that disagree about their orientation are accepted.",
    ),
    Mutant(
        "duplicate-face-accepted",
        Clause.CPLX_REJECT_5,
        MATCHING,
        "if doubled or third < len(tips):",
        "if third < len(tips):",
        "Two faces on the same three vertices are accepted.",
    ),
    Mutant(
        "degenerate-face-accepted",
        Clause.CPLX_REJECT_4,
        MATCHING,
        "if a in (b, c) or b == c:",
        "if a in (b, c):",
        "A face whose last two vertices are one is accepted.",
    ),
    Mutant(
        "third-face-ignored",
        Clause.CPLX_REJECT_6,
        MATCHING,
        """\
        elif len(group) > 2:
            third = min(third, group[2])
""",
        """\
        elif len(group) > 2:
            c, d = group[:2]
            mate[c], mate[d] = d, c
""",
        "The third face at an edge is passed over.",
    ),
    Mutant(
        "index-of-count",
        Clause.CPLX_REJECT_3,
        MATCHING,
        "0 <= a < count and",
        "0 <= a <= count and",
        "A vertex number just past the last is not refused.",
    ),
    Mutant(
        "negative-index",
        Clause.CPLX_REJECT_3,
        MATCHING,
        "and 0 <= c < count",
        "and c < count",
        "A negative vertex number is not refused.",
    ),
    Mutant(
        "empty-mesh-accepted",
        Clause.CPLX_REJECT_1,
        MATCHING,
        "    if not given.faces:\n",
        "    if given.vertices < 0:\n",
        "A mesh without faces is not thought of.",
    ),
    Mutant(
        "genus-without-curves",
        Clause.CPLX_COMPONENT_3,
        TOPOLOGY,
        "genus = (2 - loops - euler) // 2",
        "genus = (2 - euler) // 2",
        "The genus does not know of boundary curves.",
    ),
    Mutant(
        "border-edges-uncounted",
        Clause.CPLX_COMPONENT_2,
        TOPOLOGY,
        "edges = (3 * faces + border) // 2",
        "edges = 3 * faces // 2",
        "Edges on the border are counted as halves.",
    ),
    Mutant(
        "curves-merged",
        Clause.CPLX_CURVE_1,
        TOPOLOGY,
        "        loops[number[curve.corners[0] // 3]] += 1\n",
        "        loops[number[curve.corners[0] // 3]] = 1\n",
        "All boundary curves of a component count as one.",
    ),
    Mutant(
        "components-merged",
        Clause.CPLX_COMPONENT_1,
        TOPOLOGY,
        "        count += 1\n    return tuple(number)",
        "        count = 1\n    return tuple(number)",
        "All components but the first count as one.",
    ),
    Mutant(
        "components-by-last-face",
        Clause.CPLX_COMPONENT_1,
        TOPOLOGY,
        "_component(lowest[k], faces[k], vertices[k], border[k], loops[k]) for k in range(count)",
        "_component(lowest[k], faces[k], vertices[k], border[k], loops[k])\n"
        "        for k in reversed(range(count))",
        "Components are listed from the last one.",
    ),
)
