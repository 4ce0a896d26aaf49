"""Integers in messages: as numbers where every language reads them, else as strings."""

from clers.conformance.payloads import SAFE, Number


def to_wire(value: int) -> Number:
    """The integer as a message has it. Clause: ORCL-VALUE-1."""
    return value if -SAFE <= value <= SAFE else str(value)


def from_wire(number: Number) -> int:
    """The integer that a message has. Clause: ORCL-VALUE-1."""
    return int(number)
