"""One change of a right result, and the place where it is: what a judge must find."""

from math import inf, nextafter

import msgspec
from hypothesis import strategies as st
from msgspec import UNSET

from clers.conformance import payloads as form
from clers.conformance.judging.bits import bits_in
from clers.conformance.messages import Step
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.results import Result

Place = tuple[str, tuple[tuple[str, int], ...]]
"""The kind of a divergence, and its numbers by name."""

Change = tuple[Result, Place]


def _place(kind: str, **at: int) -> Place:
    return kind, tuple(at.items())


@st.composite
def changed(draw: st.DrawFn, right: Result) -> Change:
    """The result with one change somewhere. Total over all results but introductions."""
    match right:
        case form.Classified():
            return draw(_classified(right))
        case form.Stages():
            return draw(_stages(right))
        case form.BitString():
            return draw(_bits(right))
        case form.Symbols():
            return draw(_symbols(right))
        case form.WordForm():
            return draw(_encoding(right))
        case form.JustWord():
            word, i = draw(_letters(right.word))
            return form.JustWord(word=word), _place("symbol", symbol=i)
        case form.FileForm():
            return draw(_file(right))
        case form.MeshForm():
            return draw(_mesh(right))
        case form.Faces():
            faces, vertices, place = draw(_faces(right))
            return form.Faces(faces=faces, vertices=vertices), place
        case dict():
            return {**right, "more": draw(st.integers())}, _place("value")
        case _:
            raise AssertionError(f"no change of {type(right).__name__}")


@st.composite
def _classified(draw: st.DrawFn, right: form.Classified) -> Change:
    parts = list(right.components)
    k = draw(st.integers(0, len(parts)))
    if k == len(parts):
        parts.append(parts[-1])
        return form.Classified(components=tuple(parts)), _place("component", component=k)
    name = draw(st.sampled_from(form.ComponentForm.__struct_fields__))
    counts = msgspec.structs.asdict(parts[k])
    counts[name] += draw(st.sampled_from((1, -1, 2)))
    parts[k] = form.ComponentForm(**counts)
    return form.Classified(components=tuple(parts)), _place(name, component=k)


@st.composite
def _stages(draw: st.DrawFn, right: form.Stages) -> Change:
    stages = list(right.stages)
    k = draw(st.integers(0, max(len(stages) - 1, 0)))
    if not stages or draw(st.booleans()):
        end = len(stages) - 1
        if not stages or draw(st.booleans()):
            more = form.StageForm(operator="relabel 1", numbers={})
            return form.Stages(stages=(*stages, more)), _place("stage", stage=end + 1)
        return form.Stages(stages=tuple(stages[:-1])), _place("stage", stage=end)
    stage = stages[k]
    kind = draw(st.sampled_from(("operator", "number", "idle")))
    if kind == "operator":
        stages[k] = msgspec.structs.replace(stage, operator=f"{stage.operator} 1")
    elif kind == "number":
        name = draw(st.sampled_from((*stage.numbers, "no such number")))
        numbers = {**stage.numbers, name: stage.numbers.get(name, 0) + 1}
        stages[k] = msgspec.structs.replace(stage, numbers=numbers)
    else:
        stages[k] = msgspec.structs.replace(stage, idle="" if stage.idle else "it could not")
    return form.Stages(stages=tuple(stages)), _place(kind, stage=k)


def bit_string(digits: str) -> form.BitString:
    """Digits, packed."""
    filled = digits + "0" * (-len(digits) % 8)
    data = bytes(int(filled[i : i + 8], 2) for i in range(0, len(filled), 8))
    return form.BitString(hex=data.hex(), length=len(digits))


