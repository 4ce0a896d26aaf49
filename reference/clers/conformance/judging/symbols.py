"""Where messages of symbols part. Clause: ORCL-DIVERGE-6."""

from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.parting import parting, shown
from clers.conformance.numbers import from_wire


def of_symbols(right: form.Symbols, got: form.Symbols) -> Divergence | None:
    """The first symbol. Clause: ORCL-DIVERGE-6."""
    expected = list(map(from_wire, right.symbols))
    given = list(map(from_wire, got.symbols))
    i = parting(expected, given)
    if i is None:
        return None
    return Divergence(
        kind="symbol",
        place=f"symbol {i}",
        expected=shown(expected, i),
        got=shown(given, i),
        symbol=i,
    )
