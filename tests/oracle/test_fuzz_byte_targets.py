"""What fuzzers drive, driven a little: good input, good input spoilt, and bytes of no origin."""

from random import Random

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.conventions.result import Accepted
from clers.oracle.fuzz.byte_targets import TARGETS
from clers.oracle.fuzz.guided import line


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


def test_what_is_written_otherwise_is_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: CONV-RESULT-1."""

    def other(*_: object) -> Accepted[Bits]:
        return Accepted(pack([1]))

    monkeypatch.setattr("clers.codes.handle_data.encode", other)
    tried, random = TARGETS["handles"].tried, Random(1)
    inputs = (bytes([random.randrange(2), 16]) + random.randbytes(3) for _ in range(400))
    assert any(tried(data) is not None for data in inputs)


def test_the_figures_of_a_run() -> None:
    """Clause: CONV-RESULT-1."""
    said = "#2 INITED cov: 3 ft: 4 corp: 1/1b\n#9 DONE cov: 12 ft: 30 corp: 4/9b\n"
    said += "stat::number_of_executed_units: 512\n"
    assert line("word", said, 0).split() == [
        *("word", "512", "executions", "12", "edges", "4", "inputs", "0", "defects")
    ]
    assert line("word", "", 1).split()[1::2] == ["?", "?", "?", "1"]
