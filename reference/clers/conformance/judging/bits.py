"""Where strings of bits part. Clause: ORCL-DIVERGE-3."""

from msgspec import UNSET

from clers.conformance import payloads as form
from clers.conformance.judging.groups import END, Groups
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import parting, shown


def of_bits(right: form.BitString, got: form.BitString, groups: Groups) -> Divergence | None:
    """The first bit; else the number of bits; else the bits that fill the last byte.

    Clauses: ORCL-DIVERGE-3, ORCL-VALUE-2.
    """
    expected, given = bits_in(right), bits_in(got)
    i = parting(expected, given)
    if i is not None:
        group = next((group for group in groups() if group.start <= i < group.stop), None)
        return Divergence(
            kind="bit",
            place=f"bit {i}" if group is None else f"bit {i}, written at {group.told()}",
            expected=shown(expected, i),
            got=shown(given, i),
            bit=i,
            symbol=UNSET if group is None or group.symbol == END else group.symbol,
        )
    if right.length != got.length:
        return Divergence(
            kind="number of bits",
            place="the number of bits",
            expected=str(right.length),
            got=str(got.length),
        )
    if right.hex != got.hex:
        return Divergence(
            kind="filling bits",
            place=f"the bytes after bit {right.length - 1}",
            expected=f"{right.hex[-2:]} at the end",
            got=f"{got.hex[-2:]} at the end",
        )
    return None


def bits_in(given: form.BitString) -> str:
    """The bits that there are, at most the number said, as digits. Clause: ORCL-VALUE-2."""
    digits = "".join(f"{byte:08b}" for byte in bytes.fromhex(given.hex))
    return digits[: given.length]
