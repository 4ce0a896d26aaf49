"""An adapter's answers held against each other, and against those of another adapter."""

from collections.abc import Callable
from math import inf

import msgspec
import pytest
from planted_faults import FAULTS, SAID, bearing, planted

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.judging.judged import Status
from clers.conformance.lines import request_in
from clers.conformance.messages import Call, Introduction, Operation, Rejection
from clers.conformance.outcome import (
    Answered,
    Crash,
    Declined,
    NoProcess,
    Outcome,
    TimedOut,
    Unsupported,
)
from clers.conformance.samples import SAMPLES
from clers.conformance.session import Asked
from clers.conventions.reason import Fault
from clers.oracle.fuzz.asking import Ask
from clers.oracle.fuzz.checks import Tried, asker, by_reference, one_against_the_other
from clers.oracle.fuzz.families import check_of, families, narrower, opposed
from clers.oracle.fuzz.hunt import Small, hunt
from clers.oracle.fuzz.shrinking.sizes import measure

Change = Callable[[Operation, Outcome], Outcome]
SOUND = planted(FAULTS["sound"])


def told(change: Change) -> Ask:
    """The reference, what it says changed."""

    def ask(asked: Asked) -> Outcome:
        request = request_in(asked.line)
        assert isinstance(request, Call)
        return change(request, SOUND(asked))

    return ask


def tried(ask: Ask, op: str, law: str) -> Tried:
    check = check_of(asker(ask, SAID), op, law)
    assert check is not None
    found = check(SAMPLES[op])
    assert found is not None
    return found


def test_the_laws_that_there_are() -> None:
    """ORCL-FUZZ-7: those whose operations are declared, with a share of the examples."""
    all_of = families(asker(SOUND, SAID))
    laws = [(f.op, f.law, f.share) for f in all_of if f.law]
    assert laws == [
        ("arithmetic.encode", "comes-back", 4),
        ("word.encode", "comes-back", 4),
        ("word.encode", "names-do-not-matter", 4),
        ("word.encode", "codec", 4),
        ("word.decode", "codec", 4),
        ("code.encode", "comes-back", 4),
        ("mesh.encode", "comes-back", 4),
    ]
    assert {f.share for f in all_of if not f.law} == {1}
    alone = msgspec.structs.replace(SAID, ops=("echo", "word.encode"))
    assert [f.name for f in families(asker(SOUND, alone))] == [
        "word.encode",
        "word.encode names-do-not-matter",
    ]
    assert [f.name for f in families(asker(SOUND, SAID), ["surface.classify"])] == [
        "surface.classify"
    ]
    codeless = msgspec.structs.replace(
        SAID, caps=msgspec.structs.replace(SAID.caps, codes=(), coders=())
    )
    asked = {f.op for f in families(asker(SOUND, codeless))}
    assert asked.isdisjoint({"code.encode", "mesh.encode", "arithmetic.decode"})
    assert "mesh.decode" in asked


@pytest.mark.parametrize("op", ["arithmetic.encode", "word.encode", "code.encode", "mesh.encode"])
def test_what_is_encoded_comes_back(op: str) -> None:
    """ORCL-FUZZ-7: it holds of the reference; a decoder that declines breaks it."""
    assert tried(SOUND, op, "comes-back").judged.status is Status.PASS

    def declines(request: Operation, outcome: Outcome) -> Outcome:
        decoding = type(request) is not type(SAMPLES[op])
        return Declined(Rejection(Fault.INVALID, "no-reason")) if decoding else outcome

    found = tried(told(declines), op, "comes-back")
    assert found.judged.status is Status.FAIL
    assert found.judged.signature == f"{op} law comes-back: invalid"
    assert found.judged.clauses == ("ORCL-FUZZ-7",)
    assert found.law == "comes-back"
    assert not found.good


def changed(kind: type[form.Payload], **fields: object) -> Change:
    """Results of this kind with other fields."""

    def change(_: Operation, outcome: Outcome) -> Outcome:
        if isinstance(outcome, Answered) and isinstance(outcome.result, kind):
            return Answered(msgspec.structs.replace(outcome.result, **fields))
        return outcome

    return change


