"""A reader allocates what bytes justify: hostile counts cost nothing, good files a factor."""

from tracemalloc import get_traced_memory, start, stop

import pytest
from by_hand import TETRAHEDRON, WORD, file

from clers.complexes.corner_table import surface
from clers.container.file import decode, encode
from clers.container.options import InBits, Options
from clers.conventions.result import Accepted, Rejected
from clers.generate.families import sphere_of
from clers.geometry.positions import Positions, Precision

MANY = "80 80 80 20"
"""2^26 as a varint: the most that the default limits allow."""

HOSTILE = {
    "faces": file(("HEAD", f"01 01 {MANY} 04 00 03 00"), ("WORD", WORD)),
    "vertices": file(("HEAD", f"01 01 04 {MANY} 00 03 00"), ("WORD", WORD)),
    "components": file(("HEAD", f"01 01 04 04 {MANY} 03 00"), ("WORD", WORD)),
    "symbols": file(("HEAD", f"02 01 {MANY} {MANY} 00 {MANY} 00"), ("WORD", WORD)),
    "records": file(("HEAD", f"01 01 04 04 00 03 {MANY}"), ("HAND", "00"), ("WORD", WORD)),
    "bits": file(("HEAD", "01 01 04 04 00 03 00"), ("WORD", "ff ff ff ff ff 1f bc")),
    "exact": file(
        ("HEAD", f"01 03 04 {MANY} 00 03 00"), ("WORD", WORD), ("POSN", "00 00 00 00 00 00 00 00")
    ),
    "residuals": file(
        ("HEAD", f"01 04 04 {MANY} 00 03 00"),
        ("WORD", WORD),
        ("POSN", "00 00 00 00 00 00 00 ff ff ff ff ff 1f 40"),
    ),
    "length": TETRAHEDRON[:13] + b"\xff\xff\xff\xff" + TETRAHEDRON[17:],
}


def peak(data: bytes) -> int:
    """The most bytes allocated at one time while decoding."""
    start()
    try:
        decode(data)
        return get_traced_memory()[1]
    finally:
        stop()


@pytest.mark.parametrize("name", HOSTILE)
def test_declared_counts_allocate_nothing(name: str) -> None:
    """Each declares tens of millions of something in fewer than a hundred bytes.

    Clauses: FILE-COUNT-1, FILE-COUNT-2, FILE-COUNT-3, FILE-COUNT-4.
    """
    assert isinstance(decode(HOSTILE[name]), Rejected)
    assert peak(HOSTILE[name]) < 100_000


def test_memory_is_linear() -> None:
    """Four times the faces, at most six times the memory (quadratic: 16). Clause: FILE-COUNT-4."""
    small, large = (peak(_sphere(faces)) for faces in (800, 3200))
    assert large < 6 * small


def _sphere(faces: int) -> bytes:
    built = surface(sphere_of(faces))
    assert isinstance(built, Accepted)
    count = built.value.vertices
    flat = tuple((v * v % 101) / 8 for v in range(3 * count))
    found = encode(built.value, Positions(Precision.F32, flat), Options(accuracy=InBits(12)))
    assert isinstance(found, Accepted)
    return found.value
