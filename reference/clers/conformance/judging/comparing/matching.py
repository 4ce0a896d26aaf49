"""Components of one mesh matched with those of another, as many as can be."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from clers.conformance.judging.comparing.embedding import Budget, Coloured, Fits, No, embedding


@dataclass(slots=True)
class Matching:
    """Which part is matched with which, and the image of each of its vertices.

    `spent` says that a search was given up, so that there may be more.
    """

    partner: dict[int, int] = field(default_factory=dict)
    image: dict[int, int] = field(default_factory=dict)
    spent: bool = False


def matched(
    first: Coloured,
    parts: Sequence[int],
    second: Coloured,
    others: Sequence[int],
    fits: Fits,
    budget: Budget,
) -> Matching:
    """A matching of components that are alike, with as many pairs as there can be.

    Alike is no equivalence where places only have to be near, so a pair may have to be given up
    for another: augmenting paths do that. Clauses: ORCL-CODEC-5, ORCL-CODEC-8.
    """
    found = Matching()
    asked: dict[tuple[int, int], dict[int, int] | No] = {}

    def images(i: int, j: int) -> dict[int, int] | No:
        if (i, j) not in asked:
            asked[i, j] = embedding(first, i, second, j, fits, budget)
            found.spent = found.spent or asked[i, j] is No.GIVEN_UP
        return asked[i, j]

    kinds: dict[tuple[tuple[tuple[int, ...], int], ...], tuple[list[int], list[int]]] = {}
    for side, coloured, some in ((0, first, parts), (1, second, others)):
        for part in some:
            kinds.setdefault(coloured.profile(part), ([], []))[side].append(part)
    for these, those in kinds.values():
        _match(these, those, lambda i, j: isinstance(images(i, j), dict), found.partner)
    for i, j in found.partner.items():
        chosen = images(i, j)
        found.image |= chosen if isinstance(chosen, dict) else {}
    return found


def _match(
    these: Sequence[int],
    those: Sequence[int],
    alike: Callable[[int, int], bool],
    partner: dict[int, int],
) -> None:
    """Extend a matching by augmenting paths, each found breadth first; free ones come first."""
    owner: dict[int, int] = {}
    free = list(those)
    for start in these:
        end = next((j for j in free if alike(start, j)), None)
        came = {} if end is None else {end: start}
        queue = [start] if end is None else []
        for i in queue:  # which grows on the way
            if end is None:
                new = [j for j in those if j not in came and alike(i, j)]
                came |= dict.fromkeys(new, i)
                end = next((j for j in new if j not in owner), None)
                queue += [owner[j] for j in new if j in owner]
        if end is not None:
            free.remove(end)
            _augment(end, came, partner, owner)


def _augment(
    end: int, came: dict[int, int], partner: dict[int, int], owner: dict[int, int]
) -> None:
    """Along the path each takes what the next one had."""
    j: int | None = end
    while j is not None:
        i = came[j]
        owner[j] = i
        partner[i], j = j, partner.get(i)
