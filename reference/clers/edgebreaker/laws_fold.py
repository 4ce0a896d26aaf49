"""The laws that tie decoding to the operators of chapter 4: their effects, recounted."""

from dataclasses import astuple
from typing import Final, TypeVar

from clers.complexes.given import SMALL_SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components, curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import AtStep, AtSymbol
from clers.edgebreaker.decode import decode
from clers.edgebreaker.definition import fold, steps
from clers.edgebreaker.encode import encode
from clers.operators import handles as gate
from clers.operators.handle_table import Change, row
from clers.operators.sheets.apply import apply
from clers.operators.sheets.effects import rows
from clers.operators.sheets.gate import at_gate, sheet_of_growing
from clers.operators.sheets.numbers import Numbers, numbers
from clers.operators.sheets.sheet import EMPTY, Sheet, sheet_of

A = TypeVar("A")


def _taken(result: Accepted[A] | Rejected) -> A:
    """What an encoder wrote is accepted, or the encoder is broken."""
    match result:
        case Accepted(value):
            return value
        case Rejected() as rejected:
            raise AssertionError(rejected.line())


def _sums(surface: Surface) -> Verdict:
    """Face by face, the effects at gates add up to the numbers counted anew."""
    found = steps(encode(surface).stream)
    total, verdicts = Change(0, 0, 0, 0, 0, 0), list[Verdict]()
    states = _taken(and_then(found, fold))
    for i, (step, state) in enumerate(zip(_taken(found), states, strict=True)):
        for operator in step:
            total = Change(*map(sum, zip(astuple(total), astuple(row(operator)), strict=True)))
        n = numbers(sheet_of_growing(state))
        faces = n.faces - len(state.polygons)
        counted = Change(faces, n.vertices, n.euler, n.genus, n.loops, n.components)
        verdicts.append(same(counted, total, AtSymbol(i)))
    parts = components(surface)
    topology = (
        sum(part.euler + part.curves for part in parts),
        sum(part.genus for part in parts),
        0,
        len(parts),
    )
    ends = (total.euler, total.genus, total.loops, total.components)
    return every(
        *verdicts,
        same(topology, ends),
        same((surface.faces, surface.vertices), (total.faces, total.vertices)),
        same(sum(part.curves for part in parts), len(states[-1].polygons)),
    )


def filled(surface: Surface) -> Sheet:
    """The sheet of a surface with an infinite face in each boundary curve."""
    return sheet_of(surface.triangles(), (), (curve.vertices for curve in curves(surface)))


def _script(surface: Surface) -> Verdict:
    """As a script on sheets it runs, with effects as in the table, to the decoded surface."""
    stream = encode(surface).stream
    grown, sheet, verdicts = gate.NOTHING, EMPTY, list[Verdict]()
    operators = [operator for step in _taken(steps(stream)) for operator in step]
    total = Numbers()
    for k, operator in enumerate(operators):
        on_sheet = at_gate(operator, grown)
        after = apply(on_sheet, sheet)
        if isinstance(after, Rejected):
            return Fails(f"{on_sheet} to apply", after.line(), AtStep(k))
        grown, sheet = _taken(gate.apply(operator, grown)), after.value
        total = total - (-rows(on_sheet)[0])
        verdicts.append(same(total, numbers(sheet), AtStep(k)))
    return every(*verdicts, same(filled(_taken(decode(stream))), sheet))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "fold-sums-recounted",
        Clause.EB_FOLD_4,
        "Face by face the operators' effects add up to the numbers of the sheet, counted anew.",
        SMALL_SURFACES,
        _sums,
    ),
    Law(
        "fold-is-sheet-script",
        Clause.EB_FOLD_4,
        "The operators of a stream, on sheets, make the surface with its curves filled.",
        SMALL_SURFACES,
        _script,
    ),
)
