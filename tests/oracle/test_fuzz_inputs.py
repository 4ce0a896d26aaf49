"""What is drawn: every kind of input, good ones and bad ones, and nothing beyond capabilities."""

from collections import Counter
from collections.abc import Callable
from functools import cache

import msgspec
import pytest
from planted_faults import FAULTS, SAID, bearing, planted

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.needs import needs
from clers.conformance.messages import Introduction, Operation
from clers.conformance.numbers import from_wire
from clers.conformance.results import RESULTS
from clers.generate.sample import sample
from clers.operators.families import GROWING, ON_COMPLEXES, ON_SHEETS
from clers.oracle.fuzz.changes import (
    STREAM_CHANGES,
    bits_changed,
    bits_of_digits,
    digits_of,
    text_changed,
)
from clers.oracle.fuzz.checks import asker
from clers.oracle.fuzz.families import families
from clers.oracle.fuzz.hunt import First, Small, hunt, number_of
from clers.oracle.fuzz.inputs import drawn, space_of
from clers.oracle.fuzz.question import kind_of, name_of, question
from clers.oracle.fuzz.shrinking.engine import Patience
from clers.oracle.fuzz.shrinking.sizes import size_of

NAMES = tuple(name for name in RESULTS if name != "echo")
ONLY_GOOD = ("code.encode", "codec.roundtrip")


@cache
def examples(name: str, count: int = 40) -> tuple[Operation, ...]:
    return examples_for(name, count, SAID)


def examples_for(name: str, count: int, said: Introduction) -> tuple[Operation, ...]:
    what = drawn(name, said.caps)
    assert what is not None
    return sample(what, count, 7)


@pytest.mark.parametrize("name", NAMES)
def test_good_and_bad_inputs_are_drawn(name: str) -> None:
    """ORCL-FUZZ-1: of each operation."""
    kinds: Counter[str] = Counter()
    for operation in examples(name):
        assert name_of(operation) == name
        case = question(operation)
        assert case is not None
        assert case.op == name
        assert case.origin == "shrunk"
        kinds[kind_of(case)] += 1
    if name in ONLY_GOOD:
        assert set(kinds) <= {"a result", "invalid not-representable"}
    else:
        assert kinds["a result"] >= 10
        assert len(kinds) >= 2


def test_meshes_of_every_kind_are_drawn() -> None:
    """ORCL-FUZZ-1: handles, curves, components, positions; small and large."""
    seen: Counter[str] = Counter()
    for operation in examples("mesh.encode", 150):
        case = question(operation)
        assert case is not None
        seen.update(case.requires)
        assert isinstance(operation, message.MeshEncode)
        given = operation.input
        seen["large"] += len(given.faces) > 40
        seen["small"] += len(given.faces) < 13
        seen["placed"] += isinstance(given.positions, form.Places)
        seen[type(given.accuracy).__name__] += 1
    for kind in ("handles", "components", "boundaries.one", "boundaries.many", "large", "small"):
        assert seen[kind] >= 1, kind
    assert {"ExactForm", "BitsForm", "LatticeForm", "ErrorForm"} <= set(seen)
    assert 40 <= seen["placed"] <= 110


def test_scripts_of_every_family_are_drawn() -> None:
    """ORCL-FUZZ-1."""
    firsts = Counter[str]()
    for operation in examples("operator.apply", 100):
        assert isinstance(operation, message.Apply)
        firsts[next(iter(operation.input.script.replace(";", " ").split()), "")] += 1
    for family in (GROWING, ON_COMPLEXES, ON_SHEETS):
        assert sum(firsts[name] for name in family) >= 1


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_drawn_in_vain(name: str) -> None:
    """ORCL-FUZZ-2: for a poor adapter most of what is drawn can be asked."""
    poor = bearing(handles=False, boundaries="one", components=False)
    small = msgspec.structs.replace(poor.caps, max_faces=16, codes=("golden",), coders=("rans",))
    said = msgspec.structs.replace(poor, caps=small)
    cases = [question(operation) for operation in examples_for(name, 20, said)]
    bearable = [case for case in cases if case is not None and needs(case, said) is None]
    assert len(bearable) >= 6


def test_the_space_of_capabilities() -> None:
    """ORCL-FUZZ-2."""
    whole, none = space_of(SAID.caps), space_of(bearing(handles=False, boundaries="none").caps)
    assert (whole.faces, whole.genus, whole.curves, whole.components) == (200, 3, 4, 3)
    assert (none.genus, none.curves) == (0, 0)
    assert space_of(bearing(boundaries="one").caps).curves == 1
    assert space_of(bearing(components=False).caps).components == 1
    assert drawn("echo", SAID.caps) is None


