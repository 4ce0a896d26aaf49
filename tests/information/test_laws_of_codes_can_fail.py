"""Each law of codes and of divergence sees a fault planted in what it judges."""

from collections.abc import Sequence
from math import inf
from random import Random

import pytest
from hypothesis import Phase, find, settings

from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.generate.domains import DOMAINS
from clers.information import canonical, divergence, huffman, measure, prefix, unique
from clers.information.laws import LAWS
from clers.information.prefix import Lengths, PrefixCode


def fails(name: str) -> bool:
    """Some example of the law's domain shows the fault."""
    (law,) = [law for law in LAWS if law.name == name]
    example = find(
        DOMAINS[law.domain],
        lambda drawn: isinstance(law.check(drawn), Fails),
        settings=settings(max_examples=500, database=None, phases=[Phase.generate]),
        random=Random(0),
    )
    return isinstance(law.check(example), Fails)


def takes_any_words(words: Sequence[str | None]) -> Accepted[PrefixCode] | Rejected:
    return Accepted(PrefixCode(tuple(words)))


def drops_the_rest(code: PrefixCode, digits: str, count: int) -> Accepted[tuple[int, ...]]:
    symbols = list[int]()
    for _ in range(count):
        for symbol, word in enumerate(code.words):
            if word is not None and digits.startswith(word):
                symbols.append(symbol)
                digits = digits[len(word) :]
                break
    return Accepted(tuple(symbols))


def in_order_of_symbols(lengths: Sequence[int | None]) -> Accepted[PrefixCode] | Rejected:
    made = canonical.by_sums(lengths)
    if isinstance(made, Rejected):
        return made
    return Accepted(PrefixCode(tuple(sorted(made.value.words, key=lambda w: w or ""))))


def finds_none(words: Sequence[str]) -> None:
    del words


def balanced(frequencies: Sequence[int]) -> Accepted[Lengths] | Rejected:
    size = sum(1 for f in frequencies if f > 0)
    return Accepted(tuple((size - 1).bit_length() if f > 0 else None for f in frequencies))


def too_long(frequencies: Sequence[int]) -> Accepted[Lengths] | Rejected:
    return Accepted(tuple(43 if f > 0 else None for f in frequencies))


def test_prefix_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(prefix, "prefix_code", takes_any_words)
        assert fails("bad-words-are-rejected")
    with monkeypatch.context() as planted:
        planted.setattr(prefix, "decode", drops_the_rest)
        assert fails("prefix-reading-is-strict")
    with monkeypatch.context() as planted:
        planted.setattr(prefix, "encode", lambda code, symbols: Accepted("0" * len(symbols)))
        assert fails("prefix-words-decode")
    with monkeypatch.context() as planted:
        planted.setattr(prefix, "kraft", lambda lengths: len(lengths))
        assert fails("prefix-codes-satisfy-kraft")
        assert fails("complete-codes-read-everything")
    with monkeypatch.context() as planted:
        planted.setattr(canonical, "canonical", in_order_of_symbols)
        assert fails("kraft-lengths-have-a-canonical-code")
        assert fails("huffman-is-canonical")
    with monkeypatch.context() as planted:
        planted.setattr(unique, "ambiguity", finds_none)
        assert fails("ambiguities-are-found")


def test_huffman(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(huffman, "huffman_lengths", balanced)
        assert fails("huffman-is-optimal")
        assert fails("huffman-loses-less-than-a-bit")
    with monkeypatch.context() as planted:
        planted.setattr(huffman, "huffman_lengths", too_long)
        assert fails("huffman-words-are-short")


def test_divergence(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(measure, "entropy", lambda row: float(max(row, default=0)))
        assert fails("entropy-is-continuous")
    with monkeypatch.context() as planted:
        planted.setattr(divergence, "cross_entropy", lambda one, other: inf)
        assert fails("cross-entropy-is-the-mean-content")
    with monkeypatch.context() as planted:
        planted.setattr(
            divergence, "redundancy", lambda one, other: sum(one) / 1000 - sum(other) / 999
        )
        assert fails("redundancy-is-not-negative")
        assert fails("redundancy-of-two-steps-adds")
