"""An image as a part of an HTML page: no name of it is one of another image's. ORCL-HTML-3."""

from clers.pictures.beside import renamed
from clers.pictures.scene import Scene
from clers.pictures.svg import svg_of


def inline(image: Scene, prefix: str, title: str) -> str:
    """The `svg` element, its ids and classes with a prefix, its title in its place."""
    document = svg_of(renamed(image, prefix, title))
    return document.partition("?>\n")[2].rstrip("\n")
