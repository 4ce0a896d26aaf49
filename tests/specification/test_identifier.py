"""Ids in running text."""

import pytest

from clers.specification.identifier import mentions, of_member, order


@pytest.mark.parametrize(
    ("text", "ids"),
    [
        ("by BOX-LID-1, BOX-LID-3.", ["BOX-LID-1", "BOX-LID-3"]),
        ("BOX-LID-9 to BOX-LID-11", ["BOX-LID-9", "BOX-LID-10", "BOX-LID-11"]),
        ("BOX-LID-1 … BOX-LID-3", ["BOX-LID-1", "BOX-LID-2", "BOX-LID-3"]),
        ("BOX-LID-1...BOX-LID-3", ["BOX-LID-1", "BOX-LID-2", "BOX-LID-3"]),
        ("`BOX-LID-1`–`BOX-LID-3`", ["BOX-LID-1", "BOX-LID-2", "BOX-LID-3"]),
        ("BOX-LID-1 …\n    BOX-LID-3", ["BOX-LID-1", "BOX-LID-2", "BOX-LID-3"]),
        ("BOX-LID-3 to BOX-LID-1", ["BOX-LID-3", "BOX-LID-1"]),
        ("BOX-LID-1 to BOX-BASE-3", ["BOX-LID-1", "BOX-BASE-3"]),
        ("BOX-LID-1 and BOX-LID-3", ["BOX-LID-1", "BOX-LID-3"]),
        ("**BOX-LID-1.** (BOX-BIG-LID-20)", ["BOX-LID-1", "BOX-BIG-LID-20"]),
        ("BOX-1 Box-Lid-1 BOX-LID-0 BOX-LID-01 BOX-LID-1a xBOX-LID-1 BOX-LID-N UTF-8", []),
        ("BOX-LID-1-2 -BOX-LID-1 BOX_LID_1", []),
    ],
)
def test_mentions(text: str, ids: list[str]) -> None:
    """Clause: CONV-CLAUSE-8."""
    assert [mention.clause for mention in mentions(text)] == ids


def test_place() -> None:
    """All of a range but its end stand where it begins. Clause: CONV-CLAUSE-8."""
    found = [(mention.clause, mention.offset) for mention in mentions("x BOX-LID-1 to BOX-LID-3")]
    assert found == [("BOX-LID-1", 2), ("BOX-LID-2", 2), ("BOX-LID-3", 15)]


def test_member() -> None:
    """Clause: CONV-CLAUSE-9."""
    assert of_member("BOX_LID_12") == "BOX-LID-12"
    assert [of_member(name) for name in ("name", "BOX_LID", "__members__", "BOX_1")] == [None] * 4


def test_order() -> None:
    """Numbers are numbers. Clause: CONV-CLAUSE-7."""
    ids = ["BOX-LID-10", "BOX-LID-9", "BOX-BASE-11"]
    assert sorted(ids, key=order) == ["BOX-BASE-11", "BOX-LID-9", "BOX-LID-10"]
