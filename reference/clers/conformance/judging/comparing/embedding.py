"""Is a component of one mesh a component of another? Found, refuted or given up."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

from clers.conformance.judging.comparing.nets import Net, Unit

Fits = Callable[[int, int], bool]
"""Whether a vertex may become another one."""


class No(Enum):
    """Why there is no embedding: there is none, or the search was given up. ORCL-CODEC-8."""

    THERE_IS_NONE = "there is none"
    GIVEN_UP = "given up"


@dataclass(slots=True)
class Budget:
    """The steps that are left for all searches together. Clause: ORCL-CODEC-8."""

    steps: int


@dataclass(frozen=True, slots=True)
class Coloured:
    """A net and its colours, and how the search looks at one of its components."""

    net: Net
    colour: Sequence[int]

    def profile(self, part: int) -> tuple[tuple[tuple[int, ...], int], ...]:
        """What components that are alike agree on: colours and times of units, counted."""
        members = self.net.parts[part]
        return tuple(sorted(Counter(map(self.sign, members)).items()))

    def sign(self, u: int) -> tuple[int, ...]:
        """What a unit's images agree on: its times, and its colours in their order."""
        colours = [self.colour[v] for v in self.net.units[u]]
        turns = (tuple(colours[i:] + colours[:i]) for i in range(len(colours)))
        return (self.net.times[u], *min(turns))


def embedding(
    first: Coloured, part: int, second: Coloured, other: int, fits: Fits, budget: Budget
) -> dict[int, int] | No:
    """The image of each vertex of a component in one that has the same profile, or why not.

    Each unit of the component becomes a unit that is there as often, in its orientation. Exact:
    all choices are tried, until the budget is spent. Where two faces meet at an edge each choice
    follows from the first, so that on surfaces a walk is linear.
    Clauses: ORCL-CODEC-5, ORCL-CODEC-8.
    """
    order = _order(first, part)
    image: dict[int, int] = {}
    taken: set[int] = set()
    made: list[list[int]] = []
    choices = [_everywhere(second, other)]
    while choices:
        if budget.steps <= 0:
            return No.GIVEN_UP
        budget.steps -= 1
        found = next(choices[-1], None)
        if found is None:
            choices.pop()
            if made:
                _forget(made.pop(), image, taken)
            continue
        unit = order[len(made)]
        target, u = found
        if second.net.times[u] != first.net.times[unit]:
            continue
        source = first.net.units[unit]
        new = _assign(source, target, first.colour, second.colour, fits, image, taken)
        if new is None:
            continue
        made.append(new)
        if len(made) == len(order):
            return image
        choices.append(_around(second.net, first.net.units[order[len(made)]], image))
    return No.THERE_IS_NONE


def _order(of: Coloured, part: int) -> list[int]:
    """The units, a rare one first, then always one with as many known vertices as can be had."""
    members = of.net.parts[part]
    signs = {u: of.sign(u) for u in members}
    count = Counter(signs.values())
    start = min(members, key=lambda u: (count[signs[u]], u))
    known: set[int] = set()
    placed: set[int] = set()
    order: list[int] = []
    waiting: tuple[list[int], ...] = ([], [], [], [start])
    while any(waiting):
        u = next(pile for pile in reversed(waiting) if pile).pop()
        if u in placed:
            continue
        placed.add(u)
        order.append(u)
        for v in of.net.units[u]:
            if v not in known:
                known.add(v)
                for w in of.net.at[v]:
                    if w not in placed:
                        waiting[sum(x in known for x in of.net.units[w])].append(w)
    return order


def _everywhere(of: Coloured, part: int) -> Iterator[tuple[Unit, int]]:
    """Each unit of a component, turned every way."""
    return ((turn, u) for u in of.net.parts[part] for turn in _turns(of.net.units[u]))


def _around(of: Net, unit: Unit, image: dict[int, int]) -> Iterator[tuple[Unit, int]]:
    """The units where a known vertex of the unit has gone; of known ones that with the fewest."""
    fewest = min((of.at[image[v]] for v in unit if v in image), key=len)
    return ((turn, u) for u in fewest for turn in _turns(of.units[u]))


def _turns(unit: Unit) -> Iterator[Unit]:
    return (unit[i:] + unit[:i] for i in range(len(unit)))


def _assign(
    source: Unit,
    target: Unit,
    colours: Sequence[int],
    others: Sequence[int],
    fits: Fits,
    image: dict[int, int],
    taken: set[int],
) -> list[int] | None:
    """Let the corners of one unit become those of another; what is new, or None and no change."""
    new: list[int] = []
    if len(source) != len(target):
        return None
    for v, w in zip(source, target, strict=True):
        if image.get(v) == w:
            continue
        if v in image or w in taken or colours[v] != others[w] or not fits(v, w):
            _forget(new, image, taken)
            return None
        image[v] = w
        taken.add(w)
        new.append(v)
    return new


def _forget(new: Sequence[int], image: dict[int, int], taken: set[int]) -> None:
    for v in new:
        taken.remove(image.pop(v))
