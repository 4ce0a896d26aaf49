"""The way to the right answer, as tables. Clause: ORCL-EXPLAIN-2."""

from collections.abc import Iterable, Sequence

import msgspec
from msgspec import UnsetType

from clers.codes.closings import records
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Case
from clers.conformance.judging.anatomy import COUNTS, Region, anatomy
from clers.conformance.judging.bits import bits_in
from clers.conformance.judging.groups import Group, groups_of, groups_of_word
from clers.conformance.judging.steps import walk_of
from clers.conformance.messages import Operation, Step
from clers.conformance.results import Result
from clers.conformance.served.codes import closings_of, named
from clers.container.head import CODES, PositionCoding
from clers.container.layout import Window
from clers.container.numbers import varint
from clers.conventions.result import Accepted
from clers.edgebreaker.stream import Stream
from clers.oracle.explaining.explanation import Table

WALK = ("step", "symbol", "face", "gate", "apex", "stack", "χ", "new vertices", "records")
BITS = ("symbol", "", "bits")
NUMBERS = frozenset((*COUNTS, "number of bits"))
"""Fields whose value is a number of variable length."""

BYTES = ("byte", "section", "bytes", "meaning", "value")


def tables_of(case: Case, request: Operation, result: Result) -> tuple[Table, ...]:
    """The tables that there are for an operation and its right result. ORCL-EXPLAIN-2."""
    walk = walk_of(case, request)
    steps = (Table(title="the walk", heads=WALK, rows=tuple(map(_step, enumerate(walk)))),)
    match request, result:
        case ((message.WordEncode() | message.WordDecode()), _):
            return steps
        case message.MeshDecode(input=form.FileForm(hex=data)), _:
            return (_file(bytes.fromhex(data)), *steps)
        case _, form.FileForm(hex=data):
            read = message.MeshDecode(id=0, input=result)
            walk = walk_of(msgspec.structs.replace(case, trace=()), read)
            rows = tuple(map(_step, enumerate(walk)))
            return (_file(bytes.fromhex(data)), Table(title="the walk", heads=WALK, rows=rows))
        case ((message.CodeEncode() | message.ArithmeticEncode()), form.BitString()):
            return _bits(groups_of(request), bits_in(result))
        case message.CodeDecode(input=given), form.JustWord(word=word):
            return _bits(_groups_read(given, word), bits_in(given.bits))
        case message.ArithmeticDecode(input=given), form.Symbols(symbols=symbols):
            back = form.ToCode(coder=given.coder, model=given.model, symbols=symbols)
            groups = groups_of(message.ArithmeticEncode(id=0, input=back))
            return _bits(groups, bits_in(given.bits))
        case _, form.Classified(components=parts):
            heads = ("component", *form.ComponentForm.__struct_fields__)
            rows = tuple(
                (str(k), *map(str, msgspec.structs.astuple(part))) for k, part in enumerate(parts)
            )
            return (Table(title="the components", heads=heads, rows=rows),)
        case _, form.Stages(stages=stages):
            return (_stages(stages),)
        case _:
            return ()


def _step(numbered: tuple[int, Step]) -> tuple[str, ...]:
    """A row as `clers trace` has it. Clause: EB-TRACE-1."""
    k, step = numbered
    gate = "–" if step.i < 0 or isinstance(step.gate, UnsetType) else "{}→{}".format(*step.gate)
    apex = "" if isinstance(step.triangle, UnsetType) else str(step.triangle[0])
    opened = [f"opens {step.opens}"] if isinstance(step.opens, int) and step.opens >= 0 else []
    closed = () if isinstance(step.closes, UnsetType) else step.closes
    told = ", ".join([*opened, *(f"closes {r}" for r in closed)])
    new = "" if isinstance(step.new, UnsetType) else " ".join(map(str, step.new))
    rest = _known(step.face), gate, apex, _known(step.stack), _known(step.euler), new, told
    return (str(k), step.symbol, *rest)


def _known(number: int | UnsetType) -> str:
    return "" if isinstance(number, UnsetType) else str(number)


def _bits(groups: Sequence[Group], digits: str) -> tuple[Table, ...]:
    if not groups:
        return ()
    rows = tuple((_number(g), g.name, digits[g.start : g.stop] or "–") for g in groups)
    return (Table(title="the bits", heads=BITS, rows=rows),)


def _number(group: Group) -> str:
    return "" if group.symbol < 0 else str(group.symbol)


def _groups_read(given: form.FromWord, word: str) -> Sequence[Group]:
    """The groups of a word that was read. Clause: CODE-HAND-3."""
    known = records(word, closings_of(given))
    if not isinstance(known, Accepted):
        return ()
    return groups_of_word(
        named(given.code), Stream(word, known.value, given.components_with_boundary)
    )


def _file(data: bytes) -> Table:
    """What each byte of a file is for. Clause: ORCL-DIVERGE-4."""
    rows = tuple(_region(data, region) for region in anatomy(data))
    return Table(title="the file", heads=BYTES, rows=rows)


def _region(data: bytes, region: Region) -> tuple[str, ...]:
    part = data[region.start : region.stop]
    shown = part[:12].hex(" ") + (" …" if len(part) > 12 else "")
    return str(region.start), region.section, shown, region.meaning, _value(part, region)


def _value(part: bytes, region: Region) -> str:
    """What a field says, where that is more than its bytes."""
    match region.meaning:
        case "the tag":
            return part.decode("latin-1")
        case "the length of the payload":
            return str(int.from_bytes(part, "little"))
        case "the code of the word":
            return str(CODES[part[0] - 1])
        case "how positions are coded":
            return str(tuple(PositionCoding)[part[0] - 1])
        case name if name in NUMBERS:
            read = varint(64).read(Window(part, len(part)), 0)
            return str(read.value.value) if isinstance(read, Accepted) else ""
        case _:
            return ""


def _stages(stages: Iterable[form.StageForm]) -> Table:
    every = tuple(stages)
    names = tuple(dict.fromkeys(name for stage in every for name in stage.numbers))
    rows = tuple(
        (
            str(k),
            stage.operator or "the start",
            *(str(stage.numbers.get(name, "")) for name in names),
            stage.idle,
        )
        for k, stage in enumerate(every)
    )
    return Table(title="the stages", heads=("stage", "operator", *names, "nothing done"), rows=rows)
