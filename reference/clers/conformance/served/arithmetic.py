"""`arithmetic.encode` and `arithmetic.decode`."""

from collections.abc import Mapping
from typing import Final, assert_never

from clers.arithmetic.coder import REFERENCE, Coder
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.rans import RANS
from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.served.forms import bits_form, bits_of
from clers.conventions.result import Accepted, Rejected, and_then
from clers.information.adaptive import adaptive
from clers.information.model import Model
from clers.information.static import static, uniform

CODERS: Final[Mapping[form.CoderName, Coder]] = {
    "arithmetic": REFERENCE,
    "range": RANGE_CODER,
    "rans": RANS,
}
"""Clause: ORCL-OP-4."""


def _accepted(model: Model) -> Accepted[Model]:
    return Accepted(model)


def model_of(given: form.ModelForm) -> Accepted[Model] | Rejected:
    """The model of a message, checked. Clause: ORCL-OP-4."""
    match given:
        case form.StaticForm(frequencies=frequencies):
            return and_then(static(tuple(map(from_wire, frequencies))), _accepted)
        case form.UniformForm(size=size):
            return and_then(uniform(from_wire(size)), _accepted)
        case form.AdaptiveForm(frequencies=frequencies, increment=increment, limit=limit):
            table = tuple(map(from_wire, frequencies))
            learning = adaptive(table, from_wire(increment), from_wire(limit))
            return and_then(learning, _accepted)
        case _:
            assert_never(given)


def encode(given: form.ToCode) -> Accepted[form.BitString] | Rejected:
    """Symbols to bits. Clause: ORCL-OP-4."""
    coder, symbols = CODERS[given.coder], tuple(map(from_wire, given.symbols))
    bits = and_then(model_of(given.model), lambda model: coder.encode(model, symbols))
    return and_then(bits, lambda b: Accepted(bits_form(b)))


def decode(given: form.Coded) -> Accepted[form.Symbols] | Rejected:
    """Bits to symbols. Clause: ORCL-OP-4."""
    coder, model = CODERS[given.coder], model_of(given.model)
    if isinstance(model, Rejected):
        return model
    found = and_then(bits_of(given.bits), lambda bits: coder.decode(model.value, bits, given.count))
    return and_then(found, lambda s: Accepted(form.Symbols(symbols=tuple(map(to_wire, s)))))
