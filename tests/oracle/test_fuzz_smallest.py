"""Planted faults are found within few examples, and shrink to the smallest that shows them."""

from collections.abc import Iterator
from itertools import product
from math import inf

import msgspec
import pytest
from msgspec import UNSET
from planted_faults import FAULTS, SAID, bearing, planted

from clers.complexes.topology import components
from clers.conformance import payloads as form
from clers.conformance.judging.judged import Status
from clers.conformance.lines import request_in
from clers.conformance.messages import Introduction, Operation, Rejection, WordEncode
from clers.conformance.outcome import Answered, Crash, Declined, NoProcess, Outcome
from clers.conformance.serve import serve
from clers.conformance.served.forms import stream_of, surface_of
from clers.conformance.session import Asked
from clers.container.file import decode as decode_file
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.stream import Stream
from clers.oracle.fuzz.asking import Ask, asking
from clers.oracle.fuzz.checks import asker
from clers.oracle.fuzz.families import Family, families
from clers.oracle.fuzz.hunt import Event, First, Round, Small, hunt
from clers.oracle.fuzz.shrinking.engine import Patience, alike, least
from clers.oracle.fuzz.shrinking.sizes import measure, size_of
from clers.oracle.fuzz.shrinking.smallest import TETRAHEDRON

NO_BOUNDARY = bearing(boundaries="none")
CONNECTED = bearing(boundaries="none", components=False)


def family(ask: Ask, op: str, said: Introduction = SAID, law: str = "") -> Family:
    of = asker(ask, said)
    return next(f for f in families(of, [op]) if f.law == law)


def events(fault: str, op: str, said: Introduction = SAID, examples: int = 60) -> Iterator[Event]:
    return hunt(family(planted(FAULTS[fault]), op, said), 0, examples, inf)


def first_of(fault: str, op: str) -> First:
    return next(event for event in events(fault, op) if isinstance(event, First))


def found(fault: str, op: str, said: Introduction = SAID, examples: int = 60) -> Small:
    """The first finding: it fails as it did at first, minimal, and smaller than at first."""
    coming = events(fault, op, said, examples)
    first = next(event for event in coming if isinstance(event, First))
    small = next(coming)
    assert isinstance(small, Small)
    assert small.first == first.operation
    assert alike(first.tried, small.least.tried)
    assert small.least.minimal
    assert size_of(small.least.operation) <= size_of(first.operation)
    return small


def faces_of(small: Small) -> form.Faces:
    given = small.least.operation.input
    assert isinstance(given, form.Faces)
    return given


def test_a_fault_of_handles_shrinks_to_the_torus_with_a_curve() -> None:
    """ORCL-SHRINK-7: fewer than 8 faces have no handle."""
    assert measure(found("mirrors-handles", "word.encode").least.operation) == ("faces", 8)


def test_without_curves_it_shrinks_to_the_torus_on_seven_vertices() -> None:
    """ORCL-SHRINK-1, ORCL-SHRINK-7: what the adapter does not declare is not offered."""
    small = found("mirrors-handles", "word.encode", NO_BOUNDARY)
    faces = faces_of(small)
    assert (len(faces.faces), faces.vertices) == (14, 7)
    # numbered as the faces list them
    assert list(dict.fromkeys(v for face in faces.faces for v in face)) == list(range(7))


def test_a_fault_of_two_handles_shrinks_to_the_least_surface_of_genus_2() -> None:
    """ORCL-SHRINK-3: 10 vertices and 24 faces, reached by contractions and flips alone.

    Heawood's bound gives 9 vertices, but no such surface has 9 (Huneke 1978).
    """
    small = found("miscounts-second-handle", "word.encode", CONNECTED)
    built = surface_of(faces_of(small))
    assert isinstance(built, Accepted)
    assert [c.genus for c in components(built.value)] == [2]
    assert (built.value.faces, built.value.vertices) == (24, 10)


@pytest.mark.parametrize(("said", "faces", "vertices"), [(SAID, 6, 8), (NO_BOUNDARY, 12, 8)])
def test_a_crash_at_a_vertex_shrinks_to_its_star(
    said: Introduction, faces: int, vertices: int
) -> None:
    """ORCL-SHRINK-3: seven neighbours need a fan of six; or, closed, V = 8 and so T = 2V − 4."""
    small = found("crashes-on-seven", "word.encode", said)
    assert small.least.tried.judged.status is Status.CRASH
    given = faces_of(small)
    assert (len(given.faces), given.vertices) == (faces, vertices)


