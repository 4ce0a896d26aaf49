"""A view: vertices at their positions, seen from far away, the far faces painted first."""

from math import cos, radians, sin
from typing import Final

import numpy as np

from clers.complexes.surface import Face, Surface
from clers.geometry.positions import Positions
from clers.pictures.drawing import Drawing
from clers.pictures.tutte import Floats

TURN: Final = (radians(25), radians(15))
"""How far to the right and up of the direction of least spread we stand, to see depth."""

FLAT: Final = 1e-6
"""With a variance of less than this fraction of the greatest, a mesh is seen straight on."""

LIGHT: Final = (-0.4, 0.55, 0.73)
"""Where the light comes from: right, up, towards us."""


def view(
    surface: Surface, positions: Positions, direction: tuple[float, float, float] | None
) -> Drawing:
    """The surface seen from a direction, or from the one of TOOL-PICTURE-8."""
    places = np.array(positions.coordinates, dtype=np.float64).reshape(-1, 3)
    span = float(np.abs(places).max()) or 1.0
    places = places / span
    places = places - places.mean(axis=0)
    frame = _frame(places, direction)
    seen = places @ frame.T
    at = seen[np.array(surface.vertex, dtype=np.int64)].reshape(-1, 3, 3)
    a, b, c = at[:, 0], at[:, 1], at[:, 2]
    normal = np.cross(b - a, c - a)
    length = np.sqrt((normal**2).sum(axis=1))
    normal = normal / np.where(length > 0, length, 1.0)[:, None]
    far = normal[:, 2] < 0
    towards_us = np.where(far[:, None], -normal, normal)
    light = np.clip(towards_us @ np.array(LIGHT), 0.0, 1.0)
    order = np.argsort(at[:, :, 2].mean(axis=1), kind="stable")
    return Drawing(
        corners=tuple((x, y) for x, y in at[:, :, :2].reshape(-1, 2).tolist()),
        order=tuple(Face(f) for f in order.tolist()),
        far=tuple(far.tolist()),
        light=tuple(light.tolist()),
        deep=True,
    )


def _frame(places: Floats, direction: tuple[float, float, float] | None) -> Floats:
    """Rows: to the right, up, towards us. Clause: TOOL-PICTURE-8."""
    if direction is not None:
        towards = np.array(direction, dtype=np.float64)
        return _upright(towards / np.sqrt(float(towards @ towards)))
    spread, axes = np.linalg.eigh(places.T @ places)
    towards = axes[:, 0]
    if towards[np.argmax(np.abs(towards))] < 0:
        towards = -towards
    frame = _upright(towards)
    if spread[0] <= FLAT * spread[2]:
        return frame
    turn, rise = TURN
    level = cos(turn) * frame[2] + sin(turn) * frame[0]
    return _upright(cos(rise) * level + sin(rise) * frame[1])


def _upright(towards: Floats) -> Floats:
    """The second axis is up, unless we look along it: then the third is."""
    up = np.array([0.0, 1.0, 0.0]) if abs(float(towards[1])) < 0.9 else np.array([0.0, 0.0, 1.0])
    right = np.cross(up, towards)
    right = right / np.sqrt(float(right @ right))
    return np.stack([right, np.cross(towards, right), towards])
