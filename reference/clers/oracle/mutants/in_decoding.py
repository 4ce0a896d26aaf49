"""Mistakes in reading a word and its handle data."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

GLUING: Final = "clers.kernels.gluing"
LABEL: Final = "clers.edgebreaker.label"
NAMING: Final = "clers.kernels.naming"
SCAN: Final = "clers.kernels.scan"

MUTANTS: Final = (
    Mutant(
        "record-opens-a-branch",
        Clause.EB_GRAMMAR_3,
        SCAN,
        """\
                if not has_records or self.record_of[i] < 0:
                    depth += 1
""",
        """\
                depth += 1
""",
        "An S with a record counts as one that keeps its left gate.",
    ),
    Mutant(
        "one-component-too-many-open",
        Clause.EB_COMPONENT_3,
        "clers.edgebreaker.scanning",
        "_within(stream.components_with_boundary)",
        "_within(stream.components_with_boundary + 1)",
        "One component more than declared is read as one with boundary.",
    ),
    Mutant(
        "too-few-components-accepted",
        Clause.EB_GRAMMAR_3,
        SCAN,
        "if self.with_boundary < 0 or self.with_boundary > self.components:",
        "if self.with_boundary < 0:",
        "More components with boundary may be declared than there are.",
    ),
    Mutant(
        "records-in-any-order",
        Clause.EB_GRAMMAR_2,
        SCAN,
        "if s[r - 1] >= s[r]:",
        "if s[r - 1] == s[r]:",
        "Records are accepted in any order.",
    ),
    Mutant(
        "negative-split-accepted",
        Clause.EB_GRAMMAR_2,
        SCAN,
        "if s[r] < 0 or s[r] >= splits:",
        "if s[r] >= splits:",
        "A negative number of an S counts from the end.",
    ),
    Mutant(
        "negative-closer-accepted",
        Clause.EB_GRAMMAR_4,
        SCAN,
        "if at < 0 or at >= len(closers):",
        "if at >= len(closers):",
        "A negative number of a closing symbol counts from the end.",
    ),
    Mutant(
        "closers-of-r-and-l",
        Clause.EB_HANDLE_3,
        SCAN,
        "if x in (R, L, E):",
        "if x in (R, L):",
        "E is not counted among the closing symbols.",
    ),
    Mutant(
        "other-edge-glued",
        Clause.EB_HANDLE_4,
        SCAN,
        "edge: i64 = 3 * face_of[i] + 1 + left",
        "edge: i64 = 3 * face_of[i] + 2 - left",
        "The other edge of the closing triangle is glued.",
    ),
    Mutant(
        "empty-word-not-refused",
        Clause.EB_GRAMMAR_1,
        SCAN,
        "        if n == 0:\n",
        "        if n == 0 and len(self.records.s) > 0:\n",
        "The empty word is not thought of.",
    ),
    Mutant(
        "unknown-letter-passed-over",
        Clause.EB_GRAMMAR_1,
        SCAN,
        "                return self.blame(UNKNOWN, i, 0)\n",
        """\
                self.word = bytes(y for y in word if y in b"CRLES")
                return True
""",
        "Any other letter is passed over.",
    ),
    Mutant(
        "rest-of-word-ignored",
        Clause.EB_GRAMMAR_3,
        SCAN,
        "        if start < n:\n",
        "        if start < n and self.components == 0:\n",
        "What follows the last whole component is ignored.",
    ),
    Mutant(
        "outer-triangle-turned",
        Clause.EB_REVERSI_3,
        GLUING,
        """\
            opposite[root + 2] = second
            opposite[second] = root + 2
            opposite[root + 1] = third
            opposite[third] = root + 1
""",
        """\
            opposite[root + 1] = second
            opposite[second] = root + 1
            opposite[root + 2] = third
            opposite[third] = root + 2
""",
        "The last loop is glued to the first triangle in the wrong turn.",
    ),
    Mutant(
        "first-curve-of-two",
        Clause.EB_GRAMMAR_8,
        GLUING,
        "            if length < 3:\n",
        "            if length < 2:\n",
        "A first boundary curve of two edges is accepted.",
    ),
    Mutant(
        "later-curve-of-two",
        Clause.EB_GRAMMAR_7,
        GLUING,
        "return length >= 3 or",
        "return length >= 2 or",
        "A later boundary curve of two edges is accepted.",
    ),
    Mutant(
        "split-edges-swapped",
        Clause.EB_REVERSI_2,
        GLUING,
        """\
        self.opposite[gate + 1] = right
        self.opposite[right] = gate + 1
        self.opposite[gate + 2] = left
        self.opposite[left] = gate + 2
""",
        """\
        self.opposite[gate + 2] = right
        self.opposite[right] = gate + 2
        self.opposite[gate + 1] = left
        self.opposite[left] = gate + 1
""",
        "The triangle of an S is glued the wrong way round.",
    ),
    Mutant(
        "end-forgets-gate",
        Clause.EB_REVERSI_2,
        GLUING,
        """\
                after[gate] = right
                after[right] = left
                after[left] = gate
                before[right] = gate
                before[left] = right
                before[gate] = left
""",
        """\
                after[gate] = left
                after[right] = gate
                after[left] = right
                before[right] = left
                before[left] = gate
                before[gate] = right
""",
        "The loop of an E runs backwards.",
    ),
    Mutant(
        "later-curve-from-next",
        Clause.EB_ORDER_2,
        NAMING,
        "                    naming.curve(tip)\n",
        """\
                    first = outgoing(opposite, tip)
                    naming.curve(first - 2 if first % 3 == 2 else first + 1)
""",
        "A curve is named from the vertex after the apex on.",
    ),
    Mutant(
        "first-curve-from-next",
        Clause.EB_COMPONENT_1,
        NAMING,
        "naming.curve(tip + 1)",
        "naming.curve(tip + 2)",
        "The first curve is named from the right end of its gate on.",
    ),
    Mutant(
        "root-named-backwards",
        Clause.EB_ORDER_1,
        NAMING,
        "            naming.name(root + 1)\n            naming.name(root + 2)\n",
        "            naming.name(root + 2)\n            naming.name(root + 1)\n",
        "The vertices of the first triangle are named in another order.",
    ),
    Mutant(
        "creation-not-named",
        Clause.EB_ORDER_1,
        NAMING,
        """\
            if x == C:
                naming.name(tip)
""",
        """\
            if x == C:
                pass
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
