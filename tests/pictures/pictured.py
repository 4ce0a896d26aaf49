"""Pictures to test, and a surface of as many faces as wanted."""

from math import cos, pi, sin

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.geometry.positions import Positions, Precision, positions
from clers.pictures.draw import draw
from clers.pictures.options import DEFAULT, Options
from clers.pictures.picture import Picture


def picture(of: Surface, options: Options = DEFAULT, at: Positions | None = None) -> Picture:
    """The picture, which is not refused."""
    drawn = draw(of, encode(of), at, options)
    assert isinstance(drawn, Accepted), drawn
    return drawn.value


def built(faces: list[tuple[int, int, int]], vertices: int) -> Surface:
    """The surface of a good face list."""
    made = surface(FaceList(tuple(faces), vertices))
    assert isinstance(made, Accepted), made
    return made.value


def placed(of: Surface, points: list[tuple[float, float, float]]) -> Positions:
    """Positions for a surface."""
    made = positions(Precision.F64, [x for point in points for x in point], of.vertices)
    assert isinstance(made, Accepted), made
    return made.value


def globe(rows: int, columns: int) -> tuple[Surface, Positions]:
    """A sphere of 2 · (rows − 1) · columns faces, with positions."""
    north, south = 0, 1 + (rows - 1) * columns

    def at(row: int, column: int) -> int:
        return 1 + (row - 1) * columns + column % columns

    points = [(0.0, 1.0, 0.0)]
    for row in range(1, rows):
        ring, height = sin(pi * row / rows), cos(pi * row / rows)
        around = [2 * pi * column / columns for column in range(columns)]
        points += [(ring * cos(angle), height, ring * sin(angle)) for angle in around]
    points.append((0.0, -1.0, 0.0))
    faces = [(north, at(1, j + 1), at(1, j)) for j in range(columns)]
    for row in range(1, rows - 1):
        for j in range(columns):
            faces.append((at(row, j), at(row, j + 1), at(row + 1, j)))
            faces.append((at(row, j + 1), at(row + 1, j + 1), at(row + 1, j)))
    faces += [(south, at(rows - 1, j), at(rows - 1, j + 1)) for j in range(columns)]
    of = built(faces, south + 1)
    return of, placed(of, points)
