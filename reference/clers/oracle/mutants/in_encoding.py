"""Mistakes in the walk that writes the word."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

ENCODE: Final = "clers.edgebreaker.encode"
WALK: Final = "clers.kernels.walk"

MUTANTS: Final = (
    Mutant(
        "mirrored-letters",
        Clause.EB_TRAVERSE_3,
        WALK,
        """\
                word.append(R)
                gate = left_gate
            elif right_seen == UNVISITED:
                word.append(L)
""",
        """\
                word.append(L)
                gate = left_gate
            elif right_seen == UNVISITED:
                word.append(R)
""",
        "R and L are swapped.",
    ),
    Mutant(
        "mirrored-walk",
        Clause.EB_TRAVERSE_2,
        WALK,
        """\
                gate = right_gate
                continue
            left: i64""",
        """\
                gate = opposite[gate - 1 if turn else gate + 2]
                continue
            left: i64""",
        "After a C the walk goes on at the left gate.",
    ),
    Mutant(
        "split-mirrored",
        Clause.EB_TRAVERSE_6,
        WALK,
        """\
                    stack[height] = left_gate
                else:
                    stack = append(stack, left_gate)
                height += 1
                gate = right_gate
""",
        """\
                    stack[height] = right_gate
                else:
                    stack = append(stack, right_gate)
                height += 1
                gate = left_gate
""",
        "An S keeps its right gate and goes on at the left one.",
    ),
    Mutant(
        "stack-is-queue",
        Clause.EB_TRAVERSE_5,
        WALK,
        "                gate = stack[height]\n",
        """\
                gate = stack[0]
                for k in range(height):
                    stack[k] = stack[k + 1]
""",
        "An E takes the oldest gate, not the newest.",
    ),
    Mutant(
        "visited-gate-popped",
        Clause.EB_TRAVERSE_5,
        WALK,
        "while height > 0 and visited[stack[height - 1] // 3] != UNVISITED:",
        "while height > 0 and False:",
        "An E goes on at a gate whose triangle was visited since.",
    ),
    Mutant(
        "one-visited-gate-popped",
        Clause.EB_TRAVERSE_5,
        WALK,
        "while height > 0 and visited[stack[height - 1] // 3] != UNVISITED:",
        "if height > 0 and visited[stack[height - 1] // 3] != UNVISITED:",
        "An E passes over one visited gate, and not over the next.",
    ),
    Mutant(
        "boundary-vertex-created",
        Clause.EB_COMPONENT_4,
        WALK,
        "if mark[v] == UNSEEN:",
        "if mark[v] != MARKED:",
        "A vertex on a curve that was not reached yet is created by a C.",
    ),
    Mutant(
        "creation-not-marked",
        Clause.EB_TRAVERSE_2,
        WALK,
        """\
                mark[v] = MARKED
                order""",
        """\
                mark[v] = UNSEEN
                order""",
        "A C does not mark its apex.",
    ),
    Mutant(
        "curve-not-marked",
        Clause.EB_TRAVERSE_7,
        WALK,
        """\
            self.meet(v)
            c = outgoing""",
        """\
            self.meet(v)
            self.mark[v] = ON_CURVE
            c = outgoing""",
        "The vertices of a curve that was reached are not marked.",
    ),
    Mutant(
        "root-not-marked",
        Clause.EB_COMPONENT_2,
        WALK,
        "            self.meet(self.vertex[corner + k])\n",
        """\
            self.meet(self.vertex[corner + k])
            self.mark[self.vertex[corner + k]] = UNSEEN
""",
        "The vertices of the first triangle are not marked.",
    ),
    Mutant(
        "wrong-start-gate",
        Clause.EB_COMPONENT_2,
        WALK,
        "walk.traverse(opposite[3 * t])",
        "walk.traverse(opposite[3 * t + 1])",
        "A closed component is entered across the wrong edge of its first triangle.",
    ),
    Mutant(
        "first-curve-from-other-end",
        Clause.EB_COMPONENT_1,
        WALK,
        "walk.reach_curve(gate - 2 if gate % 3 == 2 else gate + 1)",
        "walk.reach_curve(gate - 1 if gate % 3 else gate + 2)",
        "The first curve is listed from the other end of the gate.",
    ),
    Mutant(
        "curve-run-backwards",
        Clause.EB_ORDER_2,
        WALK,
        """\
            c = outgoing(opposite, c - 2 if c % 3 == 2 else c + 1)
            if c == start:
                return
