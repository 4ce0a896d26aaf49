"""Meshes to send through codecs of other people, and what comes back."""

import sys
from pathlib import Path
from typing import Final

import msgspec

from clers.conformance import payloads as form
from clers.conformance.judging.meshes import Differs, compare
from clers.meshfile.formats import Format
from clers.oracle.codecs.codec import Answer, Codec, Missing
from clers.oracle.codecs.draco import draco
from clers.oracle.codecs.files import files

CORNERS: Final = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
SOLID: Final = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
CLERS: Final = f"{sys.executable} -c 'from clers.cli.main import main; main()'"
BESIDE: Final = Path(sys.executable).parent


def mesh(
    *more: tuple[int, int, int],
    at: tuple[float, ...] = (),
    f64: bool = False,
    error: tuple[float, float, float] | msgspec.UnsetType = msgspec.UNSET,
) -> form.ThroughForm:
    """A tetrahedron, with more faces and more vertices."""
    places = form.Places(precision="f64" if f64 else "f32", coordinates=CORNERS + at)
    return form.ThroughForm(
        faces=SOLID + more, vertices=4 + len(at) // 3, positions=places, error=error
    )


BARE: Final = form.ThroughForm(faces=SOLID, vertices=4)
STRAY: Final = form.ThroughForm(faces=((0, 1, 4),), vertices=4)


def served(codec: Codec | Missing) -> Codec:
    assert isinstance(codec, Codec), codec.why
    return codec


def through(codec: Codec | Missing, given: form.ThroughForm) -> Answer:
    return served(codec).through(given)


def kinds(codec: Codec | Missing, given: form.ThroughForm) -> list[tuple[str, int]]:
    """The differences that a codec makes, by name."""
    back = through(codec, given)
    assert isinstance(back, form.MeshForm), back
    found = compare(given, back)
    return [(d.kind, d.count) for d in found.differences] if isinstance(found, Differs) else []


STANDARD: Final = draco("edgebreaker-standard", None)
VALENCE: Final = draco("edgebreaker-valence", None)
SEQUENTIAL: Final = draco("sequential", None)


def of_files(encode: str, decode: str, kind: Format = Format.PLY, **named: float) -> Codec:
    return served(files(encode, decode, kind, seconds=named.get("seconds", 60.0)))


COPY: Final = "cp {in} {out}"
