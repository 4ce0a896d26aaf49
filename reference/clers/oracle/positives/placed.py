"""Coordinates for surfaces that have none: exact in binary, and the same on every machine."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ldexp
from random import Random
from typing import Final, Literal

from msgspec import UNSET

from clers.complexes.surface import Surface
from clers.conformance import payloads as form
from clers.conformance.cases.case import Origin
from clers.conformance.served.forms import faces_form
from clers.oracle.positives.stock import Named

Kind = Literal["f32", "f64"]


@dataclass(frozen=True, slots=True)
class Placed:
    """A named mesh with its positions, if it has any, and what is remarkable about these."""

    slug: str
    surface: Surface
    positions: form.Places | None
    origin: Origin
    flags: tuple[str, ...] = ()
    comment: str = ""


def coarse(vertices: int, seed: int) -> form.Places:
    """Multiples of 1/256 from −8 to 8 at random, as binary32."""
    draw = Random(seed).random
    numbers = tuple(ldexp(int(draw() * 4096) - 2048, -8) for _ in range(3 * vertices))
    return form.Places(precision="f32", coordinates=numbers)


def fine(vertices: int, seed: int) -> form.Places:
    """Numbers from −1 to 1 at random with all the digits of binary64."""
    draw = Random(seed).random
    return form.Places(
        precision="f64", coordinates=tuple(2 * draw() - 1 for _ in range(3 * vertices))
    )


def smooth(surface: Surface) -> form.Places:
    """Each vertex amid its neighbours, several times over: what predictions are made for.

    Begins with the vertices on a parabola in space, and uses sums and halves alone.
    """
    count = surface.vertices
    around: list[set[int]] = [set() for _ in range(count)]
    for a, b, c in surface.triangles():
        around[a] |= {b, c}
        around[b] |= {c, a}
        around[c] |= {a, b}
    places = [(float(v), float(v * v % 97), float(v * 31 % 89)) for v in range(count)]
    for _ in range(8):
        places = [
            _between(here, [places[u] for u in sorted(around[v])]) for v, here in enumerate(places)
        ]
    flat = tuple(ldexp(float(round(ldexp(x, 12))), -12) for place in places for x in place)
    return form.Places(precision="f64", coordinates=flat)


def _between(
    here: tuple[float, float, float], others: Sequence[tuple[float, float, float]]
) -> tuple[float, float, float]:
    n = len(others)
    x, y, z = (sum(column) / n for column in zip(*others, strict=True))
    return (here[0] + x) / 2, (here[1] + y) / 2, (here[2] + z) / 2


def mesh_form(surface: Surface, positions: form.Places | None) -> form.MeshForm:
    """A mesh as a message has it. Clause: ORCL-OP-7."""
    of = faces_form(surface)
    return form.MeshForm(
        faces=of.faces, vertices=of.vertices, positions=UNSET if positions is None else positions
    )


def bare(named: Named) -> Placed:
    """Without positions."""
    return Placed(
        f"{named.slug}-bare", named.surface, None, named.origin, ("no-positions",), named.comment
    )


def placed(named: Named, positions: form.Places, word: str, *flags: str) -> Placed:
    """With these; `word` says what is about them."""
    slug = f"{named.slug}-{word}"
    return Placed(slug, named.surface, positions, named.origin, flags, named.comment)


def repeated(kind: Kind, values: Sequence[float], vertices: int) -> form.Places:
    """These numbers again and again, as many as are needed."""
    numbers = tuple(values[k % len(values)] for k in range(3 * vertices))
    return form.Places(precision=kind, coordinates=numbers)


TINY: Final = ldexp(1.0, -1074)
TINY_32: Final = ldexp(1.0, -149)
HUGE: Final = ldexp(2.0 - ldexp(1.0, -52), 1023)
HUGE_32: Final = ldexp(2.0 - ldexp(1.0, -23), 127)

EDGES: Final[Mapping[str, tuple[Kind, tuple[float, ...], tuple[str, ...]]]] = {
    "negative-zero": ("f64", (-0.0, 0.0, 1.0, -0.0, -1.0), ("negative-zero",)),
    "negative-zero-f32": ("f32", (-0.0, 0.0, 1.0, -0.0, -1.0), ("negative-zero",)),
    "subnormal": ("f64", (TINY, -TINY, 3 * TINY, 0.0, ldexp(1.0, -1030)), ("subnormal",)),
    "subnormal-f32": ("f32", (TINY_32, -TINY_32, 5 * TINY_32, ldexp(1.0, -130)), ("subnormal",)),
    "greatest": ("f64", (HUGE, -HUGE, 1.0, TINY), ("greatest", "subnormal")),
    "greatest-f32": ("f32", (HUGE_32, -HUGE_32, 1.0, 0.5), ("greatest",)),
    "tenths": ("f64", (0.1, 0.2, 0.3, 0.7, -0.1), ("shortest-digits",)),
    "thirds": ("f64", (1 / 3, 2 / 3, -1 / 3, 4 / 3, 1e22, 1e-7), ("shortest-digits",)),
    "one-place": ("f64", (0.25,), ("no-extent",)),
    "one-line": ("f64", (0.0, 5.0, 5.0, 1.0, 5.0, 5.0, 2.0, 5.0, 5.0), ("no-extent",)),
}
"""Coordinates at the edges of what there is: the precision, numbers to repeat, flags."""

HALVES: Final = (0.5, 1.5, 2.5, -0.5, -1.5, -2.5, 0.49999999999999994, 3.0)
"""Exactly between two lattice numbers, or next to it. Clause: GEOM-LATTICE-2."""
