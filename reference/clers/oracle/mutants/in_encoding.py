"""Mistakes in the walk that writes the word."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

ENCODE: Final = "clers.edgebreaker.encode"

MUTANTS: Final = (
    Mutant(
        "mirrored-letters",
        Clause.EB_TRAVERSE_3,
        ENCODE,
        """\
                self.word.append("R")
                gate = left_gate
            elif not right_closed:
                self.word.append("L")
""",
        """\
                self.word.append("L")
                gate = left_gate
            elif not right_closed:
                self.word.append("R")
""",
        "R and L are swapped.",
    ),
    Mutant(
        "mirrored-walk",
        Clause.EB_TRAVERSE_2,
        ENCODE,
        """\
                gate = right_gate
                continue
            right_closed""",
        """\
                gate = left_gate
                continue
            right_closed""",
        "After a C the walk goes on at the left gate.",
    ),
    Mutant(
        "split-mirrored",
        Clause.EB_TRAVERSE_6,
        ENCODE,
        """\
                stack.append(left_gate)
                gate = right_gate
""",
        """\
                stack.append(right_gate)
                gate = left_gate
""",
        "An S keeps its right gate and goes on at the left one.",
    ),
    Mutant(
        "stack-is-queue",
        Clause.EB_TRAVERSE_5,
        ENCODE,
        "gate = stack.pop()\n",
        "gate = stack.pop(0)\n",
        "An E takes the oldest gate, not the newest.",
    ),
    Mutant(
        "visited-gate-popped",
        Clause.EB_TRAVERSE_5,
        ENCODE,
        "while stack and visited[stack[-1] // 3]:",
        "while stack and False:",
        "An E goes on at a gate whose triangle was visited since.",
    ),
    Mutant(
        "one-visited-gate-popped",
        Clause.EB_TRAVERSE_5,
        ENCODE,
        "while stack and visited[stack[-1] // 3]:",
        "if stack and visited[stack[-1] // 3]:",
        "An E passes over one visited gate, and not over the next.",
    ),
    Mutant(
        "boundary-vertex-created",
        Clause.EB_COMPONENT_4,
        ENCODE,
        "if not (marked[v] or on_curve[v]):",
        "if not marked[v]:",
        "A vertex on a curve that was not reached yet is created by a C.",
    ),
    Mutant(
        "creation-not-marked",
        Clause.EB_TRAVERSE_2,
        ENCODE,
        """\
                marked[v] = 1
                self.vertex_order""",
        "                self.vertex_order",
        "A C does not mark its apex.",
    ),
    Mutant(
        "curve-not-marked",
        Clause.EB_TRAVERSE_7,
        ENCODE,
        """\
            v = self.surface.vertex[c]
            self.marked[v] = 1
""",
        "            v = self.surface.vertex[c]\n",
        "The vertices of a curve that was reached are not marked.",
    ),
    Mutant(
        "root-not-marked",
        Clause.EB_COMPONENT_2,
        ENCODE,
        """\
        for v in self.surface.vertex[corner : corner + 3]:
            self.marked[v] = 1
