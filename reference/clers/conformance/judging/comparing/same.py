"""Whether two meshes are the same but for names: a certificate, none, or given up."""

from collections import Counter
from collections.abc import Sequence

from clers.conformance.judging.comparing.common import Named, anywhere
from clers.conformance.judging.comparing.embedding import Budget, Coloured, Fits, No
from clers.conformance.judging.comparing.matching import matched
from clers.conformance.judging.comparing.nets import coloured, net
from clers.conformance.judging.comparing.sites import Bound, near
from clers.conformance.judging.comparing.soup import Face, Soup, begun_at_least

Image = tuple[int, ...]


def image(sent: Soup, came: Soup, placed: Named, bound: Bound, budget: Budget) -> Image | No:
    """The vertex that each vertex has become; or there is no such map, or it is given up.

    Faces go to faces as often as they are there, in their orientation; each vertex to one that is
    near. Where each site has one vertex of either mesh this takes linear time.
    Clauses: ORCL-CODEC-3, ORCL-CODEC-5, ORCL-CODEC-8.
    """
    at = Counter(placed.sent)
    if len(sent.faces) != len(came.faces) or at != Counter(placed.came):
        return No.THERE_IS_NONE
    if len(at) == sent.vertices:
        whose = {site: w for w, site in enumerate(placed.came)}
        to = tuple(whose[site] for site in placed.sent)
        return to if _counted(sent.faces, to) == _counted(came.faces) else No.THERE_IS_NONE
    return searched(sent, came, placed, _near(sent, came, bound), budget)


def _counted(faces: Sequence[Face], to: Sequence[int] | None = None) -> Counter[tuple[int, ...]]:
    """The faces, each begun at the least of its turns, under other names if there are some."""
    named = faces if to is None else [(to[a], to[b], to[c]) for a, b, c in faces]
    return Counter(map(begun_at_least, named))


def _near(sent: Soup, came: Soup, bound: Bound) -> Fits:
    here, there = sent.places, came.places
    if here is None or there is None:
        return anywhere
    return lambda v, w: near(here[v], there[w], bound)


def searched(sent: Soup, came: Soup, placed: Named, fits: Fits, budget: Budget) -> Image | No:
    """The same, by colours and matched components: site goes to site. Clause: ORCL-CODEC-5."""
    one, other = net(sent.faces, sent.vertices), net(came.faces, came.vertices)
    if len(one.parts) != len(other.parts):
        return No.THERE_IS_NONE
    colours = coloured((one, other), (placed.sent, placed.came))
    first, second = map(Coloured, (one, other), colours)
    parts = range(len(one.parts))
    found = matched(first, parts, second, parts, fits, budget)
    if len(found.partner) == len(parts):
        return tuple(found.image[v] for v in range(sent.vertices))
    return No.GIVEN_UP if found.spent else No.THERE_IS_NONE
