"""Mistakes in the codes of words and of handle data."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

KING_ROSSIGNAC: Final = "clers.codes.king_rossignac"
LOOPS: Final = "clers.kernels.loops"
FORETELLING: Final = "clers.kernels.foretelling"
CLOSINGS: Final = "clers.codes.closings"

MUTANTS: Final = (
    Mutant(
        "codewords-swapped",
        Clause.CODE_PLAIN_1,
        "clers.codes.plain",
        '"S": "100", "R": "101"',
        '"S": "101", "R": "100"',
        "The codewords of S and R are swapped.",
    ),
    Mutant(
        "plain-goes-on",
        Clause.CODE_PLAIN_2,
        "clers.codes.plain",
        "    if at < len(digits):\n",
        "    if at < len(digits) - 7:\n",
        "A few bits after the last codeword are accepted.",
    ),
    Mutant(
        "implied-with-boundary",
        Clause.CODE_IMPLIED_1,
        "clers.codes.implied",
        'return "" if components_with_boundary else "C"',
        'return "C"',
        "The first C is implied where there is a boundary, too.",
    ),
    Mutant(
        "never-implied",
        Clause.CODE_IMPLIED_1,
        "clers.codes.implied",
        'return "" if components_with_boundary else "C"',
        'return ""',
        "The first C of a closed surface is coded.",
    ),
    Mutant(
        "golden-begins-elsewhere",
        Clause.CODE_GOLDEN_3,
        "clers.codes.golden",
        'return AFTER_C if head.endswith("C") else ELSEWHERE',
        "return ELSEWHERE",
        "The implied C is forgotten as the first context.",
    ),
    Mutant(
        "golden-tables-swapped",
        Clause.CODE_GOLDEN_1,
        "clers.codes.golden",
        "successors=((1, 0, 0, 0, 0), (1, 0, 0, 0, 0))",
        "successors=((0, 1, 1, 1, 1), (0, 1, 1, 1, 1))",
        "The tables after a C and elsewhere are swapped.",
    ),
    Mutant(
        "golden-costs-swapped",
        Clause.CODE_GOLDEN_1,
        "clers.codes.golden",
        '"L": 4, "E": 3, "R": 4, "S": 5',
        '"L": 4, "E": 5, "R": 4, "S": 3',
        "The costs of E and S are swapped.",
    ),
    Mutant(
        "context-from-the-front",
        Clause.CODE_ADAPTIVE_1,
        "clers.codes.adaptive",
        "(*self.context, symbol)[-self.order :]",
        "(symbol, *self.context)[: self.order]",
        "The symbols of a context stand in the wrong order.",
    ),
    Mutant(
        "order-off-by-one",
        Clause.CODE_ADAPTIVE_1,
        "clers.codes.adaptive",
        "(*self.context, symbol)[-self.order :]",
        "(*self.context, symbol)[-self.order - 1 :]",
        "A context remembers one symbol more than its order.",
    ),
    Mutant(
        "l-and-e-after-c",
        Clause.CODE_ADAPTIVE_1,
        "clers.codes.adaptive",
        'return AFTER_C if context[-1:] == (NUMBER["C"],) else ELSEWHERE',
        "return ELSEWHERE",
        "L and E are expected after a C.",
    ),
    Mutant(
        "huffman-by-counts",
        Clause.INFO_KRAFT_3,
        "clers.information.canonical",
        "return sorted((length, symbol) for symbol, length in enumerate(lengths)"
        " if length is not None)",
        "return sorted(((length, symbol) for symbol, length in enumerate(lengths)"
        " if length is not None), key=lambda pair: (pair[0], -pair[1]))",
        "Codewords of one length are given to the last symbol first.",
    ),
    Mutant(
        "any-huffman-table",
        Clause.CODE_HUFFMAN_3,
        "clers.codes.huffman",
        "if _lengths(symbols) != lengths:",
        "if len(_lengths(symbols)) != len(lengths):",
        "A table is accepted that is not Huffman's for these symbols.",
    ),
    Mutant(
        "last-of-shortest",
        Clause.CODE_KR_2,
        KING_ROSSIGNAC,
        "return found.index(min(found))",
        "return len(found) - 1 - found[::-1].index(min(found))",
        "Of codes that are equally short the last is chosen.",
    ),
    Mutant(
        "selector-from-1",
        Clause.CODE_KR_2,
        KING_ROSSIGNAC,
        'f"{which:0{SELECTOR}b}"',
        'f"{which + 1:0{SELECTOR}b}"',
        "The selector counts the codes from 1.",
    ),
    Mutant(
        "any-selector",
        Clause.CODE_KR_3,
        KING_ROSSIGNAC,
        "if which != chosen(found, shape.head):",
        "if which < 0:",
        "A code that is not the shortest is accepted.",
    ),
    Mutant(
        "fourth-code",
        Clause.CODE_KR_3,
        KING_ROSSIGNAC,
        "which = int(digits[:SELECTOR], 2)\n    if which >= len(OTHERWISE):",
        "which = min(int(digits[:SELECTOR], 2), 2)\n    if which >= len(OTHERWISE):",
        "The selector 11 is read as 10.",
    ),
    Mutant(
        "valence-lost-at-split",
        Clause.CODE_CONTEXT_2,
        LOOPS,
        "self.count[q] += self.count[e] + 1",
        "self.count[q] += 1",
        "Where an S joins loops, the triangles at one end of its gate are forgotten.",
    ),
    Mutant(
        "valence-of-creation",
        Clause.CODE_CONTEXT_4,
        LOOPS,
        "valence: i64 = self.count[e] + 1",
        "valence: i64 = self.count[e]",
        "The triangle of a C is not counted at the vertex that leaves.",
    ),
    Mutant(
        "weight-rounded-down",
        Clause.CODE_CONTEXT_7,
        FORETELLING,
        " * error + HALF) >> 15",
        " * error) >> 15",
        "A weight learns rounded down.",
    ),
    Mutant(
        "history-of-eleven",
        Clause.CODE_CONTEXT_4,
        FORETELLING,
        "HISTORY: Final = 2176782336",
        "HISTORY: Final = 362797056",
        "One symbol less is remembered.",
    ),
    Mutant(
        "split-foretold",
        Clause.CODE_CONTEXT_3,
        FORETELLING,
        "if decision == 3 and not self.loops.can_split():",
        "if decision == 3 and self.loops.height < 2:",
        "Whether an S is possible is asked of the stack alone.",
    ),
    Mutant(
        "counts-to-sixteen",
        Clause.CODE_CONTEXT_4,
        LOOPS,
        "MOST: Final = 15",
        "MOST: Final = 16",
        "Counts are seen up to 16.",
    ),
    Mutant(
        "minimax-begins-at-start",
        Clause.CODE_MINIMAX_4,
        "clers.codes.minimax",
        "return begin.after(NUMBER[head]) if head else begin",
        "return begin",
        "The implied C does not lead to its context.",
    ),
    Mutant(
        "urn-refilled",
        Clause.CODE_ENUM_2,
        "clers.kernels.urn",
        """\
            ones -= 1
        else:
            if zeros == 0:
                return i
            to.narrow(0, zeros, total)
            zeros -= 1