@pytest.mark.parametrize(
    ("op", "change", "kind"),
    [
        ("word.encode", changed(form.WordForm, vertex_order=(0, 1, 2, 2)), "vertex order"),
        ("word.encode", changed(form.WordForm, vertex_order=(1, 0, 2, 3)), "faces"),
        ("arithmetic.encode", changed(form.Symbols, symbols=(1, 0)), "the message"),
        ("code.encode", changed(form.JustWord, word="CRC"), "the word"),
    ],
)
def test_what_comes_back_otherwise(op: str, change: Change, kind: str) -> None:
    """ORCL-FUZZ-7."""
    found = tried(told(change), op, "comes-back")
    assert found.judged.signature == f"{op} law comes-back: {kind}"


def test_faces_that_come_back_are_compared() -> None:
    """ORCL-FUZZ-7: a vertex too high; another mesh."""

    def back(*faces: tuple[int, int, int]) -> Change:
        def change(request: Operation, outcome: Outcome) -> Outcome:
            if isinstance(request, message.WordDecode | message.MeshDecode):
                kind = form.Faces if isinstance(request, message.WordDecode) else form.MeshForm
                return Answered(kind(faces=faces, vertices=4))
            return outcome

        return change

    high = tried(told(back((0, 1, 9))), "word.encode", "comes-back")
    assert high.judged.signature.endswith(": vertices")
    other = told(back((0, 2, 1), (3, 1, 2), (0, 1, 3), (2, 0, 3)))
    assert tried(other, "word.encode", "comes-back").judged.signature.endswith(": faces")
    mirror = tried(told(back((0, 1, 2))), "mesh.encode", "comes-back")
    assert mirror.judged.status is Status.FAIL
    assert "codec.roundtrip" in mirror.judged.signature


def test_a_law_is_not_judged_where_there_is_no_answer() -> None:
    """ORCL-FUZZ-7: a crash is a finding of the operation itself, and a bad input is none's."""
    for law in ("comes-back", "names-do-not-matter", "codec"):
        check = check_of(asker(told(lambda *_: Crash(1, "")), SAID), "word.encode", law)
        assert check is not None
        assert check(SAMPLES["word.encode"]) is None
        bad = message.WordEncode(id=0, input=form.Faces(faces=((0, 1, 1),), vertices=2))
        assert check_of(asker(SOUND, SAID), "word.encode", law)(bad) is None  # type: ignore[misc]


def test_names_do_not_matter() -> None:
    """ORCL-FUZZ-7: the reference's do not; an adapter that starts at vertex 0 breaks the law."""
    assert tried(SOUND, "word.encode", "names-do-not-matter").judged.status is Status.PASS

    def by_name(change: Change) -> Change:
        def changed_if(request: Operation, outcome: Outcome) -> Outcome:
            given = request.input
            starts = isinstance(given, form.Faces) and given.faces[0][0] == 0
            return change(request, outcome) if starts else outcome

        return changed_if

    record = form.HandleForm(kind="handle", s=0, at=0, side="left")
    for change, kind in (
        (changed(form.WordForm, word="CRR"), "the word"),
        (changed(form.WordForm, handles=(record,)), "the handle data"),
        (
            changed(form.WordForm, components_with_boundary=1),
            "the number of components with boundary",
        ),
        (changed(form.WordForm, vertex_order=(3, 2, 1, 0)), "the vertex order"),
    ):
        found = tried(told(by_name(change)), "word.encode", "names-do-not-matter")
        assert found.judged.signature == f"word.encode law names-do-not-matter: {kind}"


def test_an_adapter_as_a_codec() -> None:
    """ORCL-FUZZ-7: chapter 5's laws hold of the reference, and find a fault of handles."""
    for op in ("word.encode", "word.decode"):
        assert tried(SOUND, op, "codec").judged.status is Status.PASS
    of = asker(planted(FAULTS["mirrors-handles"]), SAID)
    family = next(f for f in families(of, ["word.encode"]) if f.law == "codec")
    small = next(e for e in hunt(family, 0, 30, inf) if isinstance(e, Small))
    assert measure(small.least.operation) == ("faces", 8)
    assert small.least.tried.judged.signature == "word.encode law codec: round-trip Whole"
    accepts = told(changed(form.Faces, faces=((0, 1, 2),), vertices=3))
    assert "valid-streams" in tried(accepts, "word.decode", "codec").judged.signature


def against(first: Ask, second: Ask, said: Introduction = SAID, op: str = "word.encode") -> Tried:
    check = one_against_the_other(asker(first, SAID), asker(second, said))
    found = check(SAMPLES[op])
    assert found is not None
    return found


