"""Surfaces counted, walked and put together again: three cases of each mesh of the stock."""

from collections.abc import Iterable, Iterator
from typing import Final

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Trace
from clers.conformance.numbers import to_wire
from clers.conformance.served.forms import faces_form, handle_forms
from clers.conventions.clause import Clause
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Kind, Stream
from clers.oracle.positives.asked import TRACED, Asked, needed
from clers.oracle.positives.features import features
from clers.oracle.positives.stock import Named

_OF_SYMBOL: Final = {
    "C": Clause.EB_TRAVERSE_2,
    "R": Clause.EB_TRAVERSE_3,
    "L": Clause.EB_TRAVERSE_4,
    "E": Clause.EB_TRAVERSE_5,
    "S": Clause.EB_TRAVERSE_6,
}
_RECORDS: Final = (
    Clause.EB_HANDLE_1,
    Clause.EB_HANDLE_2,
    Clause.EB_HANDLE_3,
    Clause.EB_HANDLE_4,
    Clause.EB_HANDLE_5,
)


def stream_form(stream: Stream) -> form.StreamForm:
    """A stream as a message has it. Clause: ORCL-OP-5."""
    return form.StreamForm(
        word=stream.word,
        handles=handle_forms(stream.records),
        components_with_boundary=to_wire(stream.components_with_boundary),
    )


def walked(stream: Stream, *, closed: bool) -> tuple[Clause, ...]:
    """The clauses that a walk goes by; `closed`: is a component? Clause: ORCL-CASE-1."""
    with_boundary = stream.components_with_boundary > 0
    return (
        *([Clause.EB_COMPONENT_1, Clause.EB_COMPONENT_4] if with_boundary else []),
        *([Clause.EB_COMPONENT_2] if closed else []),
        *([Clause.EB_COMPONENT_3] if closed and with_boundary else []),
        *(clause for symbol, clause in _OF_SYMBOL.items() if symbol in stream.word),
        *(
            [Clause.EB_TRAVERSE_7]
            if any(record.kind is Kind.BOUNDARY for record in stream.records)
            else []
        ),
        *(_RECORDS if stream.records else ()),
        Clause.EB_ORDER_1,
        *([Clause.EB_ORDER_2] if with_boundary else []),
    )


def trace_of(surface: Surface) -> Trace:
    """Small surfaces have their trace in the case. Clause: ORCL-CASE-1."""
    return "full" if surface.faces <= TRACED else "none"


def of_trace(surface: Surface) -> tuple[Clause, ...]:
    """The clause of the trace, if there is one."""
    return (Clause.EB_TRACE_1,) if surface.faces <= TRACED else ()


def classified(named: Named) -> Asked:
    """The mesh in numbers."""
    surface = named.surface
    curved = any(part.curves for part in components(surface))
    return Asked(
        named.slug,
        "surface.classify",
        message.Classify(id=0, input=faces_form(surface)),
        (
            Clause.CPLX_COMPONENT_1,
            Clause.CPLX_COMPONENT_2,
            Clause.CPLX_COMPONENT_3,
            *([Clause.CPLX_CURVE_1] if curved else []),
        ),
        named.origin,
        needed(surface),
        surface.faces,
        tuple(flag for flag in features(surface) if flag in _OF_COMPONENTS),
        named.comment,
    )


_OF_COMPONENTS: Final = ("many-components", "lone-triangle", "high-genus")
"""The flags that have nothing to do with a walk."""


def encoded(named: Named) -> Asked:
    """The mesh as a word."""
    surface = named.surface
    stream = encode(surface).stream
    closed = any(not part.curves for part in components(surface))
    return Asked(
        named.slug,
        "word.encode",
        message.WordEncode(id=0, trace=trace_of(surface), input=faces_form(surface)),
        (*walked(stream, closed=closed), *of_trace(surface)),
        named.origin,
        needed(surface),
        surface.faces,
        (*features(surface), *(["shuffled-numbering"] if named.origin == "generated" else [])),
        named.comment,
    )


def decoded(named: Named) -> Asked:
    """The mesh out of its word."""
    surface = named.surface
    stream = encode(surface).stream
    closed = any(not part.curves for part in components(surface))
    return Asked(
        named.slug,
        "word.decode",
        message.WordDecode(id=0, trace=trace_of(surface), input=stream_form(stream)),
        (Clause.EB_DECODE_1, *walked(stream, closed=closed), Clause.EB_ORDER_3, *of_trace(surface)),
        named.origin,
        needed(surface),
        surface.faces,
        features(surface),
        named.comment,
    )


def walks(stock: Iterable[Named]) -> Iterator[Asked]:
    """Three cases of each mesh."""
    for named in stock:
        yield classified(named)
        yield encoded(named)
        yield decoded(named)
