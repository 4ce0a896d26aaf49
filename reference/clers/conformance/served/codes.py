"""`code.encode` and `code.decode`: whatever codes the registry has, by their names."""

from clers.codes import registry
from clers.codes.closings import Closing
from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire
from clers.conformance.served.forms import bits_form, bits_of, stream_of
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.stream import Kind, Side


def named(name: str) -> registry.CodeName | None:
    """The code of this name, if there is one. Clause: ORCL-OP-6."""
    return next((code for code in registry.CodeName if code == name), None)


def encode(code: registry.CodeName, given: form.ToWord) -> Accepted[form.BitString] | Rejected:
    """A word to bits. Clause: ORCL-OP-6."""
    return and_then(registry.encode(code, stream_of(given)), lambda bits: Accepted(bits_form(bits)))


def decode(code: registry.CodeName, given: form.FromWord) -> Accepted[form.JustWord] | Rejected:
    """Bits to a word. Clause: ORCL-OP-6."""
    seen = closings_of(given)
    fault = registry.below_zero(seen)  # before the bits are unpacked
    if fault is not None:
        return fault
    word = and_then(
        bits_of(given.bits),
        lambda bits: registry.decode(
            code, bits, given.symbols, given.components_with_boundary, seen
        ),
    )
    return and_then(word, lambda w: Accepted(form.JustWord(word=w)))


def closings_of(given: form.FromWord) -> tuple[Closing, ...]:
    """The handle data of a message, as it is seen from the end. Clauses: ORCL-OP-6, CODE-HAND-1."""
    return tuple(
        Closing(from_wire(c.passed), Kind(c.kind), Side(c.side), from_wire(c.between))
        for c in given.closings
    )