STREAM = form.StreamForm(
    word="SLRRLE",
    handles=(form.HandleForm(kind="boundary", s=0, at=3, side="left"),),
    components_with_boundary=1,
)


def fields(change: Callable[[form.StreamForm, int, int], form.StreamForm]) -> set[str]:
    """What a change may touch, whatever its numbers are."""
    touched = set[str]()
    for i in range(24):
        for j in range(24):
            other = change(STREAM, i, j)
            touched |= {
                name
                for name in ("word", "handles", "components_with_boundary")
                if getattr(other, name) != getattr(STREAM, name)
            }
    return touched


def test_each_change_of_a_stream_is_one_change() -> None:
    """ORCL-FUZZ-1: in the word, the records, or the number; and of nothing there is nothing."""
    assert [fields(change) for change in STREAM_CHANGES] == [
        {"word"}, {"word"}, {"word"}, {"word"},
        {"components_with_boundary"},
        {"handles"}, {"handles"}, {"handles"}, {"handles"},
    ]  # fmt: skip
    lengths = [len(change(STREAM, 2, 1).word) for change in STREAM_CHANGES[:4]]
    assert lengths == [6, 7, 5, 6]
    records = [len(change(STREAM, 3, 0).handles) for change in STREAM_CHANGES[5:8]]
    assert records == [2, 0, 1]
    empty = form.StreamForm(word="", handles=(), components_with_boundary=0)
    for change in STREAM_CHANGES:
        other = change(empty, 5, 3)
        assert len(other.word) + len(other.handles) <= 1


def test_each_field_of_a_record_is_changed() -> None:
    """ORCL-FUZZ-1: also to numbers beyond 2^53, which are strings then."""
    change = STREAM_CHANGES[-1]
    (old,) = STREAM.handles
    seen = {change(STREAM, 0, j).handles[0] for j in range(20)}
    assert {r.side for r in seen} == {"left", "right"}
    assert {r.kind for r in seen} == {"boundary", "handle"}
    assert {from_wire(r.s) for r in seen} == {0, 1, -1, 2, -2, (1 << 53) + 1}
    assert {from_wire(r.at) for r in seen} == {3, 4, 2, 5, 1, 3 + (1 << 53) + 1}
    for new in seen:
        names = ("kind", "s", "at", "side")
        assert sum(getattr(new, name) != getattr(old, name) for name in names) == 1


def test_bits_are_changed_at_one_place() -> None:
    """ORCL-FUZZ-1, ARITH-BITS-2."""
    bits = bits_of_digits("1011001110")
    assert (bits.hex, bits.length) == ("b380", 10)
    assert digits_of(bits) == "1011001110"
    assert digits_of(form.BitString(hex="", length=0)) == ""
    assert [digits_of(bits_changed(bits, 1, j)) for j in range(4)] == [
        "101100111", "10110011101", "111001110", "1111001110",
    ]  # fmt: skip
    none = form.BitString(hex="", length=0)
    assert {bits_changed(none, i, j).length for i in range(3) for j in range(4)} <= {0, 1}


def test_text_is_changed_at_one_place() -> None:
    """ORCL-FUZZ-1."""
    assert [text_changed("ab", 1, j) for j in range(4)] == ["a", "abb", "a-", "a9"]
    assert text_changed("", 3, 4) == "x"


def test_hypothesis_shrinks_first() -> None:
    """ORCL-SHRINK-5: through the operators that a surface was grown by, before any step."""
    of = asker(planted(FAULTS["mirrors-handles"]), SAID)
    family = next(f for f in families(of, ["word.encode"]) if not f.law)
    events = hunt(family, 0, 30, float("inf"), Patience(requests=0))
    first = next(event for event in events if isinstance(event, First))
    small = next(events)
    assert isinstance(small, Small)
    assert (small.least.asked, small.least.minimal) == (0, False)
    assert size_of(small.least.operation) < size_of(first.operation)


def test_seeds() -> None:
    """ORCL-FUZZ-3: of equal things equal, of others others."""
    assert number_of(1, "a", 0) == number_of(1, "a", 0)
    assert len({number_of(1, "a", 0), number_of(1, "a", 1), number_of(1, "b", 0)}) == 3
