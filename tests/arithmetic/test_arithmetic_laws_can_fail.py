"""Each law of a coder fails for a coder with a fault that it should see."""

from random import Random

import pytest
from faulty_coders import FAULTY
from hypothesis import Phase, find, settings

from clers.arithmetic.coder import REFERENCE
from clers.arithmetic.laws import laws_of
from clers.conventions.verdict import Fails
from clers.generate.messages import DOMAINS

CASES = [(fault, name) for fault, (_, names) in FAULTY.items() for name in sorted(names)]


@pytest.mark.parametrize(("fault", "name"), CASES)
def test_law_sees_the_fault(fault: str, name: str) -> None:
    """CONV-LAW-1: the law takes the coder as its argument."""
    law = {law.name: law for law in laws_of(FAULTY[fault][0])}[name]
    example = find(
        DOMAINS[law.domain],
        lambda drawn: isinstance(law.check(drawn), Fails),
        settings=settings(max_examples=300, database=None, phases=[Phase.generate]),
        random=Random(0),
    )
    assert isinstance(law.check(example), Fails)


def test_every_law_of_a_coder_is_seen_to_fail() -> None:
    failing = {name for _, names in FAULTY.values() for name in names}
    assert failing == {law.name for law in laws_of(REFERENCE)}
