"""Chapter 0: results, verdicts, laws and the registry."""

import re
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.conventions.clause import Clause
from clers.conventions.law import Given, Law, at_most, every, same
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds
from clers.conventions.where import (
    WHOLE,
    AtByte,
    AtCell,
    AtEdge,
    AtEntry,
    AtFace,
    AtPair,
    AtRecord,
    AtSimplex,
    AtStep,
    AtSymbol,
    AtVertex,
    Where,
    in_words,
)
from clers.generate.domains import strategy_for
from clers.laws import ALL, CHAPTERS, names_given_twice

NUMBERS = Given("numbers", "whole numbers", int)
ELEMENTS: tuple[Where, ...] = (
    WHOLE,
    AtFace(0),
    AtVertex(0),
    AtEdge(0, 1, 2),
    AtSymbol(0),
    AtRecord(0),
    AtStep(0),
    AtByte(0),
    AtByte(0, "word"),
    AtSimplex((0, 1)),
    AtPair((0, 1), (2,)),
    AtCell(2, 0),
    AtEntry("twin", 0),
)


@given(st.lists(st.tuples(st.integers(), st.integers(), st.integers())), st.integers())
def test_total(faces: list[tuple[int, int, int]], vertices: int) -> None:
    """Any numbers at all get an answer. Clause: CONV-RESULT-1."""
    answer = surface(FaceList(tuple(faces), vertices))
    assert isinstance(answer, Accepted | Rejected)


def test_counted_from_zero() -> None:
    """The first face, of vertices 5, 1, 2 where there are three. Clause: CONV-CLAUSE-5."""
    answer = surface(FaceList(((5, 1, 2),), 3))
    assert isinstance(answer, Rejected)
    assert answer.where == AtFace(0)
    assert isinstance(surface(FaceList(((0, 1, 2),), 3)), Accepted)


def test_elements_are_told_apart() -> None:
    """Clause: CONV-RESULT-2."""
    assert len({in_words(where) for where in ELEMENTS}) == len(ELEMENTS)


def test_classes() -> None:
    """One class for each reason, of four. Clause: CONV-RESULT-3."""
    assert {fault.value for fault in Fault} == {"malformed", "invalid", "unsupported", "limit"}
    assert {reason.fault for reason in Reason} == set(Fault)
    assert Reason.TOO_MANY_FACES.fault == "limit"
    assert Reason.DOUBLE_EDGE.fault == "invalid"
    assert Reason.TRUNCATED_FILE.fault == "malformed"
    assert Reason.UNKNOWN_VERSION.fault == "unsupported"


@given(st.sampled_from(Reason), st.sampled_from(Clause), st.sampled_from(ELEMENTS), st.text())
def test_one_line(reason: Reason, clause: Clause, where: Where, detail: str) -> None:
    """Class, reason, element, clause. Clause: CONV-RESULT-4."""
    line = Rejected(reason, clause, where, detail).line()
    opening = f"{reason.fault.value}: {reason.value} {in_words(where)} [{clause.value}]"
    assert line.startswith(opening)
    assert len(line.splitlines()) == 1


def test_first_fault() -> None:
    """A later step cannot hide an earlier fault. Clause: CONV-RESULT-5."""
    first = Rejected(Reason.EMPTY_MESH, Clause.CONV_RESULT_5)
    second = Rejected(Reason.ISOLATED_VERTEX, Clause.CONV_RESULT_5)
    assert and_then(first, lambda _: second) == first
    assert and_then(Accepted(1), lambda _: second) == second
    assert and_then(Accepted(1), lambda n: Accepted(n + 1)) == Accepted(2)


def test_law_judges_an_example() -> None:
    """Clause: CONV-LAW-1."""
    even = Law("even", Clause.CONV_LAW_1, "it is even", NUMBERS, lambda n: same(0, n % 2))
    assert even.check(4) == Holds()
    assert even.check(3) == Fails("0", "1", WHOLE)
    assert even.check("3") == Fails("int", "str", WHOLE)
    assert (even.domain, even.meaning) == ("numbers", "whole numbers")


def test_verdicts() -> None:
    """Clause: CONV-LAW-4."""
    fails = Fails("1", "2", AtFace(3))
    assert same(1, 2, AtFace(3)) == fails
    assert at_most(2.0, 2.0) == Holds()
    assert at_most(2.0, 2.5, "bits") == Fails("bits ≤ 2.0", "2.5", WHOLE)
    assert every(Holds(), fails, Fails("3", "4", WHOLE)) == fails
    assert every(Holds(), Holds()) == every() == Holds()


def test_every_domain_has_a_generator() -> None:
    """Clause: CONV-LAW-2."""
    assert [law.name for law in ALL if strategy_for(law.domain) is None] == []


def test_one_meaning_for_each_domain() -> None:
    """Clause: CONV-LAW-2."""
    meanings = {law.domain: law.meaning for law in ALL}
    assert [law.name for law in ALL if meanings[law.domain] != law.meaning] == []


def test_registry() -> None:
    """Clause: CONV-LAW-3."""
    assert names_given_twice(ALL) == ()
    assert sum(len(laws) for laws in CHAPTERS.values()) == len(ALL)
    twice = Law("twice", Clause.CONV_LAW_3, "nothing is said", NUMBERS, lambda _: Holds())
    assert names_given_twice([twice, twice]) == ("twice",)


def test_every_reason_stands_in_the_table_of_its_class() -> None:
    """Clause: CONV-RESULT-3."""
    chapter = (Path(__file__).parents[2] / "spec" / "00-conventions.md").read_text()
    stated = {
        reason: fault
        for fault in Fault
        for line in chapter.splitlines()
        if line.startswith(f"> | `{fault}` |")
        for reason in re.findall(r"`([a-z-]+)`", line.split("|")[2])
    }
    assert stated == {str(reason): reason.fault for reason in Reason}
