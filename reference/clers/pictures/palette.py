"""The letters that pictures tell apart, and their colours."""

from enum import StrEnum
from typing import Final

Colour = str
"""#rrggbb."""


class Letter(StrEnum):
    """P, a symbol of the word, or one of the two kinds of S with a record. Clause: EB-HANDLE-2."""

    P = "P"
    C = "C"
    L = "L"
    E = "E"
    R = "R"
    S = "S"
    SH = "Sh"
    SB = "Sb"


COLOURS: Final[dict[Letter, Colour]] = {
    Letter.P: "#5c5c5c",
    Letter.C: "#7cc4ee",
    Letter.L: "#009e73",
    Letter.E: "#cc79a7",
    Letter.R: "#f0e442",
    Letter.S: "#e69f00",
    Letter.SH: "#d55e00",
    Letter.SB: "#0072b2",
}
"""After Okabe and Ito (2008), who chose colours that all eyes tell apart. TOOL-PICTURE-3."""

PAPER: Final = "#ffffff"
INK: Final = "#1a1a1a"
FAINT: Final = "#b8b8b8"
GATE: Final = "#6a0dad"
MORSE: Final = "#c00000"
REMAINDER: Final = "#1f4fb4"
TREE: Final = "#111111"
POINTER: Final = "#d6006c"
SEAM: Final = "#8a8a8a"


def channels(colour: Colour) -> tuple[int, int, int]:
    """Red, green and blue, from 0 to 255."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def mixed(colour: Colour, other: Colour, share: float) -> Colour:
    """A colour with this share of another, from 0 to 1."""
    pairs = zip(channels(colour), channels(other), strict=True)
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def readable_on(colour: Colour) -> Colour:
    """Ink or paper, whichever stands out more from a colour, by WCAG's relative luminance."""
    linear = [
        value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
        for value in (channel / 255 for channel in channels(colour))
    ]
    luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return INK if (luminance + 0.05) ** 2 > 1.05 * 0.06 else PAPER
