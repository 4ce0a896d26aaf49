"""All ways of gluing an m-simplex, up to its symmetry, and what each does to the topology."""

from dataclasses import dataclass
from itertools import combinations, permutations
from math import comb

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import Complex, Simplex, dimension, euler, of_dimension
from clers.operators.attachments.attachment import Attachment, Vertices, common, maximal


def handles(glued: Attachment) -> tuple[int, ...]:
    """h_0 … h_m: how many k-handles the attachment is, told by homology. Clause: OPER-ATTACH-6.

    h_k is the reduced Betti number of dimension k − 1 of the part along which it is glued, over
    GF(2). The empty complex has that of dimension −1.
    """
    part = common(glued)
    if dimension(part) < 0:
        return (1, *[0] * (len(glued.simplex) - 1))
    components, *higher = betti(part, Field.GF2)
    found = (0, components - 1, *higher)
    return (*found, *[0] * (len(glued.simplex) - len(found)))


def pinches(glued: Attachment) -> tuple[Vertices, ...]:
    """The maximal simplices along which it is glued that are no facets. Clause: OPER-SIMPLEX-6."""
    return tuple(face for face in glued.along if len(face) < len(glued.simplex) - 1)


@dataclass(frozen=True, slots=True)
class Growth:
    """The change of #0 … #m, and of χ. Clause: OPER-ATTACH-5."""

    counts: tuple[int, ...]
    euler: int


def growth(glued: Attachment) -> Growth:
    """What an attachment adds, from the numbers alone. Clause: OPER-ATTACH-5."""
    size, part = len(glued.simplex), common(glued)
    counts = tuple(comb(size, k + 1) - len(of_dimension(part, k)) for k in range(size))
    return Growth(counts, 1 - euler(part))


def ways(m: int) -> tuple[Attachment, ...]:
    """Every attachment of the simplex 0 … m, one of each class under permutations of its vertices.

    In the order of their numbers of simplices along which they are glued. Clause: OPER-SOLID-3.
    """
    simplex = tuple(range(m + 1))
    seen: set[frozenset[Simplex]] = set()
    found: list[Attachment] = []
    for part in sorted(subcomplexes(m), key=lambda c: (len(c.simplices), maximal(c))):
        if part.simplices not in seen:
            found.append(Attachment(simplex, maximal(part)))
            for name in permutations(simplex):
                seen.add(frozenset(frozenset(name[v] for v in s) for s in part.simplices))
    return tuple(found)


def subcomplexes(m: int) -> tuple[Complex, ...]:
    """The subcomplexes of the frontier of the simplex 0 … m, the empty one among them."""
    found: list[frozenset[Simplex]] = [frozenset()]
    for size in range(1, m + 1):
        faces = [frozenset(face) for face in combinations(range(m + 1), size)]
        found = [
            there | frozenset(more)
            for there in found
            for ready in [[f for f in faces if size == 1 or all(f - {v} in there for v in f)]]
            for count in range(len(ready) + 1)
            for more in combinations(ready, count)
        ]
    return tuple(map(Complex, found))
