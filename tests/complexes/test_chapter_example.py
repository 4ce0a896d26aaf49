"""The tables of chapter 3 are true: its example and its small faults, read from the text."""

import re
from pathlib import Path

from golden_complexes import BAND, accepted

from clers.complexes.canonical import canonical_form, code
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Corner, next_corner, previous_corner
from clers.complexes.topology import curves
from clers.conventions.result import Rejected
from clers.conventions.where import AtEdge, AtFace, AtVertex, Where

CHAPTER = (Path(__file__).parents[2] / "spec" / "03-complexes.md").read_text(encoding="utf-8")


def row(label: str, length: int) -> list[str]:
    """The cells of the one table row of a length that begins with a label."""
    rows = [line.strip("| ").split(" | ") for line in CHAPTER.splitlines()]
    (found,) = [cells for cells in rows if cells[0] == label and len(cells) == length + 1]
    return found[1:]


def triple(text: str) -> tuple[int, int, int]:
    a, b, c = map(int, text.split())
    return a, b, c


def test_the_bands_faces() -> None:
    """Clause: CPLX-INPUT-1."""
    assert tuple(map(triple, row("vertices", 6))) == BAND.faces


def test_the_bands_corner_table() -> None:
    """Clauses: CPLX-CORNER-1, CPLX-CORNER-2."""
    band = accepted(BAND)
    corners = [Corner(c) for c in range(18)]
    edges = [f"{band.vertex[next_corner(c)]}→{band.vertex[previous_corner(c)]}" for c in corners]
    assert row("corner", 18) == [str(c) for c in corners]
    assert row("face", 18) == [str(c // 3) for c in corners]
    assert row("vertex", 18) == [str(v) for v in band.vertex]
    assert row("edge", 18) == edges
    assert row("opposite", 18) == ["–" if d < 0 else str(d) for d in band.opposite]


def test_the_bands_curves() -> None:
    """Clause: CPLX-CURVE-3."""
    said = re.findall(r"it is ([\d, ]+), along the corners ([\d, ]+)", CHAPTER)
    expected = [
        (", ".join(map(str, curve.vertices)), ", ".join(map(str, curve.corners)))
        for curve in curves(accepted(BAND))
    ]
    assert said == expected


def test_the_bands_canonical_form() -> None:
    """Clause: CPLX-ISO-5."""
    (said,) = re.findall(r"^\$\$(-1, [-\d, \\quad]+)\.\$\$$", CHAPTER, re.MULTILINE)
    (least,) = canonical_form(accepted(BAND))
    assert tuple(map(int, said.replace("\\quad", "").split(","))) == least
    same = [c for c in range(18) if code(accepted(BAND), Corner(c)) == least]
    assert same == [2, 3, 8, 9, 14, 15]


def test_the_table_of_faults() -> None:
    """Clauses: CPLX-REJECT-1 … CPLX-REJECT-9. Each row is rejected as it says."""
    rows = re.findall(r"^\| `([a-z-]+)`.*? \| (\d+) \| (.*?) \| (.*?) \|$", CHAPTER, re.MULTILINE)
    assert len(rows) == 8
    for reason, n, listed, blamed in rows:
        faces = () if listed == "–" else tuple(map(triple, listed.split(", ")))
        answer = surface(FaceList(faces, int(n)))
        assert isinstance(answer, Rejected)
        assert answer.reason == reason
        assert in_the_tables_words(answer.where) == blamed


def in_the_tables_words(where: Where) -> str:
    match where:
        case AtFace(face):
            return f"face {face}"
        case AtEdge(tail, head, face):
            return f"edge {tail}→{head} of face {face}"
        case AtVertex(vertex):
            return f"vertex {vertex}"
        case _:
            return "the whole"
