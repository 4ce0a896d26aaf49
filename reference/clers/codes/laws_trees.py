"""The laws of orientations, tree words and closure."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Final

from clers.codes.closure import sphere_of
from clers.codes.closure_definition import faces_by_rescanning
from clers.codes.given_trees import TREE_WORDS, UNIFORM
from clers.codes.half_edges import HalfEdges, half_edges
from clers.codes.orientation import orientation
from clers.codes.orientation_definition import is_orientation, turns_clockwise
from clers.codes.tree_word import tree_word
from clers.complexes.given import SPHERES
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.edgebreaker.encode import encode


@dataclass(frozen=True, slots=True)
class Trees:
    """The way from spheres to tree words and back: what these laws judge."""

    orientation: Callable[[HalfEdges], bytearray]
    tree_word: Callable[[Surface], bytes]
    sphere_of: Callable[[bytes], Accepted[Surface] | Rejected]


REFERENCE: Final = Trees(orientation, tree_word, sphere_of)


def directed(subject: Trees, surface: Surface) -> Verdict:
    """The orientation is the one of CODE-TREE-2."""
    edges = half_edges(surface)
    out = subject.orientation(edges)
    return every(same(True, is_orientation(edges, out)), same(False, turns_clockwise(edges, out)))


def shape(subject: Trees, surface: Surface) -> Verdict:
    """How long a tree word is, how many ones it has, how it begins and ends."""
    word, m = subject.tree_word(surface), surface.vertices - 3
    return every(
        same((4 * m, m), (len(word), sum(word))),
        same((b"\1\0", b"\0\0"), (word[:2], word[-2:])),
    )


def there_and_back(subject: Trees, surface: Surface) -> Verdict:
    """A sphere comes back from its tree word, up to names, with its root face as face 0."""
    match subject.sphere_of(subject.tree_word(surface)):
        case Accepted(found):
            m = surface.vertices - 3
            return every(
                same(encode(surface).stream, encode(found).stream),
                same((0, m + 1, m + 2), found.vertex[:3]),
            )
        case Rejected() as rejected:
            return Fails("a sphere", rejected.line(), rejected.where)


def back_and_there(subject: Trees, word: bytes) -> Verdict:
    """A word that is accepted comes back from its sphere."""
    match subject.sphere_of(word):
        case Accepted(found):
            return same(word, subject.tree_word(found))
        case Rejected(reason, clause):
            return same((Reason.NOT_CANONICAL, Clause.CODE_TREE_6), (reason, clause))


def as_defined(subject: Trees, word: bytes) -> Verdict:
    """The faces are those of the definition, the first one first."""
    match (faces_by_rescanning(word), subject.sphere_of(word)):
        case (Accepted(faces), Accepted(found)):
            listed = list(found.triangles())
            return every(
                same(faces[0], listed[0]),
                same(sorted(map(turned, faces)), sorted(map(turned, listed))),
            )
        case (expected, got):
            return same((Rejected, Rejected), (type(expected), type(got)))


def turned(face: tuple[int, ...]) -> tuple[int, ...]:
    """A face from its lowest vertex on."""
    least = face.index(min(face))
    return face[least:] + face[:least]


def laws_of(subject: Trees) -> tuple[AnyLaw, ...]:
    """The laws, of these functions."""
    return (
        Law(
            "orientation-three-out",
            Clause.CODE_TREE_2,
            "three edges go out of each inner vertex, and no cycle is clockwise",
            UNIFORM,
            partial(directed, subject),
        ),
        Law(
            "tree-word-shape",
            Clause.CODE_TREE_7,
            "a tree word has 4m bits, m of them ones, from 10 to 00",
            UNIFORM,
            partial(shape, subject),
        ),
        Law(
            "tree-word-decodes",
            Clause.CODE_TREE_9,
            "the sphere of a sphere's tree word is that sphere, from the same root",
            SPHERES,
            partial(there_and_back, subject),
        ),
        Law(
            "tree-word-unique",
            Clause.CODE_TREE_6,
            "a word that is accepted is the tree word of its sphere",
            TREE_WORDS,
            partial(back_and_there, subject),
        ),
        Law(
            "closure-as-defined",
            Clause.CODE_TREE_8,
            "a stack closes the string to the faces that looking again and again finds",
            TREE_WORDS,
            partial(as_defined, subject),
        ),
    )


LAWS: Final[tuple[AnyLaw, ...]] = laws_of(REFERENCE)
