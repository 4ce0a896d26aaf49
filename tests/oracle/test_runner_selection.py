"""Which cases a run asks, and how many those must be."""

from dataclasses import replace

import msgspec
import pytest
from small_suite import CODED, ECHOES, WORDS, small_suite

from clers.oracle.runs.selection import NotThere, Selected, Selection, select
from clers.oracle.suite.files import Suite

ALL = (*ECHOES, *WORDS, *CODED)


@pytest.fixture(scope="module")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Suite:
    return small_suite(tmp_path_factory.mktemp("suite"))


def ids(found: Selected | NotThere) -> set[str]:
    assert isinstance(found, Selected), found
    assert found.counted == len(found.chosen)
    return {chosen.case.id for chosen in found.chosen}


def test_everything_in_the_order_of_the_manifest(suite: Suite) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-2."""
    found = select(suite, Selection())
    assert isinstance(found, Selected)
    assert [chosen.case for chosen in found.chosen] == list(suite.cases)
    assert [chosen.profile for chosen in found.chosen] == ["core"] * 12 + ["codes"]
    assert found.counted == 13


@pytest.mark.parametrize(
    ("selection", "expected"),
    [
        (Selection(profiles=("codes",)), CODED),
        (Selection(profiles=("codes", "core")), ALL),
        (Selection(ops=("word.decode",)), WORDS),
        (Selection(ops=("word.decode", "code.encode")), (*WORDS, *CODED)),
        (Selection(clauses=("EB-GRAMMAR-1",)), WORDS[1:]),
        (Selection(clauses=("EB-GRAMMAR-1", "EB-DECODE-1")), WORDS),
        (Selection(only=("tetra*",)), WORDS[:1]),
        (Selection(only=("*-[01]-*", "plain-????????")), (*ECHOES[:2], *CODED)),
        (Selection(profiles=("core",), ops=("echo",), only=("echo-3-*",)), ECHOES[3:4]),
    ],
)
def test_named_by_each_way_that_is_used(
    suite: Suite, selection: Selection, expected: tuple[object, ...]
) -> None:
    """ORCL-CHECK-2."""
    assert ids(select(suite, selection)) == {case.id for case in ALL if case in expected}


@pytest.mark.parametrize(
    ("selection", "why"),
    [
        (Selection(only=("tetra",)), "no case of the suite is selected"),
        (Selection(only=("TETRA*",)), "no case of the suite is selected"),
        (Selection(clauses=("EB-DECODE",)), "no case of the suite is selected"),
        (
            Selection(profiles=("core", "all")),
            "the suite has no profile all; it has codes, core",
        ),
        (
            Selection(ops=("decode",)),
            "the suite has no operation decode; it has code.encode, echo, word.decode",
        ),
    ],
)
def test_a_selection_of_nothing(suite: Suite, selection: Selection, why: str) -> None:
    """ORCL-CHECK-2: a glob is held against the whole id."""
    assert select(suite, selection) == NotThere(why)


def test_the_count_is_the_manifests(suite: Suite) -> None:
    """ORCL-CHECK-5: not that of the cases that happen to be there."""
    entries = tuple(
        msgspec.structs.replace(entry, cases=entry.cases + 3) if entry.op == "echo" else entry
        for entry in suite.manifest.files
    )
    other = replace(suite, manifest=msgspec.structs.replace(suite.manifest, files=entries))
    for selection, counted in (
        (Selection(), 16),
        (Selection(ops=("echo",)), 13),
        (Selection(ops=("echo",), only=("echo-0-*",)), 4),
        (Selection(ops=("word.decode",)), 2),
    ):
        found = select(other, selection)
        assert isinstance(found, Selected)
        assert found.counted == counted
