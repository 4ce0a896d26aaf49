"""Where strings of bits part. Clause: ORCL-DIVERGE-3."""

from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import parting, shown


def of_bits(right: form.BitString, got: form.BitString) -> Divergence | None:
    """The first bit; else the number of bits; else the bits that fill the last byte.

    Clauses: ORCL-DIVERGE-3, ORCL-VALUE-2.
    """
    expected, given = bits_in(right), bits_in(got)
    i = parting(expected, given)
    if i is not None:
        return Divergence(
            kind="bit", place=f"bit {i}", expected=shown(expected, i), got=shown(given, i), bit=i
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