@pytest.mark.parametrize(("said", "faces"), [(SAID, 2), (NO_BOUNDARY, 8)])
def test_a_hang_on_two_components_shrinks_to_the_smallest_two(
    said: Introduction, faces: int
) -> None:
    """ORCL-FUZZ-4, ORCL-SHRINK-4: with few requests, and it is found once."""
    all_events = list(events("hangs-on-two", "word.encode", said))
    (small,) = [event for event in all_events if isinstance(event, Small)]
    assert small.least.tried.judged.status is Status.TIMEOUT
    assert measure(small.least.operation) == ("faces", faces)
    assert small.least.asked <= 12


def test_what_hangs_is_not_asked_for_ever() -> None:
    """ORCL-FUZZ-5: after three more."""
    *_, last = events("hangs-on-two", "word.encode", examples=400)
    assert isinstance(last, Round)
    assert last.broken == "3 times timeout"


def test_a_fault_of_curves_shrinks_to_an_annulus() -> None:
    """ORCL-SHRINK-7: no connected surface of fewer than 6 faces has two curves."""
    small = found("turns-second-curve", "word.encode")
    built = surface_of(faces_of(small))
    assert isinstance(built, Accepted)
    assert [(c.faces, c.curves) for c in components(built.value)] == [(6, 2)]


def test_a_fault_of_bits_shrinks_to_one_symbol() -> None:
    """ORCL-SHRINK-3: the word E of a triangle, not a string that is no word."""
    given = found("forgets-a-bit", "code.encode", examples=20).least.operation.input
    assert isinstance(given, form.ToWord)
    assert (given.word, given.components_with_boundary) == ("E", 1)
    coded = found("forgets-a-bit", "arithmetic.encode", examples=20).least.operation
    assert measure(coded) == ("symbols", 0)


def test_a_fault_of_words_shrinks_through_their_meshes() -> None:
    """ORCL-SHRINK-3: SEE with boundary; closed, no word of 5 symbols with an S is accepted."""
    given = found("rejects-long-words", "word.decode").least.operation.input
    assert isinstance(given, form.StreamForm)
    assert given.word == "SEE"
    closed = found("rejects-long-words", "word.decode", NO_BOUNDARY).least.operation.input
    assert isinstance(closed, form.StreamForm)
    assert len(closed.word) == 7
    assert isinstance(decode(stream_of(closed)), Accepted)
    fewer = ("".join(word) for n in (3, 5) for word in product("CLERS", repeat=n) if "S" in word)
    assert not any(isinstance(decode(Stream(word)), Accepted) for word in fewer)


def test_a_fault_of_files_shrinks_by_bytes() -> None:
    """ORCL-SHRINK-3: magic and version, then one section of no bytes with a wrong seal."""
    small = found("believes-seals", "mesh.decode", examples=150)
    given = small.least.operation.input
    assert isinstance(given, form.FileForm)
    again = decode_file(bytes.fromhex(given.hex))
    assert isinstance(again, Rejected)
    assert again.reason is Reason.BAD_CHECKSUM
    assert len(given.hex) // 2 <= 9 + 12


def test_nothing_is_found_of_the_reference() -> None:
    """ORCL-FUZZ-2: every operation and every law, and all that is drawn is asked or judged."""
    of = asker(asking(serve), SAID)
    for each in families(of):
        all_events = list(hunt(each, 1, 8, inf))
        assert [e for e in all_events if not isinstance(e, Round)] == []
        rounds = [event for event in all_events if isinstance(event, Round)]
        assert sum(r.drawn for r in rounds) == 8
        if not each.law:
            assert 3 <= sum(r.asked for r in rounds) <= 8


def lines_of(number: int, said: Introduction = SAID) -> Iterator[bytes]:
    lines: list[bytes] = []
    right = planted(FAULTS["mirrors-handles"])

    def ask(asked: Asked) -> Outcome:
        lines.append(asked.line)
        return right(asked)

    list(hunt(family(ask, "word.encode", said), number, 12, inf))
    yield from lines


