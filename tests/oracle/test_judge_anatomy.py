"""What each byte of a file is for. Clause: ORCL-DIVERGE-4."""

from itertools import pairwise
from typing import Final

import pytest
from judged_by_hand import divergence_of

from clers.codes import registry
from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface
from clers.complexes.surface import Surface
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.anatomy import BITS, COUNTS, Region, anatomy, region_at
from clers.conformance.judging.groups import END, Group, groups_of, groups_of_word
from clers.conformance.samples import SAMPLES
from clers.conformance.served.forms import mesh_form
from clers.container import file
from clers.container.options import Accuracy, Exact, InBits, Options
from clers.container.section import section
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.generate.families import grid_torus
from clers.geometry.mesh import Mesh
from clers.geometry.positions import Positions, Precision


def _torus() -> Surface:
    built = surface(grid_torus(3, 3))
    assert isinstance(built, Accepted)
    return built.value


TORUS: Final = _torus()
PLACES: Final = tuple(float(k * k % 11) for k in range(27))


def _file(precision: Precision | None, accuracy: Accuracy) -> bytes:
    placed = None if precision is None else Positions(precision, PLACES)
    found = file.encode(TORUS, placed, Options(CodeName.PLAIN, accuracy))
    assert isinstance(found, Accepted)
    return found.value


FILES: Final = {
    "none": _file(None, Exact()),
    "single": _file(Precision.F32, Exact()),
    "double": _file(Precision.F64, Exact()),
    "lattice": _file(Precision.F64, InBits(9)),
}
OPEN: Final = Stream("CRSRLEE", (), 1)
"""A disc."""

AXES: Final = "xyz"
NUMBERS: Final = ("exponent", "low x", "low y", "low z", "extent x", "extent y", "extent z")


@pytest.mark.parametrize("name", FILES)
def test_every_byte_has_a_meaning(name: str) -> None:
    """Clause: ORCL-DIVERGE-4: the regions follow each other without gaps, none is empty."""
    data = FILES[name]
    found = anatomy(data)
    assert found[0].start == 0
    assert found[-1].stop == len(data)
    assert all(one.stop == other.start for one, other in pairwise(found))
    assert all(one.start < one.stop for one in found)
    for byte in range(len(data)):
        region = region_at(found, byte)
        assert region is not None
        assert region.start <= byte < region.stop
    assert region_at(found, len(data)) is None


def _payload(name: str, tag: str) -> list[str]:
    """The meanings within a payload."""
    found = [region.meaning for region in anatomy(FILES[name]) if region.section == tag]
    assert found[:3] == ["the tag", "the length of the payload", "the seal of tag and length"]
    assert found[-1] == "the seal of the payload"
    return found[3:-1]


def test_head_and_words() -> None:
    """Clauses: ORCL-DIVERGE-4, FILE-HEAD-1, FILE-HAND-1, FILE-WORD-1."""
    head = _payload("none", "HEAD")
    assert head == ["the code of the word", "how positions are coded", *COUNTS]
    for tag in ("HAND", "WORD"):
        assert _payload("none", tag) == ["number of bits", BITS]


@pytest.mark.parametrize(("name", "width"), [("single", 4), ("double", 8)])
def test_exact_positions(name: str, width: int) -> None:
    """Clauses: ORCL-DIVERGE-4, GEOM-EXACT-1."""
    found = [region for region in anatomy(FILES[name]) if region.section == "POSN"][3:-1]
    assert [region.meaning for region in found] == [
        f"vertex {k // 3}, axis {AXES[k % 3]}" for k in range(27)
    ]
    assert {region.stop - region.start for region in found} == {width}


def test_a_lattice() -> None:
    """Clauses: ORCL-DIVERGE-4, FILE-POSN-2."""
    assert _payload("lattice", "POSN") == [*NUMBERS, "number of bits", BITS]


def test_what_is_no_file_has_no_regions() -> None:
    """Clause: ORCL-DIVERGE-4."""
    assert anatomy(b"") == ()
    assert anatomy(FILES["none"][:-1]) == ()


@pytest.mark.parametrize(
    ("payload", "meanings"),
    [(b"", []), (b"\xff", [BITS]), (b"\x06\xbc", ["number of bits", BITS])],
)
def test_a_section_whose_number_cannot_be_read(payload: bytes, meanings: list[str]) -> None:
    """Clause: ORCL-DIVERGE-4: sections are sound, their contents are not looked at."""
    head = SAMPLES["mesh.decode"].input
    assert isinstance(head, form.FileForm)
    data = bytes.fromhex(head.hex)[:32] + section("WORD", payload)
    found = anatomy(data)
    assert all(one.stop == other.start for one, other in pairwise(found))
    assert found[-1].stop == len(data)
    assert [region.meaning for region in found if region.section == "WORD"][3:-1] == meanings


def _region(name: str, tag: str, meaning: str) -> Region:
    return next(r for r in anatomy(FILES[name]) if r.section == tag and r.meaning == meaning)