@st.composite
def _bits(draw: st.DrawFn, right: form.BitString) -> Change:
    digits = bits_in(right)
    ways = ["flip", "cut", "more"] if digits else ["more"]
    way = draw(st.sampled_from([*ways, *(["fill"] if len(digits) % 8 else [])]))
    if way == "flip":
        i = draw(st.integers(0, len(digits) - 1))
        other = "0" if digits[i] == "1" else "1"
        return bit_string(digits[:i] + other + digits[i + 1 :]), _place("bit", bit=i)
    if way == "cut":
        return bit_string(digits[:-1]), _place("bit", bit=len(digits) - 1)
    if way == "more":
        return bit_string(digits + draw(st.sampled_from("01"))), _place("bit", bit=len(digits))
    data = bytearray(bytes.fromhex(right.hex))
    data[-1] |= 1
    return form.BitString(hex=data.hex(), length=right.length), _place("filling bits")


@st.composite
def _symbols(draw: st.DrawFn, right: form.Symbols) -> Change:
    symbols = list(right.symbols)
    i = draw(st.integers(0, len(symbols)))
    if i == len(symbols):
        symbols.append(0)
    elif draw(st.booleans()):
        symbols[i] = to_wire(from_wire(symbols[i]) + 1)
    else:
        symbols, i = symbols[:-1], len(symbols) - 1
    return form.Symbols(symbols=tuple(symbols)), _place("symbol", symbol=i)


@st.composite
def _letters(draw: st.DrawFn, word: str) -> tuple[str, int]:
    i = draw(st.integers(0, len(word)))
    if i == len(word):
        return word + draw(st.sampled_from("CLERS")), i
    if draw(st.integers(0, 9)) == 0:
        return word[:-1], len(word) - 1
    return word[:i] + draw(st.sampled_from([x for x in "CLERS" if x != word[i]])) + word[i + 1 :], i


@st.composite
def _encoding(draw: st.DrawFn, right: form.WordForm) -> Change:
    way = draw(st.sampled_from(("word", "handles", "components", "order")))
    if way == "word":
        word, i = draw(_letters(right.word))
        return msgspec.structs.replace(right, word=word), _place("symbol", symbol=i)
    if way == "handles":
        handles, r = draw(_handles(list(right.handles)))
        return msgspec.structs.replace(right, handles=handles), _place("record", record=r)
    if way == "components":
        more = to_wire(from_wire(right.components_with_boundary) + 1)
        place = _place("components with boundary")
        return msgspec.structs.replace(right, components_with_boundary=more), place
    order = list(right.vertex_order)
    k = draw(st.integers(0, len(order) - 2))
    order[k], order[-1] = order[-1], order[k]
    place = _place("vertex order", vertex=right.vertex_order[k])
    return msgspec.structs.replace(right, vertex_order=tuple(order)), place


@st.composite
def _handles(
    draw: st.DrawFn, handles: list[form.HandleForm]
) -> tuple[tuple[form.HandleForm, ...], int]:
    r = draw(st.integers(0, len(handles)))
    if r == len(handles):
        more = form.HandleForm(kind="handle", s=0, at=0, side="right")
        return (*handles, more), r
    h = handles[r]
    way = draw(st.sampled_from(("kind", "s", "at", "side", "gone")))
    if way == "gone":
        return tuple(handles[:-1]), len(handles) - 1
    if way == "kind":
        h = msgspec.structs.replace(h, kind="handle" if h.kind == "boundary" else "boundary")
    elif way == "side":
        h = msgspec.structs.replace(h, side="left" if h.side == "right" else "right")
    elif way == "s":
        h = msgspec.structs.replace(h, s=to_wire(from_wire(h.s) + 1))
    else:
        h = msgspec.structs.replace(h, at=to_wire(from_wire(h.at) + 1))
    handles[r] = h
    return tuple(handles), r


@st.composite
def _file(draw: st.DrawFn, right: form.FileForm) -> Change:
    data = bytearray(bytes.fromhex(right.hex))
    i = draw(st.integers(0, len(data)))
    if i == len(data):
        data.append(0)
    elif draw(st.integers(0, 9)) == 0:
        i = len(data) - 1
        del data[-1]
    else:
        data[i] ^= draw(st.integers(1, 255))
    return form.FileForm(hex=data.hex()), _place("byte", byte=i)


