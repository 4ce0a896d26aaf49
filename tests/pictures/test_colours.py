"""The palette, for all eyes."""

from itertools import combinations
from typing import Final

import numpy as np
import numpy.typing as npt
import pytest
from pictured import picture

from clers.edgebreaker.examples import TORUS
from clers.pictures.palette import COLOURS, INK, PAPER, Colour, Letter, readable_on

Matrix = npt.NDArray[np.float64]

EYES: Final[dict[str, Matrix]] = {
    "all cones": np.eye(3),
    "no red": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "no green": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "no blue": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
}
"""Machado, Oliveira and Fernandes (2009), severity 1, for linear light."""


def linear(colour: Colour) -> Matrix:
    """The sRGB transfer function, undone."""
    values = np.array([int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def lab(light: Matrix) -> Matrix:
    """CIELAB under D65."""
    to_xyz = np.array(
        [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    )
    x, y, z = to_xyz @ np.clip(light, 0, 1) / to_xyz.sum(axis=1)
    fx, fy, fz = (
        np.cbrt(t) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29 for t in (x, y, z)
    )
    return np.array([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)])


@pytest.mark.parametrize("eye", EYES)
def test_letters_are_told_apart(eye: str) -> None:
    """Clause: TOOL-PICTURE-3."""
    seen = {letter: lab(EYES[eye] @ linear(COLOURS[letter])) for letter in Letter}
    near = {
        (a.value, b.value): float(np.linalg.norm(seen[a] - seen[b]))
        for a, b in combinations(Letter, 2)
    }
    assert len(near) == 28
    assert min(near.values()) >= 15, min(near, key=lambda pair: near[pair])


def contrast(a: Colour, b: Colour) -> float:
    """By WCAG 2."""
    low, high = sorted(float(linear(c) @ (0.2126, 0.7152, 0.0722)) for c in (a, b))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("letter", Letter)
def test_letters_can_be_read(letter: Letter) -> None:
    """Clause: TOOL-PICTURE-3."""
    colour = COLOURS[letter]
    chosen = contrast(readable_on(colour), colour)
    assert chosen == max(contrast(INK, colour), contrast(PAPER, colour))
    assert chosen >= 4.5


def test_legend_counts_the_walk() -> None:
    """CCCCRCSCRSSRLSEEE, after P, with two S of handles. Clause: TOOL-PICTURE-3."""
    counts = {letter.value: count for letter, count in picture(TORUS).counts}
    assert counts == {"P": 1, "C": 6, "L": 1, "E": 3, "R": 3, "S": 2, "Sh": 2}
