"""The context code by definition: loops as tuples, triangles at a vertex counted one by one.

Nothing is changed in place, so that this is a model in the sense of chapter 1. It takes time
quadratic in the word, and is meant for laws; `context` is the algorithm.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from math import floor
from typing import Final

from clers.codes.closings import Closing
from clers.codes.closings_definition import SIDES
from clers.codes.logistic import CURVE
from clers.edgebreaker.stream import Side

Edge = tuple[int, int]
"""Of the t-th triangle undone: 0 its gate, 1 its right edge, 2 its left edge."""

Loop = tuple[Edge, ...]
Key = tuple[int | str, ...]

ORDER: Final = "CRLES"
"""The symbols in the order in which they are asked for. Clause: CODE-CONTEXT-1."""


@dataclass(frozen=True, slots=True)
class Undone:
    """What a word from its end looks like. Clause: CODE-CONTEXT-2.

    `past`: its symbols, the last first; `loops`: each from any of its edges on; `gates`: the top
    last; `glued`: both ways; `valences`: of the vertices that have left a loop, in order.
    """

    closings: tuple[Closing, ...]
    past: str = ""
    loops: tuple[Loop, ...] = ()
    gates: tuple[Edge, ...] = ()
    glued: Mapping[Edge, Edge] = field(default_factory=dict)
    valences: tuple[int, ...] = ()

    def loop(self, edge: Edge) -> Loop:
        """The loop of an edge, from it on."""
        found = next(loop for loop in self.loops if edge in loop)
        at = found.index(edge)
        return found[at:] + found[:at]

    def triangles(self, edge: Edge) -> int:
        """How many triangles lie around the start of an edge of a loop, within the loop."""
        number = 1
        t, place = edge
        while (into := (t, (place + 2) % 3)) in self.glued:
            t, place = self.glued[into]
            number += 1
        return number

    def other(self) -> Edge | None:
        """The edge that the left edge of an S would be glued to, if it can be undone here.

        Clauses: CODE-HAND-1, CODE-CONTEXT-3.
        """
        gate = self.gates[-1]
        closing = self._closing()
        if closing is not None:
            place = 1 if closing.side is Side.RIGHT else 2
            edges = [(t, place) for t, x in enumerate(self.past) if closing.side in SIDES[x]]
            edges = edges[: max(0, len(edges) - closing.between)]
        else:
            edges = list(self.gates[:-1])
        if not edges or not any(edges[-1] in loop for loop in self.loops) or edges[-1] == gate:
            return None
        here, there = self.loop(gate), self.loop(edges[-1])
        if edges[-1] in here:
            return edges[-1] if edges[-1] not in (here[1], here[-1]) else None
        return edges[-1] if len(there) > 1 else None

    def _closing(self) -> Closing | None:
        """That of the next S, if it has one. Clause: CODE-HAND-1."""
        passed, rest = 0, list(self.closings)
        for symbol in self.past:
            if symbol == "S" and rest and rest[0].passed == passed:
                passed = 0
                rest = rest[1:]
            elif symbol == "S":
                passed += 1
        return rest[0] if rest and rest[0].passed == passed else None

    def undo(self, symbol: str) -> "Undone":
        """One symbol more. Clause: CODE-CONTEXT-2, by the table of EB-REVERSI-2."""
        g, r, left = ((len(self.past), place) for place in range(3))
        past = self.past + symbol
        if symbol == "E":
            loops, gates = (*self.loops, (g, r, left)), (*self.gates, g)
            return replace(self, past=past, loops=loops, gates=gates)
        e, *rest = self.loop(self.gates[-1])
        loops = tuple(loop for loop in self.loops if e not in loop)
        gates = (*self.gates[:-1], g)
        valences = self.valences
        match symbol:
            case "R":
                glue, made = {left: e}, [(g, r, *rest)]
            case "L":
                glue, made = {r: e}, [(g, *rest, left)]
            case "C":
                glue, made = {r: e, left: rest[-1]}, [(g, *rest[:-1])]
                valences = (*valences, self.triangles(e) + 1)
            case _:
                other = self.other()
                assert other is not None, "asked for only where it can be"
                glue = {r: e, left: other}
                if other in rest:
                    at = rest.index(other)
                    made = [(g, *rest[:at]), tuple(rest[at + 1 :])]
                else:
                    made = [(g, *rest, *self.loop(other)[1:])]
                    loops = tuple(loop for loop in loops if other not in loop)
                if self._closing() is None:
                    gates = (*self.gates[:-2], g)
        glued = {**self.glued, **glue, **{b: a for a, b in glue.items()}}
        return Undone(self.closings, past, (*loops, *made), gates, glued, valences)

    def contexts(self) -> tuple[Key, ...]:
        """The five contexts. Clause: CODE-CONTEXT-4."""
        loop = self.loop(self.gates[-1])
        a, b, x, xx = (min(15, self.triangles(loop[i % len(loop)])) for i in (0, 1, -1, -2))
        newest = tuple(reversed(("none",) * 12 + tuple(self.past)))
        valences = tuple(reversed((0, 0, *(min(15, v) for v in self.valences))))
        size = min(5, max(3, len(loop)))
        return (
            (a, b, size),
            (*newest[:12], a),
            newest[:4],
            (a, *valences[:2]),
            (x, a, xx, newest[0]),
        )


@dataclass(frozen=True, slots=True)
class Told:
    """The model of the decisions of `count` symbols. Clauses: CODE-CONTEXT-1 … CODE-CONTEXT-7.

    `decision`: which is next; `slots`: probability and count for each context and decision met;
    `weights`: five for each decision.
    """

    count: int
    undone: Undone
    decision: int = 0
    slots: Mapping[tuple[int, Key, int], tuple[int, int]] = field(default_factory=dict)
    weights: tuple[tuple[int, ...], ...] = ((16384,) * 5,) * 4

    @property
    def cumulative(self) -> tuple[int, ...]:
        """The table of the next decision: no, then yes."""
        if len(self.undone.past) == self.count:
            return (0,)
        certain = self._certain()
        p = self._mixed() if certain is None else 65536 * certain
        return (0, 65536 - p, 65536)

    def after(self, symbol: int) -> "Told":
        """The model of what follows a decision."""
        learnt = self if self._certain() is not None else self._learning(symbol)
        if symbol == 0 and self.decision < 3:
            return replace(learnt, decision=self.decision + 1)
        undone = self.undone.undo(ORDER[self.decision] if symbol else "S")
        return replace(learnt, undone=undone, decision=0)

    def _certain(self) -> int | None:
        """1 or 0 where nothing else can be. Clause: CODE-CONTEXT-3."""
        name = ORDER[self.decision]
        if not self.undone.gates:
            return int(name == "E")
        if name == "C" and len(self.undone.loop(self.undone.gates[-1])) < 4:
            return 0
        return 1 if name == "E" and self.undone.other() is None else None

    def _slots(self) -> list[tuple[int, Key, int]]:
        return [(i, key, self.decision) for i, key in enumerate(self.undone.contexts())]

    def _logits(self) -> list[int]:
        """Clauses: CODE-CONTEXT-5, CODE-CONTEXT-6."""
        return [stretch(self.slots.get(slot, (32768, 0))[0]) for slot in self._slots()]

    def _mixed(self) -> int:
        """Clauses: CODE-CONTEXT-6, CODE-CONTEXT-7."""
        pairs = zip(self.weights[self.decision], self._logits(), strict=True)
        total = floor(sum(weight * logit for weight, logit in pairs) / 65536)
        return squash(max(-2047, min(2047, total)))

    def _learning(self, symbol: int) -> "Told":
        """Clauses: CODE-CONTEXT-5, CODE-CONTEXT-7."""
        error = 65536 * symbol - self._mixed()
        mine = tuple(
            weight + floor((logit * error + 16384) / 32768)
            for weight, logit in zip(self.weights[self.decision], self._logits(), strict=True)
        )
        weights = (*self.weights[: self.decision], mine, *self.weights[self.decision + 1 :])
        slots = dict(self.slots)
        for slot in self._slots():
            p, k = slots.get(slot, (32768, 0))
            step = floor((65535 * symbol - p) * floor(65536 / (k + 1.5)) / 65536)
            slots[slot] = (p + step, min(k + 1, 255))
        return replace(self, slots=slots, weights=weights)


def squash(logit: int) -> int:
    """Between two points of the curve, rounded. Clause: CODE-CONTEXT-6."""
    i, w = divmod(logit + 2048, 128)
    return floor((CURVE[i] * (128 - w) + CURVE[i + 1] * w) / 128 + 0.5)


@cache
def stretch(p: int) -> int:
    """The least logit whose probability is that of `p` or more, in 4096ths. CODE-CONTEXT-6."""
    for logit in range(-2047, 2047):
        if squash(logit) // 16 >= p // 16:
            return logit
    return 2047