""",
        """\
        else:
            if zeros == 0:
                return i
            to.narrow(0, zeros, total)
""",
        "What the encoder draws from the urn is put back.",
    ),
    Mutant(
        "tree-walked-from-edge",
        Clause.CODE_TREE_4,
        "clers.codes.enumerative",
        "tree_word(surface)[len(FRONT) : -len(BACK)]",
        "tree_word(surface)[len(BACK) - 1 : -len(FRONT) - 1]",
        "The known bits are cut off one place too early.",
    ),
    Mutant(
        "best-selectors-swapped",
        Clause.CODE_BEST_1,
        "clers.codes.best",
        """\
    Candidate("101", golden.CODE, _least_golden),
    Candidate("110", king_rossignac.CODE, _least_king_rossignac),
""",
        """\
    Candidate("110", golden.CODE, _least_golden),
    Candidate("101", king_rossignac.CODE, _least_king_rossignac),
""",
        "The selectors of two codes are swapped.",
    ),
    Mutant(
        "not-the-best",
        Clause.CODE_BEST_2,
        "clers.codes.best",
        "if again.selector != candidate.selector:",
        'if again.selector == "":',
        "A code that is not the shortest is accepted.",
    ),
    Mutant(
        "between-from-other-end",
        Clause.CODE_HAND_1,
        CLOSINGS,
        "between = len(places) - 1 - places[record.at]",
        "between = places[record.at]",
        "Edges between an S and its closing edge are counted from the end of the word.",
    ),
    Mutant(
        "passed-not-reset",
        Clause.CODE_HAND_1,
        CLOSINGS,
        """\
                found.append(Closing(passed, record.kind, record.side, between))
                passed = 0
""",
        """\
                found.append(Closing(passed, record.kind, record.side, between))
""",
        "S without record are counted from the end of the word.",
    ),
    Mutant(
        "kinds-swapped",
        Clause.CODE_HAND_4,
        "clers.codes.handle_data",
        "(Kind.HANDLE, Kind.BOUNDARY)",
        "(Kind.BOUNDARY, Kind.HANDLE)",
        "The numbers of the two kinds of records are swapped.",
    ),
    Mutant(
        "sides-swapped-in-bits",
        Clause.CODE_HAND_4,
        "clers.codes.handle_data",
        "(Side.RIGHT, Side.LEFT)",
        "(Side.LEFT, Side.RIGHT)",
        "The numbers of the two sides are swapped.",
    ),
    Mutant(
        "sizes-too-few",
        Clause.CODE_HAND_4,
        "clers.codes.handle_data",
        "return max(1, symbols.bit_length())",
        "return max(1, (symbols - 1).bit_length())",
        "The largest size of a number is not thought of.",
    ),
)
