"""All small surfaces, found without Edgebreaker: witnesses that its grammar misses none."""

from collections.abc import Iterator
from itertools import product

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.stream import SYMBOLS, Kind, Record, Side, Stream

Faces = tuple[tuple[int, int, int], ...]


def rooted_forms(faces: Faces) -> set[Faces]:
    """The face list renamed from each of its gates: equal sets for isomorphic connected surfaces.

    From a gate, vertices are named and faces listed breadth first across edges.
    """
    third: dict[tuple[int, int], int] = {}
    for a, b, c in faces:
        third.update({(a, b): c, (b, c): a, (c, a): b})
    return {_form(third, edge) for edge in third}


def _form(third: dict[tuple[int, int], int], root: tuple[int, int]) -> Faces:
    name: dict[int, int] = {}
    queue, listed, done = [root], list[tuple[int, int, int]](), set[tuple[int, int]]()
    for a, b in queue:
        if (a, b) in done:
            continue
        c = third[a, b]
        done |= {(a, b), (b, c), (c, a)}
        for v in (a, b, c):
            name.setdefault(v, len(name))
        listed.append((name[a], name[b], name[c]))
        queue += [e for e in ((b, a), (c, b), (a, c)) if e in third]
    return tuple(listed)


def canonical(faces: Faces) -> Faces:
    """The least of the rooted forms of a connected face list."""
    return min(rooted_forms(faces))


def sphere_triangulations(vertices: int) -> set[Faces]:
    """All triangulations of the sphere up to orientation-preserving isomorphism, by edge flips.

    Any two are joined by flips (Wagner), so that the closure of one is all of them.
    """
    faces: Faces = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))
    for v in range(4, vertices):
        a, b, c = faces[-1]
        faces = (*faces[:-1], (a, b, v), (b, c, v), (c, a, v))
    first = canonical(faces)
    found, todo = {first}, [first]
    while todo:
        for other in _flipped(todo.pop()):
            form = canonical(other)
            if form not in found:
                found.add(form)
                todo.append(form)
    return found


def _flipped(faces: Faces) -> Iterator[Faces]:
    """The face list with one edge flipped, for each edge whose flip keeps it simplicial."""
    third: dict[tuple[int, int], int] = {}
    for a, b, c in faces:
        third.update({(a, b): c, (b, c): a, (c, a): b})
    for (a, b), c in third.items():
        if a < b and (d := third[b, a]) != c and (c, d) not in third:
            gone = ({a, b, c}, {a, b, d})
            kept = tuple(face for face in faces if set(face) not in gone)
            yield (*kept, (c, a, d), (d, b, c))


def connected_surfaces(most_faces: int) -> set[Faces]:
    """All connected oriented surfaces of so many faces at most, up to isomorphism.

    Grown by putting a triangle on an open edge, to a new vertex or any old one. What is grown on
    the way may be pinched; what is returned is not.
    """
    grown: set[Faces] = {((0, 1, 2),)}
    accepted: set[Faces] = set()
    for size in range(1, most_faces + 1):
        accepted |= {faces for faces in grown if as_surface(faces) is not None}
        if size < most_faces:
            grown = {canonical(more) for faces in grown for more in _extended(faces)}
    return accepted


def _extended(faces: Faces) -> Iterator[Faces]:
    edges = {e for a, b, c in faces for e in ((a, b), (b, c), (c, a))}
    vertices = 1 + max(max(face) for face in faces)
    for a, b in edges:
        if (b, a) in edges:
            continue
        for v in range(vertices + 1):
            if v not in (a, b) and (a, v) not in edges and (v, b) not in edges:
                yield (*faces, (b, a, v))


def as_surface(faces: Faces) -> Surface | None:
    """The surface of a face list, if it is one."""
    built = surface(FaceList(faces, 1 + max(max(face) for face in faces)))
    return built.value if isinstance(built, Accepted) else None


def rooted_surfaces(faces: Faces) -> Iterator[Surface]:
    """A connected surface begun at each of its gates: every stream it has is the stream of one."""
    for i, face in enumerate(faces):
        rest = faces[:i] + faces[i + 1 :]
        for k in range(3):
            turned = (face[k], face[(k + 1) % 3], face[(k + 2) % 3])
            built = as_surface((turned, *rest))
            if built is not None:
                yield built


def all_streams(symbols: int, last: str = SYMBOLS) -> Iterator[Stream]:
    """Every word of so many symbols, with every choice of records, closed and with boundary.

    Only records whose numbers are in range; at most one for each S. `last`: the letters that a word
    may end in. Exponential.
    """
    for letters in product(*[SYMBOLS] * (symbols - 1), last):
        word = "".join(letters)
        closers = sum(x in "RLE" for x in word)
        options = [
            (None, *(Record(kind, s, at, side) for kind, at, side in _fields(closers)))
            for s in range(word.count("S"))
        ]
        for chosen in product(*options):
            records = tuple(record for record in chosen if record is not None)
            for boundary in (0, 1):
                yield Stream(word, records, boundary)


def _fields(closers: int) -> Iterator[tuple[Kind, int, Side]]:
    return product(Kind, range(closers), Side)
