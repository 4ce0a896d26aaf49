"""The same surface under other names, and its mirror image."""

from clers.complexes.surface import BORDER, Corner, Surface, Vertex, corners_listed


def relabelled(
    surface: Surface, vertex_order: tuple[Vertex, ...], tips: tuple[Corner, ...]
) -> Surface:
    """The surface whose vertex k is `vertex_order[k]` and whose face f begins at corner `tips[f]`.

    `vertex_order` names every vertex once, `tips` one corner of every face. Linear.
    Clause: CPLX-ISO-1.
    """
    name = [Vertex(0)] * surface.vertices
    for k, v in enumerate(vertex_order):
        name[v] = Vertex(k)
    image = corner_images(tips)
    vertex = [Vertex(0)] * len(image)
    opposite = [BORDER] * len(image)
    for new, v, d in zip(image, surface.vertex, surface.opposite, strict=True):
        vertex[new] = name[v]
        opposite[new] = BORDER if d == BORDER else image[d]
    return corners_listed(tuple(vertex), tuple(opposite), surface.vertices)


def corner_images(tips: tuple[Corner, ...]) -> tuple[Corner, ...]:
    """The new number of each old corner, if the old corner `tips[f]` is corner 3f.

    Clause: CPLX-ISO-2.
    """
    image = [Corner(0)] * (3 * len(tips))
    for f, tip in enumerate(tips):
        first = tip - tip % 3
        for i in range(3):
            image[first + (tip + i) % 3] = Corner(3 * f + i)
    return tuple(image)


def mirror(surface: Surface) -> Surface:
    """Every face (a, b, c) turned over into (a, c, b); numbers are kept. Clause: CPLX-ISO-8."""
    tips, across = surface.vertex, surface.opposite
    turned = [c + (0, 1, -1)[c % 3] for c in range(len(tips))]
    opposite = (across[c] for c in turned)
    return corners_listed(
        tuple(tips[c] for c in turned),
        tuple(BORDER if d == BORDER else Corner(turned[d]) for d in opposite),
        surface.vertices,
    )