def test_the_same_seed_asks_the_same() -> None:
    """ORCL-FUZZ-3."""
    first, again, other = (list(lines_of(number)) for number in (3, 3, 4))
    assert first == again
    assert first != other


def test_what_is_not_declared_is_not_asked() -> None:
    """ORCL-FUZZ-2."""
    poor = bearing(handles=False, boundaries="one", components=False)
    small = msgspec.structs.replace(poor, caps=msgspec.structs.replace(poor.caps, max_faces=30))
    for line in lines_of(0, small):
        request = request_in(line)
        assert isinstance(request, WordEncode)
        built = surface_of(request.input)
        assert len(request.input.faces) <= 30
        if isinstance(built, Accepted):
            (part,) = components(built.value)
            assert (part.genus, part.curves) in ((0, 0), (0, 1))


def test_patience_ends_and_says_so() -> None:
    """ORCL-SHRINK-4: by requests, by time-outs, by time."""
    first = first_of("hangs-on-two", "word.encode")
    check = family(planted(FAULTS["hangs-on-two"]), "word.encode").check
    few = least(first.operation, first.tried, check, Patience(requests=1))
    assert (few.asked, few.minimal) == (1, False)
    hasty = least(first.operation, first.tried, check, Patience(timeouts=1))
    assert (hasty.minimal, measure(hasty.operation)) == (False, ("faces", 2))
    late = least(first.operation, first.tried, check, Patience(seconds=-1.0))
    assert (late.asked, late.minimal, late.operation) == (0, False, first.operation)


def test_shrinking_ends_where_nobody_answers() -> None:
    """ORCL-SHRINK-4, ORCL-RUN-6."""
    first = first_of("hangs-on-two", "word.encode")
    gone = family(lambda _: NoProcess("none is left"), "word.encode")
    done = least(first.operation, first.tried, gone.check)
    assert (done.asked, done.minimal) == (1, False)
    (only,) = hunt(gone, 0, 30, inf)
    assert only == Round(1, 1, "none is left")


def test_no_time_no_examples() -> None:
    """ORCL-FUZZ-3."""
    assert list(hunt(family(asking(serve), "word.encode"), 0, 5, -inf)) == []


@pytest.mark.parametrize(
    ("faces", "vertices", "reason", "left"),
    [
        (TETRAHEDRON, 4, None, ((0, 1, 2),)),
        ((*TETRAHEDRON, (0, 1, 1)), 4, Reason.REPEATED_INDEX, ((0, 0, 0),)),
        (TETRAHEDRON, 6, Reason.ISOLATED_VERTEX, ((0, 1, 2),)),
    ],
)
def test_a_good_mesh_stays_good_and_a_bad_one_bad_in_its_way(
    faces: tuple[tuple[int, int, int], ...],
    vertices: int,
    reason: Reason | None,
    left: tuple[tuple[int, int, int], ...],
) -> None:
    """ORCL-SHRINK-1: where all fails alike, what is right to answer is still of the same kind."""
    check = family(lambda _: Crash(-11, ""), "word.encode").check
    start = WordEncode(id=0, input=form.Faces(faces=faces, vertices=vertices))
    tried = check(start)
    assert tried is not None
    done = least(start, tried, check).operation.input
    assert isinstance(done, form.Faces)
    built = surface_of(done)
    assert (built.reason if isinstance(built, Rejected) else None) is reason
    assert len(done.faces) == len(left)


def test_one_failure_does_not_become_another() -> None:
    """ORCL-SHRINK-1, ORCL-FUZZ-4: all else is wrong too, and is a finding of its own."""

    def fault(operation: Operation, outcome: Outcome) -> Outcome:
        crashed = FAULTS["crashes-on-seven"](operation, outcome)
        mirrored = Declined(Rejection(Fault.INVALID))
        return mirrored if isinstance(crashed, Answered) else crashed

    coming = hunt(family(planted(fault), "word.encode"), 0, 60, inf)
    small = [event.least for event in coming if isinstance(event, Small)]
    found = {
        least.tried.judged.signature: measure(least.operation)[1]
        for least in small
        if least.tried.case.reject is UNSET
    }
    assert len(found) == 2
    assert found["word.encode crash SIGSEGV"] == 6
    assert found["word.encode fail invalid instead of a result"] == 1