""",
        """\
            c = outgoing(opposite, c - 2 if c % 3 == 2 else c + 1)
            if c == start:
                break
        order = list(self.order)
        first = order.index(self.vertex[start])
        met = self.met
        self.order = vec[i64](order[:first] + order[first:met][::-1] + order[met:])
""",
        "The vertices of a curve are listed against its direction.",
    ),
    Mutant(
        "splits-counted-from-1",
        Clause.EB_HANDLE_3,
        ENCODE,
        "            s,\n",
        "            s + 1,\n",
        "The S of a record is counted from 1.",
    ),
    Mutant(
        "closing-symbol-counted",
        Clause.EB_HANDLE_3,
        ENCODE,
        "            at >> 1,\n",
        "            (at >> 1) + 1,\n",
        "The closing symbol counts itself.",
    ),
    Mutant(
        "closers-of-the-component",
        Clause.EB_HANDLE_3,
        WALK,
        "        stack = vec[i64]()\n",
        "        stack = vec[i64]()\n        self.closers = 0\n",
        "Closing symbols are counted anew in each component.",
    ),
    Mutant(
        "every-record-a-handle",
        Clause.EB_HANDLE_2,
        ENCODE,
        "Kind.BOUNDARY if walk.reaches[s] else Kind.HANDLE",
        "Kind.HANDLE",
        "That an S reached a curve is forgotten where it is closed.",
    ),
    Mutant(
        "next-split-reached-curve",
        Clause.EB_HANDLE_2,
        ENCODE,
        "Kind.BOUNDARY if walk.reaches[s] else",
        "Kind.BOUNDARY if s > 0 and walk.reaches[s - 1] else",
        "The S after the one that reached a curve is taken for it.",
    ),
    Mutant(
        "closing-sides-swapped",
        Clause.EB_HANDLE_4,
        WALK,
        """\
                self.close(right_gate, 2 * closers)
            if left_seen == SPLIT:
                self.close(left_gate, 2 * closers + 1)
""",
        """\
                self.close(right_gate, 2 * closers + 1)
            if left_seen == SPLIT:
                self.close(left_gate, 2 * closers)
""",
        "The sides of records are swapped.",
    ),
    Mutant(
        "records-as-closed",
        Clause.EB_HANDLE_5,
        ENCODE,
        "    closed = ((s, at) for s, at in enumerate(walk.closed) if at >= 0)\n",
        "    closed = sorted(((s, at) for s, at in enumerate(walk.closed) if at >= 0),"
        " key=lambda record: record[1])\n",
        "Records are written in the order in which they were closed.",
    ),
    Mutant(
        "left-of-end-not-closed",
        Clause.EB_HANDLE_4,
        WALK,
        "            if left_seen == SPLIT:\n",
        "            if left_seen == SPLIT and right_seen == UNVISITED:\n",
        "An E closes with its right edge only.",
    ),
    Mutant(
        "closed-components-first",
        Clause.EB_COMPONENT_1,
        WALK,
        """\
    walk = Walk(vertex, opposite, vertices)
""",
        """\
    walk = Walk(vertex, opposite, vertices)
    more = [c // 3 for c in range(len(vertex)) if opposite[c] < 0]
    open_parts = set(more)
    while more:
        t = more.pop()
        near = {opposite[3 * t + k] // 3 for k in range(3)} - open_parts - {-1}
        open_parts |= near
        more += near
    for t in range(len(vertex) // 3):
        if t not in open_parts and walk.visited[t] == 0:
            walk.visit_root(3 * t)
            walk.traverse(opposite[3 * t])
""",
        "Closed components are written before those with boundary.",
    ),
    Mutant(
        "curves-counted",
        Clause.EB_COMPONENT_1,
        ENCODE,
        "walk.with_boundary)",
        "walk.with_boundary + sum(walk.reaches))",
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
