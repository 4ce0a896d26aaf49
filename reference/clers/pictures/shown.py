"""What laws and tests look for in a picture."""

from dataclasses import replace

from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.edgebreaker.encode import encode
from clers.pictures.draw import draw
from clers.pictures.options import Layout, Options
from clers.pictures.picture import Edge, Panel, Picture, Role, Shape


def flat_picture(surface: Surface, options: Options) -> Picture | Fails:
    """The walk over a surface in the flat layout, with labels."""
    flat = replace(options, layout=Layout.FLAT, labels=True)
    match draw(surface, encode(surface), None, flat):
        case Accepted(picture):
            return picture
        case Rejected() as rejected:
            return Fails("a picture", rejected.line(), rejected.where)


def shapes_of(panel: Panel) -> tuple[Shape, ...]:
    """The faces, in the order of painting."""
    return tuple(item for item in panel.ground if isinstance(item, Shape))


def edges_of(panel: Panel, *roles: Role) -> tuple[Edge, ...]:
    """The edges that show one of these things."""
    return tuple(item for item in panel.ground if isinstance(item, Edge) and item.role in roles)