""",
        "        for v in self.surface.vertex[corner : corner + 3]:\n",
        "The vertices of the first triangle are not marked.",
    ),
    Mutant(
        "wrong-start-gate",
        Clause.EB_COMPONENT_2,
        ENCODE,
        "walk.traverse(surface.opposite[3 * t])",
        "walk.traverse(surface.opposite[3 * t + 1])",
        "A closed component is entered across the wrong edge of its first triangle.",
    ),
    Mutant(
        "first-curve-from-other-end",
        Clause.EB_COMPONENT_1,
        ENCODE,
        "walk.reach_curve(next_corner(corner))",
        "walk.reach_curve(previous_corner(corner))",
        "The first curve is listed from the other end of the gate.",
    ),
    Mutant(
        "curve-run-backwards",
        Clause.EB_ORDER_2,
        ENCODE,
        "for c in border_from(self.surface.opposite, corner):",
        "for c in reversed(list(border_from(self.surface.opposite, corner))):",
        "The vertices of a curve are listed against its direction.",
    ),
    Mutant(
        "splits-counted-from-1",
        Clause.EB_HANDLE_3,
        ENCODE,
        "Record(kind, s, self.closers, side)",
        "Record(kind, s + 1, self.closers, side)",
        "The S of a record is counted from 1.",
    ),
    Mutant(
        "closing-symbol-counted",
        Clause.EB_HANDLE_3,
        ENCODE,
        "Record(kind, s, self.closers, side)",
        "Record(kind, s, self.closers + 1, side)",
        "The closing symbol counts itself.",
    ),
    Mutant(
        "closers-of-the-component",
        Clause.EB_HANDLE_3,
        ENCODE,
        "        stack: list[Corner] = []\n",
        "        stack: list[Corner] = []\n        self.closers = 0\n",
        "Closing symbols are counted anew in each component.",
    ),
    Mutant(
        "every-record-a-handle",
        Clause.EB_HANDLE_2,
        ENCODE,
        "Kind.BOUNDARY if s in self.reached_curve else Kind.HANDLE",
        "Kind.HANDLE",
        "That an S reached a curve is forgotten where it is closed.",
    ),
    Mutant(
        "next-split-reached-curve",
        Clause.EB_HANDLE_2,
        ENCODE,
        "self.reached_curve.add(len(self.left_of))",
        "self.reached_curve.add(len(self.left_of) + 1)",
        "The S after the one that reached a curve is taken for it.",
    ),
    Mutant(
        "closing-sides-swapped",
        Clause.EB_HANDLE_4,
        ENCODE,
        """\
                self.close(right, Side.RIGHT)
            if left_closed:
                self.close(left, Side.LEFT)
""",
        """\
                self.close(right, Side.LEFT)
            if left_closed:
                self.close(left, Side.RIGHT)
""",
        "The sides of records are swapped.",
    ),
    Mutant(
        "records-as-closed",
        Clause.EB_HANDLE_5,
        ENCODE,
        "for s in sorted(walk.records)",
        "for s in walk.records",
        "Records are written in the order in which they were closed.",
    ),
    Mutant(
        "left-of-end-not-closed",
        Clause.EB_HANDLE_4,
        ENCODE,
        "            if left_closed:\n                self.close(left",
        "            if left_closed and not right_closed:\n                self.close(left",
        "An E closes with its right edge only.",
    ),
    Mutant(
        "closed-components-first",
        Clause.EB_COMPONENT_1,
        ENCODE,
        """\
    walk = _Walk(surface)
""",
        """\
    walk = _Walk(surface)
    from clers.complexes.topology import component_of_faces

    number = component_of_faces(surface)
    open_parts = {number[c // 3] for c, d in enumerate(surface.opposite) if d == BORDER}
    for t in range(surface.faces):
        if number[t] not in open_parts and not walk.visited[t]:
            walk.visit_root(Corner(3 * t))
            walk.traverse(surface.opposite[3 * t])
""",
        "Closed components are written before those with boundary.",
    ),
    Mutant(
        "curves-counted",
        Clause.EB_COMPONENT_1,
        ENCODE,
        'stream = Stream("".join(walk.word), records, with_boundary)',
        'stream = Stream("".join(walk.word), records, with_boundary + len(walk.reached_curve))',
        "Boundary curves are counted in place of components with boundary.",
    ),
    Mutant(
        "border-turned-the-wrong-way",
        Clause.CPLX_CURVE_1,
        "clers.complexes.border",
        "c = outgoing_border(opposite, next_corner(c))",
        "c = outgoing_border(opposite, previous_corner(c))",
        "From a border edge one goes on at the vertex where it begins.",
    ),
    Mutant(
        "gate-of-trace-turned",
        Clause.EB_TRACE_1,
        "clers.edgebreaker.trace",
        "(v, a, b), (a, b), len(stack)",
        "(v, a, b), (b, a), len(stack)",
        "The trace runs the gate from right to left.",
    ),
    Mutant(
        "stack-of-trace-too-deep",
        Clause.EB_TRACE_1,
        "clers.edgebreaker.trace",
        "while stack and stack.pop() >= 0:",
        "if stack and stack.pop() >= 0:",
        "The trace keeps gates on its stack that were passed over.",
    ),
)
