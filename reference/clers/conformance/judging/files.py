"""Where files part: the byte, its section, and what it says. Clause: ORCL-DIVERGE-4."""

from clers.conformance import payloads as form
from clers.conformance.judging.anatomy import anatomy, region_at
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import NOTHING, parting


def of_file(right: form.FileForm, got: form.FileForm) -> Divergence | None:
    """The first byte, with its section and meaning in the file that is right. ORCL-DIVERGE-4."""
    expected, given = bytes.fromhex(right.hex), bytes.fromhex(got.hex)
    i = parting(expected, given)
    if i is None:
        return None
    region = region_at(anatomy(expected), i)
    within = "" if region is None else f" of {region.section}" if region.section else ""
    meaning = "" if region is None else f": {region.meaning}"
    return Divergence(
        kind=f"byte{within}",
        place=f"byte {i}{within}{meaning}",
        expected=_byte(expected, i),
        got=_byte(given, i),
        byte=i,
    )


def _byte(data: bytes, i: int) -> str:
    return f"{data[i]:02x}" if i < len(data) else NOTHING
