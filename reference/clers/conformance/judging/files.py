"""Where files part: the byte, its section, and what it says. Clause: ORCL-DIVERGE-4."""

from msgspec import UNSET

from clers.conformance import payloads as form
from clers.conformance.judging.anatomy import BITS, Region, anatomy, region_at
from clers.conformance.judging.groups import END, Group, groups_of_word
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import NOTHING, parting
from clers.container.contents import parse
from clers.conventions.result import Rejected


def of_file(right: form.FileForm, got: form.FileForm) -> Divergence | None:
    """The first byte, with its section and meaning in the file that is right. ORCL-DIVERGE-4."""
    expected, given = bytes.fromhex(right.hex), bytes.fromhex(got.hex)
    i = parting(expected, given)
    if i is None:
        return None
    region = region_at(anatomy(expected), i)
    within = f" of {region.section}" if region is not None and region.section else ""
    meaning = f": {region.meaning}" if region is not None else ""
    bit = None if region is None else _bit(expected, given, region, i)
    group = _written(expected, bit) if bit is not None and within == " of WORD" else None
    return Divergence(
        kind=f"byte{within}",
        place=f"byte {i}{within}{meaning}"
        + ("" if bit is None else f", bit {bit}")
        + ("" if group is None else f", written at {group.told()}"),
        expected=_byte(expected, i),
        got=_byte(given, i),
        byte=i,
        bit=UNSET if bit is None else bit,
        symbol=UNSET if group is None or group.symbol == END else group.symbol,
    )


def _bit(right: bytes, got: bytes, region: Region, i: int) -> int | None:
    """Which of a section's bits it is, where the byte is one of those in both files."""
    if region.meaning != BITS or i >= len(got):
        return None
    return 8 * (i - region.start) + 8 - (right[i] ^ got[i]).bit_length()


def _written(data: bytes, bit: int) -> Group | None:
    """The symbol that a bit of WORD is written at, where that is known. ORCL-DIVERGE-3."""
    contents = parse(data)
    if isinstance(contents, Rejected):
        return None
    groups = groups_of_word(contents.value.code, contents.value.stream)
    return next((group for group in groups if group.start <= bit < group.stop), None)


def _byte(data: bytes, i: int) -> str:
    return f"{data[i]:02x}" if i < len(data) else NOTHING
