"""The laws of comparing meshes: by definition, under other names, and each difference by name."""

from collections import Counter
from dataclasses import dataclass
from itertools import permutations
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Kind
from clers.conformance.judging.comparing.sites import Bound
from clers.conformance.judging.comparing.soup import Soup, begun_at_least, soup
from clers.conformance.judging.meshes import Compared, Differs, Same, Undecided, compare
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE


@dataclass(frozen=True, slots=True)
class MeshPair:
    """A mesh that was sent, one that came back, and how far coordinates may move."""

    sent: form.MeshForm
    came: form.MeshForm
    error: Bound


@dataclass(frozen=True, slots=True)
class Planted:
    """A pair with known differences: each kind and how often it is there."""

    pair: MeshPair
    differences: tuple[tuple[Kind, int], ...]


RENAMED: Final = Given(
    "mesh-pairs-renamed", "meshes, dirty ones too, and the same under other names", MeshPair
)
TINY: Final = Given("mesh-pairs-tiny", "pairs of meshes with up to five vertices", MeshPair)
PLANTED: Final = Given("mesh-pairs-planted", "surfaces that came back with differences", Planted)


def _compared(pair: MeshPair) -> Compared:
    return compare(pair.sent, pair.came, pair.error)


def _renamed(pair: MeshPair) -> Verdict:
    """The certificate is judged by the definition."""
    found = _compared(pair)
    if isinstance(found, Same):
        return same(True, carries(found.vertices, soup(pair.sent), soup(pair.came), pair.error))
    return Fails("the same mesh", repr(found), WHOLE)


def carries(image: tuple[int, ...], sent: Soup, came: Soup, error: Bound) -> bool:
    """Whether a map of vertices makes one mesh of the other, by the definition. ORCL-CODEC-3."""
    if sorted(image) != list(range(came.vertices)) or len(image) != sent.vertices:
        return False
    gone = Counter(begun_at_least((image[a], image[b], image[c])) for a, b, c in sent.faces)
    if gone != Counter(map(begun_at_least, came.faces)):
        return False
    if sent.places is None or came.places is None:
        return sent.places is came.places
    far = (
        abs(x - y) > most
        for v, w in enumerate(image)
        for x, y, most in zip(sent.places[v], came.places[w], error, strict=True)
    )
    return not any(far)


def _by_definition(pair: MeshPair) -> Verdict:
    """Places of this domain are multiples of ½, so that their differences are exact."""
    sent, came = soup(pair.sent), soup(pair.came)
    images = permutations(range(came.vertices))
    expected = any(carries(image, sent, came, pair.error) for image in images)
    found = _compared(pair)
    return every(same(expected, isinstance(found, Same)), same(False, isinstance(found, Undecided)))


def _planted(planted: Planted) -> Verdict:
    found = _compared(planted.pair)
    if not isinstance(found, Differs):
        return Fails(repr(planted.differences), repr(found), WHOLE)
    return same(planted.differences, tuple((d.kind, d.count) for d in found.differences))


def _either_way(pair: MeshPair) -> Verdict:
    back = compare(pair.came, pair.sent, pair.error)
    return same(isinstance(_compared(pair), Same), isinstance(back, Same))


def _some_difference(pair: MeshPair) -> Verdict:
    """At least one, each kind once, in order, with a number."""
    found = _compared(pair)
    if not isinstance(found, Differs):
        return Holds()
    kinds = [d.kind for d in found.differences]
    return every(
        same(False, not kinds),
        same(sorted(set(kinds), key=list(Kind).index), kinds),
        same([], [d for d in found.differences if d.count < 1]),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "a-mesh-under-other-names-is-the-same",
        Clause.ORCL_CODEC_5,
        "a mesh with its vertices renamed, its faces in another order and turned, and coordinates "
        "moved within the error, is the same, and the certificate shows it",
        RENAMED,
        _renamed,
    ),
    Law(
        "same-is-what-some-permutation-does",
        Clause.ORCL_CODEC_3,
        "two meshes are the same exactly if one of all permutations of the vertices makes one of "
        "the other, and it is always decided",
        TINY,
        _by_definition,
    ),
    Law(
        "same-either-way",
        Clause.ORCL_CODEC_4,
        "a mesh is the same as another exactly if the other is the same as it",
        TINY,
        _either_way,
    ),
    Law(
        "what-is-not-the-same-has-a-difference",
        Clause.ORCL_CODEC_7,
        "two meshes that are not the same have a difference, each kind once, in order, counted",
        TINY,
        _some_difference,
    ),
    Law(
        "differences-are-named",
        Clause.ORCL_CODEC_6,
        "what was done to a mesh is what is named, as often as it was done",
        PLANTED,
        _planted,
    ),
)
