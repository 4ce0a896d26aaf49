"""The walk as a script of operators on sheets: what the definition of decoding folds."""

from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.definition import steps
from clers.edgebreaker.stream import Stream
from clers.operators.handles import NOTHING, apply
from clers.operators.sheets.gate import at_gate
from clers.operators.sheets.operator import Constructive


def on_sheets(stream: Stream) -> Accepted[tuple[Constructive, ...]] | Rejected:
    """The operators of a stream's steps, each at the gate where it is. EB-FOLD-1, OPER-SHEET-7."""
    found = steps(stream)
    if isinstance(found, Rejected):
        return found
    grown, script = NOTHING, list[Constructive]()
    for step in found.value:
        for operator in step:
            after = apply(operator, grown)
            if isinstance(after, Rejected):
                return after
            script.append(at_gate(operator, grown))
            grown = after.value
    return Accepted(tuple(script))