@pytest.mark.parametrize(("tag", "bit"), [("HAND", 3), ("WORD", 17), ("POSN", 40)])
def test_the_first_bit_of_a_section(tag: str, bit: int) -> None:
    """Clauses: ORCL-DIVERGE-3, ORCL-DIVERGE-4: in WORD with its symbol."""
    mesh = mesh_form(Mesh(TORUS, Positions(Precision.F64, PLACES)))
    request = message.MeshEncode(
        id=0,
        input=form.ToFile(
            faces=mesh.faces,
            vertices=mesh.vertices,
            positions=mesh.positions,
            code="plain",
            accuracy=form.BitsForm(bits=9),
        ),
    )
    region = _region("lattice", tag, BITS)
    data = bytearray(FILES["lattice"])
    byte = region.start + bit // 8
    data[byte] ^= 0x80 >> bit % 8
    data[byte] ^= 1
    found = divergence_of(request, form.FileForm(hex=data.hex()))
    assert (found.byte, found.bit) == (byte, bit)
    assert found.place.startswith(f"byte {byte} of {tag}: the bits, bit {bit}")
    if tag == "WORD":
        word = encode(TORUS).stream.word
        written = [i for i, x in enumerate(word[1:], 1) for _ in range(1 if x == "C" else 3)]
        assert found.symbol == written[bit]
        assert found.place.endswith(f"written at symbol {written[bit]} ({word[written[bit]]})")
    else:
        assert "written" not in found.place


@pytest.mark.parametrize(
    ("code", "first", "last"),
    [
        (CodeName.PLAIN, 1, 16),
        (CodeName.GOLDEN, 1, END),
        (CodeName.HUFFMAN, END, 16),
        (CodeName.ADAPTIVE_1, 1, END),
        (CodeName.ADAPTIVE_3, 1, END),
        (CodeName.ADAPTIVE_6, 1, END),
    ],
)
@pytest.mark.parametrize("boundary", [False, True])
def test_groups_of_a_word(code: CodeName, first: int, last: int, boundary: bool) -> None:
    """Clause: ORCL-DIVERGE-3: they are all bits; the C that is implied has none."""
    stream = OPEN if boundary else encode(TORUS).stream
    implied = 0 if boundary else 1
    bits = registry.encode(code, stream)
    assert isinstance(bits, Accepted)
    found = groups_of_word(code, stream)
    assert found[0].start == 0
    assert found[-1].stop == bits.value.length
    assert all(one.stop == other.start for one, other in pairwise(found))
    letters = [group for group in found if group.symbol != END]
    assert [group.symbol for group in letters] == list(range(implied, len(stream.word)))
    assert "".join(group.name for group in letters) == stream.word[implied:]
    if not boundary:
        assert len(stream.word) == 17
        assert (found[0].symbol, found[-1].symbol) == (first, last)


def test_the_codewords_of_each_letter() -> None:
    """Clauses: ORCL-DIVERGE-3, CODE-PLAIN-1, CODE-HUFFMAN-1: one letter, one codeword."""
    stream = encode(TORUS).stream
    for code in (CodeName.PLAIN, CodeName.HUFFMAN):
        bits = registry.encode(code, stream)
        assert isinstance(bits, Accepted)
        digits = bits.value.digits()
        words = {
            (group.name, digits[group.start : group.stop])
            for group in groups_of_word(code, stream)
            if group.symbol != END
        }
        assert len(words) == len({name for name, _ in words}) == len(set(stream.word[1:]))
    table = groups_of_word(CodeName.HUFFMAN, stream)[0]
    assert table == Group(END, "the table", 0, 15)


@pytest.mark.parametrize("word", ["", "XRE", "CRXE"])
def test_what_no_code_takes_has_no_groups(word: str) -> None:
    """Clause: ORCL-DIVERGE-3."""
    for code in (CodeName.PLAIN, CodeName.GOLDEN, CodeName.HUFFMAN, CodeName.ADAPTIVE_3):
        assert groups_of_word(code, Stream(word, (), 0)) == ()
    assert groups_of_word(CodeName.BEST, Stream("CRE", (), 0)) == ()
    assert groups_of_word(None, Stream("CRE", (), 0)) == ()


def _coding(coder: form.CoderName, model: form.ModelForm, *symbols: int) -> tuple[Group, ...]:
    given = form.ToCode(coder=coder, model=model, symbols=symbols)
    return groups_of(message.ArithmeticEncode(id=0, input=given))


def test_groups_of_messages() -> None:
    """Clause: ORCL-DIVERGE-3: halves are one digit each; what is not allowed ends the list."""
    halves = form.StaticForm(frequencies=(1, 1))
    assert _coding("arithmetic", halves, 0, 1) == (
        Group(0, "0", 0, 1),
        Group(1, "1", 1, 2),
        Group(END, "the end", 2, 4),
    )
    assert _coding("arithmetic", halves, 0, 2) == (Group(0, "0", 0, 1),)
    assert _coding("arithmetic", halves, -1) == ()
    assert _coding("arithmetic", form.StaticForm(frequencies=(1, 0, 1)), 1) == ()
    assert _coding("arithmetic", form.StaticForm(frequencies=()), 0) == ()
    assert _coding("range", halves, 0) == ()
    assert groups_of(SAMPLES["word.decode"]) == ()


def test_a_group_in_words() -> None:
    """Clause: ORCL-DIVERGE-3."""
    assert Group(3, "S", 0, 1).told() == "symbol 3 (S)"
    assert Group(END, "the end", 0, 1).told() == "the end"