def test_one_against_the_other() -> None:
    """ORCL-AGAINST-1, ORCL-AGAINST-2: the first is what is expected, the reference judges both."""
    wrong = told(changed(form.WordForm, word="CRR"))
    assert against(SOUND, SOUND).judged.status is Status.PASS
    assert against(wrong, wrong).judged.status is Status.PASS
    for first, second, statuses in (
        (SOUND, wrong, (Status.PASS, Status.FAIL)),
        (wrong, SOUND, (Status.FAIL, Status.PASS)),
    ):
        found = against(first, second)
        assert found.judged.status is Status.FAIL
        assert found.judged.signature.startswith("against: word.encode fail")
        assert found.against is not None
        assert (found.against.first.status, found.against.second.status) == statuses


def test_failures_against_each_other() -> None:
    """ORCL-AGAINST-1: both fail alike, or one alone does; rejections are compared by class."""
    crash, slow = told(lambda *_: Crash(1, "")), told(lambda *_: TimedOut(1.0, ""))
    assert against(crash, crash).good
    assert against(crash, SOUND).judged.signature == "against: word.encode crash exit"
    assert against(SOUND, crash).judged.signature == "against: word.encode crash exit"
    assert not against(crash, slow).good
    gone = told(lambda *_: NoProcess("none"))
    assert against(SOUND, gone).gone == "none"
    assert against(gone, SOUND).gone == "none"
    assert against(SOUND, SOUND).gone == ""

    def rejects(fault: Fault, reason: str) -> Ask:
        return told(lambda *_: Declined(Rejection(fault, reason)))

    invalid, other = rejects(Fault.INVALID, "a"), rejects(Fault.INVALID, "b")
    assert against(invalid, other).good
    assert not against(invalid, rejects(Fault.MALFORMED, "a")).good
    assert not against(invalid, SOUND).good
    assert not against(SOUND, invalid).good


def test_what_one_does_not_support_is_no_difference() -> None:
    """ORCL-AGAINST-1."""
    check = one_against_the_other(
        asker(SOUND, SAID), asker(told(lambda *_: Unsupported("handles")), SAID)
    )
    assert check(SAMPLES["word.encode"]) is None
    poor = msgspec.structs.replace(SAID, ops=("echo", "word.decode", "surface.classify"))
    both = opposed(asker(SOUND, SAID), asker(SOUND, poor))
    assert [f.name for f in both] == ["surface.classify", "word.decode"]
    assert one_against_the_other(asker(SOUND, SAID), asker(SOUND, poor))(
        SAMPLES["word.encode"]
    ) is None  # fmt: skip
    only = opposed(asker(SOUND, SAID), asker(SOUND, poor), ["word.decode"])
    assert [f.name for f in only] == ["word.decode"]


def test_what_both_bear() -> None:
    """ORCL-AGAINST-1."""
    poor = msgspec.structs.replace(
        bearing(handles=False, boundaries="one", components=False).caps,
        max_faces=7,
        codes=("plain", "mine"),
        coders=("rans",),
    )
    for caps in (narrower(poor, SAID.caps), narrower(SAID.caps, poor)):
        assert (caps.handles, caps.boundaries, caps.components) == (False, "one", False)
        assert (caps.max_faces, caps.max_symbols) == (7, SAID.caps.max_symbols)
        assert (caps.codes, caps.coders) == (("plain",), ("rans",))
    none = bearing(boundaries="none").caps
    assert narrower(none, poor).boundaries == "none"
    assert narrower(SAID.caps, SAID.caps).boundaries == "many"


def test_bad_inputs_may_be_unsupported_where_something_is_lacking() -> None:
    """ORCL-FUZZ-2: nobody can say what a bad input requires."""
    bad = message.WordEncode(id=0, input=form.Faces(faces=((0, 1, 1),), vertices=2))
    does_not = told(lambda *_: Unsupported("handles"))
    whole = by_reference(asker(does_not, SAID))(bad)
    assert whole is not None
    assert not whole.good
    poor = by_reference(asker(does_not, bearing(handles=False)))(bad)
    assert poor is not None
    assert poor.judged.status is Status.SKIP


def test_a_difference_is_found_and_shrunk() -> None:
    """ORCL-AGAINST-1, ORCL-SHRINK-1."""
    first = asker(planted(FAULTS["mirrors-handles"]), SAID)
    (family,) = opposed(first, asker(SOUND, SAID), ["word.encode"])
    small = next(e for e in hunt(family, 0, 30, inf) if isinstance(e, Small))
    assert measure(small.least.operation) == ("faces", 8)
