"""Mistakes in reading a word and its handle data."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

LABEL: Final = "clers.edgebreaker.label"
OUTLINE: Final = "clers.edgebreaker.outline"
REVERSI: Final = "clers.edgebreaker.reversi"

MUTANTS: Final = (
    Mutant(
        "record-opens-a-branch",
        Clause.EB_GRAMMAR_3,
        OUTLINE,
        "depth += record_of[i] < 0",
        "depth += 1",
        "An S with a record counts as one that keeps its left gate.",
    ),
    Mutant(
        "one-component-too-many-open",
        Clause.EB_COMPONENT_3,
        OUTLINE,
        "closed = len(parts) >= stream.components_with_boundary",
        "closed = len(parts) > stream.components_with_boundary",
        "One component more than declared is read as one with boundary.",
    ),
    Mutant(
        "too-few-components-accepted",
        Clause.EB_GRAMMAR_3,
        OUTLINE,
        "if not 0 <= stream.components_with_boundary <= len(parts):",
        "if not 0 <= stream.components_with_boundary:",
        "More components with boundary may be declared than there are.",
    ),
    Mutant(
        "records-in-any-order",
        Clause.EB_GRAMMAR_2,
        OUTLINE,
        "if before.s >= record.s:",
        "if before.s == record.s:",
        "Records are accepted in any order.",
    ),
    Mutant(
        "negative-split-accepted",
        Clause.EB_GRAMMAR_2,
        OUTLINE,
        "if not 0 <= record.s < len(splits):",
        "if not record.s < len(splits):",
        "A negative number of an S counts from the end.",
    ),
    Mutant(
        "negative-closer-accepted",
        Clause.EB_GRAMMAR_4,
        OUTLINE,
        "if not 0 <= record.at < len(closers):",
        "if not record.at < len(closers):",
        "A negative number of a closing symbol counts from the end.",
    ),
    Mutant(
        "closers-of-r-and-l",
        Clause.EB_HANDLE_3,
        OUTLINE,
        'closers = [i for i, x in enumerate(stream.word) if x in "RLE"]',
        'closers = [i for i, x in enumerate(stream.word) if x in "RL"]',
        "E is not counted among the closing symbols.",
    ),
    Mutant(
        "other-edge-glued",
        Clause.EB_HANDLE_4,
        OUTLINE,
        "edge = 3 * face[i] + (1 if record.side is Side.RIGHT else 2)",
        "edge = 3 * face[i] + (2 if record.side is Side.RIGHT else 1)",
        "The other edge of the closing triangle is glued.",
    ),
    Mutant(
        "empty-word-not-refused",
        Clause.EB_GRAMMAR_1,
        OUTLINE,
        "    if not word:\n",
        "    if not word and stream.records:\n",
        "The empty word is not thought of.",
    ),
    Mutant(
        "unknown-letter-is-split",
        Clause.EB_GRAMMAR_1,
        OUTLINE,
        "    if stranger is not None:\n",
        "    if stranger is not None and word[stranger] in SYMBOLS:\n",
        "Any other letter is read as an S.",
    ),
    Mutant(
        "rest-of-word-ignored",
        Clause.EB_GRAMMAR_3,
        OUTLINE,
        "    if start < len(stream.word):\n",
        "    if start < len(stream.word) and not parts:\n",
        "What follows the last whole component is ignored.",
    ),
    Mutant(
        "outer-triangle-turned",
        Clause.EB_REVERSI_3,
        REVERSI,
        "zip(loop, (0, 2, 1), strict=True)",
        "zip(loop, (0, 1, 2), strict=True)",
        "The last loop is glued to the first triangle in the wrong turn.",
    ),
    Mutant(
        "long-last-loop",
        Clause.EB_GRAMMAR_8,
        REVERSI,
        "            if len(loop) != TRIANGLE:\n",
        "            if len(loop) < TRIANGLE:\n",
        "The last loop of a closed component may be longer than three.",
    ),
    Mutant(
        "first-curve-of-two",
        Clause.EB_GRAMMAR_8,
        REVERSI,
        "            if len(loop) < TRIANGLE:\n",
        "            if len(loop) < 2:\n",
        "A first boundary curve of two edges is accepted.",
    ),
    Mutant(
        "later-curve-of-two",
        Clause.EB_GRAMMAR_7,
        REVERSI,
        "        if length < TRIANGLE:\n",
        "        if length < 2:\n",
        "A later boundary curve of two edges is accepted.",
    ),
    Mutant(
        "split-edges-swapped",
        Clause.EB_REVERSI_2,
        REVERSI,
        """\
        self.glue(gate + 1, right)
        self.glue(gate + 2, left)
""",
        """\
        self.glue(gate + 2, right)
        self.glue(gate + 1, left)
""",
        "The triangle of an S is glued the wrong way round.",
    ),
    Mutant(
        "end-forgets-gate",
        Clause.EB_REVERSI_2,
        REVERSI,
        "after[gate], after[right], after[left] = right, left, gate",
        "after[gate], after[right], after[left] = left, gate, right",
        "The loop of an E runs backwards.",
    ),
    Mutant(
        "later-curve-from-next",
        Clause.EB_ORDER_2,
        LABEL,
        "                yield from border_from(opposite, tip)",
        "                found = list(border_from(opposite, tip))\n"
        "                yield from (*found[1:], found[0])",
        "A curve is named from the vertex after the apex on.",
    ),
    Mutant(
        "first-curve-from-next",
        Clause.EB_COMPONENT_1,
        LABEL,
        "Corner(3 * part.first + 1)",
        "Corner(3 * part.first + 2)",
        "The first curve is named from the right end of its gate on.",
    ),
    Mutant(
        "root-named-backwards",
        Clause.EB_ORDER_1,
        LABEL,
        "(Corner(3 * part.face + i) for i in range(3))",
        "(Corner(3 * part.face + i) for i in (0, 2, 1))",
        "The vertices of the first triangle are named in another order.",
    ),
    Mutant(
        "creation-not-named",
        Clause.EB_ORDER_1,
        LABEL,
        """\
            if word[i] == "C":
                yield tip
""",
        """\
            if word[i] == "C":
                continue
""",
        "The vertex that a C makes gets no name.",
    ),
    Mutant(
        "double-edge-accepted",
        Clause.EB_GRAMMAR_9,
        LABEL,
        "            repeated = reason is Reason.REPEATED_INDEX\n",
        "            repeated = reason is Reason.REPEATED_INDEX\n"
        "            if not repeated:\n                return Accepted(glued)\n",
        "Two edges on the same two vertices are accepted.",
    ),
    Mutant(
        "repeated-vertex-accepted",
        Clause.EB_GRAMMAR_9,
        LABEL,
        "            repeated = reason is Reason.REPEATED_INDEX\n",
        "            repeated = reason is Reason.REPEATED_INDEX\n"
        "            if repeated:\n                return Accepted(glued)\n",
        "A triangle with a vertex twice is accepted.",
    ),
)
