"""What fuzzers drive, driven a little: good input, good input spoilt, and bytes of no origin."""

from random import Random

import pytest

from clers.generate.byte_targets import TARGETS
from clers.generate.guided import line


def spoilt(data: bytes, random: Random) -> bytes:
    out = bytearray(data)
    for _ in range(random.randrange(1, 4)):
        if out:
            out[random.randrange(len(out))] = random.randrange(256)
    return bytes(out[: random.randrange(len(out) + 1)] if random.randrange(4) == 0 else out)


@pytest.mark.parametrize("name", TARGETS)
def test_nothing_is_wrong(name: str) -> None:
    """Clause: CONV-RESULT-1."""
    target, random = TARGETS[name], Random(name)
    seeds = list(target.seeds())
    inputs = [b"", *seeds, *(spoilt(random.choice(seeds), random) for _ in range(60))]
    inputs += [random.randbytes(random.randrange(40)) for _ in range(60)]
    assert [data for data in inputs if target.tried(data) is not None] == []


def test_the_figures_of_a_run() -> None:
    """Clause: CONV-RESULT-1."""
    said = "#2 INITED cov: 3 ft: 4 corp: 1/1b\n#9 DONE cov: 12 ft: 30 corp: 4/9b\n"
    said += "stat::number_of_executed_units: 512\n"
    assert line("word", said, 0).split() == [
        *("word", "512", "executions", "12", "edges", "4", "inputs", "0", "defects")
    ]
    assert line("word", "", 1).split()[1::2] == ["?", "?", "?", "1"]