@st.composite
def _faces(
    draw: st.DrawFn, right: form.Faces
) -> tuple[tuple[form.Triple, ...], form.Number, Place]:
    faces = list(right.faces)
    way = draw(st.sampled_from(("turn", "flip", "vertex", "cut", "more", "vertices", "swap")))
    f = draw(st.integers(0, len(faces) - 1))
    a, b, c = faces[f]
    vertices = right.vertices
    if way == "vertices":
        return right.faces, to_wire(from_wire(vertices) + 1), _place("number of vertices")
    if way == "turn":
        faces[f] = b, c, a
    elif way == "flip":
        faces[f] = a, c, b
    elif way == "vertex":
        faces[f] = a, b, to_wire(from_wire(c) + 1)
    elif way == "swap":
        f = draw(st.integers(0, len(faces) - 2))
        faces[f], faces[-1] = faces[-1], faces[f]
    elif way == "cut":
        f = len(faces) - 1
        del faces[-1]
    else:
        f = len(faces)
        faces.append((0, 1, 2))
    return tuple(faces), vertices, _place("face", face=f)


@st.composite
def _mesh(draw: st.DrawFn, right: form.MeshForm) -> Change:
    places = right.positions
    if not isinstance(places, form.Places):
        if draw(st.booleans()):
            more = form.Places(precision="f32", coordinates=())
            return msgspec.structs.replace(right, positions=more), _place("positions")
        faces, vertices, place = draw(_faces(right))
        return form.MeshForm(faces=faces, vertices=vertices), place
    way = draw(st.sampled_from(("faces", "none", "precision", "coordinate", "cut")))
    if way == "faces":
        faces, vertices, place = draw(_faces(right))
        return form.MeshForm(faces=faces, vertices=vertices, positions=places), place
    if way == "none":
        return msgspec.structs.replace(right, positions=UNSET), _place("positions")
    if way == "precision":
        other = msgspec.structs.replace(
            places, precision="f64" if places.precision == "f32" else "f32"
        )
        return msgspec.structs.replace(right, positions=other), _place("precision")
    coordinates = list(places.coordinates)
    k = draw(st.integers(0, len(coordinates) - 1))
    if way == "cut":
        k = len(coordinates) - 1
        del coordinates[-1]
    else:
        coordinates[k] = nextafter(coordinates[k], inf if coordinates[k] < 1 else -inf)
    other = msgspec.structs.replace(places, coordinates=tuple(coordinates))
    place = _place("coordinate", vertex=k // 3)
    return msgspec.structs.replace(right, positions=other), place


@st.composite
def steps_changed(draw: st.DrawFn, right: tuple[Step, ...]) -> tuple[tuple[Step, ...], Place]:
    """A walk with one key of one step changed, a step missing at its end, or one too much."""
    steps = list(right)
    k = draw(st.integers(0, len(steps)))
    if k == len(steps):
        steps.append(Step(k, "C"))
        return tuple(steps), _place("step", symbol=k)
    if draw(st.booleans()) and len(steps) > 1:
        last = steps.pop()
        return tuple(steps), _place("step", symbol=last.i)
    key = draw(st.sampled_from(("symbol", "face", "gate", "triangle", "stack", "euler")))
    wrong: dict[str, Step] = {
        "symbol": msgspec.structs.replace(steps[k], symbol="X"),
        "face": msgspec.structs.replace(steps[k], face=-1),
        "gate": msgspec.structs.replace(steps[k], gate=(-1, -1)),
        "triangle": msgspec.structs.replace(steps[k], triangle=(-1, -1, -1)),
        "stack": msgspec.structs.replace(steps[k], stack=-1),
        "euler": msgspec.structs.replace(steps[k], euler=99),
    }
    at = _place(f"step, {key}") if right[k].i < 0 else _place(f"step, {key}", symbol=right[k].i)
    steps[k] = wrong[key]
    return tuple(steps), at
