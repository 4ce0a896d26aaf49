"""Each law of enumeration, runs and numbers sees a fault planted in what it judges."""

from collections.abc import Sequence

import pytest
from test_laws_of_codes_can_fail import fails

from clers.conventions.result import Accepted, Rejected
from clers.information import enumerative, numbers, runs
from clers.information.numbers import Read
from clers.information.runs import Run


def backwards(size: int, symbols: Sequence[int]) -> Accepted[int] | Rejected:
    return RANK(size, symbols[::-1])


RANK = enumerative.rank
GOLOMB = numbers.golomb


def any_rank(counts: Sequence[int], digits: str) -> Accepted[tuple[int, ...]] | Rejected:
    made = enumerative.unrank([abs(c) for c in counts], len(digits))
    return Accepted(()) if isinstance(made, Rejected) else made


def any_runs(parts: Sequence[Run], count: int) -> Accepted[tuple[int, ...]]:
    del count
    return Accepted(tuple(symbol for symbol, length in parts for _ in range(length)))


def lenient(digits: str, at: int = 0) -> Accepted[Read]:
    return Accepted(Read(0, at + 1 if digits else at))


def shifted(parameter: int, number: int) -> Accepted[str] | Rejected:
    return GOLOMB(parameter + 1, number)


def test_enumeration(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(enumerative, "rank", backwards)
        assert fails("ranks-count-what-is-before")
        assert fails("binary-ranks-are-sums-of-binomials")
        assert fails("urns-give-all-words-alike")
    with monkeypatch.context() as planted:
        planted.setattr(enumerative, "decode", any_rank)
        assert fails("ranks-are-read-strictly")
    with monkeypatch.context() as planted:
        planted.setattr(enumerative, "rearrangements", lambda counts: 1 + sum(counts))
        assert fails("rearrangements-are-near-entropy")


def test_runs_and_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(runs, "joined", any_runs)
        assert fails("runs-are-maximal")
    with monkeypatch.context() as planted:
        planted.setattr(numbers, "read_gamma", lenient)
        assert fails("numbers-come-back")
        assert fails("any-digits-read-as-numbers")
    with monkeypatch.context() as planted:
        planted.setattr(numbers, "golomb", shifted)
        assert fails("golomb-remainders-are-huffman")
        assert fails("unwritable-numbers-are-rejected")
