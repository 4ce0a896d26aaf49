"""Meshes of simpler topology: handles cut, curves filled, then edges contracted. ORCL-SHRINK-3."""

from collections.abc import Iterator

from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner
from clers.complexes.topology import curves
from clers.oracle.fuzz.behind import Net, Triangle, surface_of_net
from clers.oracle.fuzz.shrinking.contracting import edges_of, smaller
from clers.oracle.fuzz.shrinking.nets import without_components


def filled(net: Net) -> Iterator[Net]:
    """Each curve filled, with one face or a cone, and edges contracted until it is smaller."""
    built = surface_of_net(net)
    if built is None:
        return
    for curve in curves(built):
        loop = [int(v) for v in curve.vertices]
        top = net.vertices
        if len(loop) == 3:
            new: tuple[Triangle, ...] = ((loop[0], loop[2], loop[1]),)
            more = Net((*net.faces, *new), net.vertices, net.precision, net.places)
        else:
            pairs = zip(loop, (*loop[1:], loop[0]), strict=True)
            cone = tuple((b, a, top) for a, b in pairs)
            places = None if net.places is None else (*net.places, net.places[loop[0]])
            more = Net((*net.faces, *cone), net.vertices + 1, net.precision, places)
        yield from smaller(more, len(net.faces) - 1)


def cut(net: Net) -> Iterator[Net]:
    """Cut along each loop of three edges that bounds no face; both sides closed with a face.

    If that gives two pieces, each alone; and the whole, contracted until it is smaller.
    """
    built = surface_of_net(net)
    if built is None:
        return
    for loop in _empty_triangles(net.faces):
        sides = _cut_along(built, loop)
        if sides is not None:
            faces, vertices = sides
            places = None
            if net.places is not None:
                places = (*net.places, *(net.places[v] for v in loop))
            after = Net(faces, vertices, net.precision, places)
            yield from without_components(after)
            yield from smaller(after, len(net.faces) - 1)


def _empty_triangles(faces: tuple[Triangle, ...]) -> Iterator[Triangle]:
    """Three edges in a loop, and no face between them; each loop once."""
    beside: dict[int, set[int]] = {}
    for a, b in edges_of(faces):
        beside.setdefault(a, set()).add(b)
        beside.setdefault(b, set()).add(a)
    known = {frozenset(face) for face in faces}
    for a, b in edges_of(faces):
        for c in sorted(beside[a] & beside[b]):
            if c > b and frozenset((a, b, c)) not in known:
                yield a, b, c


def _cut_along(of: Surface, loop: Triangle) -> tuple[tuple[Triangle, ...], int] | None:
    """New vertices for the corners on the left of the loop; none if a curve is in the way."""
    corners = (Corner(c) for c in range(len(of.vertex)))
    gates = {
        (int(of.vertex[next_corner(c)]), int(of.vertex[previous_corner(c)])): c for c in corners
    }
    vertex = [int(v) for v in of.vertex]
    for k, v in enumerate(loop):
        onward, back = loop[(k + 1) % 3], loop[k - 1]
        # Turn around v from the face left of v→onward to the face left of back→v.
        corner = next_corner(gates[v, onward]) if (v, onward) in gates else None
        while corner is not None:
            vertex[corner] = of.vertices + k
            if int(of.vertex[previous_corner(corner)]) == back:
                break
            across = of.opposite[next_corner(corner)]
            corner = None if across == BORDER else next_corner(across)
        else:
            return None
    faces = tuple(zip(vertex[0::3], vertex[1::3], vertex[2::3], strict=True))
    n = of.vertices
    a, b, c = loop
    return (*faces, (a, b, c), (n, n + 2, n + 1)), n + 3
